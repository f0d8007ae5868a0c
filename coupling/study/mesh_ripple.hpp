// From the motion of the gears to what they add to the mean load on a planet bearing.
#pragma once

#include <optional>

#include "coupling/study/drivetrain.hpp"
#include "gearset/dynamics/parameters.hpp"

namespace orbearing::study {

/// What the gears do on planet bearings that are linear.
struct GearDrive {
  bearing::dynamics::MeshRipple ripple;  // on the bore of one bearing of the planet of `duty`
  Eigen::VectorXd final_state;           // where their motion ended, a whole number of mesh periods on
};

/// The load on the bore of one bearing under which a free bore of the given mass, on a bearing that is `law`
/// over their number, moves relative to its pin as the planet of `duty` does in the set, less its mean, as a
/// Fourier series. For a bore with its share of the planet's mass that is the force of the meshes, and what
/// a carrier adds that shakes; for one without mass, the force that the gears put on the bearing. It is taken
/// from the displacement, which is smooth where the mesh stiffness jumps. No harmonics where the
/// drivetrain has no `gear_set`, or no mesh variation.
/// @param bore_mass [kg] of one bearing
/// @param start state of the gears to go on from; none: their static state
/// @throws std::runtime_error where the gears' motion cannot be computed
GearDrive drive_of_gears(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                         const BearingDuty& duty, const gearset::dynamics::AffineBearing& law,
                         double bore_mass, const std::optional<Eigen::VectorXd>& start = std::nullopt);

/// Orders of the mesh frequency that such a series has: up to three times the frequency of a planet on its
/// bearings, where its mass leaves an eighth of a force, and at least twelve.
int ripple_orders(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                  const gearset::dynamics::AffineBearing& law);

}  // namespace orbearing::study
