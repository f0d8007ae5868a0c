#include "bearing/motion/balls/ball_bearing.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/equilibrium/row_group.hpp"
#include "bearing/geometry.hpp"
#include "bearing/motion/balls/bodies.hpp"
#include "bearing/motion/balls/mixture.hpp"
#include "bearing/motion/balls/pocket_contact.hpp"
#include "bearing/motion/balls/race_contact.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::balls {

namespace {

using constants::two_pi;

std::unique_ptr<Engine> make_engine([[maybe_unused]] mechanics::InstructionSet set,
                                    const BallNumbers& numbers) {
#ifdef ORBEARING_HAS_AVX512
  if (set == mechanics::InstructionSet::avx512) {
    const bool half_empty = (numbers.balls + 7) / 8 % 2 == 1;
    return std::unique_ptr<Engine>(half_empty ? short_avx512_engine(numbers) : avx512_engine(numbers));
  }
#endif
#ifdef ORBEARING_HAS_AVX2
  if (set == mechanics::InstructionSet::avx2) return std::unique_ptr<Engine>(avx2_engine(numbers));
#endif
  return std::unique_ptr<Engine>(baseline_engine(numbers));
}

// All of a state in plain numbers.
struct Bodies {
  Body inner, outer, cage;
  double cage_turn = 0.0;
};

Bodies bodies_of(const StateLayout& layout, const Surroundings& now, const double* x) {
  const auto at = [&](int first, int unknowns, double spin, double turn) {
    return body_at(x + first, x + first + unknowns, spin, turn);
  };
  return {at(layout.inner(), kRingUnknowns, now.inner_spin, now.inner_turn),
          at(layout.outer(), kRingUnknowns, now.outer_spin, now.outer_turn),
          at(layout.cage(), kCageUnknowns, x[layout.cage() + 2 * kCageUnknowns - 1], 0.0),
          x[layout.cage() + 5]};
}

Ball<double> ball_of(const StateLayout& layout, const double* x, int j) {
  const auto entry = [&](int group) { return x[group * layout.lanes() + j]; };
  const double angle = entry(1), orbital = entry(4);
  return {entry(0),
          entry(2),
          std::cos(angle),
          std::sin(angle),
          {entry(3), entry(0) * orbital, entry(5)},
          {entry(6), entry(7), entry(8)},
          orbital};
}

// Everything that happens to one ball.
struct BallTouches {
  Ball<double> ball;
  BodyFromBall<double> ring[2];  // inner, outer
  RaceTouch<double> race[2];
  PocketTouch<double> pocket;
};

template <class Law>
[[gnu::noinline]] RaceTouch<double> touch_of(const Law& law, const BallNumbers& c,
                                             const GrooveNumbers& groove, const Ball<double>& ball,
                                             const BodyFromBall<double>& ring,
                                             const ScratchesFromBall<double>& spots) {
  ContactSlopes<double> unused;
  return race_touch<false>(law, c, groove, ball, ring, spots, unused);
}

std::vector<BallTouches> touches_of(const BallNumbers& c, const StateLayout& layout, const Bodies& bodies,
                                    const double* x) {
  std::vector<BallTouches> all;
  for (int j = 0; j < c.balls; ++j) {
    BallTouches& now = all.emplace_back();
    now.ball = ball_of(layout, x, j);
    ScratchesFromBall<double> spots;
    for (int i = 0; i < c.spots.count; ++i) {
      if (c.spots.ball[i] != j) continue;
      const double* position = x + layout.spot(i);
      spots.spot[spots.count++] = {
          in_axes_of(now.ball, unit(Triple<double>{position[0], position[1], position[2]})), 1.0};
    }
    for (const int race : {0, 1}) {
      now.ring[race] = seen(now.ball, race == 0 ? bodies.inner : bodies.outer);
      now.race[race] = with_shear_law(c.shear.law, [&](auto law) {
        return touch_of(law, c, race == 0 ? c.inner : c.outer, now.ball, now.ring[race], spots);
      });
    }
    const BodyFromBall<double> cage = seen(now.ball, bodies.cage);
    const double ahead = two_pi * j / c.balls + bodies.cage_turn - x[layout.lanes() + j];
    ContactSlopes<double> unused;
    PocketFilmSlopes<double> none;
    now.pocket = pocket_touch<false>(
        c, now.ball, cage, pocket_direction(cage.axis, std::cos(ahead), std::sin(ahead)), unused, none);
  }
  return all;
}

ContactSnapshot shown(const RaceTouch<double>& touch) {
  return {touch.load,          touch.approach, std::asin(std::clamp(touch.contact_angle, -1.0, 1.0)),
          touch.sliding_along, touch.spin,     touch.entrainment,
          touch.film};
}

// Moment of a ball on the drive of a ring: moment about the ring's axis of the ball's wrench on the ring.
double axial_moment(const BodyFromBall<double>& ring, const BallWrench<double>& on_ball) {
  return -dot(on_ball.moment + cross(ring.from_centre, on_ball.force), ring.axis);
}

BallNumbers with_moving_oil(BallNumbers numbers, const BallDuty& duty) {
  numbers.drag = carried_drag(numbers.drag, duty.inner.final_speed, duty.outer.final_speed);
  return numbers;
}

template <class Visit>
void visit_lands(const BallNumbers& c, const Bodies& bodies, const Visit& visit) {
  if (!c.land.present) return;
  const Body& ring = c.land.on_outer ? bodies.outer : bodies.inner;
  for (const double position : {-c.land.offset, c.land.offset}) {
    const LandOffset at = land_offset(bodies.cage, ring, position);
    visit(at,
          c.land.law.force(LandMotion<double>{at.by[0], at.by[1], at.by[2], at.by[3], at.by[4]}, ring.spin));
  }
}

}  // namespace

double RingDrive::speed_at(double time) const {
  return time < duration() ? speed + acceleration * time : final_speed;
}

double RingDrive::angle_at(double time) const {
  const double rising = std::min(time, duration());
  return rising * (speed + 0.5 * acceleration * rising) + (time - rising) * final_speed;
}

BallBearing::BallBearing(const BallNumbers& numbers, const BallDuty& duty, mechanics::InstructionSet set)
    : numbers_(with_moving_oil(numbers, duty)),
      duty_(duty),
      layout_{numbers.balls, numbers.spots.count},
      engine_(make_engine(set, numbers_)),
      last_x_(static_cast<std::size_t>(layout_.size())),
      last_rate_(last_x_.size()) {}

Surroundings BallBearing::surroundings(double time) const {
  return {duty_.inner.speed_at(time),
          duty_.outer.speed_at(time),
          duty_.inner.angle_at(time),
          duty_.outer.angle_at(time),
          duty_.on_inner,
          duty_.on_outer};
}

void BallBearing::derivative(double time, const double* x, double* dx) {
  engine_->derivative(x, surroundings(time), dx);
}

void BallBearing::linearise(double time, const double* x, double* dx) {
  engine_->linearise(x, surroundings(time), dx);
  std::copy_n(x, last_x_.size(), last_x_.begin());
  std::copy_n(dx, last_rate_.size(), last_rate_.begin());
}

void BallBearing::time_slope(double time, double* rate) {
  std::fill(rate, rate + layout_.size(), 0.0);
  const auto changes = [&](const RingDrive& drive, const GrooveNumbers& groove) {
    return drive.acceleration_at(time) != 0.0 || (groove.scratch.count > 0 && drive.speed_at(time) != 0.0);
  };
  if (!changes(duty_.inner, numbers_.inner) && !changes(duty_.outer, numbers_.outer)) return;
  constexpr double kStep = 1e-6;  // [s]  speeds are linear in time; friction and scratches are smooth
  derivative(time + kStep, last_x_.data(), rate);
  for (std::size_t i = 0; i < last_rate_.size(); ++i) rate[i] = (rate[i] - last_rate_[i]) / kStep;
}

BallSnapshot BallBearing::snapshot(double time, const double* x) const {
  const Surroundings now = surroundings(time);
  const Bodies bodies = bodies_of(layout_, now, x);
  BallSnapshot s;
  s.cage_speed = bodies.cage.spin;
  s.cage_position = {bodies.cage.centre.x, bodies.cage.centre.y, bodies.cage.centre.z};
  for (const BallTouches& ball : touches_of(numbers_, layout_, bodies, x)) {
    s.inner.push_back(shown(ball.race[0]));
    s.outer.push_back(shown(ball.race[1]));
    s.pocket_load.push_back(ball.pocket.load);
    s.inner_torque -= axial_moment(ball.ring[0], ball.race[0].on_ball);
    s.outer_torque -= axial_moment(ball.ring[1], ball.race[1].on_ball);
    for (const RaceTouch<double>& touch : ball.race) {
      s.loss.sliding += touch.sliding_power;
      s.loss.differential += touch.differential_power;
      s.loss.spin += touch.spin_power;
      s.loss.rolling += touch.rolling_power;
      s.loss.damping += touch.damping_power;
    }
    s.loss.cage += ball.pocket.damping_power + ball.pocket.friction_power + ball.pocket.film_power;
    const double speed = ball.ball.velocity.y, square = dot(ball.ball.spin, ball.ball.spin);
    s.loss.churning += numbers_.drag.translation * speed * speed * std::abs(speed) +
                       numbers_.drag.churning * std::sqrt(square + 1e-12) * square;
  }
  const double cage = bodies.cage.spin;
  s.loss.churning += numbers_.drag.cage_churning * cage * cage * std::abs(cage);
  const WallTorques walls = wall_torques(numbers_.drag.mixture, now.inner_spin, now.outer_spin);
  s.inner_torque += walls.inner;
  s.outer_torque += walls.outer;
  s.loss.churning += walls.inner * now.inner_spin + walls.outer * now.outer_spin;
  visit_lands(numbers_, bodies, [&](const LandOffset&, const LandForce<double>& land) {
    s.loss.cage += land.power;
    (numbers_.land.on_outer ? s.outer_torque : s.inner_torque) -= land.on_land;
  });
  return s;
}

BallEnergy BallBearing::energy(const double* x, double time) const {
  const Bodies bodies = bodies_of(layout_, surroundings(time), x);
  const BallNumbers& c = numbers_;
  BallEnergy energy;
  for (const BallTouches& now : touches_of(c, layout_, bodies, x)) {
    energy.races += race_energy(c.inner, now.race[0].approach) + race_energy(c.outer, now.race[1].approach);
    energy.pockets += pocket_energy(c.pocket, now.pocket.approach);
    energy.kinetic += 0.5 * c.mass * dot(now.ball.velocity, now.ball.velocity) +
                      0.5 * c.inertia * dot(now.ball.spin, now.ball.spin);
  }
  const auto add = [&](const BodyNumbers& numbers, const Body& body) {
    if (numbers.mass > 0.0)
      energy.kinetic += 0.5 * numbers.mass * dot(body.velocity, body.velocity) +
                        0.5 * numbers.across * dot(body.axis_rate, body.axis_rate);
  };
  add(c.inner_ring, bodies.inner);
  add(c.outer_ring, bodies.outer);
  add(c.cage, bodies.cage);
  energy.kinetic += 0.5 * c.cage.polar * bodies.cage.spin * bodies.cage.spin;
  visit_lands(c, bodies, [&](const LandOffset& at, const LandForce<double>&) {
    energy.lands += c.land.law.energy(std::hypot(at.by[0], at.by[1]));
  });
  return energy;
}

double BallBearing::power_input(double time, const double* x) const {
  const BallSnapshot s = snapshot(time, x);
  const Surroundings now = surroundings(time);
  double power = s.inner_torque * now.inner_spin + s.outer_torque * now.outer_spin;
  const auto add = [&](const BodyNumbers& numbers, int first, const RingLoad& load) {
    if (!(numbers.mass > 0.0)) return;
    const Bodies bodies = bodies_of(layout_, now, x);
    const Body& body = first == layout_.inner() ? bodies.inner : bodies.outer;
    const double* v = x + first + kRingUnknowns;
    for (int i = 0; i < 3; ++i) power += load.by[i] * v[i];
    const Triple<double> across = cross(body.axis, body.axis_rate);
    power += load.by[3] * across.y - load.by[4] * across.x;
  };
  add(numbers_.inner_ring, layout_.inner(), duty_.on_inner);
  add(numbers_.outer_ring, layout_.outer(), duty_.on_outer);
  return power;
}

std::vector<double> start_state(const Bearing& bearing, const BallBearing& model, double first,
                                double share) {
  const BallNumbers& c = model.numbers();
  const StateLayout layout = model.layout();
  // Load on the inner ring; a free outer one carries the opposite and moves the opposite way.
  const bool outer_moves = c.outer_ring.mass > 0.0 && !(c.inner_ring.mass > 0.0);
  RingLoad load = outer_moves ? model.duty().on_outer : model.duty().on_inner;
  if (outer_moves)
    for (double& part : load.by) part = -part;
  equilibrium::RingLoad static_load;
  static_load.radial = std::hypot(load.by[0], load.by[1]);
  static_load.axial = load.by[2];
  // Moments lean the axis the other way than a tilt counts, in the planes along and across the radial load.
  const double along = static_load.radial > 0.0 ? load.by[0] / static_load.radial : 1.0;
  const double across = static_load.radial > 0.0 ? load.by[1] / static_load.radial : 0.0;
  static_load.moment = -(load.by[3] * along + load.by[4] * across);
  static_load.moment_across = -(load.by[4] * along - load.by[3] * across);
  const double direction = static_load.radial > 0.0 ? std::atan2(load.by[1], load.by[0]) : 0.0;
  Bearing turned = bearing;
  turned.first_element = first - direction;
  equilibrium::RingState state = equilibrium::balance_bearing(turned, static_load);
  std::vector<double> x(static_cast<std::size_t>(layout.size()), 0.0);
  const double cosine = std::cos(direction), sine = std::sin(direction);
  const double tilts[2] = {-state.tilt * cosine + state.lateral_tilt * sine,
                           -state.tilt * sine - state.lateral_tilt * cosine};
  const double displaced[kRingUnknowns] = {state.radial * cosine - state.lateral * sine,
                                           state.radial * sine + state.lateral * cosine, state.axial,
                                           tilts[0], tilts[1]};
  for (int i = 0; i < kRingUnknowns; ++i)
    x[static_cast<std::size_t>((outer_moves ? layout.outer() : layout.inner()) + i)] =
        outer_moves ? -displaced[i] : displaced[i];
  const double inner_speed = model.duty().inner.speed, outer_speed = model.duty().outer.speed;
  // Balls and cage go round together, as the mean of the loaded contact angles has it.
  const double carried = std::max(1e-300, state.contact_load.sum());
  BearingGeometry leaning = geometry_of(bearing);
  leaning.slenderness =
      2.0 * c.radius / bearing.pitch_diameter *
      (state.contact_load.sum() > 0.0 ? (state.contact_load * state.contact_angle.cos()).sum() / carried
                                      : std::cos(bearing.balls().contact_angle));
  const double cage = share * kinematic_cage_speed(leaning, inner_speed, outer_speed);
  const Surroundings now = model.surroundings(0.0);
  const Bodies bodies = bodies_of(layout, now, x.data());
  const int lanes = layout.lanes();
  for (int j = 0; j < lanes; ++j) x[static_cast<std::size_t>(j)] = c.pitch_radius;
  for (int j = 0; j < c.balls; ++j) {
    const double angle = first + two_pi * j / c.balls;
    const auto entry = [&](int group) -> double& { return x[static_cast<std::size_t>(group * lanes + j)]; };
    // On the line of both groove centres, with the approach that its load needs on the outer race; an
    // unloaded ball midway.
    const Ball<double> axes{0.0, 0.0, std::cos(angle), std::sin(angle), {}, {}, 0.0};
    const auto groove_centre = [&](const Body& ring, const GrooveNumbers& groove) {
      const Triple<double> centre = in_axes_of(axes, ring.centre), axis = in_axes_of(axes, ring.axis);
      return Eigen::Vector2d(groove.centre_radius + centre.x + groove.centre_axial * axis.x,
                             centre.z + groove.centre_axial - groove.centre_radius * axis.x);
    };
    const Eigen::Vector2d at_inner = groove_centre(bodies.inner, c.inner);
    const Eigen::Vector2d at_outer = groove_centre(bodies.outer, c.outer);
    const double inner_r = at_inner.x(), inner_z = at_inner.y(), outer_r = at_outer.x(),
                 outer_z = at_outer.y();
    const double length = std::hypot(inner_r - outer_r, inner_z - outer_z);
    const double load_here = state.contact_load[j];
    const double from_outer = load_here > 0.0
                                  ? c.outer.play + std::pow(load_here / c.outer.stiffness, 2.0 / 3.0)
                                  : std::min(c.outer.play, 0.5 * length);
    const double part = length > 0.0 ? from_outer / length : 0.0;
    entry(0) = outer_r + part * (inner_r - outer_r);
    entry(1) = angle;
    entry(2) = outer_z + part * (inner_z - outer_z);
    entry(4) = cage;
    // Rolling on the outer race: relative to the cage about the line across the contact's normal.
    const double angle_here = load_here > 0.0 ? state.contact_angle[j] : bearing.balls().contact_angle;
    const double rotating = (share * outer_speed - cage) * (entry(0) / c.radius + std::cos(angle_here));
    entry(6) = -rotating * std::sin(angle_here);
    entry(8) = rotating * std::cos(angle_here) + cage;
  }
  for (int i = 0; i < c.spots.count; ++i) {
    const double lean = bearing.balls().contact_angle, ahead = c.spots.angle[i];
    const double angle = x[static_cast<std::size_t>(lanes + c.spots.ball[i])];
    const Ball<double> axes{0.0, 0.0, std::cos(angle), std::sin(angle), {}, {}, 0.0};
    const Triple<double> position = in_bearing_axes(
        axes,
        Triple<double>{std::cos(lean) * std::cos(ahead), std::sin(ahead), std::sin(lean) * std::cos(ahead)});
    double* into = x.data() + layout.spot(i);
    into[0] = position.x;
    into[1] = position.y;
    into[2] = position.z;
  }
  x[static_cast<std::size_t>(layout.cage() + 5)] = first;
  x[static_cast<std::size_t>(layout.cage() + 2 * kCageUnknowns - 1)] = cage;
  return x;
}

}  // namespace orbearing::bearing::balls
