// A planet bearing run in time until its means stand still, then observed over whole cage revolutions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bearing/motion/parameters.hpp"
#include "bearing/motion/statistics.hpp"
#include "coupling/integration/integrate.hpp"

namespace orbearing::integration {

/// The bore of a bearing in motion.
struct BoreSample {
  double time = 0.0;                                   // [s]
  double weight = 0.0;                                 // any unit: how long it counts
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // [m/s]
  Eigen::Vector2d force = Eigen::Vector2d::Zero();     // [N]  of the bearing on the bore
};
using BoreObserver = std::function<void(const BoreSample&)>;

/// What belongs to the method. A window is one revolution of the cage relative to the carrier.
struct SteadyStateOptions {
  double first_roller = 0.0;            // [rad]  place of the first roller at the start
  double load_drift = 2e-3;             // [-]  steady: rms loads of two windows in turn differ by no more
  double cage_drift = 1e-3;             // [-]  steady: cage speeds differ by no more of the kinematic one
  int least_windows = 2;                // [-]  before the criterion is asked
  int most_windows = 20;                // [-]  before the run is observed all the same, and says so
  int observed_windows = 3;             // [-]  averaged once steady; at least ten for reliable maxima
  long samples_per_window = 2000;       // [-]
  long series_samples = 500;            // [-]  of the last window, kept as time series
  long places = 72;                     // [-]  bins on the races
  double allowed_length_error = 2e-10;  // [m]  of one step; all other variables follow from it
  IntegrationOptions integration;       // allowed_error is filled in
  BoreObserver on_bore = {};            // sees the observed windows, step by step; may be empty
};

/// Of a bearing that is driven too.
inline described::Row<double> length_error_row(double& allowed_length_error) {
  using namespace described;
  return field(allowed_length_error, "simulation.length_error", Felt::motion,
               "error of a position allowed in one step",
               {.models = planetary_drivetrain,
                .dimension = dimension::length,
                .range = positive(0.1),
                .reason = "coarser steps ring at contacts that close and then take longer",
                .fmu = InFmu::parameter});
}

/// What a case states of it.
template <class Visitor>
void describe(Visitor& visit, SteadyStateOptions& m) {
  using namespace described;
  rows(
      visit,
      field(m.integration.method, "simulation.integrator", Felt::motion,
            "how the roller dynamics is integrated: linearly implicit steps on the vectorised equations, or "
            "the "
            "readable equations by explicit steps of order 5",
            {.models = planetary_drivetrain, .reason = "the same means in a fraction of the time"}),
      field(m.observed_windows, "simulation.observed_revolutions", Felt::run,
            "cage revolutions that are averaged once steady",
            {.models = planetary_drivetrain, .range = {1, 100000}, .reason = "enough for maxima"}),
      field(m.most_windows, "simulation.most_revolutions", Felt::run,
            "cage revolutions allowed to become steady",
            {.models = planetary_drivetrain, .range = {2, 100000}, .reason = "bearings settle in a few"}),
      field(m.load_drift, "simulation.load_drift", Felt::run,
            "steady: rms loads of two revolutions in turn differ by less",
            {.models = planetary_drivetrain, .range = positive(1.0), .reason = "below what a life can tell"}),
      field(m.cage_drift, "simulation.cage_drift", Felt::run,
            "steady: cage speeds of two revolutions in turn differ by less",
            {.models = planetary_drivetrain, .range = positive(1.0), .reason = "below what a slip can tell"}),
      length_error_row(m.allowed_length_error));
}

/// One window as time series. Matrices are (rollers, samples).
struct BearingSeries {
  Eigen::ArrayXd time;            // [s]  from the start of the run
  Eigen::ArrayXXd angle;          // [rad]
  Eigen::ArrayXXd inner_load;     // [N]
  Eigen::ArrayXXd outer_load;     // [N]
  Eigen::ArrayXXd inner_sliding;  // [m/s]
  Eigen::ArrayXXd outer_sliding;  // [m/s]
  Eigen::ArrayXXd inner_film;     // [m]
  Eigen::ArrayXXd outer_film;     // [m]
  Eigen::ArrayXXd pocket_load;    // [N]
  Eigen::ArrayXXd spin;           // [rad/s]
  Eigen::Array2Xd cage_position;  // [m]      (x and y, samples)
  Eigen::ArrayXd cage_angle;      // [rad]    grows without bound
  Eigen::ArrayXd cage_speed;      // [rad/s]  relative to the carrier
  Eigen::ArrayXd power_loss;      // [W]
};

/// What a run gives.
struct SteadyStateResult {
  bool completed = false;  // false: `message` says why and the means hold what there was, if anything
  bool steady = false;     // false with completed: the means drifted to the end
  std::string message;
  bearing::dynamics::WindowStatistics statistics;            // over the observed windows
  std::vector<bearing::dynamics::WindowStatistics> windows;  // each window on the way to the steady state
  BearingSeries series;                                      // of the last window
  double kinematic_cage_speed = 0.0;                         // [rad/s]
  double kinematic_spin = 0.0;                               // [rad/s]
  Eigen::VectorXd final_state;
  IntegrationReport report;  // summed over all windows; smallest step of all

  /// 1 - cage speed / kinematic cage speed.
  double cage_slip() const { return 1.0 - statistics.cage_speed / kinematic_cage_speed; }
};

/// Empty series of `samples` samples, and what stands in sample `i` at `time` [s].
void resize(BearingSeries& series, Eigen::Index rollers, Eigen::Index samples);
void record(double time, const bearing::dynamics::Snapshot& now, Eigen::Index i, BearingSeries& series);

/// Whether the means stand still from one window to the next.
bool is_steady(const bearing::dynamics::WindowStatistics& before,
               const bearing::dynamics::WindowStatistics& now, double kinematic_cage_speed,
               const SteadyStateOptions& options);

/// Options of the integrator with the errors allowed for the state of `model`.
IntegrationOptions integration_options(const bearing::dynamics::BearingModel& model,
                                       const SteadyStateOptions& options);

/// Runs `bearing` at `point` from its quasi-static state. Throws std::invalid_argument for input that
/// bearing_model() refuses, for a run-up (run_up.hpp) and where nothing turns; what goes wrong later is in
/// the result.
SteadyStateResult run_to_steady_state(const bearing::CylindricalRollerBearing& bearing,
                                      const bearing::OperatingPoint& point,
                                      const bearing::dynamics::DynamicsParameters& parameters,
                                      const SteadyStateOptions& options);

/// As above, from the given state (the final state of a neighbouring operating point).
SteadyStateResult run_to_steady_state_from(const Eigen::VectorXd& start,
                                           const bearing::CylindricalRollerBearing& bearing,
                                           const bearing::OperatingPoint& point,
                                           const bearing::dynamics::DynamicsParameters& parameters,
                                           const SteadyStateOptions& options);

}  // namespace orbearing::integration
