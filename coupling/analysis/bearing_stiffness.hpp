// The 5 x 5 stiffness of a bearing over speed and load.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bearing/equilibrium/ring_axes.hpp"
#include "coupling/analysis/single_bearing.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// One equilibrium. Order x, y, z, tilt about x, tilt about y; SI.
struct StiffnessPoint {
  double speed = 0.0;  // [rad/s]  of the inner ring, of rollers 0: they rest; of a drivetrain, its input
  std::vector<std::pair<std::string, double>> load{};  // by name with unit, on the ring that moves
  std::size_t series = 0;  // points of one series differ by speed alone, or are one sweep
  std::string set{};       // of several sets, whose planet bearing
  std::optional<bearing::equilibrium::RingStiffness> stiffness{};  // none: no equilibrium
  bearing::equilibrium::RingDisplacement displacement = bearing::equilibrium::RingDisplacement::Zero();
  std::optional<double> largest_pressure{};  // [Pa]  of a single bearing, after Hertz
  std::string status = "ok";                 // or why there is none
};

void describe(described::Record& row, const StiffnessPoint& point);

struct StiffnessStudy {
  std::vector<StiffnessPoint> points;
  std::size_t series = 1;
  std::string frame;    // what moves against what, and where x points
  std::string damping;  // why there is none
  std::vector<std::string> warnings;
};

void describe(described::Record& record, const StiffnessStudy& study);

/// The inner ring of a single bearing against the outer one, x along the radial load, at each of the load
/// factors; of balls over each of the speeds.
StiffnessStudy stiffness_of_rollers(const RollerSupport& in);
StiffnessStudy stiffness_of_balls(const BallSupport& in);

}  // namespace orbearing::analysis
