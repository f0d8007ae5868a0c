// From the motion of the gears to what they add to the mean load on a planet bearing.
#pragma once

#include <optional>

#include "coupling/analysis/drivetrain.hpp"
#include "coupling/analysis/gear_dynamics.hpp"
#include "gearset/dynamics/parameters.hpp"

namespace orbearing::analysis {

/// The gears on planet bearings that are a law.
class GearsOnLaw {
 public:
  GearsOnLaw(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
             const gearset::dynamics::AffineBearing& law);

  /// Whether small motions die out. They need not: a law that is fitted to a motion may give energy by
  /// springs that are not alike across, and meshes that pump add to it.
  bool stay_on() const { return map_.largest_growth() <= 0.0; }

  /// Observed with excitation_orders() harmonics. `completed`: whether the motion could be computed.
  /// @param start state of the gears to go on from; none: their static state
  GearRunResult run(const std::optional<Eigen::VectorXd>& start = std::nullopt) const;

 private:
  gearset::dynamics::SetModel model_;
  gearset::dynamics::PeriodMap map_;
  GearRunOptions options_;
};

/// The gears on bearing_tangent() instead of their bearings: the start of every planet.
struct GearsOnTangent {
  gearset::dynamics::AffineBearing tangent;
  GearRunResult run;
};
/// Nothing where the gears give nothing but their mean loads. Throws as bearing_tangent(), and
/// std::runtime_error with the reason where the gears' motion could not be computed.
GearsOnTangent gears_on_tangent(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry);

/// Force [N] of the bearings on `planet` at rest, of gears on bearing_tangent() under their mean loads:
/// outward and in the sense of rotation. None where no gears move, or several sets share the loads.
/// @throws std::runtime_error where no equilibrium is found
std::optional<Eigen::Vector2d> bearing_force_at_rest(const PlanetaryDrivetrain& drivetrain,
                                                     const DrivetrainGeometry& geometry, int planet);

/// The load on the bore of one bearing under which a free bore of the given mass, on a bearing that is `law`
/// over their number, moves relative to its pin as the planet of `duty` does in `run`, less its mean, as a
/// Fourier series. For a bore with its share of the planet's mass that is the force of the meshes, and what
/// a carrier adds that shakes; for one without mass, the force that the gears put on the bearing. It is taken
/// from the displacement, which is smooth where the mesh stiffness jumps. No harmonics where `run` has none.
/// @param run   of GearsOnLaw of the same law
/// @param bore_mass [kg] of one bearing
bearing::motion::MeshExcitation excitation_of(const GearRunResult& run, const PlanetaryDrivetrain& drivetrain,
                                              const BearingDuty& duty,
                                              const gearset::dynamics::AffineBearing& law, double bore_mass);

/// Orders of the mesh frequency that such a series has at most: up to three times the frequency of a planet
/// on its bearings, where its mass leaves an eighth of a force, and at least twelve.
int excitation_orders(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const gearset::dynamics::AffineBearing& law);

}  // namespace orbearing::analysis
