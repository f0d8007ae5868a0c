#include "coupling/system/driven_bearing.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "bearing/motion/driven_start.hpp"
#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/integration/window.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/driven_system.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/force_left.hpp"

namespace orbearing::system {

// All that the future of a driven bearing depends on.
struct DrivenState {
  std::vector<double> x;                // padded
  double step = 1e-6;                   // [s]    to try next
  double angle = 0.0;                   // [rad]  of the bore
  double carrier_angle = 0.0;           // [rad]  turned by the carrier
  double turned = 0.0;                  // [rad]  there and back
  double step_before = 0.0;             // [s]    half of it is not counted yet
  double start_x = 0.0, start_y = 0.0;  // [m]  of the bore under the start load
  bearing::motion::DamageSums sums{0};

  // Every number in turn, for `visit(double* first, size)`.
  template <class Visit>
  void each(Visit visit) {
    for (double* one : {&step, &angle, &carrier_angle, &turned, &step_before, &start_x, &start_y})
      visit(one, 1);
    visit(x.data(), static_cast<long>(x.size()));
    sums.each(visit);
  }
};

namespace {

using bearing::motion::BearingModel;
using bearing::motion::BoreMotion;
using bearing::motion::BoreReaction;
using bearing::motion::DamageSums;
using bearing::motion::Snapshot;
using bearing::vectorised::VectorBearing;
using mechanics::require;

// Step of central differences: far below what the laws see, far above round-off.
constexpr double kSpeedStep = 1e-3;  // [rad/s]

void check_numbers(const DrivenBearingSetup& setup) {
  require(std::isfinite(setup.orbit_radius) && setup.orbit_radius >= 0.0, "orbit radius [m]",
          setup.orbit_radius, "0 or more");
  require(std::isfinite(setup.first_roller), "angle of the first roller [rad]", setup.first_roller,
          "a finite number");
  require(std::isfinite(setup.reduction_factor) && setup.reduction_factor > 0.0,
          "reduction factor of the life [-]", setup.reduction_factor, "more than 0");
  require(std::isfinite(setup.allowed_length_error) && setup.allowed_length_error > 0.0,
          "allowed length error [m]", setup.allowed_length_error, "more than 0");
  require(setup.bins >= 1, "bins on the races", static_cast<double>(setup.bins), "at least 1");
  const double tilt = setup.bore_tilt.norm();
  require(std::isfinite(tilt), "tilt of the bore [rad]", tilt, "a finite number");
  require(tilt == 0.0 || setup.bearing.rollers().laminae > 0, "tilt of the bore [rad]", tilt,
          "0 without laminae, which alone it acts on");
  require(setup.start_load.allFinite(), "load at the start [N]", setup.start_load.norm(), "a finite number");
  require(setup.most_steps >= 1, "largest number of steps", static_cast<double>(setup.most_steps),
          "at least 1");
}

void check_effects(const bearing::motion::DynamicsParameters& dynamics) {
  require(dynamics.driving.ramp == 0.0, "speed ramp [1/s]", dynamics.driving.ramp,
          "0, since the speeds are inputs");
  require(dynamics.excitation.harmonics.empty(), "harmonics of a mesh excitation",
          static_cast<double>(dynamics.excitation.harmonics.size()), "none, since the motion is an input");
}

bool finite(const InputPolynomial& polynomial) {
  return std::all_of(polynomial.coefficient.begin(), polynomial.coefficient.end(),
                     [](double c) { return std::isfinite(c); });
}

void require_finite(const BoreInputs& inputs) {
  const std::pair<const char*, const InputPolynomial*> all[] = {
      {"x [m]", &inputs.x},
      {"y [m]", &inputs.y},
      {"v_x [m/s]", &inputs.v_x},
      {"v_y [m/s]", &inputs.v_y},
      {"speed [rad/s]", &inputs.speed},
      {"carrier speed [rad/s]", &inputs.carrier_speed},
      {"carrier acceleration [rad/s^2]", &inputs.carrier_acceleration}};
  for (const auto& [name, polynomial] : all)
    if (!finite(*polynomial))
      throw std::runtime_error(std::string("driven bearing: the input ") + name +
                               " is not finite; required: finite numbers");
}

void require_finite(const bearing::motion::BoreMotion& motion) {
  const bool holds = motion.position.allFinite() && motion.velocity.allFinite() &&
                     motion.acceleration.allFinite() && std::isfinite(motion.speed) &&
                     std::isfinite(motion.carrier_speed) && std::isfinite(motion.carrier_acceleration);
  if (!holds)
    throw std::runtime_error(
        "driven bearing: the motion of bore and carrier is not finite; required: finite numbers");
}

namespace bearing_input {
enum Position : std::size_t {
  x,
  y,
  velocity_x,
  velocity_y,
  planet_speed,
  carrier_speed,
  carrier_acceleration
};
}

std::vector<Input> bearing_inputs(const DrivenBearingSetup& setup) {
  using namespace bearing_input;
  const std::string goes_on = "; inside a step it continues with ";
  const auto displacement = [&](const char* axis, const char* sense) {
    return std::string("displacement of the planet's axis from that of its undeformed pin, ") + sense +
           goes_on + "planet.velocity." + axis;
  };
  return {
      {"planet.displacement.x", "m", displacement("x", "outward"), setup.start_displacement.x(), velocity_x},
      {"planet.displacement.y", "m", displacement("y", "in the sense of carrier rotation"),
       setup.start_displacement.y(), velocity_y},
      {"planet.velocity.x", "m/s", "slope of planet.displacement.x by time"},
      {"planet.velocity.y", "m/s", "slope of planet.displacement.y by time"},
      {"planet.speed", "rad/s", "speed of the planet about its axis, relative to the carrier",
       setup.planet_speed},
      {"carrier.speed", "rad/s", "speed of the carrier" + goes_on + "carrier.acceleration",
       setup.carrier_speed, carrier_acceleration},
      {"carrier.acceleration", "rad/s2", "slope of carrier.speed by time"}};
}

// The bore's motion acts at once on what rolls on it; the rest only through its own motion.
std::vector<Output> bearing_outputs(int rollers, bool caged) {
  using namespace bearing_input;
  using Inputs = std::vector<std::size_t>;
  const Inputs none, rotating{planet_speed}, bore{x, y, velocity_x, velocity_y, planet_speed};
  const Inputs all{x, y, velocity_x, velocity_y, planet_speed, carrier_speed, carrier_acceleration};
  const Inputs speeds{planet_speed, carrier_speed, carrier_acceleration};
  std::vector<Output> outputs{
      {"force.x", "N", "force of the bearing on the planet, outward", bore, all},
      {"force.y", "N", "force of the bearing on the planet, in the sense of carrier rotation", bore, all},
      {"moment", "N.m", "moment of the bearing on the planet about its axis", bore, all},
      {"life_used", "1", "revolutions so far over the life of Lundberg and Palmgren under the loads so far",
       none, none, false},
      caged ? Output{"cage.slip", "1", "1 - speed of the cage over that at pure rolling", rotating, rotating}
            : Output{"rollers.slip", "1", "1 - mean orbital speed of the rollers over that at pure rolling",
                     rotating, rotating},
      caged ? Output{"cage.speed", "rad/s", "speed of the cage relative to the carrier", none, rotating}
            : Output{"rollers.speed", "rad/s", "mean orbital speed of the rollers relative to the carrier",
                     none, rotating},
      {"revolutions", "1", "revolutions of the planet relative to the carrier since the start", none, none,
       false},
      {"friction_loss", "W", "power lost to friction", bore, all},
      {"planet.start_displacement.x", "m",
       "displacement under which the bearing carries its start load: where to put the planet, outward", none,
       speeds},
      {"planet.start_displacement.y", "m", "the same in the sense of carrier rotation", none, speeds}};
  for (int i = 1; i <= rollers; ++i) {
    const std::string roller = "roller[" + std::to_string(i) + "].";
    outputs.push_back({roller + "inner_load", "N", "load between roller and pin", none, all});
    outputs.push_back({roller + "outer_load", "N", "load between roller and planet", bore, all});
    outputs.push_back({roller + "angle", "rad",
                       "position of the roller, from outward towards carrier rotation", none, none});
  }
  return outputs;
}

constexpr double kVersion = 6.0;

DrivenBearingSetup without_start(DrivenBearingSetup setup) {
  setup.start_load.setZero();
  return setup;
}

}  // namespace

void require_length(const Window& window) {
  if (std::isfinite(window.begin) && std::isfinite(window.end) && window.length() > 0.0) return;
  std::ostringstream text;
  text << "driven bearing: found a window from " << window.begin << " s to " << window.end
       << " s; required: an end after the beginning";
  throw std::runtime_error(text.str());
}

BearingModel driven_model(const DrivenBearingSetup& setup) {
  check_numbers(setup);
  check_effects(setup.dynamics);
  bearing::OperatingPoint point;
  point.carrier.orbit_radius = setup.orbit_radius;
  point.bore_tilt = setup.bore_tilt;
  point.outer_race = setup.outer_race;
  return bearing_model(setup.bearing, point, setup.dynamics);
}

struct DrivenBearing::Inside {
  DrivenBearingSetup setup;
  BearingModel model;
  VectorBearing vectorised;
  integration::Rosenbrock2 stepper;
  system::LoadsAtStep loads;
  DrivenState state, backup;
  std::vector<double> at_instant, rate;  // padded

  explicit Inside(const DrivenBearingSetup& given)
      : setup(given),
        model(driven_model(given)),
        vectorised(model),
        stepper(system::linearly_implicit_errors(vectorised,
                                                 system::allowed_errors(model, setup.allowed_length_error)),
                system::longest_step(model)),
        loads(given.bearing.rollers().count),
        at_instant(static_cast<std::size_t>(vectorised.layout().size())),
        rate(at_instant) {
    state.sums = no_damage();
    set(Eigen::VectorXd::Zero(model.layout.size()));
  }

  DamageSums no_damage() const { return DamageSums(setup.bins, uneven_laminae(cut_races(model))); }

  void set(const Eigen::VectorXd& x) { state.x = vectorised.padded(x); }
  Eigen::VectorXd flat() const {
    Eigen::VectorXd x(model.layout.size());
    vectorised.flatten(state.x.data(), x);
    return x;
  }

  // Header in which saved states must agree: version, rollers, bins, waves, cage.
  std::vector<double> head() const {
    return {kVersion, static_cast<double>(setup.bearing.rollers().count), static_cast<double>(setup.bins),
            static_cast<double>(model.layout.waves), setup.bearing.has_cage() ? 1.0 : 0.0};
  }

  BoreMotion here(BoreMotion motion) const {
    motion.angle = state.angle;
    motion.carrier_angle = state.carrier_angle;
    return motion;
  }

  void run(double length, const BoreInputs& inputs) {
    const InputPolynomial angle = integral(state.angle, inputs.speed);
    const integration::WindowLimits limits{.most_steps = setup.most_steps};
    loads.step_before = state.step_before;
    DrivenSystem system(vectorised, inputs, {state.angle, state.carrier_angle}, loads, &state.sums);
    system.settle(0.0, state.x);
    integration::through_window(stepper, system, state.x, length, limits, state.step);
    state.step_before = loads.step_before;
    state.turned += std::abs(angle.at(length) - state.angle);
    state.angle = angle.at(length);
    state.carrier_angle = integral(state.carrier_angle, inputs.carrier_speed).at(length);
    const std::string reason = system::out_of_place(model, flat());
    if (!reason.empty()) throw std::runtime_error("driven bearing: " + reason);
  }

  // The vectorised bearing with the bore motion `motion`; `linear` keeps slopes.
  BoreReaction evaluate(const BoreMotion& motion, bool linear) {
    at_instant = state.x;
    double* bore = at_instant.data() + vectorised.layout().bore();
    std::copy_n(motion.position.data(), 2, bore);
    std::copy_n(motion.velocity.data(), 2, bore + 2);
    if (linear)
      vectorised.linearise(motion, at_instant.data(), rate.data());
    else
      vectorised.derivative(motion, at_instant.data(), rate.data());
    return vectorised.reaction();
  }
  BoreReaction reaction(const BoreMotion& motion) { return evaluate(motion, false); }

  // Central difference of the force by the number that `move` changes.
  template <class Move>
  Eigen::Vector2d slope(const BoreMotion& motion, double step, Move move) {
    BoreMotion less = motion, more = motion;
    move(less) -= step;
    move(more) += step;
    return (reaction(more).force - reaction(less).force) / (2.0 * step);
  }
};

DrivenBearing::DrivenBearing(const DrivenBearingSetup& setup)
    : Participant(bearing_inputs(setup),
                  bearing_outputs(setup.bearing.rollers().count, setup.bearing.has_cage())),
      inside_(std::make_unique<Inside>(setup)) {}
DrivenBearing::~DrivenBearing() = default;
DrivenBearing::DrivenBearing(DrivenBearing&&) noexcept = default;
DrivenBearing& DrivenBearing::operator=(DrivenBearing&&) noexcept = default;

void DrivenBearing::initialize(const BoreMotion& motion) {
  require_finite(motion);
  Inside& in = *inside_;
  const Eigen::VectorXd start =
      driven_start(in.setup.bearing, in.model, in.setup.dynamics, motion, in.setup.first_roller);
  if (!start.allFinite()) throw std::runtime_error("driven bearing: the start is not finite");
  const Eigen::Vector2d under_load = position_under(in.setup.start_load, motion);
  in.state = {};
  in.state.start_x = under_load.x();
  in.state.start_y = under_load.y();
  in.state.sums = in.no_damage();
  in.set(start);
}

// Rolling and traction add little to the static forces: their sum is taken off the required load
// until the bearing's own force is the load.
Eigen::Vector2d DrivenBearing::position_under(const Eigen::Vector2d& load, const BoreMotion& motion) const {
  constexpr int kMost = 30;
  constexpr double kEnough = 1e-9;  // [-]  of the load
  BoreMotion there = motion;
  there.position.setZero();
  there.velocity.setZero();
  if (load.norm() == 0.0) return there.position;
  DrivenBearing trial(without_start(inside_->setup));
  Eigen::Vector2d asked = load, missing = load;
  for (int i = 0; i < kMost && missing.norm() > kEnough * load.norm(); ++i) {
    const bearing::motion::PinBalance balance =
        bearing::motion::balance_pin_and_bore(inside_->setup.bearing, inside_->model, inside_->setup.dynamics,
                                              there, inside_->setup.first_roller, asked);
    if (!balance.rollers.report.converged) break;
    there.position = balance.bore;
    trial.initialize(there);
    missing = load + trial.reaction(there).force;
    asked += missing;
  }
  if (missing.norm() <= kEnough * load.norm()) return there.position;
  std::ostringstream text;
  text << "driven bearing: found no position of the bore under a load of (" << load.x() << ", " << load.y()
       << ") N at the start: " << mechanics::force_left_text(missing.norm())
       << "; required: a load that rollers and support can carry";
  throw std::runtime_error(text.str());
}

void DrivenBearing::complete(std::vector<double>& inputs, const std::vector<bool>& given) const {
  using namespace bearing_input;
  if (given[x] || given[y]) return;
  const Eigen::Vector2d position = position_under(inside_->setup.start_load, motion_of(inputs));
  inputs[x] = position.x();
  inputs[y] = position.y();
}

void DrivenBearing::advance(const Window& window, const BoreInputs& inputs) {
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
  constexpr double kLeastSpeed = 1e-9;  // [rad/s]  below it nothing turns
  Inside& in = *inside_;
  const BoreMotion here = in.here(motion);
  const Snapshot now = driven_snapshot(in.model, here, in.flat());
  const double kinematic = kinematic_cage_speed(in.model.geometry, 0.0, motion.speed);
  const double revolutions = in.state.turned / constants::two_pi;
  return {.reaction = in.reaction(here),
          .cage_speed = now.orbit_speed,
          .cage_slip = std::abs(kinematic) > kLeastSpeed ? 1.0 - now.orbit_speed / kinematic : 0.0,
          .life_used = revolutions / in.state.sums.life(in.setup.bearing, in.setup.reduction_factor).bearing,
          .revolutions = revolutions,
          .friction_loss = now.loss.total(),
          .inner_load = {now.inner.load.begin(), now.inner.load.end()},
          .outer_load = {now.outer.load.begin(), now.outer.load.end()},
          .roller_angle = {now.angle.begin(), now.angle.end()}};
}

void DrivenBearing::take_snapshot(const BoreMotion& motion, Snapshot& into) const {
  into = driven_snapshot(inside_->model, inside_->here(motion), inside_->flat());
}

Eigen::VectorXd DrivenBearing::state() const {
  return inside_->flat();
}

void DrivenBearing::collect_loads(bearing::motion::StatisticsCollector* collector) {
  inside_->loads.collector = collector;
}

ForceSlopes DrivenBearing::slopes(const BoreMotion& motion) const {
  Inside& in = *inside_;
  const BoreMotion here = in.here(motion);
  ForceSlopes slopes;
  in.evaluate(here, true);
  const bearing::vectorised::BoreSlopes exact = in.vectorised.bore_slopes();
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k) {
      slopes.by_displacement(i, k) = exact.by_position[i][k];
      slopes.by_velocity(i, k) = exact.by_velocity[i][k];
    }
  slopes.by_speed = in.slope(here, kSpeedStep, [](BoreMotion& m) -> double& { return m.speed; });
  return slopes;
}

void DrivenBearing::save(SavedState& state) const {
  state = saved_state(inside_->head(), inside_->state);
}

void DrivenBearing::restore(const SavedState& state) {
  restore_state(state, "driven bearing", inside_->head(), inside_->state);
}

BoreMotion DrivenBearing::motion_of(const std::vector<double>& in) {
  using namespace bearing_input;
  BoreMotion motion;
  motion.position = {in[x], in[y]};
  motion.velocity = {in[velocity_x], in[velocity_y]};
  motion.speed = in[planet_speed];
  motion.carrier_speed = in[carrier_speed];
  motion.carrier_acceleration = in[carrier_acceleration];
  return motion;
}

void DrivenBearing::initialize(double, const std::vector<double>& inputs) {
  initialize(motion_of(inputs));
}

void DrivenBearing::advance(const Window& window, const std::vector<InputPolynomial>& in) {
  using namespace bearing_input;
  advance(window, BoreInputs{.x = in[x],
                             .y = in[y],
                             .v_x = in[velocity_x],
                             .v_y = in[velocity_y],
                             .speed = in[planet_speed],
                             .carrier_speed = in[carrier_speed],
                             .carrier_acceleration = in[carrier_acceleration]});
}

std::vector<double> DrivenBearing::values(const std::vector<double>& inputs, std::size_t number) const {
  const BoreMotion motion = motion_of(inputs);
  constexpr std::size_t of_reaction = 3;
  if (number <= of_reaction) {
    const BoreReaction now = reaction(motion);
    return {now.force.x(), now.force.y(), now.moment};
  }
  const DrivenBearingOutput now = output(motion);
  std::vector<double> values{now.reaction.force.x(), now.reaction.force.y(), now.reaction.moment,
                             now.life_used,          now.cage_slip,          now.cage_speed,
                             now.revolutions,        now.friction_loss,      inside_->state.start_x,
                             inside_->state.start_y};
  for (std::size_t i = 0; i < now.inner_load.size(); ++i)
    values.insert(values.end(), {now.inner_load[i], now.outer_load[i], now.roller_angle[i]});
  return values;
}

// Those of the force exactly, all others by central differences, with steps far below what changes a contact
// and far above round-off.
std::vector<double> DrivenBearing::slopes(const std::vector<double>& inputs, std::size_t input) const {
  using namespace bearing_input;
  constexpr double kLength = 1e-9, kVelocity = 1e-5, kSpeed = 1e-3;  // [m], [m/s], [rad/s]
  const double step = input < velocity_x ? kLength : input < planet_speed ? kVelocity : kSpeed;
  std::vector<double> moved = inputs;
  moved[input] = inputs[input] + step;
  std::vector<double> by = values(moved, outputs().size());
  moved[input] = inputs[input] - step;
  const std::vector<double> below = values(moved, outputs().size());
  for (std::size_t i = 0; i < by.size(); ++i) by[i] = (by[i] - below[i]) / (2.0 * step);
  if (input > planet_speed) return by;
  const ForceSlopes force = slopes(motion_of(inputs));
  const Eigen::Vector2d column = input < velocity_x ? force.by_displacement.col(static_cast<int>(input - x))
                                 : input < planet_speed
                                     ? force.by_velocity.col(static_cast<int>(input - velocity_x))
                                     : force.by_speed;
  by[0] = column.x();
  by[1] = column.y();
  return by;
}

}  // namespace orbearing::system
