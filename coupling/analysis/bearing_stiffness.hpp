// The 5 x 5 stiffness of a bearing over speed and load.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bearing/equilibrium/ring_axes.hpp"
#include "coupling/analysis/duplex_run.hpp"
#include "coupling/analysis/multi_stage.hpp"
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

/// Adds a warning for each point without an equilibrium.
void warn_of_failed_points(StiffnessStudy& study);

/// The inner ring of a single bearing against the outer one, x along the radial load, at each of the load
/// factors; of balls over each of the speeds.
StiffnessStudy stiffness_of_rollers(const RollerSupport& in);
StiffnessStudy stiffness_of_balls(const BallSupport& in);

/// Change of the first point of rollers by straight rollers, in words; none where one has no equilibrium.
std::optional<std::string> effect_of_straight_rollers(RollerSupport in, const StiffnessPoint& first);

/// The shaft of a duplex pair under its preload, about its mass centre, at each of its speeds.
/// Throws std::runtime_error where it has no equilibrium.
StiffnessStudy stiffness_of_pair(PreloadedPair pair);

/// The bore of one planet bearing against its pin: rollers and cage at their kinematic speeds, mean over the
/// cage angles.
StiffnessPoint stiffness_of_planet_bearing(const NamedSet& set);
/// Points of a drivetrain as a study: one table for each set.
/// @param whole_contacts rollers are not cut into laminae, and are taken as straight
StiffnessStudy stiffness_of_planet_bearings(std::vector<StiffnessPoint> points, bool whole_contacts);

}  // namespace orbearing::analysis
