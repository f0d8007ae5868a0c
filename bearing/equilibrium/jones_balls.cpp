#include "bearing/equilibrium/jones_balls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/geometry.hpp"

namespace orbearing::bearing::equilibrium {

namespace {

// Slopes by the position of the ball from the outer groove centre (0 and 1), and of the inner centre from the
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

BallRaceLaw<double> race_law(const Bearing& bearing, Race race, const BallRow& row,
                             const std::optional<Lubricant>& oil) {
  const PointContact& contact = row.contact(race);
  const PointPressure unit = point_pressure(contact, 1.0);  // semi-axes grow with the cube root of the load
  BallRaceLaw<double> law{.constant = contact.constant};
  law.distance = (bearing.ring(race).osculation - 0.5) * bearing.balls().diameter;
  law.ellipse = std::pow(contact.constant, 2.0 / 3.0) * (unit.major * unit.major + unit.minor * unit.minor);
  law.pivot = std::cbrt(contact.constant) * unit.major * contact.ellipse.second;
  if (oil) law.film = film::approach_law(film::ball_contact(bearing, race), *oil);
  return law;
}

}  // namespace

BallLaw<double> ball_law(const Bearing& bearing, const RowMotion& motion, const BallRow& at_rest) {
  const BearingGeometry geometry = geometry_of(bearing);
  BallLaw<double> law{.inner = race_law(bearing, Race::inner, at_rest, motion.film),
                      .outer = race_law(bearing, Race::outer, at_rest, motion.film),
                      .ball_radius = geometry.element_radius,
                      .pitch_radius = geometry.pitch_radius,
                      .groove_radius = bearing.inner.osculation * bearing.balls().diameter,
                      .mass = motion.inertia.enabled ? geometry.element_mass : 0.0,
                      .speeds = motion.speeds,
                      .attitude = motion.inertia.attitude,
                      .gyroscopic_moment = motion.inertia.gyroscopic_moment,
                      .filmed = motion.film.has_value()};
  law.moment_of_inertia = 0.4 * law.mass * law.ball_radius * law.ball_radius;  // of a ball
  const double half_speed = 0.5 * std::max(std::abs(law.speeds.inner), std::abs(law.speeds.outer));
  constexpr double kHolds = 0.1;  // an assumption: balls are seen to skid at far higher loads
  law.holding_load = kHolds * law.mass * law.pitch_radius * half_speed * half_speed;
  return law;
}

JonesRow::JonesRow(const Bearing& bearing, const RowMotion& motion)
    : JonesRow(bearing, motion, BallRow(bearing)) {}

JonesRow::JonesRow(const Bearing& bearing, const RowMotion& motion, const BallRow& at_rest)
    : geometry_(at_rest), law_(ball_law(bearing, motion, at_rest)) {
  const double angle = bearing.balls().contact_angle;
  const ContactNormal<double> normal{std::cos(angle), std::sin(angle)};
  const double orbit =
      ball_motion<double>(normal, normal, {0.0, 1.0}, law_.ball_radius, law_.pitch_radius, law_.speeds).orbit;
  default_centrifugal_ = law_.mass * law_.pitch_radius * orbit * orbit;
  memory_.resize(static_cast<std::size_t>(geometry_.count()));
  balls_.resize(memory_.size());
}

double JonesRow::reach(double load) const {
  const double spin = std::max(std::abs(law_.speeds.inner), std::abs(law_.speeds.outer));
  return geometry_.reach(load + law_.mass * law_.pitch_radius * spin * spin);
}

template <class T, class Outer, class Inner>
BallForcesOf<T> JonesRow::forces_of(const Outer& outer_r, const Outer& outer_z, const Inner& inner_r,
                                    const Inner& inner_z, const BallMemory& ball) const {
  if (!frozen_) return law_.forces<T>(outer_r, outer_z, inner_r, inner_z, ball.control);
  const BallContacts<T> at = law_.contacts<T>(outer_r, outer_z, inner_r, inner_z);
  const T inner_force_r = at.inner_load * at.inner.cosine, inner_force_z = at.inner_load * at.inner.sine;
  return {.ball_r = inner_force_r - at.outer_load * at.outer.cosine + ball.push,
          .ball_z = inner_force_z - at.outer_load * at.outer.sine,
          .ring_r = -inner_force_r,
          .ring_z = -inner_force_z,
          .ring_moment = T{},
          .inner_load = at.inner_load,
          .outer_load = at.outer_load};
}

// Between both groove centres under the load of a ball at rest; if they are too near for that, against the
// outer race, as by the centrifugal load.
Eigen::Vector2d JonesRow::default_position(const Eigen::Vector2d& grooves) const {
  const double length = grooves.norm();
  const double approach = length - law_.inner.distance - law_.outer.distance;
  if (approach <= 0.0 && length > 0.0) return {law_.outer.distance, 0.0};
  const double share =
      std::pow(law_.outer.constant / law_.inner.constant, 2.0 / 3.0);  // inner over outer approach
  return (law_.outer.distance + approach / (1.0 + share)) / length * grooves;
}

// Forces of one ball at its position, with their slopes.
struct JonesRow::BallForces {
  BallForcesOf<Slopes> f;
  mechanics::Imbalance<2> on_ball;
  Eigen::Matrix2d ball_by_grooves;
  Eigen::Matrix<double, 3, 2> ring_by_grooves, ring_by_position;

  void of(const JonesRow& row, const Eigen::Vector2d& position, const BallMemory& ball) {
    const Eigen::Vector2d inner = ball.grooves - position;
    f = row.forces_of<Slopes>(coordinate<kOuter, 0>(position[0]), coordinate<kOuter, 1>(position[1]),
                              coordinate<kInner, 0>(inner[0]), coordinate<kInner, 1>(inner[1]), ball);
    ball_by_grooves << by_inner(f.ball_r), by_inner(f.ball_z);
    on_ball.force = {f.ball_r.value, f.ball_z.value};
    on_ball.stiffness << by_outer(f.ball_r), by_outer(f.ball_z);
    on_ball.stiffness = ball_by_grooves - on_ball.stiffness;
    on_ball.scale = std::max(f.inner_load.value, f.outer_load.value);
  }
  void on_ring() {
    ring_by_grooves << by_inner(f.ring_r), by_inner(f.ring_z), by_inner(f.ring_moment);
    ring_by_position << by_outer(f.ring_r), by_outer(f.ring_z), by_outer(f.ring_moment);
    ring_by_position -= ring_by_grooves;
  }
  Eigen::Vector3d ring() const { return {f.ring_r.value, f.ring_z.value, f.ring_moment.value}; }
};

// A step beyond the last one is taken into account to first order, which leaves an error of second order.
void JonesRow::remember(BallForces& at, BallMemory& ball) const {
  const auto& stiffness = at.on_ball.stiffness;
  const Eigen::Vector2d left = mechanics::lengths_under_any<2>(at.on_ball.force, stiffness);
  ball.follows.col(0) = mechanics::lengths_under_any<2>(at.ball_by_grooves.col(0), stiffness);
  ball.follows.col(1) = mechanics::lengths_under_any<2>(at.ball_by_grooves.col(1), stiffness);
  at.on_ring();
  ball.position += left;
  ball.ring = at.ring() + at.ring_by_position * left;
  ball.slope = at.ring_by_grooves + at.ring_by_position * ball.follows;
  ball.load = at.f.inner_load.value;
}

void JonesRow::settle_from(const Eigen::Vector2d& start, const Eigen::Vector2d& grooves,
                           BallMemory& ball) const {
  const bool begun = ball.found || frozen_;
  ball.grooves = grooves;
  ball.position = start;
  BallForces at;
  const auto imbalance_at = [&](const Eigen::Vector2d& position) {
    at.of(*this, position, ball);
    return at.on_ball;
  };
  // Relative to the loads. The remaining error is its square: small during the search, round-off at the end,
  // when a step of the ring hardly moves the ball.
  const double near = begun ? 1e-4 : 1e-7;
  const mechanics::SearchLimits limits{.reach = 0.2 * law_.outer.distance,
                                       .size = grooves.norm(),
                                       .tolerance = near,
                                       .acceptable = near,
                                       .most_iterations = 60};
  mechanics::Imbalance<2> now;
  ball.found = (frozen_ ? mechanics::find_balance<2>(imbalance_at, limits, ball.position, now)
                        : mechanics::find_root<2>(imbalance_at, limits, ball.position, now))
                   .converged;
  remember(at, ball);
}

void JonesRow::settle(const Eigen::Vector2d& grooves, BallMemory& ball) const {
  if (ball.found) settle_from(ball.position + ball.follows * (grooves - ball.grooves), grooves, ball);
  if (!ball.found) settle_from(default_position(grooves), grooves, ball);
  if (!ball.found) settle_from({law_.outer.distance, 0.0}, grooves, ball);
}

Eigen::Vector2d JonesRow::grooves_at(Eigen::Index ball, const RingPosition& position) const {
  const BallRow::BallPosition at = geometry_.position_of(ball, position);
  return {at.radial, at.axial};
}

JonesRow::RingActs JonesRow::acts_of(Eigen::Index ball) const {
  const auto [cosine, sine] = geometry_.direction(ball);
  const double arm = 1.0 / lever();
  return (RingActs() << cosine, 0.0, 0.0,  //
          sine, 0.0, 0.0,                  //
          0.0, 1.0, 0.0,                   //
          0.0, cosine, arm * cosine,       //
          0.0, sine, arm * sine)
      .finished();
}

void JonesRow::add_forces(const RingPosition& position, RingImbalance& sum) const {
  const bool known = known_ && *known_ == position;
  if (!known) settled_ = true;
  for (Eigen::Index j = 0; j < geometry_.count(); ++j) {
    BallMemory& ball = memory_[static_cast<std::size_t>(j)];
    if (!known) settle(grooves_at(j, position), ball);
    if (!ball.found) settled_ = false;
    const RingActs acts = acts_of(j);
    sum.force += acts * ball.ring;
    sum.stiffness -= (acts * ball.slope) * acts.leftCols<2>().transpose();
    sum.scale += ball.load;
  }
  known_ = position;
}

JonesBall JonesRow::ball_at(const BallMemory& ball) const {
  const Eigen::Vector2d inner = ball.grooves - ball.position;
  BallContacts<double> at = law_.contacts<double>(ball.position[0], ball.position[1], inner[0], inner[1]);
  const BallMotionForces<double> moved = law_.add_motion(ball.control, at);
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

void JonesRow::put_loads(const RingPosition& position, RingState& state) const {
  RingImbalance unused;
  add_forces(position, unused);
  const Eigen::Index count = geometry_.count();
  state.contact_load = state.contact_angle = Eigen::ArrayXd::Zero(count);
  state.outer_load = state.outer_angle = Eigen::ArrayXd::Zero(count);
  state.inner_rolling = state.inner_spin = state.outer_rolling = state.outer_spin = state.outer_load;
  state.ball_position.resize(2, count);
  state.inner_control.clear();
  for (Eigen::Index j = 0; j < count; ++j) {
    const JonesBall ball = ball_at(memory_[static_cast<std::size_t>(j)]);
    balls_[static_cast<std::size_t>(j)] = ball;
    const BallMemory& found = memory_[static_cast<std::size_t>(j)];
    state.ball_position.col(j) = found.position.array();
    state.inner_control.push_back(found.control == SpinControl::inner);
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

void JonesRow::freeze(bool frozen) {
  frozen_ = frozen;
  known_.reset();
}

void JonesRow::push_unlike(int path) {
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    const double unlike = 0.7 * std::sin(2.4 * static_cast<double>(j + 1) * path);
    memory_[j].push = default_centrifugal_ * (1.0 + unlike);
    memory_[j].found = false;
  }
  known_.reset();
}

// Far above Hertz's stiffness of all contacts together, which is more than a row has.
bool JonesRow::has_stiffness() const {
  constexpr double kFarAbove = 10.0;
  const auto slope = [](const BallRaceLaw<double>& side, double load) {
    return 1.5 * std::pow(side.constant, 2.0 / 3.0) * std::cbrt(load);
  };
  double contacts = 0.0;
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  for (Eigen::Index j = 0; j < geometry_.count(); ++j) {
    const JonesBall& ball = balls_[static_cast<std::size_t>(j)];
    contacts += slope(law_.inner, ball.inner_load) + slope(law_.outer, ball.outer_load);
    const RingActs acts = acts_of(j);
    stiffness -= acts.topRows<3>() * memory_[static_cast<std::size_t>(j)].slope *
                 acts.topLeftCorner<3, 2>().transpose();
  }
  return stiffness.cwiseAbs().maxCoeff() <= kFarAbove * contacts;
}

int JonesRow::beyond_grooves() const {
  const auto ended = [](const ContactNormal<double>& normal, double load) {
    return load > 0.0 && normal.cosine <= 0.0;
  };
  return static_cast<int>(std::count_if(balls_.begin(), balls_.end(), [&](const JonesBall& ball) {
    return ended(ball.inner, ball.inner_load) || ended(ball.outer, ball.outer_load);
  }));
}

Eigen::VectorXd JonesRow::ball_positions() const {
  Eigen::VectorXd all(2 * geometry_.count());
  for (Eigen::Index j = 0; j < geometry_.count(); ++j)
    all.segment<2>(2 * j) = memory_[static_cast<std::size_t>(j)].position;
  return all;
}

void JonesRow::put_positions(const RingPosition& ring, const Eigen::VectorXd& balls) {
  for (Eigen::Index j = 0; j < geometry_.count(); ++j) {
    BallMemory& ball = memory_[static_cast<std::size_t>(j)];
    ball.grooves = grooves_at(j, ring);
    ball.position = balls.segment<2>(2 * j);
    BallForces at;
    at.of(*this, ball.position, ball);
    remember(at, ball);
    ball.found = true;
  }
  known_ = ring;
  settled_ = true;
}

mechanics::Imbalance<Eigen::Dynamic> JonesRow::all_forces(const RingPosition& ring,
                                                          const Eigen::VectorXd& balls) const {
  const Eigen::Index size = 5 + balls.size();
  mechanics::Imbalance<Eigen::Dynamic> sum{.force = Eigen::VectorXd::Zero(size),
                                           .stiffness = Eigen::MatrixXd::Zero(size, size)};
  BallForces at;
  for (Eigen::Index j = 0; j < geometry_.count(); ++j) {
    const Eigen::Index row = 5 + 2 * j;
    BallMemory ball = memory_[static_cast<std::size_t>(j)];
    ball.grooves = grooves_at(j, ring);
    at.of(*this, balls.segment<2>(2 * j), ball);
    at.on_ring();
    const RingActs acts = acts_of(j);
    const auto grooves_by_ring = acts.leftCols<2>().transpose();
    sum.force.head<5>() += acts * at.ring();
    sum.force.segment<2>(row) = at.on_ball.force;
    sum.stiffness.topLeftCorner<5, 5>() -= acts * at.ring_by_grooves * grooves_by_ring;
    sum.stiffness.block<5, 2>(0, row) = -acts * at.ring_by_position;
    sum.stiffness.block<2, 5>(row, 0) = -at.ball_by_grooves * grooves_by_ring;
    sum.stiffness.block<2, 2>(row, row) = at.on_ball.stiffness;
    sum.scale += at.f.inner_load.value + at.f.outer_load.value;
  }
  return sum;
}

// By [Harris2006] the outer race controls where Q_o a_o E_o cos(a_i - a_o) > Q_i a_i E_i.
bool JonesRow::choose_control() {
  if (law_.attitude != BallAttitude::race_control) return false;
  bool changed = false;
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    const JonesBall& ball = balls_[j];
    const double inner =
        law_.inner.pivot / std::cbrt(law_.inner.constant) * std::pow(ball.inner_load, 4.0 / 3.0);
    const double outer =
        law_.outer.pivot / std::cbrt(law_.outer.constant) * std::pow(ball.outer_load, 4.0 / 3.0);
    const double across = ball.inner.cosine * ball.outer.cosine + ball.inner.sine * ball.outer.sine;
    const SpinControl control = outer * across > inner ? SpinControl::outer : SpinControl::inner;
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
