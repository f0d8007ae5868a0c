#include "bearing/motion/vector_bearing.hpp"

#include <algorithm>

#include "bearing/motion/vectorised/engine.hpp"

namespace orbearing::bearing::vectorised {

namespace {

std::unique_ptr<Engine> make_engine([[maybe_unused]] mechanics::InstructionSet set,
                                    const Constants& constants, const RollerConstants& rollers) {
#ifdef ORBEARING_HAS_AVX512
  if (set == mechanics::InstructionSet::avx512)
    return std::unique_ptr<Engine>(avx512_engine(constants, rollers));
#endif
#ifdef ORBEARING_HAS_AVX2
  if (set == mechanics::InstructionSet::avx2) return std::unique_ptr<Engine>(avx2_engine(constants, rollers));
#endif
  return std::unique_ptr<Engine>(baseline_engine(constants, rollers));
}

}  // namespace

VectorBearing::VectorBearing(const motion::BearingModel& model, mechanics::InstructionSet set)
    : model_(model),
      given_(model_),
      set_(set),
      changes_(surroundings_change(model_)),
      now_(surroundings_at(model_, 0.0)),
      engine_(make_engine(set, given_.constants(), given_.rollers())),
      flat_state_(static_cast<std::size_t>(layout().size())),
      flat_rate_(flat_state_),
      last_state_(flat_state_),
      last_rate_(flat_state_) {}

void VectorBearing::set(const Surroundings& now) {
  now_ = now;
  engine_->set_surroundings(now);
}

void VectorBearing::derivative(double time, const double* x, double* dx) {
  const mechanics::Vector2 load = motion::bore_load(model_, time);
  if (changes_) set(surroundings_at(model_, time));
  engine_->derivative(x, load.x(), load.y(), dx);
}

void VectorBearing::linearise(double time, const double* x, double* dx) {
  const mechanics::Vector2 load = motion::bore_load(model_, time);
  if (changes_) set(surroundings_at(model_, time));
  engine_->linearise(x, load.x(), load.y(), dx);
  if (model_.driving.ramp == 0.0 && !model_.gravity.acts()) return;
  std::copy_n(x, last_state_.size(), last_state_.begin());
  std::copy_n(dx, last_rate_.size(), last_rate_.begin());
}

void VectorBearing::time_slope(double time, double* rate) {
  if (model_.driving.ramp != 0.0) {
    constexpr double kStep =
        1e-8;  // [s]  speeds and loads change little in it, and far more than by round-off
    derivative(time + kStep, last_state_.data(), rate);
    for (std::size_t i = 0; i < last_rate_.size(); ++i) rate[i] = (rate[i] - last_rate_[i]) / kStep;
    return;
  }
  std::fill(rate, rate + layout().size(), 0.0);
  const mechanics::Vector2 slope = motion::bore_load_slope(model_, time);
  rate[layout().bore() + 2] = slope.x() / model_.bore_mass;
  rate[layout().bore() + 3] = slope.y() / model_.bore_mass;
  if (model_.gravity.acts())
    add_weight_slope(carrier_angle(model_, time), model_.point.carrier.speed, last_state_.data(), rate);
}

// Gravity turns against the carrier.
void VectorBearing::add_weight_slope(double carrier_angle, double carrier_speed, const double* x,
                                     double* rate) const {
  const mechanics::Vector2 gravity = gravity_at(model_, carrier_angle);
  const double by_x = carrier_speed * gravity.y(), by_y = -carrier_speed * gravity.x();
  const int lanes = layout().lanes();
  for (int j = 0; j < layout().rollers; ++j) {
    const mechanics::Vector2 outward = mechanics::direction(x[lanes + j]);
    rate[2 * lanes + j] += by_x * outward.x() + by_y * outward.y();
    rate[3 * lanes + j] += (by_y * outward.x() - by_x * outward.y()) / x[j];
  }
  const auto add = [&](int velocity) {
    rate[velocity] += by_x;
    rate[velocity + 1] += by_y;
  };
  if (layout().caged) add(layout().cage() + 3);
  add(layout().pin() + 2);
}

void VectorBearing::derivative(double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                               Eigen::Ref<Eigen::VectorXd> dx) {
  given_.pad(x, flat_state_.data());
  derivative(time, flat_state_.data(), flat_rate_.data());
  given_.flatten(flat_rate_.data(), dx);
}

void VectorBearing::derivative(const motion::BoreMotion& motion, const double* x, double* dx) {
  set(surroundings_of(model_, motion));
  engine_->derivative(x, 0.0, 0.0, dx);
  std::copy_n(motion.acceleration.data(), 2, dx + layout().bore() + 2);
}

void VectorBearing::linearise(const motion::BoreMotion& motion, const double* x, double* dx) {
  set(surroundings_of(model_, motion));
  engine_->linearise(x, 0.0, 0.0, dx);
  std::copy_n(motion.acceleration.data(), 2, dx + layout().bore() + 2);
}

motion::BoreReaction VectorBearing::derivative(const motion::BoreMotion& motion,
                                               const Eigen::Ref<const Eigen::VectorXd>& x,
                                               Eigen::Ref<Eigen::VectorXd> dx) {
  given_.pad(x, flat_state_.data());
  double* bore = flat_state_.data() + layout().bore();
  std::copy_n(motion.position.data(), 2, bore);
  std::copy_n(motion.velocity.data(), 2, bore + 2);
  derivative(motion, flat_state_.data(), flat_rate_.data());
  given_.flatten(flat_rate_.data(), dx);
  return reaction();
}

motion::BoreReaction VectorBearing::reaction() const {
  const BoreForces forces = engine_->bore_forces();
  return {{forces.x, forces.y}, forces.moment};
}

}  // namespace orbearing::bearing::vectorised
