// Several planetary sets at one operating point of their drivetrain: which has the worst bearing.
#pragma once

#include <string>
#include <vector>

#include "coupling/analysis/operating_point.hpp"

namespace orbearing::analysis {

/// A set with bearings, and what follows from its parameters. All of a drivetrain share `drive`.
struct NamedSet {
  std::string name;  // empty for a single set
  PlanetaryDrivetrain drivetrain;
  DrivetrainGeometry geometry;
};

/// The point of the set with the worst bearing, by worst_governing_hours(), with all sets' results and the
/// life of all bearings together, Eq. (4) of coupling/README.md; a single set, as from `evaluate`.
/// Throws std::runtime_error that names the set where one has no result, std::invalid_argument for no sets.
PointResult evaluate(const std::vector<NamedSet>& sets, Fidelity fidelity = Fidelity::quasi_static);

/// Copies of the sets with another speed of the motor [rad/s].
std::vector<NamedSet> at_speed(std::vector<NamedSet> sets, double speed);

}  // namespace orbearing::analysis
