// Several planetary sets at one operating point of their drivetrain: whose bearings live shortest.
#pragma once

#include <string>
#include <vector>

#include "coupling/study/operating_point.hpp"

namespace orbearing::study {

/// A set with bearings, and what follows from its parameters. All of a drivetrain share `drive`.
struct NamedSet {
  std::string name;  // empty for a set that is alone
  PlanetaryDrivetrain drivetrain;
  DrivetrainGeometry geometry;
};

/// The point of the set whose bearing lives shortest, with all sets' results and the life of all bearings
/// together, Eq. (4) of coupling/README.md; a set that is alone, as `evaluate` gives it. Throws
/// std::runtime_error that names the set where one has no result, std::invalid_argument for no sets.
PointResult evaluate(const std::vector<NamedSet>& sets, Fidelity fidelity = Fidelity::quasi_static);

/// Copies of the sets with another speed of the motor [rad/s].
std::vector<NamedSet> at_speed(std::vector<NamedSet> sets, double speed);

}  // namespace orbearing::study
