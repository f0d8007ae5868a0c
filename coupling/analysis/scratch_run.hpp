// The vibration of a bearing with scratches, sampled as an instrument would.
#pragma once

#include <Eigen/Core>

#include <functional>

#include "bearing/defect/scratched_bearing.hpp"
#include "bearing/defect/scratched_elements.hpp"
#include "coupling/analysis/signal_rows.hpp"
#include "coupling/integration/integration_options.hpp"
#include "mechanics/described.hpp"

namespace orbearing::analysis {

/// Sampling of the motion.
struct Sampling {
  double rate = 51200.0;              // [Hz]
  double revolutions = 50.0;          // [-]  of the shaft
  double settling_revolutions = 2.0;  // [-]  left out before
  double length_error = 1e-14;        // [m]  of a step
  double run_up_from = 1.0;           // [-]  share of the speed at which the motion begins; it ends at 1
};

template <class Visitor>
void describe(Visitor& visit, Sampling& m) {
  using namespace described;
  members(
      visit, m, sampling_rate_row(m.rate),
      input(m.revolutions, "signal.revolutions",
            "sampled revolutions of the shaft; frequency resolution: its speed divided by this number",
            {.range = {2.0, 1e5},
             .reason = "lines a fiftieth of the shaft's frequency apart",
             .numerical = true}),
      input(
          m.settling_revolutions, "signal.settling_revolutions",
          "revolutions of the shaft before sampling, in which the start transient decays",
          {.range = {0.0, 1e5}, .reason = "hundreds of periods of the ring's vibration", .numerical = true}),
      input(m.length_error, "signal.length_error", "allowed error of the ring's position in one step",
            {.dimension = dimension::length,
             .range = {1e-16, 1e-3},
             .reason = "the vibration of a sound bearing exceeds the error of its sampled acceleration",
             .written = "mm",
             .numerical = true}),
      run_up_row(m.run_up_from));
}

/// The ring's motion at equal times; position and acceleration along the load and across it. The acceleration
/// has passed the low-pass of an instrument, which takes off what lies above a third of the rate.
struct RingVibration {
  double rate = 0.0;             // [Hz]
  double begin = 0.0;            // [s]  of the first sample, since the motion began
  Eigen::Array2Xd position;      // [m]      (directions, samples)
  Eigen::Array2Xd acceleration;  // [m/s^2]  (directions, samples)
  Eigen::ArrayXd ball_approach;  // [m]      of the first element, negative where it is free
  Eigen::ArrayXd ball_load;      // [N]      of the first element, with damping
  double largest_load = 0.0;     // [N]      of any element at any sample; on the inner race
  Eigen::ArrayXd shaft_angle;    // [rad]    since the motion began
  double shaft_speed = 0.0;      // [rad/s]  mean while sampled
  double cage_speed = 0.0;       // [rad/s]  mean while sampled
  integration::IntegrationReport report;
};

/// The run-up of `sampling`: settling and sampled revolutions take as long as they do at the mean speed.
bearing::defect::RunUp run_up_of(double shaft_speed, const Sampling& sampling);

/// From the static equilibrium on. A run that ends early states it in the report and has no samples.
RingVibration sample_vibration(const bearing::defect::ScratchedBearing& scratched, const Sampling& sampling);

/// The same with all that moves in a ball bearing: the balls roll and slip by themselves, the cage turns as
/// they push it. `length_error` [m] may be made in one step; `progress` gets the share done, if any. Damping
/// of the ring and the allowed error of `sampling` have no effect: contacts and oil have their own.
RingVibration sample_vibration(const bearing::defect::ScratchedBearing& scratched,
                               const bearing::balls::MotionParameters& motion, double length_error,
                               const Sampling& sampling, const std::function<void(double)>& progress = {});

}  // namespace orbearing::analysis
