#include "coupling/cosim/driven_bearing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "bearing/motion/driven_bore.hpp"
#include "bearing/motion/driven_start.hpp"
#include "coupling/cosim/driven_state.hpp"
#include "coupling/cosim/driven_system.hpp"
#include "coupling/integration/in_place.hpp"
#include "coupling/integration/integrate_bearing.hpp"
#include "coupling/integration/readable_window.hpp"
#include "coupling/integration/rosenbrock2.hpp"

namespace orbearing::cosim {

namespace {

using bearing::dynamics::BearingModel;
using bearing::dynamics::BoreMotion;
using bearing::dynamics::BoreReaction;
using bearing::dynamics::DamageSums;
using bearing::dynamics::Snapshot;
using bearing::fast::VectorBearing;

// Steps of central differences: far below what the laws see, far above round-off.
constexpr double kSpeedStep = 1e-3;     // [rad/s]
constexpr double kPlaceStep = 1e-10;    // [m]
constexpr double kVelocityStep = 1e-6;  // [m/s]

}  // namespace

struct DrivenBearing::Inside {
  DrivenBearingSetup setup;
  BearingModel model;
  std::optional<VectorBearing> fast;  // none where the readable equations alone know all of the model
  Eigen::VectorXd allowed;
  std::optional<integration::Rosenbrock2> stepper;
  LoadsAtStep loads;
  DrivenState state, backup;
  std::vector<double> at_instant, rate;  // padded

  explicit Inside(const DrivenBearingSetup& given)
      : setup(given), model(driven_model(given)), loads(given.bearing.rollers) {
    allowed = integration::bearing_allowed_errors(model.layout, setup.allowed_length_error,
                                                  model.geometry.pitch_radius,
                                                  integration::roller_frequency(model));
    state.sums = no_damage();
    state.flat = Eigen::VectorXd::Zero(model.layout.size());
    if (!bearing::fast::supports(model)) return;
    fast.emplace(model);
    stepper.emplace(integration::linearly_implicit_errors(*fast, allowed), integration::longest_step(model));
    at_instant.resize(static_cast<std::size_t>(fast->layout().size()));
    rate = at_instant;
    set(Eigen::VectorXd::Zero(model.layout.size()));
  }

  DamageSums no_damage() const { return DamageSums(setup.places, uneven_laminae(cut_races(model))); }

  void set(const Eigen::VectorXd& x) {
    if (fast) {
      state.x = fast->padded(x);
      state.flat.resize(0);
    } else {
      state.flat = x;
    }
  }
  Eigen::VectorXd flat() const {
    if (!fast) return state.flat;
    Eigen::VectorXd x(model.layout.size());
    fast->flatten(state.x.data(), x);
    return x;
  }

  BoreMotion here(BoreMotion motion) const {
    motion.angle = state.angle;
    return motion;
  }

  void run(double length, const BoreCourse& inputs) {
    const Course angle = integral(state.angle, inputs.speed);
    const integration::WindowLimits limits{.most_steps = setup.most_steps};
    loads.step_before = state.step_before;
    if (fast)
      run_fast(length, inputs, limits);
    else
      run_readable(length, inputs, angle, limits);
    state.step_before = loads.step_before;
    state.turned += std::abs(angle.at(length) - state.angle);
    state.angle = angle.at(length);
    const std::string reason = integration::out_of_place(model, flat());
    if (!reason.empty()) throw std::runtime_error("driven bearing: " + reason);
  }

  void run_fast(double length, const BoreCourse& inputs, const integration::WindowLimits& limits) {
    DrivenSystem system(*fast, inputs, state.angle, loads, state.sums);
    system.settle(0.0, state.x);
    integration::through_window(*stepper, system, state.x, length, limits, state.step);
  }

  void run_readable(double length, const BoreCourse& inputs, const Course& angle,
                    const integration::WindowLimits& limits) {
    const auto motion_at = [&](double time) {
      BoreMotion motion = inputs.at(time);
      motion.angle = angle.at(time);
      return motion;
    };
    const auto derivative = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                                Eigen::Ref<Eigen::VectorXd> dx) {
      driven_derivative(model, motion_at(time), x, dx);
    };
    const auto on_step = [&](double time, double step, const Eigen::Ref<const Eigen::VectorXd>& x) {
      const Snapshot now = driven_snapshot(model, motion_at(time), x);
      loads.take(loads_of(now));
      loads.count(step, state.sums);
    };
    state.flat = state_at(model, motion_at(0.0), state.flat);
    integration::through_window(derivative, state.flat, length, allowed, limits, state.step, on_step);
    state.flat = state_at(model, motion_at(length), state.flat);
  }

  // The vectorised bearing with its bore where `motion` says; `linear` keeps slopes.
  BoreReaction evaluate(const BoreMotion& motion, bool linear) {
    at_instant = state.x;
    double* bore = at_instant.data() + fast->layout().bore();
    std::copy_n(motion.position.data(), 2, bore);
    std::copy_n(motion.velocity.data(), 2, bore + 2);
    if (linear)
      fast->linearise(motion, at_instant.data(), rate.data());
    else
      fast->derivative(motion, at_instant.data(), rate.data());
    return fast->reaction();
  }
  BoreReaction reaction(const BoreMotion& motion) {
    return fast ? evaluate(motion, false) : bearing::dynamics::reaction(model, motion, state.flat);
  }

  // Central difference of the force by the number that `move` changes.
  template <class Move>
  Eigen::Vector2d slope(const BoreMotion& motion, double step, Move move) {
    BoreMotion less = motion, more = motion;
    move(less) -= step;
    move(more) += step;
    return (reaction(more).force - reaction(less).force) / (2.0 * step);
  }
};

DrivenBearing::DrivenBearing(const DrivenBearingSetup& setup) : inside_(std::make_unique<Inside>(setup)) {}
DrivenBearing::~DrivenBearing() = default;
DrivenBearing::DrivenBearing(DrivenBearing&&) noexcept = default;
DrivenBearing& DrivenBearing::operator=(DrivenBearing&&) noexcept = default;

int DrivenBearing::rollers() const {
  return inside_->setup.bearing.rollers;
}

void DrivenBearing::initialize(const BoreMotion& motion) {
  require_finite(motion);
  Inside& in = *inside_;
  const Eigen::VectorXd start =
      driven_start(in.setup.bearing, in.model, in.setup.dynamics, motion, in.setup.first_roller);
  if (!start.allFinite()) throw std::runtime_error("driven bearing: the start is not finite");
  in.state = {};
  in.state.sums = in.no_damage();
  in.set(start);
}

void DrivenBearing::advance(const Window& window, const BoreCourse& inputs) {
  require_length(window);
  require_finite(inputs);
  inside_->backup = inside_->state;
  try {
    inside_->run(window.length(), inputs);
  } catch (...) {
    inside_->state = inside_->backup;
    throw;
  }
}

BoreReaction DrivenBearing::reaction(const BoreMotion& motion) const {
  return inside_->reaction(inside_->here(motion));
}

DrivenBearingOutput DrivenBearing::output(const BoreMotion& motion) const {
  Inside& in = *inside_;
  const BoreMotion here = in.here(motion);
  return driven_output(in.model.geometry, motion.speed, driven_snapshot(in.model, here, in.flat()),
                       in.reaction(here), in.state.turned,
                       in.state.sums.life(in.setup.bearing, in.setup.lambda, kStanding).bearing);
}

void DrivenBearing::take_snapshot(const BoreMotion& motion, Snapshot& into) const {
  into = driven_snapshot(inside_->model, inside_->here(motion), inside_->flat());
}

Eigen::VectorXd DrivenBearing::state() const {
  return inside_->flat();
}

void DrivenBearing::collect_loads(bearing::dynamics::StatisticsCollector* collector) {
  inside_->loads.collector = collector;
}

ForceSlopes DrivenBearing::slopes(const BoreMotion& motion) const {
  Inside& in = *inside_;
  const BoreMotion here = in.here(motion);
  ForceSlopes slopes;
  if (in.fast) {
    in.evaluate(here, true);
    const bearing::fast::BoreSlopes exact = in.fast->bore_slopes();
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 2; ++k) {
        slopes.by_displacement(i, k) = exact.by_position[i][k];
        slopes.by_velocity(i, k) = exact.by_velocity[i][k];
      }
  } else {
    for (int k = 0; k < 2; ++k) {
      slopes.by_displacement.col(k) =
          in.slope(here, kPlaceStep, [k](BoreMotion& m) -> double& { return m.position[k]; });
      slopes.by_velocity.col(k) =
          in.slope(here, kVelocityStep, [k](BoreMotion& m) -> double& { return m.velocity[k]; });
    }
  }
  slopes.by_speed = in.slope(here, kSpeedStep, [](BoreMotion& m) -> double& { return m.speed; });
  return slopes;
}

void DrivenBearing::save(SavedState& state) const {
  const double places = static_cast<double>(inside_->setup.places), path = inside_->fast ? 1.0 : 0.0;
  write({static_cast<double>(rollers()), places, path}, inside_->state, state);
}

void DrivenBearing::restore(const SavedState& state) {
  const double places = static_cast<double>(inside_->setup.places), path = inside_->fast ? 1.0 : 0.0;
  read(state, {static_cast<double>(rollers()), places, path}, inside_->state);
}

}  // namespace orbearing::cosim
