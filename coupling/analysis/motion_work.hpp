// Computing time of a point in motion, from counts of revolutions, steps, bearings, rollers, laminae and
// waves, and of some steps of slow motion: known before it is computed.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "coupling/analysis/multi_stage.hpp"

namespace orbearing::analysis {

/// Factor within which estimates are of the measured times: of most motions, of slow ones, and of slow ones
/// whose rollers strike each other. docs/motion_time.md has the measurement.
inline constexpr int kAccuracy = 2, kAccuracyOfSlow = 4, kAccuracyOfSlowUncaged = 25;

/// Duration and accuracy of a motion, as in system::SteadyStateOptions.
struct MotionWindows {
  int observed = 10;            // [-]  revolutions of the cage
  int most = 20;                // [-]  revolutions on the way to the steady state
  double length_error = 2e-10;  // [m]

  bool operator==(const MotionWindows&) const = default;
};
template <class Visitor>
void describe(Visitor& visit, MotionWindows& m) {
  using namespace described;
  members(visit, m, internal(m.observed, "simulation.observed_revolutions"),
          internal(m.most, "simulation.most_revolutions"),
          internal(m.length_error, "simulation.length_error", "", {.dimension = dimension::length}));
}

/// The motion of one bearing, or of all bearings of a set as one system. Times are processor times of the
/// core on which they were measured: docs/motion_time.md has the measurement and its accuracy.
struct MotionWork {
  double runs = 1.0;            // of gears and bearing in turn, and of bearings that are followed one by one
  double settling = 2.0;        // [-]  revolutions of the cage on the way to the steady state
  double turn = 0.0;            // [s]  of motion: a revolution of the cage
  double longest_step = 0.0;    // [s]
  double accurate_step = 0.0;   // [s]  that errors allow at the default length error
  double load_error = 0.0;      // [m]  that the load allows where no length error is stated
  double step_seconds = 0.0;    // [s]  processor time of a step
  double window_seconds = 0.0;  // [s]  processor time of a second of motion besides, for exchanges
  double other_seconds = 0.0;   // [s]  processor time of all that is no step of bearings
  int alike = 1;                // such motions
  double run_up = 0.0;          // [s]  of motion, instead of the observed revolutions; 0: none
  bool slow = false;            // steps follow the passage of rollers, and are counted
  int accuracy = kAccuracy;     // the estimate is within this factor

  double step(const MotionWindows& windows) const;  // [s]  mean
  double time(const MotionWindows& windows) const;  // [s]  of motion, in all runs
  double steps(const MotionWindows& windows) const { return time(windows) / step(windows); }
  double seconds(const MotionWindows& windows) const;  // [s]  of processor time, of all alike
};

/// The motions of a point. Throws as evaluate() where its bearings cannot move.
std::vector<MotionWork> motion_work(const std::vector<NamedSet>& sets, Fidelity fidelity);

/// [s]  of processor time of all of them
double seconds_of(const std::vector<MotionWork>& motions, const MotionWindows& windows);

/// The least accurate of them.
inline int accuracy_of(const std::vector<MotionWork>& motions) {
  int worst = kAccuracy;
  for (const MotionWork& motion : motions) worst = std::max(worst, motion.accuracy);
  return worst;
}

/// Life of one revolution of the cage about that of many [-], standard deviation: the largest of eleven
/// motions (docs/motion_time.md); and that of the slip.
inline constexpr double kScatterOfLife = 8.5e-3;
inline constexpr double kScatterOfSlip = 2e-4;
/// Means over n revolutions scatter less by the root of n.
inline double scatter_of_life(const MotionWindows& windows) {
  return kScatterOfLife / std::sqrt(windows.observed);
}

/// By which lives may err with five times the default length error (coupling/system/README.md) [-].
inline constexpr double kErrorOfLargeSteps = 0.02;

}  // namespace orbearing::analysis
