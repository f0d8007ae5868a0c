#include "bearing/equilibrium/moving_balls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/geometry.hpp"

namespace orbearing::bearing::equilibrium {

namespace {

using mechanics::root;
using mechanics::value_of;

// Slopes by the place of the ball from the outer groove centre, and of the inner centre from the ball.
template <int index>
auto coordinate(double value) {
  mechanics::SparseDual<0b1111u, double> x{value, {}};
  x.slope[index] = 1.0;
  return x;
}
using Slopes = mechanics::SparseDual<0b1111u, double>;

Eigen::RowVector2d by_outer(const Slopes& x) {
  return {x.slope[0], x.slope[1]};
}
Eigen::RowVector2d by_inner(const Slopes& x) {
  return {x.slope[2], x.slope[3]};
}

}  // namespace

// How a ball touches both races, and turns between them.
template <class T>
struct MovingBallRow::Contacts {
  ContactNormal<T> inner, outer;
  T inner_approach, outer_approach;  // [m]
  T inner_load, outer_load;          // [N]
  BallMotion<T> motion;
};

MovingBallRow::RaceSide MovingBallRow::side_of(const Bearing& bearing, Race race,
                                               const std::optional<Lubricant>& oil) const {
  const PointContact& contact = geometry_.contact(race);
  const PointPressure unit = point_pressure(contact, 1.0);  // semi-axes grow with the cube root of the load
  RaceSide side{.constant = contact.constant};
  side.distance = (bearing.ring(race).osculation - 0.5) * bearing.balls().diameter;
  side.ellipse = std::pow(contact.constant, 2.0 / 3.0) * (unit.major * unit.major + unit.minor * unit.minor);
  side.pivot = std::cbrt(contact.constant) * unit.major * contact.ellipse.second;
  if (oil) side.film = film::approach_law(film::ball_contact(bearing, race), *oil);
  return side;
}

MovingBallRow::MovingBallRow(const Bearing& bearing, const RowMotion& motion)
    : MovingBallRow(bearing, motion, BallRow(bearing)) {}

MovingBallRow::MovingBallRow(const Bearing& bearing, const RowMotion& motion, const BallRow& at_rest)
    : geometry_(at_rest), inertia_(motion.inertia), speeds_(motion.speeds), filmed_(motion.film.has_value()) {
  inner_ = side_of(bearing, Race::inner, motion.film);
  outer_ = side_of(bearing, Race::outer, motion.film);
  const BearingGeometry geometry = geometry_of(bearing);
  ball_radius_ = geometry.element_radius;
  pitch_radius_ = geometry.pitch_radius;
  groove_radius_ = bearing.inner.osculation * bearing.balls().diameter;
  full_mass_ = inertia_.enabled ? geometry.element_mass : 0.0;
  lighten(1.0);
  memory_.resize(static_cast<std::size_t>(geometry_.count()));
  balls_.resize(memory_.size());
}

double MovingBallRow::reach(double load) const {
  const double spin = std::max(std::abs(speeds_.inner), std::abs(speeds_.outer));
  return geometry_.reach(load + mass_ * pitch_radius_ * spin * spin);
}

template <class T>
T MovingBallRow::hertz(const RaceSide& side, const T& approach) {
  if (value_of(approach) <= 0.0) return T{};
  return side.constant * (approach * root(approach));
}

namespace {

// Of the centres of ball and groove, with its direction. A groove ends where it stands upright: beyond, it
// goes on as a plane across the axis, so that a ring which has left its balls does not meet them from behind.
template <class T>
T distance(const T& radial, const T& axial, ContactNormal<T>& normal) {
  if (value_of(radial) > 0.0) {
    const T length = root(radial * radial + axial * axial);
    const T inverse = 1.0 / length;
    normal = {radial * inverse, axial * inverse};
    return length;
  }
  const double side = value_of(axial) < 0.0 ? -1.0 : 1.0;
  normal = {T{}, T{} + side};
  return side * axial;
}

}  // namespace

template <class T>
MovingBallRow::Contacts<T> MovingBallRow::contacts_of(const T& outer_r, const T& outer_z, const T& inner_r,
                                                      const T& inner_z) const {
  Contacts<T> at;
  at.outer_approach = distance(outer_r, outer_z, at.outer) - outer_.distance;
  at.inner_approach = distance(inner_r, inner_z, at.inner) - inner_.distance;
  at.inner_load = hertz(inner_, at.inner_approach);
  at.outer_load = hertz(outer_, at.outer_approach);
  return at;
}

// The closure weighs spins by Hertz's loads, also where a film then gives the loads. A ball that leaves the
// inner race is held by the outer one alone.
template <class T>
MovingBallRow::MotionForces<T> MovingBallRow::add_motion(Control control, Contacts<T>& at) const {
  SpinWeights<T> weights{T{}, T{} + 1.0};
  T inner_share{}, outer_share = T{} + 2.0;  // of the gyroscopic moment over the diameter
  const bool on_inner = value_of(at.inner_load) > 0.0, on_outer = value_of(at.outer_load) > 0.0;
  if (on_inner && inertia_.attitude == BallAttitude::race_control && control == Control::inner) {
    weights = {T{} + 1.0, T{}};
    inner_share = outer_share = T{} + 1.0;
  } else if (on_inner && inertia_.attitude == BallAttitude::minimum_friction) {
    weights.inner = inner_.ellipse * (at.inner_load * at.inner_approach);
    weights.outer = on_outer ? outer_.ellipse * (at.outer_load * at.outer_approach) : T{};
    inner_share = 2.0 * (at.inner_load / (at.inner_load + at.outer_load));
    outer_share = 2.0 - inner_share;
  } else if (on_inner && inertia_.attitude == BallAttitude::hybrid) {
    weights.inner = inner_.pivot * (at.inner_load * root(at.inner_approach));
    weights.outer = on_outer ? outer_.pivot * (at.outer_load * root(at.outer_approach)) : T{};
    inner_share = 2.0 * (weights.inner / (weights.inner + weights.outer));
    outer_share = 2.0 - inner_share;
  }
  at.motion = ball_motion(at.inner, at.outer, weights, ball_radius_, pitch_radius_, speeds_);
  if (filmed_) {
    const auto& motion = at.motion;
    at.inner_load = film::load_at(inner_.film, at.inner_approach, motion.inner_rolling, motion.inner_spin);
    at.outer_load = film::load_at(outer_.film, at.outer_approach, motion.outer_rolling, motion.outer_spin);
  }
  const double sign = inertia_.gyroscopic_moment == GyroscopicMoment::balanced     ? 1.0
                      : inertia_.gyroscopic_moment == GyroscopicMoment::as_printed ? -1.0
                                                                                   : 0.0;
  MotionForces<T> forces;
  forces.centrifugal = mass_ * pitch_radius_ * (at.motion.orbit * at.motion.orbit);
  forces.gyroscopic = (sign * moment_of_inertia_) * (at.motion.orbit * at.motion.radial_spin);
  const T pull = (0.5 / ball_radius_) * forces.gyroscopic;
  forces.inner_traction = inner_share * pull;
  forces.outer_traction = -(outer_share * pull);
  return forces;
}

template <class T>
MovingBallRow::Forces<T> MovingBallRow::forces_of(const T& outer_r, const T& outer_z, const T& inner_r,
                                                  const T& inner_z, const BallMemory& ball) const {
  Contacts<T> at = contacts_of(outer_r, outer_z, inner_r, inner_z);
  if (frozen_) {
    const FrozenForces& held = ball.frozen;
    at.inner_load = held.inner_share * at.inner_load;
    at.outer_load = held.outer_share * at.outer_load;
    const T inner_force_r = at.inner_load * at.inner.cosine, inner_force_z = at.inner_load * at.inner.sine;
    return {.ball_r = inner_force_r - at.outer_load * at.outer.cosine + held.ball[0],
            .ball_z = inner_force_z - at.outer_load * at.outer.sine + held.ball[1],
            .ring_r = held.ring[0] - inner_force_r,
            .ring_z = held.ring[1] - inner_force_z,
            .ring_moment = T{} + held.ring[2],
            .inner_load = at.inner_load,
            .outer_load = at.outer_load};
  }
  const MotionForces<T> moved = add_motion(ball.control, at);
  const T inner_force_r = at.inner_load * at.inner.cosine - moved.inner_traction * at.inner.sine;
  const T inner_force_z = at.inner_load * at.inner.sine + moved.inner_traction * at.inner.cosine;
  const T outer_force_r = at.outer_load * at.outer.cosine + moved.outer_traction * at.outer.sine;
  const T outer_force_z = at.outer_load * at.outer.sine - moved.outer_traction * at.outer.cosine;
  return {.ball_r = inner_force_r - outer_force_r + moved.centrifugal,
          .ball_z = inner_force_z - outer_force_z,
          .ring_r = -inner_force_r,
          .ring_z = -inner_force_z,
          .ring_moment = groove_radius_ * moved.inner_traction,
          .inner_load = at.inner_load,
          .outer_load = at.outer_load};
}

// Between both groove centres under the load of a ball at rest; where they are too near for that, thrown
// against the outer race.
Eigen::Vector2d MovingBallRow::usual_place(const Eigen::Vector2d& grooves) const {
  const double length = grooves.norm();
  const double approach = length - inner_.distance - outer_.distance;
  if (approach <= 0.0 && length > 0.0) return {outer_.distance, 0.0};
  const double share = std::pow(outer_.constant / inner_.constant, 2.0 / 3.0);  // inner over outer approach
  return (outer_.distance + approach / (1.0 + share)) / length * grooves;
}

// A step beyond the last one is taken into account to first order, which leaves an error of second order.
void MovingBallRow::settle_from(const Eigen::Vector2d& start, const Eigen::Vector2d& grooves,
                                BallMemory& ball) const {
  ball.grooves = grooves;
  ball.place = start;
  Forces<Slopes> f;
  Eigen::Matrix2d by_grooves;
  const auto imbalance_at = [&](const Eigen::Vector2d& at) {
    f = forces_of(coordinate<0>(at[0]), coordinate<1>(at[1]), coordinate<2>(grooves[0] - at[0]),
                  coordinate<3>(grooves[1] - at[1]), ball);
    by_grooves << by_inner(f.ball_r), by_inner(f.ball_z);
    mechanics::Imbalance<2> now;
    now.force = {f.ball_r.value, f.ball_z.value};
    now.stiffness << by_outer(f.ball_r), by_outer(f.ball_z);
    now.stiffness = by_grooves - now.stiffness;
    now.scale = std::max(f.inner_load.value, f.outer_load.value);
    return now;
  };
  const double near = frozen_ ? 1e-5 : 1e-8;  // of the loads: its square is round-off, or little while frozen
  const mechanics::SearchLimits limits{.reach = 0.2 * outer_.distance,
                                       .size = grooves.norm(),
                                       .tolerance = near,
                                       .acceptable = near,
                                       .most_iterations = 60};
  mechanics::Imbalance<2> now;
  ball.found = (frozen_ ? mechanics::find_balance<2>(imbalance_at, limits, ball.place, now)
                        : mechanics::find_root<2>(imbalance_at, limits, ball.place, now))
                   .converged;
  const Eigen::Vector2d left = mechanics::lengths_under_any<2>(now.force, now.stiffness);
  ball.follows.col(0) = mechanics::lengths_under_any<2>(by_grooves.col(0), now.stiffness);
  ball.follows.col(1) = mechanics::lengths_under_any<2>(by_grooves.col(1), now.stiffness);
  Eigen::Matrix<double, 3, 2> ring_by_grooves, ring_by_ball;
  ring_by_grooves << by_inner(f.ring_r), by_inner(f.ring_z), by_inner(f.ring_moment);
  ring_by_ball << by_outer(f.ring_r), by_outer(f.ring_z), by_outer(f.ring_moment);
  ring_by_ball -= ring_by_grooves;
  ball.place += left;
  ball.ring = Eigen::Vector3d(f.ring_r.value, f.ring_z.value, f.ring_moment.value) + ring_by_ball * left;
  ball.slope = ring_by_grooves + ring_by_ball * ball.follows;
  ball.load = f.inner_load.value;
}

void MovingBallRow::settle(const Eigen::Vector2d& grooves, BallMemory& ball) const {
  if (ball.found) settle_from(ball.place + ball.follows * (grooves - ball.grooves), grooves, ball);
  if (!ball.found) settle_from(usual_place(grooves), grooves, ball);
  if (!ball.found) settle_from({outer_.distance, 0.0}, grooves, ball);
}

Eigen::Vector2d MovingBallRow::grooves_at(Eigen::Index ball, const RingPlace& place) const {
  const BallRow::BallPlace at = geometry_.place_of(ball, place);
  return {at.radial, at.axial};
}

void MovingBallRow::add_forces(const RingPlace& place, RingImbalance& sum) {
  const bool known = known_ && *known_ == place;
  if (!known) settled_ = true;
  const double arm = 1.0 / lever();
  for (Eigen::Index j = 0; j < geometry_.count(); ++j) {
    BallMemory& ball = memory_[static_cast<std::size_t>(j)];
    if (!known) settle(grooves_at(j, place), ball);
    if (!ball.found) settled_ = false;
    const auto [cosine, sine] = geometry_.direction(j);
    Eigen::Matrix<double, 5, 3> acts;  // of the ring's force on its coordinates
    acts << cosine, 0.0, 0.0,          //
        sine, 0.0, 0.0,                //
        0.0, 1.0, 0.0,                 //
        0.0, cosine, arm * cosine,     //
        0.0, sine, arm * sine;
    sum.force += acts * ball.ring;
    sum.stiffness -= (acts * ball.slope) * acts.leftCols<2>().transpose();
    sum.scale += ball.load;
  }
  known_ = place;
}

MovingBall MovingBallRow::ball_at(const BallMemory& ball) const {
  const Eigen::Vector2d inner = ball.grooves - ball.place;
  Contacts<double> at = contacts_of(ball.place[0], ball.place[1], inner[0], inner[1]);
  const MotionForces<double> moved = add_motion(ball.control, at);
  return {.inner = at.inner,
          .outer = at.outer,
          .inner_load = at.inner_load,
          .outer_load = at.outer_load,
          .inner_traction = moved.inner_traction,
          .outer_traction = moved.outer_traction,
          .centrifugal_force = moved.centrifugal,
          .gyroscopic_moment = moved.gyroscopic,
          .motion = at.motion};
}

void MovingBallRow::put_loads(const RingPlace& place, RingState& state) {
  RingImbalance unused;
  add_forces(place, unused);
  const Eigen::Index count = geometry_.count();
  state.contact_load = state.contact_angle = Eigen::ArrayXd::Zero(count);
  state.outer_load = state.outer_angle = Eigen::ArrayXd::Zero(count);
  state.inner_rolling = state.inner_spin = state.outer_rolling = state.outer_spin = state.outer_load;
  for (Eigen::Index j = 0; j < count; ++j) {
    const MovingBall ball = ball_at(memory_[static_cast<std::size_t>(j)]);
    balls_[static_cast<std::size_t>(j)] = ball;
    state.contact_load[j] = ball.inner_load;
    for (const auto& [traction, load] :
         {std::pair(ball.inner_traction, ball.inner_load), std::pair(ball.outer_traction, ball.outer_load)})
      if (load > 0.0) state.friction = std::max(state.friction, std::abs(traction) / load);
    state.outer_load[j] = ball.outer_load;
    state.contact_angle[j] = std::atan2(ball.inner.sine, ball.inner.cosine);
    state.outer_angle[j] = std::atan2(ball.outer.sine, ball.outer.cosine);
    state.inner_rolling[j] = ball.motion.inner_rolling;
    state.inner_spin[j] = ball.motion.inner_spin;
    state.outer_rolling[j] = ball.motion.outer_rolling;
    state.outer_spin[j] = ball.motion.outer_spin;
  }
  state.largest_pressure =
      std::max(point_pressure(geometry_.contact(Race::inner), state.contact_load.maxCoeff()).pressure,
               point_pressure(geometry_.contact(Race::outer), state.outer_load.maxCoeff()).pressure);
}

void MovingBallRow::freeze(const RingPlace& place) {
  for (Eigen::Index j = 0; j < geometry_.count(); ++j) {
    BallMemory& ball = memory_[static_cast<std::size_t>(j)];
    if (!ball.found) {
      ball.grooves = grooves_at(j, place);
      ball.place = usual_place(ball.grooves);
    }
    const Eigen::Vector2d inner = ball.grooves - ball.place;
    const Contacts<double> at = contacts_of(ball.place[0], ball.place[1], inner[0], inner[1]);
    Contacts<double> moving = at;
    const MotionForces<double> moved = add_motion(ball.control, moving);
    const Eigen::Vector2d inner_along(-at.inner.sine, at.inner.cosine);
    const Eigen::Vector2d outer_along(-at.outer.sine, at.outer.cosine);
    const Eigen::Vector2d traction = moved.inner_traction * inner_along;
    ball.frozen.ball = traction + moved.outer_traction * outer_along;
    ball.frozen.ball[0] += moved.centrifugal;
    ball.frozen.ring = {-traction[0], -traction[1], groove_radius_ * moved.inner_traction};
    if (filmed_ && at.inner_load > 0.0) ball.frozen.inner_share = moving.inner_load / at.inner_load;
    if (filmed_ && at.outer_load > 0.0) ball.frozen.outer_share = moving.outer_load / at.outer_load;
  }
  frozen_ = true;
  known_.reset();
}

void MovingBallRow::lighten(double share) {
  mass_ = share * full_mass_;
  moment_of_inertia_ = 0.4 * mass_ * ball_radius_ * ball_radius_;  // of a ball
  known_.reset();
}

void MovingBallRow::thaw() {
  frozen_ = false;
  known_.reset();
}

// By [Harris2006] the outer race controls where Q_o a_o E_o cos(a_i - a_o) > Q_i a_i E_i.
bool MovingBallRow::choose_control() {
  if (inertia_.attitude != BallAttitude::race_control) return false;
  bool changed = false;
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    const MovingBall& ball = balls_[j];
    const double inner = inner_.pivot / std::cbrt(inner_.constant) * std::pow(ball.inner_load, 4.0 / 3.0);
    const double outer = outer_.pivot / std::cbrt(outer_.constant) * std::pow(ball.outer_load, 4.0 / 3.0);
    const double across = ball.inner.cosine * ball.outer.cosine + ball.inner.sine * ball.outer.sine;
    const Control control = outer * across > inner ? Control::outer : Control::inner;
    BallMemory& memory = memory_[j];
    // A ball between both, which each rule sends to the other race, stays where it went.
    if (control == memory.control || memory.changed_before) continue;
    memory.control = control;
    memory.changed_before = changed = true;
    known_.reset();
  }
  return changed;
}

namespace {

// The row while it is frozen: a search in a convex energy.
struct FrozenRow {
  static constexpr double near = 1e-4;
  MovingBallRow& row;

  double lever() const { return row.lever(); }
  double reach(double load) const { return row.reach(load); }
  void add_forces(const RingPlace& place, RingImbalance& sum) { row.add_forces(place, sum); }
  void put_loads(const RingPlace&, RingState&) {}
};

RingState balance_thawed(MovingBallRow& row, const RingLoad& load, const RingPlace& place) {
  RingState state = balance_ring(row, load, place);
  if (state.report.converged && !row.settled()) {
    state.report.converged = false;
    state.report.message = "a ball found no balance between its races";
  }
  return state;
}

// Some rounds with all frozen that follows from the motion, then Newton's method on the whole.
RingState balance_from(MovingBallRow& row, const RingLoad& load, RingPlace place, int rounds) {
  for (int i = 0; i < rounds; ++i) {
    row.freeze(place);
    place = place_of(balance_ring(FrozenRow{row}, load, place), row.lever());
  }
  row.thaw();
  return balance_thawed(row, load, place);
}

// By and by from balls without mass.
RingState balance_in_steps(MovingBallRow& row, const RingLoad& load, RingPlace place) {
  constexpr double kShortest = 1.0 / 512.0;
  double share = 0.0, step = 0.125;
  RingState state;
  while (share < 1.0 && step >= kShortest) {
    const double next = std::min(1.0, share + step);
    row.lighten(next);
    state = balance_from(row, load, place, 1);
    if (!state.report.converged) {
      step *= 0.5;
      continue;
    }
    place = place_of(state, row.lever());
    share = next;
    step *= 1.5;
  }
  row.lighten(1.0);
  return state;
}

}  // namespace

RingState balance_moving(const Bearing& bearing, const RowMotion& motion, const RingLoad& load) {
  const BallRow row_at_rest(bearing);
  const RingState at_rest = balance_ring(row_at_rest, load);
  if (motion.speeds.at_rest() || (!motion.inertia.enabled && !motion.film)) return at_rest;
  MovingBallRow row(bearing, motion, row_at_rest);
  RingState state;
  for (const int rounds : {1, 3, 12, 40}) {
    state = balance_from(row, load, place_of(at_rest, row.lever()), rounds);
    if (state.report.converged) break;
  }
  if (!state.report.converged) state = balance_in_steps(row, load, place_of(at_rest, row.lever()));
  constexpr int kMostChanges = 6;
  for (int i = 0; i < kMostChanges && state.report.converged && row.choose_control(); ++i)
    state = balance_from(row, load, place_of(state, row.lever()), 1);
  return state;
}

}  // namespace orbearing::bearing::equilibrium
