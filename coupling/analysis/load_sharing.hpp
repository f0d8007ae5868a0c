// Sharing of the mean load among the planets of a set with pins off their positions.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/analysis/drivetrain.hpp"

namespace orbearing::analysis {

/// Static equilibrium of planets that shares the set's mean load among them. Each is on a spring whose pin is
/// displaced such that it gives the force of the bearings there.
struct PlanetBalance {
  /// [-]  (planets)  of the mean load of the meshes, 1 where all carry alike; negative where the planet is
  /// driven on its back flanks.
  std::vector<double> shares;
  Eigen::Matrix2Xd forces;  // [N]  (2, planets)  of the bearings on each planet
  Eigen::Matrix2Xd offset;  // [m]  (2, planets)  of the pins: displacement by the bearings, force / stiffness
  double stiffness = 0.0;   // [N/m]  of the springs
  /// Balances of the bearing of each planet under these forces, where all cage angles were found at once.
  std::vector<std::shared_ptr<const bearing::vectorised::PitchResults>> pitches{};
};

/// Static equilibrium of the gears at their mean mesh stiffness, with teeth that may separate, on bearings
/// with their quasi-static compliance, each on the support of its pin.
/// @throws std::runtime_error where no equilibrium is found, std::invalid_argument where the drivetrain has
/// no gears that can move
PlanetBalance planet_balance(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry);

/// Operating point of the bearings of one planet that exert `force` [N] on it: in the search, the
/// displacement of the planet by the bearings and the pin's support is a function of it.
bearing::OperatingPoint point_under(const PlanetaryDrivetrain& drivetrain, const BearingDuty& even,
                                    const Eigen::Vector2d& force);

/// Duty of one bearing of each planet; a single one where all planets carry alike.
std::vector<BearingDuty> planet_duties(const PlanetaryDrivetrain& drivetrain,
                                       const DrivetrainGeometry& geometry);

}  // namespace orbearing::analysis
