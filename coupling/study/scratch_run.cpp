#include "coupling/study/scratch_run.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "coupling/integration/integrate_switches.hpp"

namespace orbearing::study {

namespace {

using bearing::defect::ScratchedMotion;
using ConstState = Eigen::Ref<const Eigen::VectorXd>;

integration::IntegrationOptions options_for(const ScratchedMotion& motion, const Sampling& sampling) {
  const double angular = 2.0 * boost::math::double_constants::pi * motion.static_place().natural_frequency;
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

class Recorder {
 public:
  Recorder(const ScratchedMotion& motion, long settling, RingVibration& into)
      : motion_(motion), left_out_(settling), into_(into), rates_(4) {}

  void operator()(double time, const ConstState& x) {
    if (left_out_-- > 0) return;
    motion_.rates(time, x, rates_);
    into_.place.col(next_) = x.head<2>().array();
    into_.acceleration.col(next_) = rates_.tail<2>().array();
    const ScratchedMotion::Contact first = motion_.contact(0, time, x);
    into_.ball_approach[next_] = first.approach;
    into_.ball_load[next_] = first.load;
    for (Eigen::Index j = 0; j < motion_.elements(); ++j)
      into_.largest_load = std::max(into_.largest_load, motion_.contact(j, time, x).load);
    ++next_;
  }

 private:
  const ScratchedMotion& motion_;
  long left_out_;
  RingVibration& into_;
  Eigen::VectorXd rates_;
  Eigen::Index next_ = 0;
};

}  // namespace

RingVibration sample_vibration(const bearing::defect::ScratchedBearing& scratched, const Sampling& sampling) {
  ScratchedMotion motion(scratched);
  const double revolution = 2.0 * boost::math::double_constants::pi / std::abs(scratched.shaft_speed);  // [s]
  const long settling = std::lround(sampling.settling_revolutions * revolution * sampling.rate);
  const long samples = std::max(2L, std::lround(sampling.revolutions * revolution * sampling.rate));
  RingVibration vibration{.rate = sampling.rate};
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
      rates, x, {.interval = 1.0 / sampling.rate, .samples = settling + samples}, switches_of(motion),
      options_for(motion, sampling), [&record](double time, const ConstState& at) { record(time, at); });
  if (vibration.report.completed) return vibration;
  return {.rate = sampling.rate, .report = vibration.report};
}

}  // namespace orbearing::study
