#include "coupling/system/monolithic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "coupling/integration/integrate_pieces.hpp"
#include "coupling/integration/window.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "gearset/dynamics/snapshot.hpp"

namespace orbearing::system {

namespace {

using bearing::motion::BoreMotion;
using bearing::motion::Snapshot;

constexpr double kFirstStep = 1e-6;  // [s]
// Errors that linearly implicit steps may make in the gears, over those of dopri5.
constexpr double kGearErrorFactor = 100.0;
constexpr double kLongestPiece = 1.0;  // [s]  where nothing jumps

// The same of steps of order 4, whose error estimate holds all that the equations have beyond linear ones.
constexpr double kFourthOrderGearErrorFactor = 1000.0;

// Whether gears and bearings use steps of order 4.
bool is_smooth(const CoupledModel& model) {
  for (int b = 0; b < model.bearings(); ++b)
    if (order_of_steps(model.bearing_of(b), true) != 4) return false;
  return true;
}

// Slowness by the planets' speed against the carrier.
double slowness_of(const CoupledModel& model) {
  const bearing::motion::BearingModel& bearing = model.bearing;
  return slowness(bearing, bearing::kinematic_cage_speed(bearing.geometry, 0.0,
                                                         model.gears.operation.speeds.planet_relative));
}

Eigen::VectorXd gear_errors(const CoupledSetup& setup, const CoupledModel& model, double factor) {
  return factor * integration::gear_allowed_errors(model.gears, setup.gears.allowed_share);
}

CoupledStepOptions step_options(const CoupledSetup& setup, const CoupledModel& model,
                                const CoupledSystem& coupled) {
  const Eigen::VectorXd gears = gear_errors(setup, model, kGearErrorFactor);
  const StepBounds bounds = steps_of_order(
      2, coupled.bearing(0), allowed_errors(model.bearing_of(0), setup.bearing.allowed_length_error),
      slowness_of(model));
  return {.gears = {gears.begin(), gears.end()},
          .bearing = bounds.allowed,
          .longest_step = bounds.longest,
          .most_substepped = setup.most_substepped,
          .most_steps = setup.bearing.most_steps};
}

integration::Rosenbrock4 smooth_steps(const CoupledSetup& setup, const CoupledModel& model,
                                      const CoupledSystem& coupled) {
  const Eigen::VectorXd gears = gear_errors(setup, model, kFourthOrderGearErrorFactor);
  std::vector<double> allowed(coupled.size(), 0.0);
  std::copy(gears.begin(), gears.end(), allowed.begin());
  double longest = std::numeric_limits<double>::infinity();
  for (int b = 0; b < coupled.bearings(); ++b) {
    const Eigen::VectorXd errors = allowed_errors(model.bearing_of(b), setup.bearing.allowed_length_error);
    const StepBounds bounds = steps_of_order(4, coupled.bearing(b), errors, slowness_of(model));
    longest = std::min(longest, bounds.longest);
    std::copy(bounds.allowed.begin(), bounds.allowed.end(), coupled.of_bearing(allowed.data(), b));
  }
  return integration::Rosenbrock4(std::move(allowed), longest, integration::StepRule::two_errors);
}

}  // namespace

Monolithic::Monolithic(const CoupledSetup& setup)
    : setup_(setup),
      model_(coupled_model(setup)),
      equations_(model_.gears),
      system_(model_, is_smooth(model_)),
      x_(system_.size(), 0.0),
      before_(x_),
      shown_(x_) {
  if (system_.rotating())
    smooth_.emplace(smooth_steps(setup, model_, system_));
  else
    substepping_.emplace(system_, step_options(setup, model_, system_));
}

void Monolithic::initialize(double time) {
  initialize(time, coupled_start(setup_, model_, time));
}

void Monolithic::initialize(double time, const CoupledStart& start) {
  time_ = reached_ = reached_before_ = time;
  step_ = kFirstStep;
  following_ = false;
  std::fill(x_.begin(), x_.end(), 0.0);
  std::copy(start.gears.begin(), start.gears.end(), x_.begin());
  for (int b = 0; b < system_.bearings(); ++b) {
    const auto padded = system_.bearing(b).padded(start.bearings[static_cast<std::size_t>(b)]);
    std::copy(padded.begin(), padded.end(), system_.of_bearing(x_.data(), b));
  }
  system_.settle(0.0, x_);
  show_all();
  for (LoadsAtStep& loads : system_.loads) loads.step_before = 0.0;
}

Monolithic::Piece Monolithic::piece_from(double begin) const {
  const double close = 4e-16 * std::abs(begin) + 1e-15;  // [s]  round-off of the times
  const integration::Jumps jumps = integration::jumps_of(model_.gears, begin);
  if (!jumps.time) return {begin, begin + kLongestPiece};
  long jump = 0;
  while (jumps.time(jump) <= begin + close) ++jump;
  return {begin, jumps.time(jump)};
}

void Monolithic::enter(const Piece& piece) {
  piece_ = piece;
  const double margin =
      std::min(integration::jumps_of(model_.gears).margin, 0.25 * (piece.end - piece.begin));
  system_.set_piece(piece.begin, piece.begin + margin, piece.end - margin);
}

void Monolithic::one_step() try {
  const double length = piece_.end - piece_.begin;
  long attempts = 0;
  const integration::WindowLimits limits{.most_steps = setup_.bearing.most_steps};
  if (smooth_)
    integration::step_within_window(*smooth_, system_, x_, piece_.done, length, limits, step_, attempts);
  else
    integration::step_within_window(*substepping_, static_cast<CoupledSystem&>(system_), x_, piece_.done,
                                    length, limits, step_, attempts);
  rejected_ += attempts - 1;
  reached_ = piece_.done >= length ? piece_.end : piece_.begin + piece_.done;
} catch (const integration::NoStep& error) {
  throw std::runtime_error(error.what() + ("; " + fastest_vibration(model_.bearing)));
}

void Monolithic::advance(const Window& window) {
  require_length(window);
  const double close = 4e-16 * std::abs(window.end) + 1e-15;  // [s]
  if (following_)
    throw std::runtime_error("monolithic solution: found follow() before a window; required: windows alone");
  if (smooth_) smooth_->forget();  // each window separately
  const long most = system_.steps + setup_.bearing.most_steps;
  reached_ = window.begin;
  while (reached_ < window.end) {
    Piece piece = piece_from(reached_);
    if (piece.end >= window.end - close) piece.end = window.end;
    enter(piece);
    while (reached_ < piece.end) {
      if (system_.steps >= most)
        throw std::runtime_error("monolithic solution: the largest number of steps was taken");
      one_step();
    }
  }
  show_all();
  require_containment();
}

void Monolithic::follow(double time) {
  if (!following_) {
    following_ = true;
    enter(piece_from(reached_));
  }
  while (reached_ < time) {
    if (reached_ >= piece_.end) enter(piece_from(piece_.end));
    before_ = x_;
    reached_before_ = reached_;
    one_step();
  }
  show(time);
  require_containment();
}

void Monolithic::show_all() {
  shown_ = x_;
  time_ = reached_;
}

void Monolithic::show(double time) {
  if (!(reached_ > reached_before_)) return show_all();
  const system::WithinStep within(reached_before_, before_, reached_, x_, time, shown_);
  within.bend(0, freedoms(), freedoms());
  for (int b = 0; b < system_.bearings(); ++b) within.bend(system_.bearing(b).layout(), system_.offset(b));
  system_.settle(0.0, shown_);
  time_ = time;
}

void Monolithic::require_containment() const {
  for (int b = 0; b < system_.bearings(); ++b) {
    const std::string reason = system::out_of_place(model_.bearing_of(b), bearing_state(b));
    if (reason.empty()) continue;
    std::ostringstream text;
    text << "bearing " << b + 1 << " at t = " << time_ << " s: " << reason;
    throw std::runtime_error(text.str());
  }
}

Eigen::VectorXd Monolithic::gear_state() const {
  return Eigen::Map<const Eigen::VectorXd>(shown_.data(), 2 * freedoms());
}

Eigen::VectorXd Monolithic::bearing_state(int b) const {
  Eigen::VectorXd flat(model_.bearing_of(b).layout.size());
  system_.bearing(b).flatten(system_.of_bearing(shown_.data(), b), flat);
  return flat;
}

// Motion of the planet of bearing `b`.
BoreMotion Monolithic::planet_motion(int b) const {
  return bore_motion(model_, model_.port_of(b), time_, system_.part(shown_.data(), 0),
                     system_.part(shown_.data(), freedoms()));
}

void Monolithic::advance(const integration::OutputTimes& times,
                         const std::function<void(double time)>& observe) {
  for (long sample = 1; sample <= times.samples; ++sample) {
    follow(times.time(sample));
    observe(times.time(sample));
  }
}

integration::IntegrationReport Monolithic::report() const {
  return {.completed = true, .reached = reached_, .steps = system_.steps, .rejected = rejected_};
}

DrivenGearsOutput Monolithic::gears() const {
  Eigen::VectorXd workspace;
  gearset::dynamics::SetSnapshot snapshot;
  gearset::dynamics::take_snapshot(equations_, time_, gear_state(), workspace, snapshot);
  DrivenGearsOutput out;
  for (int i = 0; i < planets(); ++i) {
    const BoreMotion motion = planet_motion(i * model_.per_planet);
    out.planets.push_back(
        {.displacement = motion.position,
         .velocity = motion.velocity,
         .angle = model_.ports[static_cast<std::size_t>(i)].turn(gear_state().head(freedoms())),
         .speed = motion.speed,
         .sun_mesh_force = snapshot.sun_mesh_force[i],
         .ring_mesh_force = snapshot.ring_mesh_force[i]});
    out.carrier_speed = motion.carrier_speed;
    out.carrier_acceleration = motion.carrier_acceleration;
  }
  return out;
}

bearing::motion::BoreReaction Monolithic::reaction(int b) const {
  Snapshot now;
  take_snapshot(b, now);
  return now.on_bore;
}

void Monolithic::take_snapshot(int b, Snapshot& into) const {
  into = driven_snapshot(model_.bearing_of(b), at_seat(model_, b, planet_motion(b)), bearing_state(b));
}

void Monolithic::observe_steps(const system::StepObservers& observers) {
  for (std::size_t b = 0; b < observers.loads.size(); ++b) system_.loads[b].collector = observers.loads[b];
}

CoupledStart Monolithic::state() const {
  CoupledStart all{gear_state(), {}};
  for (int b = 0; b < bearings(); ++b) all.bearings.push_back(bearing_state(b));
  return all;
}

}  // namespace orbearing::system
