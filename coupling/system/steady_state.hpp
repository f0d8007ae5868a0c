// Bearings in motion, run in time until their means are steady, then observed over whole cage revolutions.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "bearing/motion/layout.hpp"
#include "bearing/motion/parameters.hpp"
#include "coupling/system/motion.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::system {

/// Optional check among the observed windows: whether the others are to be observed too.
struct EarlyCheck {
  int windows = 0;                     // observed before the check; 0: no check
  std::function<bool()> goes_on = {};  // false: the run ends there with the means so far; its series is void
};

/// Settings of the method. A window is one revolution of the cage relative to the carrier; with gravity, one
/// of the carrier.
struct SteadyStateOptions {
  double first_roller = 0.0;            // [rad]  angle of the first roller at the start
  double load_drift = 2e-3;             // [-]  steady: rms loads of two windows in turn differ by no more
  double cage_drift = 1e-3;             // [-]  steady: cage speeds differ by no more of the kinematic one
  int least_windows = 2;                // [-]  before the criterion is checked
  int most_windows = 20;                // [-]  before the run is observed all the same, with a message
  int observed_windows = 3;             // [-]  averaged once steady; at least ten for reliable maxima
  long samples_per_window = 2000;       // [-]
  long series_samples = 500;            // [-]  of the last window, kept as time series
  long bins = 72;                       // [-]  bins on the races
  double allowed_length_error = 2e-10;  // [m]  of one step; all other variables follow from it
  double load_error_share = 2e-5;  // [-]  of the elastic approach of the most loaded roller at rest, where
                                   //      that allows more
  integration::IntegrationOptions integration;  // of a single bearing; allowed_error is filled in
  BoreObserver on_bore = {};  // gets the observed windows of a single bearing, step by step; may be empty
  EarlyCheck look = {};
  double window = 0.0;  // [s]  of a window; 0: a revolution of the cage
};

/// The same where gravity acts: windows of whole turns of the carrier, if it rotates at all.
inline SteadyStateOptions with_window(SteadyStateOptions options, const bearing::motion::Gravity& gravity,
                                      double carrier_speed) {
  if (gravity.acts() && carrier_speed != 0.0) options.window = constants::two_pi / std::abs(carrier_speed);
  return options;
}

/// Also used for a driven bearing.
inline described::Row<double> length_error_row(double& allowed_length_error) {
  using namespace described;
  return input(allowed_length_error, "simulation.length_error", "error of a position allowed in one step",
               {.dimension = dimension::length,
                .range = positive(0.1),
                .reason = "coarser steps oscillate at closing contacts and take longer",
                .numerical = true});
}

/// Parameters in a case.
template <class Visitor>
void describe(Visitor& visit, SteadyStateOptions& m) {
  using namespace described;
  rows(visit,
       input(m.integration.method, "simulation.integrator",
             "integration of the roller dynamics: linearly implicit method, or explicit method of order 5",
             {.reason = "the same means in a fraction of the time", .numerical = true}),
       input(m.observed_windows, "simulation.observed_revolutions",
             "number of cage revolutions for the means of the steady state; with inertia.gravity of the "
             "carrier",
             {.range = {1, 100000}, .reason = "enough for maxima", .numerical = true}),
       input(m.most_windows, "simulation.most_revolutions",
             "maximum number of cage revolutions to reach a steady state; with inertia.gravity of the "
             "carrier",
             {.range = {2, 100000}, .reason = "bearings settle in a few", .numerical = true}),
       input(m.load_drift, "simulation.load_drift",
             "limit for a steady state: difference of the rms loads of two consecutive revolutions",
             {.range = positive(1.0), .reason = "small compared with any effect on life", .numerical = true}),
       input(m.cage_drift, "simulation.cage_drift",
             "limit for a steady state: difference of the cage speeds of two consecutive revolutions",
             {.range = positive(1.0), .reason = "small compared with any effect on slip", .numerical = true}),
       length_error_row(m.allowed_length_error),
       input(m.load_error_share, "simulation.load_error_share",
             "error of a position allowed in one step over the elastic approach of the most loaded roller at "
             "rest, where that is more than simulation.length_error",
             {.range = {.least = 0.0, .most = 0.1},
              .reason = "heavily loaded contacts deflect more, and their loads err by a share of that",
              .numerical = true}));
}

/// One window as time series. Matrices are (rollers, samples).
struct BearingSeries {
  Eigen::ArrayXd time;             // [s]  from the start of the run
  Eigen::ArrayXXd angle;           // [rad]
  Eigen::ArrayXXd inner_load;      // [N]
  Eigen::ArrayXXd outer_load;      // [N]
  Eigen::ArrayXXd inner_sliding;   // [m/s]
  Eigen::ArrayXXd outer_sliding;   // [m/s]
  Eigen::ArrayXXd inner_film;      // [m]
  Eigen::ArrayXXd outer_film;      // [m]
  Eigen::ArrayXXd pocket_load;     // [N]      zero without a cage
  Eigen::ArrayXXd neighbour_load;  // [N]      of the roller ahead, without a cage; else zero
  Eigen::ArrayXXd spin;            // [rad/s]
  Eigen::Array2Xd cage_position;   // [m]      (x and y, samples)
  bool caged = true;
  Eigen::ArrayXd
      orbit_angle;  // [rad]    of the cage, without one the mean over the rollers; grows without bound
  Eigen::ArrayXd orbit_speed;  // [rad/s]  likewise; relative to the carrier
  Eigen::ArrayXd power_loss;   // [W]
};

/// Speeds at pure rolling.
struct RollingSpeeds {
  double cage = 0.0;  // [rad/s]  relative to the carrier
  double spin = 0.0;  // [rad/s]  of a roller
};

/// Result of a run. For several bearings, loads are as if all were passages of one.
struct SteadyStateResult {
  bool completed = false;  // false: reason in `message`; the means are those so far, if any
  bool steady = false;     // false with completed: the means drifted to the end
  std::string message;
  bearing::motion::WindowStatistics statistics;             // over the observed windows
  std::vector<bearing::motion::WindowStatistics> bearings;  // the same, bearing by bearing
  // Each window on the way to the steady state; except loads and the cage's speed, at its end only.
  std::vector<bearing::motion::WindowStatistics> windows;
  BearingSeries series;  // of the first bearing in the last window
  RollingSpeeds rolling;
  double duration = 0.0;        // [s]  from the start to the end of what was observed
  Eigen::VectorXd final_state;  // of a single bearing, in the order of `layout`
  bearing::motion::StateLayout layout{};
  integration::IntegrationReport report;  // summed over all windows; smallest step of all

  /// 1 - orbital speed / that at pure rolling: of the cage, without one of the rollers' mean.
  double orbit_slip() const { return 1.0 - statistics.orbit_speed / rolling.cage; }
};

/// Loads of several bearings as if all were passages of one: means over the bearings, the largest load of
/// all.
bearing::motion::WindowStatistics pooled(const std::vector<bearing::motion::WindowStatistics>& bearings);

/// Whether the means are steady from one window to the next.
bool is_steady(const bearing::motion::WindowStatistics& before, const bearing::motion::WindowStatistics& now,
               double kinematic_cage_speed, const SteadyStateOptions& options);

/// Length [s] of a window.
double window_length(const RollingSpeeds& rolling, const SteadyStateOptions& options);

/// Time [s] between two samples of a motion that keeps to one interval.
double sample_interval(const RollingSpeeds& rolling, const SteadyStateOptions& options);

/// Runs `motion` from its present state in windows until the pooled loads and the cage are steady, then
/// observes `options.observed_windows` of them. Throws std::invalid_argument where the cage does not turn;
/// later errors are in the result.
SteadyStateResult run_to_steady_state(Motion& motion, const RollingSpeeds& rolling,
                                      const SteadyStateOptions& options);

/// A single bearing at `point`, from the state `start` (the final state of a neighbouring operating
/// point), without one from its quasi-static state. Throws std::invalid_argument for input that
/// bearing_model() refuses, and for a run-up.
SteadyStateResult run_to_steady_state(const bearing::Bearing& bearing, const bearing::OperatingPoint& point,
                                      const bearing::motion::DynamicsParameters& parameters,
                                      const SteadyStateOptions& options,
                                      const std::optional<Eigen::VectorXd>& start = std::nullopt);

/// As above until it is steady, then all speeds grow by `parameters.driving.ramp` for `duration` [s] at
/// constant power. Means, series (options.series_samples over the whole run-up) and slip are those of the
/// run-up; its time counts from its beginning, the cage's slip refers to the mean speed. Throws
/// std::invalid_argument where the duration is not positive or the speeds would come to rest.
SteadyStateResult run_up(const bearing::Bearing& bearing, const bearing::OperatingPoint& point,
                         const bearing::motion::DynamicsParameters& parameters,
                         const SteadyStateOptions& options, double duration);

}  // namespace orbearing::system
