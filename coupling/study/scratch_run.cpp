#include "coupling/study/scratch_run.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>

#include "coupling/integration/integrate_switches.hpp"

namespace orbearing::study {

namespace {

using bearing::defect::ScratchedMotion;
using ConstState = Eigen::Ref<const Eigen::VectorXd>;

constexpr double kHalfTurn = boost::math::double_constants::pi;

integration::IntegrationOptions options_for(const ScratchedMotion& motion, const Sampling& sampling) {
  const double angular = 2.0 * kHalfTurn * motion.static_place().natural_frequency;
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

// What an instrument has before it samples: a low-pass, here the windowed sine of Blackman over samples taken
// more often. Forces that jump would else show as lines where none are.
class LowPass {
 public:
  static constexpr long kOversampling = 8;
  static constexpr long kReach = 16;  // samples to each side that one takes part in

  LowPass() : weight_(2 * kReach * kOversampling + 1), last_(2, weight_.size()) {
    constexpr double middle =
        0.42;  // of the fall from 1 to 0, over the sampling rate: between a third and a half
    const auto reach = static_cast<double>(kReach * kOversampling);
    for (Eigen::Index k = 0; k < weight_.size(); ++k) {
      const double at = static_cast<double>(k) - reach, turn = kHalfTurn * at / reach;
      const double blackman = 0.42 + 0.5 * std::cos(turn) + 0.08 * std::cos(2.0 * turn);
      weight_[k] = blackman * boost::math::sinc_pi(2.0 * kHalfTurn * middle * at / kOversampling);
    }
    weight_ /= weight_.sum();
    last_.setZero();
  }

  void take(const Eigen::Vector2d& value) {
    last_.col(next_) = value.array();
    next_ = (next_ + 1) % last_.cols();
  }

  /// The value `kReach` samples ago.
  Eigen::Array2d value() const {
    const Eigen::Index old = last_.cols() - next_;  // how many stand at the end of the store
    return (last_.rightCols(old).matrix() * weight_.head(old).matrix() +
            last_.leftCols(next_).matrix() * weight_.tail(next_).matrix())
        .array();
  }

 private:
  Eigen::ArrayXd weight_;
  Eigen::Array2Xd last_;
  Eigen::Index next_ = 0;
};

class Recorder {
 public:
  Recorder(const ScratchedMotion& motion, long settling, RingVibration& into)
      : motion_(motion), settling_(settling), into_(into), rates_(4) {}

  void operator()(double time, const ConstState& x) {
    motion_.rates(time, x, rates_);
    low_pass_.take(rates_.tail<2>());
    if (++taken_ % LowPass::kOversampling != 0) return;
    const Eigen::Index now = taken_ / LowPass::kOversampling - settling_ - LowPass::kReach;
    if (now >= 0 && now < into_.ball_load.size()) put_state(now, time, x);
    const Eigen::Index before = now - LowPass::kReach;
    if (before >= 0 && before < into_.ball_load.size()) into_.acceleration.col(before) = low_pass_.value();
  }

 private:
  void put_state(Eigen::Index sample, double time, const ConstState& x) {
    into_.place.col(sample) = x.head<2>().array();
    const ScratchedMotion::Contact first = motion_.contact(0, time, x);
    into_.ball_approach[sample] = first.approach;
    into_.ball_load[sample] = first.load;
    for (Eigen::Index j = 0; j < motion_.elements(); ++j)
      into_.largest_load = std::max(into_.largest_load, motion_.contact(j, time, x).load);
  }

  const ScratchedMotion& motion_;
  long settling_;
  RingVibration& into_;
  Eigen::VectorXd rates_;
  LowPass low_pass_;
  long taken_ = 0;
};

}  // namespace

RingVibration sample_vibration(const bearing::defect::ScratchedBearing& scratched, const Sampling& sampling) {
  ScratchedMotion motion(scratched);
  const double revolution = 2.0 * kHalfTurn / std::abs(scratched.shaft_speed);  // [s]
  const long settling = std::lround(sampling.settling_revolutions * revolution * sampling.rate);
  const long samples = std::max(2L, std::lround(sampling.revolutions * revolution * sampling.rate));
  RingVibration vibration{.rate = sampling.rate,
                          .begin = static_cast<double>(settling + LowPass::kReach) / sampling.rate};
  vibration.place.resize(2, samples);
  vibration.acceleration.resize(2, samples);
  vibration.ball_approach.resize(samples);
  vibration.ball_load.resize(samples);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(4);
  x.head<2>() = motion.static_place().place;
  const auto rates = [&motion](double time, const ConstState& at, Eigen::Ref<Eigen::VectorXd> dx) {
    motion.rates(time, at, dx);
  };
  Recorder record(motion, settling, vibration);
  vibration.report = integration::integrate_switches(
      rates, x,
      {.interval = 1.0 / (LowPass::kOversampling * sampling.rate),
       .samples = LowPass::kOversampling * (settling + samples + 2 * LowPass::kReach)},
      switches_of(motion), options_for(motion, sampling),
      [&record](double time, const ConstState& at) { record(time, at); });
  if (vibration.report.completed) return vibration;
  return {.rate = sampling.rate, .report = vibration.report};
}

}  // namespace orbearing::study
