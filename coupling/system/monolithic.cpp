#include "coupling/system/monolithic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "coupling/integration/integrate_pieces.hpp"
#include "coupling/integration/rosenbrock4.hpp"
#include "coupling/integration/window.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/coupled_steps.hpp"
#include "gearset/dynamics/snapshot.hpp"

namespace orbearing::system {

namespace {

using bearing::motion::BoreMotion;
using bearing::motion::Snapshot;

constexpr double kFirstStep = 1e-6;  // [s]
constexpr double kSavedSystemKind = 30002.0;
// Errors that linearly implicit steps may make in the gears, over those of dopri5.
constexpr double kGearErrorFactor = 100.0;
constexpr double kLongestPiece = 1.0;  // [s]  where nothing jumps

// The same of steps of order 4, whose error estimate holds all that the equations have beyond linear ones.
constexpr double kFourthOrderGearErrorFactor = 1000.0;

// Whether gears and bearings go by steps of order 4.
bool is_smooth(const CoupledModel& model) {
  for (int b = 0; b < model.bearings(); ++b)
    if (order_of_steps(model.bearing_of(b), true) != 4) return false;
  return true;
}

// Of the planets' speed against the carrier.
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

// State, steps, and what is shown of them. One object is either advanced from window to window or followed,
// not both.
struct Monolithic::Inside {
  explicit Inside(const CoupledSetup& setup);
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

  void start(double time, const CoupledStart& start);
  void forget();
  // Piece by piece between the jumps of the mesh stiffness; the last step ends with the window. The state is
  // lost on an error.
  void advance(const Window& window);
  // To `time` [s], which steps may pass: the state shown is interpolated, positions by cubics, velocities in
  // straight lines.
  void follow(double time);

  Eigen::VectorXd gear_state() const;
  Eigen::VectorXd bearing_state(int b) const;
  bearing::motion::BoreMotion planet_motion(int b) const;
  bearing::motion::BoreMotion motion(int b) const { return at_seat(model_, b, planet_motion(b)); }

  // Both throw std::runtime_error between two steps of follow().
  SavedState saved();
  // Throws std::invalid_argument where it is not one of such a system, and then nothing has changed.
  void put(const SavedState& state);

  // Between two jumps.
  struct Piece {
    double begin = 0.0, end = 0.0;  // [s]
    double done = 0.0;              // [s]  since its beginning
  };

  Piece piece_from(double begin) const;
  void enter(const Piece& piece);
  void one_step();
  void show(double time);
  void show_all();
  void count_turns();
  void require_containment() const;
  template <class Visit>
  void each(Visit visit);
  std::vector<double> head() const;
  Eigen::Index freedoms() const { return model_.gears.layout.freedoms(); }

  CoupledSetup setup_;
  CoupledModel model_;
  gearset::dynamics::PlanetarySetEquations equations;
  WithAllSlopes system_;
  std::optional<CoupledSteps> substepping_;         // of order 2
  std::optional<integration::Rosenbrock4> smooth_;  // in its place where nothing bounces
  long rejected_ = 0;                               // [-]  attempts
  std::vector<double> x_;                           // as far as steps have gone
  std::vector<double> before_;                      // where the last step of follow() began
  std::vector<double> shown_;
  std::vector<double> turned_, angle_;                        // [rad]  (bearings)
  double time_ = 0.0, reached_ = 0.0, reached_before_ = 0.0;  // [s]  shown, of x_, of before_
  double step_ = 1e-6;                                        // [s]  to try next
  Piece piece_;
  bool following_ = false;
};

Monolithic::Inside::Inside(const CoupledSetup& setup)
    : setup_(setup),
      model_(coupled_model(setup)),
      equations(model_.gears),
      system_(model_, setup.bearing.bins, is_smooth(model_)),
      x_(system_.size(), 0.0),
      before_(x_),
      shown_(x_),
      turned_(static_cast<std::size_t>(system_.bearings()), 0.0),
      angle_(turned_) {
  if (system_.rotating())
    smooth_.emplace(smooth_steps(setup, model_, system_));
  else
    substepping_.emplace(system_, step_options(setup, model_, system_));
}

void Monolithic::Inside::start(double time, const CoupledStart& start) {
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
  forget();
}

void Monolithic::Inside::forget() {
  for (int b = 0; b < system_.bearings(); ++b) {
    const auto position = static_cast<std::size_t>(b);
    turned_[position] = 0.0;
    angle_[position] = motion(b).angle;
    system_.loads[position].step_before = 0.0;
    system_.sums[position] = system_.no_damage(setup_.bearing.bins);
  }
}

Monolithic::Inside::Piece Monolithic::Inside::piece_from(double begin) const {
  const double close = 4e-16 * std::abs(begin) + 1e-15;  // [s]  round-off of the times
  const integration::Jumps jumps = integration::jumps_of(model_.gears, begin);
  if (!jumps.time) return {begin, begin + kLongestPiece};
  long jump = 0;
  while (jumps.time(jump) <= begin + close) ++jump;
  return {begin, jumps.time(jump)};
}

void Monolithic::Inside::enter(const Piece& piece) {
  piece_ = piece;
  const double margin =
      std::min(integration::jumps_of(model_.gears).margin, 0.25 * (piece.end - piece.begin));
  system_.set_piece(piece.begin, piece.begin + margin, piece.end - margin);
}

void Monolithic::Inside::one_step() try {
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

void Monolithic::Inside::advance(const Window& window) {
  const double close = 4e-16 * std::abs(window.end) + 1e-15;  // [s]
  if (smooth_) smooth_->forget();  // or a run that goes on from a saved state would step otherwise
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
  count_turns();
  require_containment();
}

void Monolithic::Inside::follow(double time) {
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
  count_turns();
  require_containment();
}

void Monolithic::Inside::show_all() {
  shown_ = x_;
  time_ = reached_;
}

void Monolithic::Inside::show(double time) {
  if (!(reached_ > reached_before_)) return show_all();
  const system::WithinStep within(reached_before_, before_, reached_, x_, time, shown_);
  within.bend(0, freedoms(), freedoms());
  for (int b = 0; b < system_.bearings(); ++b) within.bend(system_.bearing(b).layout(), system_.offset(b));
  system_.settle(0.0, shown_);
  time_ = time;
}

void Monolithic::Inside::count_turns() {
  for (int b = 0; b < system_.bearings(); ++b) {
    const auto position = static_cast<std::size_t>(b);
    const double now = motion(b).angle;
    turned_[position] += std::abs(now - angle_[position]);
    angle_[position] = now;
  }
}

void Monolithic::Inside::require_containment() const {
  for (int b = 0; b < system_.bearings(); ++b) {
    const std::string reason = system::out_of_place(model_.bearing_of(b), bearing_state(b));
    if (reason.empty()) continue;
    std::ostringstream text;
    text << "bearing " << b + 1 << " at t = " << time_ << " s: " << reason;
    throw std::runtime_error(text.str());
  }
}

Eigen::VectorXd Monolithic::Inside::gear_state() const {
  return Eigen::Map<const Eigen::VectorXd>(shown_.data(), 2 * freedoms());
}

Eigen::VectorXd Monolithic::Inside::bearing_state(int b) const {
  Eigen::VectorXd flat(model_.bearing_of(b).layout.size());
  system_.bearing(b).flatten(system_.of_bearing(shown_.data(), b), flat);
  return flat;
}

// Of the planet of bearing `b`.
BoreMotion Monolithic::Inside::planet_motion(int b) const {
  return bore_motion(model_, model_.port_of(b), time_, system_.part(shown_.data(), 0),
                     system_.part(shown_.data(), freedoms()));
}

// Every number of the state in turn, for `visit(double* first, size)`.
template <class Visit>
void Monolithic::Inside::each(Visit visit) {
  visit(&reached_, 1);
  visit(&step_, 1);
  for (std::vector<double>* all : {&x_, &turned_, &angle_})
    visit(all->data(), static_cast<long>(all->size()));
  for (std::size_t b = 0; b < turned_.size(); ++b) {
    visit(&system_.loads[b].step_before, 1);
    system_.sums[b].each(visit);
  }
}

// Version, rollers, bearings, freedoms of the gears.
std::vector<double> Monolithic::Inside::head() const {
  if (following_)
    throw std::runtime_error("monolithic solution: found follow() before save; required: windows alone");
  return {kSavedSystemKind, static_cast<double>(model_.bearing.layout.rollers),
          static_cast<double>(system_.bearings()), static_cast<double>(freedoms())};
}

SavedState Monolithic::Inside::saved() {
  return saved_state(head(), *this);
}

void Monolithic::Inside::put(const SavedState& state) {
  restore_state(state, "monolithic solution", head(), *this);
  show_all();
}

Monolithic::Monolithic(const CoupledSetup& setup) : inside_(std::make_unique<Inside>(setup)) {}
Monolithic::~Monolithic() = default;
Monolithic::Monolithic(Monolithic&&) noexcept = default;
Monolithic& Monolithic::operator=(Monolithic&&) noexcept = default;

void Monolithic::initialize(double time) {
  initialize(time, coupled_start(inside_->setup_, inside_->model_, time));
}
void Monolithic::initialize(double time, const CoupledStart& start) {
  inside_->start(time, start);
}
void Monolithic::forget() {
  inside_->forget();
}

void Monolithic::advance(const Window& window) {
  require_length(window);
  const SavedState before = inside_->saved();
  try {
    inside_->advance(window);
  } catch (...) {
    inside_->put(before);
    throw;
  }
}
void Monolithic::follow(double time) {
  inside_->follow(time);
}
void Monolithic::advance(const integration::OutputTimes& times,
                         const std::function<void(double time)>& observe) {
  for (long sample = 1; sample <= times.samples; ++sample) {
    follow(times.time(sample));
    observe(times.time(sample));
  }
}

int Monolithic::planets() const {
  return static_cast<int>(inside_->model_.ports.size());
}
int Monolithic::bearings() const {
  return inside_->system_.bearings();
}
double Monolithic::time() const {
  return inside_->time_;
}
integration::IntegrationReport Monolithic::report() const {
  return {.completed = true,
          .reached = inside_->reached_,
          .steps = inside_->system_.steps,
          .rejected = inside_->rejected_};
}
long Monolithic::substepped() const {
  return inside_->substepping_ ? inside_->substepping_->substepped() : 0;
}

DrivenGearsOutput Monolithic::gears() const {
  const Inside& in = *inside_;
  Eigen::VectorXd workspace;
  gearset::dynamics::SetSnapshot snapshot;
  gearset::dynamics::take_snapshot(in.equations, in.time_, in.gear_state(), workspace, snapshot);
  DrivenGearsOutput out;
  for (int i = 0; i < planets(); ++i) {
    const BoreMotion motion = in.planet_motion(i * in.model_.per_planet);
    out.planets.push_back({.displacement = motion.position,
                           .velocity = motion.velocity,
                           .angle = in.model_.ports[static_cast<std::size_t>(i)].turn(
                               in.gear_state().head(in.model_.gears.layout.freedoms())),
                           .speed = motion.speed,
                           .sun_mesh_force = snapshot.sun_mesh_force[i],
                           .ring_mesh_force = snapshot.ring_mesh_force[i]});
    out.carrier_speed = motion.carrier_speed;
    out.carrier_acceleration = motion.carrier_acceleration;
  }
  return out;
}

bearing::motion::BoreReaction Monolithic::reaction(int b) const {
  return driven_snapshot(inside_->model_.bearing_of(b), inside_->motion(b), inside_->bearing_state(b))
      .on_bore;
}

DrivenBearingOutput Monolithic::bearing(int b) const {
  const Inside& in = *inside_;
  const BoreMotion motion = in.motion(b);
  const bearing::motion::BearingModel& model = in.model_.bearing_of(b);
  const Snapshot now = driven_snapshot(model, motion, in.bearing_state(b));
  return driven_output(model.geometry, motion.speed, now, now.on_bore,
                       in.turned_[static_cast<std::size_t>(b)], life(b).bearing);
}

void Monolithic::take_snapshot(int b, Snapshot& into) const {
  into = driven_snapshot(inside_->model_.bearing_of(b), inside_->motion(b), inside_->bearing_state(b));
}

void Monolithic::observe_steps(const system::StepObservers& observers) {
  for (std::size_t b = 0; b < observers.loads.size(); ++b)
    inside_->system_.loads[b].collector = observers.loads[b];
}

bearing::BearingLife Monolithic::life(int b) const {
  const DrivenBearingSetup& setup = inside_->setup_.bearing;
  return inside_->system_.sums[static_cast<std::size_t>(b)].life(setup.bearing, setup.reduction_factor);
}

CoupledStart Monolithic::state() const {
  CoupledStart all{inside_->gear_state(), {}};
  for (int b = 0; b < bearings(); ++b) all.bearings.push_back(inside_->bearing_state(b));
  return all;
}

void Monolithic::save(SavedState& state) const {
  state = inside_->saved();
}

void Monolithic::restore(const SavedState& state) {
  inside_->put(state);
}

}  // namespace orbearing::system
