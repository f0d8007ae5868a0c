#include "coupling/analysis/scratch_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bearing/geometry.hpp"
#include "coupling/analysis/low_pass.hpp"
#include "coupling/integration/integrate_switches.hpp"
#include "coupling/integration/run.hpp"
#include "coupling/system/balls_in_time.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/easy_length.hpp"

namespace orbearing::analysis {

namespace {

using bearing::defect::ScratchedMotion;
using ConstState = Eigen::Ref<const Eigen::VectorXd>;

constexpr double kHalfTurn = constants::pi;

integration::IntegrationOptions options_for(const ScratchedMotion& motion, const Sampling& sampling) {
  const double angular = 2.0 * kHalfTurn * motion.static_position().natural_frequency;
  integration::IntegrationOptions options;
  options.step = 0.05 / angular;
  options.allowed_error = Eigen::Vector4d(1.0, 1.0, angular, angular) * sampling.length_error;
  return options;
}

integration::Switches switches_of(ScratchedMotion& motion) {
  constexpr double steps_in_a_scratch = 4.0;
  const double passing = motion.passing_time();
  return {.count = motion.switches(),
          .values = [&motion](double time, const ConstState& x,
                              Eigen::Ref<Eigen::ArrayXd> values) { motion.switch_values(time, x, values); },
          .set = [&motion](Eigen::Index which, bool positive) { motion.set_switch(which, positive); },
          .largest_step = std::isfinite(passing) ? passing / steps_in_a_scratch : 0.0};
}

using LowPass = InstrumentLowPass<2>;

// Contribution of one instant to the signal.
struct Instant {
  Eigen::Vector2d position, acceleration;
  double ball_approach = 0.0, ball_load = 0.0, largest_load = 0.0;
};

// Counts instants, kOversampling to a sample, and keeps what falls into the signal.
class Recorder {
 public:
  Recorder(long settling, long samples, double rate, RingVibration& into) : settling_(settling), into_(into) {
    into_.rate = rate;
    into_.begin = static_cast<double>(settling + LowPass::kReach) / rate;
    into_.position.resize(2, samples);
    into_.acceleration.resize(2, samples);
    into_.ball_approach.resize(samples);
    into_.ball_load.resize(samples);
  }

  long instants() const {
    return LowPass::kOversampling * (settling_ + into_.ball_load.size() + 2 * LowPass::kReach);
  }
  double interval() const { return 1.0 / (static_cast<double>(LowPass::kOversampling) * into_.rate); }

  /// `state` gives all of the Instant but its acceleration; it is called only for samples that are kept.
  template <class State>
  void take(const Eigen::Vector2d& acceleration, const State& state) {
    low_pass_.take(acceleration);
    if (++taken_ % LowPass::kOversampling != 0) return;
    const Eigen::Index now = taken_ / LowPass::kOversampling - settling_ - LowPass::kReach;
    if (now >= 0 && now < into_.ball_load.size()) keep(now, state());
    const Eigen::Index before = now - LowPass::kReach;
    if (before >= 0 && before < into_.ball_load.size()) into_.acceleration.col(before) = low_pass_.value();
  }

 private:
  void keep(Eigen::Index sample, const Instant& now) {
    into_.position.col(sample) = now.position.array();
    into_.ball_approach[sample] = now.ball_approach;
    into_.ball_load[sample] = now.ball_load;
    into_.largest_load = std::max(into_.largest_load, now.largest_load);
  }

  long settling_;
  RingVibration& into_;
  LowPass low_pass_;
  long taken_ = 0;
};

Recorder recorder_of(double shaft_speed, const Sampling& sampling, RingVibration& into) {
  const double revolution = 2.0 * kHalfTurn / std::abs(shaft_speed);  // [s]
  double settling = sampling.settling_revolutions * revolution,
         sampled = sampling.revolutions * revolution;  // [s]
  if (sampling.run_up_from < 1.0) {
    const bearing::defect::RunUp run_up = run_up_of(shaft_speed, sampling);
    // Root of RunUp::turned_at.
    const double from = run_up.from;
    settling *= 2.0 / (from + std::sqrt(from * from + 2.0 * (1.0 - from) * settling / run_up.time));
    sampled = run_up.time - settling;
  }
  long samples = std::max(2L, std::lround(sampled * sampling.rate));
  if (sampling.run_up_from < 1.0) samples = mechanics::easy_length_within(samples);
  return {std::lround(settling * sampling.rate), samples, sampling.rate, into};
}

// Angle and speed of the shaft during the samples of `vibration`.
void add_shaft(const bearing::defect::ScratchedBearing& scratched, RingVibration& vibration) {
  const Eigen::Index samples = vibration.ball_load.size();
  vibration.shaft_angle.resize(samples);
  for (Eigen::Index k = 0; k < samples; ++k)
    vibration.shaft_angle[k] =
        scratched.shaft_speed *
        scratched.run_up.turned_at(vibration.begin + static_cast<double>(k) / vibration.rate);
  vibration.shaft_speed = scratched.shaft_speed;
  if (scratched.run_up.time > 0.0)
    vibration.shaft_speed = (vibration.shaft_angle[samples - 1] - vibration.shaft_angle[0]) * vibration.rate /
                            static_cast<double>(samples - 1);
}

Instant state_of(const ScratchedMotion& motion, double time, const ConstState& x) {
  const ScratchedMotion::Contact first = motion.contact(0, time, x);
  Instant now{.position = x.head<2>(), .ball_approach = first.approach, .ball_load = first.load};
  for (Eigen::Index j = 0; j < motion.elements(); ++j)
    now.largest_load = std::max(now.largest_load, motion.contact(j, time, x).load);
  return now;
}

Eigen::Vector2d along_load(const double* outer) {
  return {-outer[0], -outer[1]};
}

Instant state_of(const bearing::balls::BallBearing& model, double time, const double* x) {
  const bearing::balls::BallSnapshot shown = model.snapshot(time, x);
  Instant now{.position = along_load(x + model.layout().outer()),
              .ball_approach = shown.inner.front().approach + shown.outer.front().approach,
              .ball_load = shown.inner.front().load};
  for (const bearing::balls::ContactSnapshot& contact : shown.inner)
    now.largest_load = std::max(now.largest_load, contact.load);
  return now;
}

}  // namespace

bearing::defect::RunUp run_up_of(double shaft_speed, const Sampling& sampling) {
  if (!(sampling.run_up_from < 1.0)) return {};
  const double angle = 2.0 * kHalfTurn * (sampling.settling_revolutions + sampling.revolutions);
  return {sampling.run_up_from, angle / (0.5 * (1.0 + sampling.run_up_from) * std::abs(shaft_speed))};
}

RingVibration sample_vibration(const bearing::defect::ScratchedBearing& given, const Sampling& sampling) {
  bearing::defect::ScratchedBearing scratched = given;
  scratched.run_up = run_up_of(given.shaft_speed, sampling);
  ScratchedMotion motion(scratched);
  RingVibration vibration;
  Recorder record = recorder_of(scratched.shaft_speed, sampling, vibration);
  add_shaft(scratched, vibration);
  vibration.cage_speed =
      bearing::kinematic_cage_speed(geometry_of(scratched.bearing), vibration.shaft_speed, 0.0);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(4), now(4);
  x.head<2>() = motion.static_position().position;
  const auto rates = [&motion](double time, const ConstState& at, Eigen::Ref<Eigen::VectorXd> dx) {
    motion.rates(time, at, dx);
  };
  vibration.report = integration::integrate_switches(
      rates, x, {.interval = record.interval(), .samples = record.instants()}, switches_of(motion),
      options_for(motion, sampling), [&](double time, const ConstState& at) {
        motion.rates(time, at, now);
        record.take(now.tail<2>(), [&] { return state_of(motion, time, at); });
      });
  if (vibration.report.completed) return vibration;
  return {.rate = sampling.rate, .report = vibration.report};
}

RingVibration sample_vibration(const bearing::defect::ScratchedBearing& given,
                               const bearing::balls::MotionParameters& parameters, double length_error,
                               const Sampling& sampling, const std::function<void(double)>& progress) {
  constexpr long kShown = 100;  // times that progress is reported
  bearing::defect::ScratchedBearing scratched = given;
  scratched.run_up = run_up_of(given.shaft_speed, sampling);
  bearing::balls::BallBearing model(scratched_numbers(scratched, parameters), scratched_duty(scratched));
  const bearing::balls::StateLayout layout = model.layout();
  RingVibration vibration;
  Recorder record = recorder_of(scratched.shaft_speed, sampling, vibration);
  add_shaft(scratched, vibration);
  system::BallsInTime balls(start_state(scratched.bearing, model, scratched.bearing.first_element),
                            system::ball_stepper(model.numbers(), length_error, system::kStepsOfVibration));
  const std::vector<double>& x = balls.state();
  std::vector<double> now(x.size());
  system::BallEquations system(model);
  integration::IntegrationOptions limits;
  limits.most_seconds = std::numeric_limits<double>::infinity();
  integration::Run budget(limits, vibration.report);
  const auto cage_turn = static_cast<std::size_t>(layout.cage() + 5);
  const long instants = record.instants(), shown = std::max(1L, instants / kShown);
  double sampled_from = 0.0, turned_then = 0.0;
  bool sampled = false;
  try {
    for (long i = 1; i <= instants; ++i) {
      const double time = static_cast<double>(i) * record.interval();
      balls.advance(system, time, budget, vibration.report);
      system::require_containment(model.numbers(), x.data());
      model.derivative(time, x.data(), now.data());
      record.take(along_load(now.data() + layout.outer() + bearing::balls::kRingUnknowns), [&] {
        if (!std::exchange(sampled, true)) sampled_from = time, turned_then = x[cage_turn];
        return state_of(model, time, x.data());
      });
      if (progress && i % shown == 0) progress(static_cast<double>(i) / static_cast<double>(instants));
    }
    vibration.report.completed = true;
  } catch (const std::runtime_error& error) {
    return {.rate = sampling.rate, .report = {.message = error.what()}};
  }
  vibration.report.wall_seconds = budget.seconds();
  vibration.cage_speed = (x[cage_turn] - turned_then) / (balls.time() - sampled_from);
  return vibration;
}

}  // namespace orbearing::analysis
