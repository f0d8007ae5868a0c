#include "bearing/equilibrium/moving_balls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/geometry.hpp"

namespace orbearing::bearing::equilibrium {

namespace {

using mechanics::root;
using mechanics::value_of;

// Slopes by the place of the ball from the outer groove centre (0 and 1), and of the inner centre from the
// ball.
constexpr unsigned kOuter = 0b0011u, kInner = 0b1100u;
template <unsigned kVariables, int index>
auto coordinate(double value) {
  mechanics::SparseDual<kVariables, double> x{value, {}};
  x.slope[index] = 1.0;
  return x;
}
using Slopes = mechanics::SparseDual<kOuter | kInner, double>;

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
  mass_ = inertia_.enabled ? geometry.element_mass : 0.0;
  moment_of_inertia_ = 0.4 * mass_ * ball_radius_ * ball_radius_;  // of a ball
  const double angle = bearing.balls().contact_angle;
  const ContactNormal<double> normal{std::cos(angle), std::sin(angle)};
  const double orbit =
      ball_motion<double>(normal, normal, {0.0, 1.0}, ball_radius_, pitch_radius_, speeds_).orbit;
  const double half_speed = 0.5 * std::max(std::abs(speeds_.inner), std::abs(speeds_.outer));
  constexpr double kHolds = 0.1;  // an assumption: balls are seen to skid at far higher loads
  holding_load_ = kHolds * mass_ * pitch_radius_ * half_speed * half_speed;
  usual_centrifugal_ = mass_ * pitch_radius_ * orbit * orbit;
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

template <class T, class Outer, class Inner>
MovingBallRow::Contacts<T> MovingBallRow::contacts_of(const Outer& outer_r, const Outer& outer_z,
                                                      const Inner& inner_r, const Inner& inner_z) const {
  ContactNormal<Outer> outer;
  ContactNormal<Inner> inner;
  const Outer outer_approach = distance(outer_r, outer_z, outer) - outer_.distance;
  const Inner inner_approach = distance(inner_r, inner_z, inner) - inner_.distance;
  return {.inner = {T{} + inner.cosine, T{} + inner.sine},
          .outer = {T{} + outer.cosine, T{} + outer.sine},
          .inner_approach = T{} + inner_approach,
          .outer_approach = T{} + outer_approach,
          .inner_load = T{} + hertz(inner_, inner_approach),
          .outer_load = T{} + hertz(outer_, outer_approach),
          .motion = {}};
}

namespace {

// How far the inner race makes a ball roll on it, by its load over the one that does so wholly: smoothly,
// since a balance may lie between both.
template <class T>
T hold_of(const T& load, double whole) {
  if (!(value_of(load) > 0.0)) return T{};
  if (!(value_of(load) < whole)) return T{} + 1.0;
  const T share = (1.0 / whole) * load;
  return share * share * (3.0 - 2.0 * share);
}

template <class T>
BallMotion<T> between(const BallMotion<T>& a, const BallMotion<T>& b, const T& share) {
  const auto mean = [&](const T& of_a, const T& of_b) { return of_a + share * (of_b - of_a); };
  return {.orbit = mean(a.orbit, b.orbit),
          .radial_spin = mean(a.radial_spin, b.radial_spin),
          .axial_spin = mean(a.axial_spin, b.axial_spin),
          .inner_spin = mean(a.inner_spin, b.inner_spin),
          .outer_spin = mean(a.outer_spin, b.outer_spin),
          .inner_rolling = mean(a.inner_rolling, b.inner_rolling),
          .outer_rolling = mean(a.outer_rolling, b.outer_rolling)};
}

}  // namespace

// The closure weighs spins by Hertz's loads, also where a film then gives the loads. A ball that leaves the
// inner race is held by the outer one alone, and the cage takes it along with the speed of a ball that the
// inner race touches opposite to the outer one.
template <class T>
MovingBallRow::MotionForces<T> MovingBallRow::add_motion(Control control, Contacts<T>& at) const {
  const SpinWeights<T> outer_alone{T{}, T{} + 1.0};
  const T hold = hold_of(at.inner_load, holding_load_);
  const bool held = value_of(hold) > 0.0, rolls = value_of(hold) >= 1.0;
  const bool on_outer = value_of(at.outer_load) > 0.0;
  T inner_share{};  // of the gyroscopic moment over the diameter
  if (held) {
    SpinWeights<T> weights = outer_alone;
    if (inertia_.attitude == BallAttitude::race_control && control == Control::inner) {
      weights = {T{} + 1.0, T{}};
      inner_share = hold;
    } else if (inertia_.attitude == BallAttitude::minimum_friction) {
      weights.inner = inner_.ellipse * (at.inner_load * at.inner_approach);
      weights.outer = on_outer ? outer_.ellipse * (at.outer_load * at.outer_approach) : T{};
      inner_share = 2.0 * (at.inner_load / (at.inner_load + at.outer_load));
    } else if (inertia_.attitude == BallAttitude::hybrid) {
      weights.inner = inner_.pivot * (at.inner_load * root(at.inner_approach));
      weights.outer = on_outer ? outer_.pivot * (at.outer_load * root(at.outer_approach)) : T{};
      inner_share = 2.0 * (weights.inner / (weights.inner + weights.outer));
    }
    at.motion = ball_motion(at.inner, at.outer, weights, ball_radius_, pitch_radius_, speeds_);
  }
  if (!rolls) {
    const BallMotion<T> taken =
        ball_motion(at.outer, at.outer, outer_alone, ball_radius_, pitch_radius_, speeds_);
    at.motion = held ? between(taken, at.motion, hold) : taken;
  }
  const T outer_share = 2.0 - inner_share;
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

template <class T, class Outer, class Inner>
MovingBallRow::Forces<T> MovingBallRow::forces_of(const Outer& outer_r, const Outer& outer_z,
                                                  const Inner& inner_r, const Inner& inner_z,
                                                  const BallMemory& ball) const {
  Contacts<T> at = contacts_of<T>(outer_r, outer_z, inner_r, inner_z);
  if (frozen_) {
    const T inner_force_r = at.inner_load * at.inner.cosine, inner_force_z = at.inner_load * at.inner.sine;
    return {.ball_r = inner_force_r - at.outer_load * at.outer.cosine + ball.push,
            .ball_z = inner_force_z - at.outer_load * at.outer.sine,
            .ring_r = -inner_force_r,
            .ring_z = -inner_force_z,
            .ring_moment = T{},
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

// Forces of one ball at its place, with their slopes.
struct MovingBallRow::BallForces {
  Forces<Slopes> f;
  mechanics::Imbalance<2> on_ball;
  Eigen::Matrix2d ball_by_grooves;
  Eigen::Matrix<double, 3, 2> ring_by_grooves, ring_by_place;

  void of(const MovingBallRow& row, const Eigen::Vector2d& place, const BallMemory& ball) {
    const Eigen::Vector2d inner = ball.grooves - place;
    f = row.forces_of<Slopes>(coordinate<kOuter, 0>(place[0]), coordinate<kOuter, 1>(place[1]),
                              coordinate<kInner, 0>(inner[0]), coordinate<kInner, 1>(inner[1]), ball);
    ball_by_grooves << by_inner(f.ball_r), by_inner(f.ball_z);
    on_ball.force = {f.ball_r.value, f.ball_z.value};
    on_ball.stiffness << by_outer(f.ball_r), by_outer(f.ball_z);
    on_ball.stiffness = ball_by_grooves - on_ball.stiffness;
    on_ball.scale = std::max(f.inner_load.value, f.outer_load.value);
  }
  void on_ring() {
    ring_by_grooves << by_inner(f.ring_r), by_inner(f.ring_z), by_inner(f.ring_moment);
    ring_by_place << by_outer(f.ring_r), by_outer(f.ring_z), by_outer(f.ring_moment);
    ring_by_place -= ring_by_grooves;
  }
  Eigen::Vector3d ring() const { return {f.ring_r.value, f.ring_z.value, f.ring_moment.value}; }
};

// A step beyond the last one is taken into account to first order, which leaves an error of second order.
void MovingBallRow::remember(BallForces& at, BallMemory& ball) const {
  const auto& stiffness = at.on_ball.stiffness;
  const Eigen::Vector2d left = mechanics::lengths_under_any<2>(at.on_ball.force, stiffness);
  ball.follows.col(0) = mechanics::lengths_under_any<2>(at.ball_by_grooves.col(0), stiffness);
  ball.follows.col(1) = mechanics::lengths_under_any<2>(at.ball_by_grooves.col(1), stiffness);
  at.on_ring();
  ball.place += left;
  ball.ring = at.ring() + at.ring_by_place * left;
  ball.slope = at.ring_by_grooves + at.ring_by_place * ball.follows;
  ball.load = at.f.inner_load.value;
}

void MovingBallRow::settle_from(const Eigen::Vector2d& start, const Eigen::Vector2d& grooves,
                                BallMemory& ball) const {
  const bool begun = ball.found || frozen_;
  ball.grooves = grooves;
  ball.place = start;
  BallForces at;
  const auto imbalance_at = [&](const Eigen::Vector2d& place) {
    at.of(*this, place, ball);
    return at.on_ball;
  };
  // Of the loads. Its square is what remains: little on the way, round-off in the end, when a step of the
  // ring hardly moves the ball.
  const double near = begun ? 1e-4 : 1e-7;
  const mechanics::SearchLimits limits{.reach = 0.2 * outer_.distance,
                                       .size = grooves.norm(),
                                       .tolerance = near,
                                       .acceptable = near,
                                       .most_iterations = 60};
  mechanics::Imbalance<2> now;
  ball.found = (frozen_ ? mechanics::find_balance<2>(imbalance_at, limits, ball.place, now)
                        : mechanics::find_root<2>(imbalance_at, limits, ball.place, now))
                   .converged;
  remember(at, ball);
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

MovingBallRow::RingActs MovingBallRow::acts_of(Eigen::Index ball) const {
  const auto [cosine, sine] = geometry_.direction(ball);
  const double arm = 1.0 / lever();
  return (RingActs() << cosine, 0.0, 0.0,  //
          sine, 0.0, 0.0,                  //
          0.0, 1.0, 0.0,                   //
          0.0, cosine, arm * cosine,       //
          0.0, sine, arm * sine)
      .finished();
}

void MovingBallRow::add_forces(const RingPlace& place, RingImbalance& sum) {
  const bool known = known_ && *known_ == place;
  if (!known) settled_ = true;
  for (Eigen::Index j = 0; j < geometry_.count(); ++j) {
    BallMemory& ball = memory_[static_cast<std::size_t>(j)];
    if (!known) settle(grooves_at(j, place), ball);
    if (!ball.found) settled_ = false;
    const RingActs acts = acts_of(j);
    sum.force += acts * ball.ring;
    sum.stiffness -= (acts * ball.slope) * acts.leftCols<2>().transpose();
    sum.scale += ball.load;
  }
  known_ = place;
}

MovingBall MovingBallRow::ball_at(const BallMemory& ball) const {
  const Eigen::Vector2d inner = ball.grooves - ball.place;
  Contacts<double> at = contacts_of<double>(ball.place[0], ball.place[1], inner[0], inner[1]);
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

void MovingBallRow::freeze(bool frozen) {
  frozen_ = frozen;
  known_.reset();
}

void MovingBallRow::push_unlike(int path) {
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    const double unlike = 0.7 * std::sin(2.4 * static_cast<double>(j + 1) * path);
    memory_[j].push = usual_centrifugal_ * (1.0 + unlike);
    memory_[j].found = false;
  }
  known_.reset();
}

// Far above Hertz's stiffness of all contacts together, which is more than a row has.
bool MovingBallRow::has_stiffness() const {
  constexpr double kFarAbove = 10.0;
  const auto slope = [](const RaceSide& side, double load) {
    return 1.5 * std::pow(side.constant, 2.0 / 3.0) * std::cbrt(load);
  };
  double contacts = 0.0;
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  for (Eigen::Index j = 0; j < geometry_.count(); ++j) {
    const MovingBall& ball = balls_[static_cast<std::size_t>(j)];
    contacts += slope(inner_, ball.inner_load) + slope(outer_, ball.outer_load);
    const RingActs acts = acts_of(j);
    stiffness -= acts.topRows<3>() * memory_[static_cast<std::size_t>(j)].slope *
                 acts.topLeftCorner<3, 2>().transpose();
  }
  return stiffness.cwiseAbs().maxCoeff() <= kFarAbove * contacts;
}

int MovingBallRow::beyond_grooves() const {
  const auto ended = [](const ContactNormal<double>& normal, double load) {
    return load > 0.0 && normal.cosine <= 0.0;
  };
  return static_cast<int>(std::count_if(balls_.begin(), balls_.end(), [&](const MovingBall& ball) {
    return ended(ball.inner, ball.inner_load) || ended(ball.outer, ball.outer_load);
  }));
}

Eigen::VectorXd MovingBallRow::places(const RingPlace& ring) const {
  Eigen::VectorXd all(5 + 2 * geometry_.count());
  all.head<5>() = ring;
  for (Eigen::Index j = 0; j < geometry_.count(); ++j)
    all.segment<2>(5 + 2 * j) = memory_[static_cast<std::size_t>(j)].place;
  return all;
}

RingPlace MovingBallRow::put_places(const Eigen::VectorXd& all) {
  const RingPlace ring = all.head<5>();
  for (Eigen::Index j = 0; j < geometry_.count(); ++j) {
    BallMemory& ball = memory_[static_cast<std::size_t>(j)];
    ball.grooves = grooves_at(j, ring);
    ball.place = all.segment<2>(5 + 2 * j);
    BallForces at;
    at.of(*this, ball.place, ball);
    remember(at, ball);
    ball.found = true;
  }
  known_ = ring;
  settled_ = true;
  return ring;
}

MovingBallRow::AllForces MovingBallRow::all_forces(const Eigen::VectorXd& all) const {
  const Eigen::Index size = all.size();
  AllForces sum{.force = Eigen::VectorXd::Zero(size), .stiffness = Eigen::MatrixXd::Zero(size, size)};
  const RingPlace ring = all.head<5>();
  BallForces at;
  for (Eigen::Index j = 0; j < geometry_.count(); ++j) {
    const Eigen::Index row = 5 + 2 * j;
    BallMemory ball = memory_[static_cast<std::size_t>(j)];
    ball.grooves = grooves_at(j, ring);
    at.of(*this, all.segment<2>(row), ball);
    at.on_ring();
    const RingActs acts = acts_of(j);
    const auto grooves_by_ring = acts.leftCols<2>().transpose();
    sum.force.head<5>() += acts * at.ring();
    sum.force.segment<2>(row) = at.on_ball.force;
    sum.stiffness.topLeftCorner<5, 5>() -= acts * at.ring_by_grooves * grooves_by_ring;
    sum.stiffness.block<5, 2>(0, row) = -acts * at.ring_by_place;
    sum.stiffness.block<2, 5>(row, 0) = -at.ball_by_grooves * grooves_by_ring;
    sum.stiffness.block<2, 2>(row, row) = at.on_ball.stiffness;
    sum.scale += at.f.inner_load.value + at.f.outer_load.value;
  }
  return sum;
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

}  // namespace orbearing::bearing::equilibrium
