#include "tests/reference/inertial_balls.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace orbearing::reference::inertial_balls {

using bearing::balls::BallNumbers;
using bearing::balls::BodyNumbers;
using bearing::balls::GrooveNumbers;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLeastLoad = 1e-6;       // [N]    added to what ellipse, film and friction see
constexpr double kLeastSliding = 1e-7;    // [m/s]  rounds the size of the sliding at a point
constexpr double kLeastRotating = 1e-12;  // [rad^2/s^2]

Vector axis_of(const Body& body) {
  return body.attitude.col(2);
}

Vector velocity_at(const Body& body, const Vector& point) {
  return body.velocity + body.rotating.cross(point - body.position);
}

Matrix cross_matrix(const Vector& v) {
  Matrix m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Matrix inertia_of(const BodyNumbers& numbers, const Body& body) {
  const Vector principal(numbers.across, numbers.across, numbers.polar);
  return body.attitude * principal.asDiagonal() * body.attitude.transpose();
}

void act_and_react(Wrench& on_one, const Body& one, Wrench& on_other, const Body& other, const Vector& point,
                   const Vector& force_on_one) {
  on_one.add(one, point, force_on_one);
  on_other.add(other, point, -force_on_one);
}

struct Load {
  double elastic, damped;
};

Load load_of(double stiffness, double damping, double approach, double closing) {
  const double elastic = stiffness * approach * std::sqrt(approach);
  return {elastic, elastic * std::max(0.0, 1.0 + damping * closing)};
}

// Coefficient of friction at one point, by the size of the sliding there.
double friction_coefficient(const bearing::ShearParameters& law, double sliding, double pressure,
                            double film) {
  const double viscosity =
      law.viscosity * std::exp(std::min(law.pressure_viscosity * pressure, law.largest_exponent));
  const double limit = law.limiting_friction * pressure;  // [Pa]
  const double newtonian = viscosity * sliding / film;
  const auto limited = [&](double stress) { return law.limiting_friction * -std::expm1(-stress / limit); };
  switch (law.law) {
    case bearing::TractionLaw::regularised_coulomb:
      return law.friction * sliding / std::hypot(sliding, law.sliding_scale);
    case bearing::TractionLaw::limiting_shear:
      return limited(newtonian);
    case bearing::TractionLaw::ree_eyring:
      return limited(law.eyring_stress * std::asinh(newtonian / law.eyring_stress));
  }
  throw std::invalid_argument("no such law of friction");
}

// Load that the squeeze film adds: pressure (c - a x)/h^2 over the plane where it is positive, less the load
// without closing, by Simpson's rule in polar coordinates; film and bodies deflect in series.
double squeezed_load(const bearing::balls::GrooveNumbers& groove, double approach, double elastic,
                     double speed, double closing) {
  const bearing::RigidPointFilm& oil = groove.squeeze.film;
  const double rx = groove.rolling_radius;
  const double ry = std::pow(oil.size / M_PI, 2) / rx;
  const auto rigid = [&](double gap, double v) {
    const double c = 6.0 * oil.viscosity * v / (1.0 / rx + 1.0 / ry);
    const double a = 12.0 * oil.viscosity * speed / (3.0 + 2.0 * rx / ry) * std::sqrt(2.0 * rx * gap);
    // Over y in closed form, x = sqrt(2 R_x g) tan t from where the pressure ends.
    constexpr int kPieces = 2000;
    const double begin = std::atan(-c / a), end = 0.5 * M_PI;
    const auto density = [&](double t) { return 0.5 * M_PI * (c * std::cos(t) + a * std::sin(t)); };
    double sum = density(begin) + density(end);
    for (int i = 1; i < kPieces; ++i)
      sum += (i % 2 == 1 ? 4.0 : 2.0) * density(begin + (end - begin) * i / kPieces);
    return 2.0 * std::sqrt(rx * ry) / gap * sum * (end - begin) / (3.0 * kPieces);
  };
  const auto& law = groove.central_film;
  const double film =
      std::exp(law.log_factor) * std::pow(speed, law.speed) * std::pow(std::max(elastic, 1.0), -law.load);
  const double gap = std::max(film + std::max(-approach, 0.0), oil.least_gap);
  const double wedge = rigid(gap, 0.0);
  double share = 1.0;
  if (approach > 0.0) {
    const double film_yields = (wedge + law.load * elastic) / (wedge + elastic) * gap;
    share = film_yields / (film_yields + 2.0 / 3.0 * approach);
  }
  return share * (rigid(gap, share * closing) - wedge);
}

// Axes of a ball's place about the bearing's axis.
struct Position {
  explicit Position(const Body& ball)
      : radius(std::hypot(ball.position.x(), ball.position.y())),
        outward(ball.position.x() / radius, ball.position.y() / radius, 0.0),
        ahead(Vector::UnitZ().cross(outward)) {}

  double radius;
  Vector outward, ahead;
};

Contact roll(const BallNumbers& b, const GrooveNumbers& groove, const Body& ball, const Body& ring,
             Wrench& on_ball, Wrench& on_ring, Outcome& total) {
  Contact contact;
  const Vector axis = axis_of(ring), arm = ball.position - ring.position;
  const Vector outward = inertial_balls::across(axis, arm).normalized();
  const Vector groove_centre = ring.position + groove.centre_radius * outward + groove.centre_axial * axis;
  const Vector line = ball.position - groove_centre, n = line.normalized();
  contact.approach = line.norm() - groove.play;
  if (contact.approach <= 0.0 && !groove.squeeze.present()) return contact;

  const Vector point = ball.position + b.radius * n;
  const Vector passing = velocity_at(ring, point) - velocity_at(ball, point);
  const Vector rotating = ring.rotating - ball.rotating;
  const double closing = -passing.dot(n);
  const Vector along = axis.cross(outward), across = n.cross(along);
  const Position position(ball);
  // Speed with which the surfaces, on the average, run through the contact, which goes round with the ball.
  const double orbital = ball.velocity.dot(position.ahead) / position.radius;  // [rad/s]
  const double mean = velocity_at(ball, point).dot(position.ahead) +
                      0.5 * passing.dot(along) * along.dot(position.ahead) -
                      orbital * (position.radius + b.radius * n.dot(position.outward));
  const double drawn = std::hypot(mean, b.entrainment_scale);

  Load load = load_of(groove.stiffness, groove.damping, std::max(contact.approach, 0.0), closing);
  if (groove.squeeze.present())
    load.damped =
        std::max(0.0, load.damped + squeezed_load(groove, contact.approach, load.elastic, drawn, closing));
  total.elastic_power += load.elastic * closing;
  total.loss.damping += (load.damped - load.elastic) * closing;
  contact.load = load.damped;
  if (load.damped <= 0.0) return contact;
  act_and_react(on_ball, ball, on_ring, ring, point, -load.damped * n);

  const double seen = load.damped + kLeastLoad, scale = std::cbrt(seen);
  const auto& film = groove.central_film;
  contact.film = std::exp(film.log_factor) * std::pow(drawn, film.speed) * std::pow(seen, -film.load);
  contact.contact_angle = std::asin(n.z());
  contact.sliding = passing.dot(along);
  contact.spin = rotating.dot(n);
  contact.entrainment = drawn;

  const double half_across = groove.across * scale, half_along = groove.along * scale;
  for (int i = 0; i < b.points.count; ++i) {
    const double x = half_across * b.points.across[i], y = half_along * b.points.along[i];
    const double height = half_across * half_across * (0.5 * groove.curvature - 0.5 / b.radius) -
                          0.5 * groove.curvature * x * x;
    const Vector there = point + x * across + y * along + height * n;
    const auto in_plane = [&](const Vector& v) { return inertial_balls::across(n, v); };
    const Vector sliding = in_plane(velocity_at(ring, there) - velocity_at(ball, there));
    const double size = std::hypot(sliding.norm(), kLeastSliding);
    const double pressure = b.points.pressure[i] * groove.pressure * scale;
    const double limit = friction_coefficient(b.shear, size, pressure, contact.film);
    const Vector force = b.points.share[i] * seen * limit / size * sliding;
    act_and_react(on_ball, ball, on_ring, ring, there, force);
    total.loss.friction += force.dot(sliding);
    total.loss.sliding += force.dot(in_plane(passing));
    total.loss.spin += force.dot(in_plane(rotating.dot(n) * n.cross(there - point)));
  }

  const double rolling = rotating.dot(across) * groove.rolling_radius;
  const double couple = groove.rolling_factor *
                        std::pow(std::hypot(rolling, b.entrainment_scale), groove.rolling.speed - 1.0) *
                        std::pow(seen, groove.rolling.load) * rolling;
  on_ball.moment += couple * across;
  on_ring.moment -= couple * across;
  total.loss.rolling += couple * rotating.dot(across);
  return contact;
}

// Oil between a ball and the side `n` of its pocket; `straight_up` is the pocket's axis, along which it is
// straight. Sphere and cylinder: pressure (c - a . x) / h^2, cut at zero.
void oil_in_pocket(const BallNumbers& b, double gap, const Vector& n, const Vector& straight_up,
                   const Body& ball, const Body& cage, Wrench& on_ball, Wrench& on_cage, Contact& contact,
                   Outcome& total, double sign) {
  const bearing::RigidPointFilm& film = b.pocket.film;
  const double along_radius = b.radius, round_radius = b.radius * (b.radius + b.pocket.play) / b.pocket.play;
  const double mean = std::sqrt(along_radius * round_radius), g = std::max(gap, film.least_gap);
  const Vector point = ball.position + b.radius * n, up = straight_up, aside = n.cross(up);
  const Vector centres = velocity_at(cage, ball.position) - velocity_at(ball, ball.position);
  const Vector turn = cage.rotating - ball.rotating, by_turning = b.radius * turn.cross(n);
  const Vector passing = centres + by_turning;
  const double closing = -passing.dot(n);
  const double c = 6.0 * film.viscosity * closing / (1.0 / along_radius + 1.0 / round_radius);
  const double ux = 0.5 * passing.dot(up), uy = 0.5 * passing.dot(aside);
  const double ax = 12.0 * film.viscosity * ux / (3.0 + 2.0 * along_radius / round_radius);
  const double ay = 12.0 * film.viscosity * uy / (3.0 + 2.0 * round_radius / along_radius);
  const double wedge = std::sqrt(2.0 * g * (along_radius * ax * ax + round_radius * ay * ay));
  const double both = std::hypot(wedge, c);
  const double load = kPi * mean / g * (c + both);
  const double shear = kPi * mean * film.viscosity * (both > 0.0 ? 1.0 + std::max(0.0, c) / both : 1.0) *
                       std::log(1.0 + film.extent / g);
  const Vector sliding = passing + closing * n;
  act_and_react(on_ball, ball, on_cage, cage, point, shear * sliding - load * n);
  // Surfaces that roll on each other meet a couple.
  const Vector couple =
      shear * b.radius *
      (3.0 / (3.0 + 2.0 * along_radius / round_radius) * by_turning.dot(up) * n.cross(up) +
       3.0 / (3.0 + 2.0 * round_radius / along_radius) * by_turning.dot(aside) * n.cross(aside));
  on_ball.moment += couple;
  on_cage.moment -= couple;
  contact.load += sign * load;
  total.loss.pockets += load * closing + shear * sliding.squaredNorm() + couple.dot(turn);
}

Contact guide_ball(const BallNumbers& b, int pocket, const Body& ball, const Body& cage, Wrench& on_ball,
                   Wrench& on_cage, Outcome& total) {
  Contact contact;
  const double angle = 2.0 * kPi * pocket / b.balls;
  const Vector direction = cage.attitude * Vector(std::cos(angle), std::sin(angle), 0.0);
  const Vector axis = axis_of(cage), ahead = axis.cross(direction), arm = ball.position - cage.position;
  // Nearest point of the middle plane of the slot: along the pocket it lies where the ball does.
  const double straight = std::clamp(arm.dot(ahead), -b.pocket.half_straight, b.pocket.half_straight);
  const Vector off = arm - arm.dot(direction) * direction - straight * ahead;
  contact.approach = off.norm() - b.pocket.play;
  if (b.pocket.film.present()) {
    const Vector n = off.normalized();
    const double wider = 2.0 * (b.pocket.play + b.pocket.half_straight * std::abs(n.dot(ahead)));
    const double near = -contact.approach;
    oil_in_pocket(b, near, n, direction, ball, cage, on_ball, on_cage, contact, total, 1.0);
    oil_in_pocket(b, wider - near, -n, direction, ball, cage, on_ball, on_cage, contact, total, -1.0);
    // Round the middle.
    const double e = std::min(1.0, off.norm() / b.pocket.play), least = b.pocket.film.least_gap;
    const double mean = b.radius * std::sqrt((b.radius + b.pocket.play) / b.pocket.play);
    const double by = 6.0 * b.pocket.film.viscosity /
                      (1.0 / b.radius + b.pocket.play / (b.radius * (b.radius + b.pocket.play))) * kPi *
                      mean * (1.0 / std::max(near, least) + 1.0 / std::max(wider - near, least)) *
                      (1.0 - e * e) / (1.0 + 2.0 * e * e);
    const Vector aside = n.cross(direction);
    const Vector passing = velocity_at(cage, ball.position) - velocity_at(ball, ball.position);
    const Vector force = by * passing.dot(aside) * aside;
    act_and_react(on_ball, ball, on_cage, cage, ball.position, force);
    total.loss.pockets += force.dot(passing);
  }
  if (contact.approach <= 0.0) return contact;
  const Vector n = off.normalized(), point = ball.position + b.radius * n;
  const Vector passing = velocity_at(cage, point) - velocity_at(ball, point);
  const double closing = -passing.dot(n);
  const Load load = load_of(b.pocket.stiffness, b.pocket.damping, contact.approach, closing);
  contact.load += load.damped;
  const Vector sliding = passing + closing * n;
  const Vector friction =
      b.pocket.friction * load.damped / std::hypot(sliding.norm(), b.pocket.sliding_scale) * sliding;
  act_and_react(on_ball, ball, on_cage, cage, point, friction - load.damped * n);
  total.elastic_power += load.elastic * closing;
  total.loss.pockets += friction.dot(sliding) + (load.damped - load.elastic) * closing;
  return contact;
}

void guide_cage(const BallNumbers& b, const Body& cage, const Body& ring, Wrench& on_cage, Wrench& on_ring,
                Outcome& total) {
  const bearing::LandLaw& law = b.land.law;
  const Vector cage_axis = axis_of(cage), ring_axis = axis_of(ring);
  for (const double position : {-b.land.offset, b.land.offset}) {
    const Vector at_cage = cage.position + position * cage_axis,
                 at_ring = ring.position + position * ring_axis;
    const Vector offset = at_cage - at_ring;
    const Vector velocity = cage.velocity - ring.velocity +
                            position * (cage.rotating.cross(cage_axis) - ring.rotating.cross(ring_axis));
    const double cage_spin = cage.rotating.dot(cage_axis), ring_spin = ring.rotating.dot(ring_axis);
    const auto found = law.forces<double>({.offset_x = offset.x(),
                                           .offset_y = offset.y(),
                                           .velocity_x = velocity.x(),
                                           .velocity_y = velocity.y(),
                                           .cage_speed = cage_spin},
                                          ring_spin);
    const Vector film(found.film_x, found.film_y, 0.0), touch(found.touch_x, found.touch_y, 0.0);
    const double couple = 0.5 * (offset.x() * film.y() - offset.y() * film.x());
    const double arm = law.side * law.cage_radius, distance = std::hypot(offset.x(), offset.y());
    const double about_cage = found.shear - couple + arm * found.touch_friction;
    const double about_ring = -found.shear - couple - (arm + distance) * found.touch_friction;
    on_cage.add(cage, at_cage, film + touch);
    on_ring.add(ring, at_ring, -film - touch);
    on_cage.moment += about_cage * cage_axis;
    on_ring.moment += about_ring * ring_axis;
    const double depth = distance - law.largest_eccentricity * law.clearance;
    const double springs =
        depth > 0.0
            ? law.stiffness * depth * (velocity.x() * offset.x() + velocity.y() * offset.y()) / distance
            : 0.0;
    total.touching_lands += depth > 0.0 ? 1 : 0;
    total.elastic_power += springs;
    total.loss.lands -=
        (film + touch).dot(velocity) + about_cage * cage_spin + about_ring * ring_spin + springs;
  }
}

void drag(const BallNumbers& b, const Body& ball, Wrench& on_ball, Outcome& total) {
  const Position position(ball);
  const double speed = ball.velocity.dot(position.ahead);
  const double size = std::sqrt(ball.rotating.squaredNorm() + kLeastRotating);
  const Vector force = -b.drag.translation * speed * std::abs(speed) * position.ahead;
  const Vector moment = -b.drag.churning * size * ball.rotating;
  on_ball.force += force;
  on_ball.moment += moment;
  total.loss.churning -= force.dot(ball.velocity) + moment.dot(ball.rotating);
}

// Shear of the oil that goes round, on both walls: half of the friction that [BilgenBoulos1973] have for a
// cylinder in another, at twice the wall's own speed.
void stir(const BallNumbers& b, const Body& inner, const Body& outer, Wrench& on_inner, Wrench& on_outer,
          Outcome& total) {
  const auto& m = b.drag.mixture;
  if (!m.carried) return;
  const auto spin = [](const Body& ring) { return ring.rotating.dot(axis_of(ring)); };
  const double ball = m.slenderness * b.pitch_radius;
  const double low = b.pitch_radius - ball, high = b.pitch_radius + ball;
  const double oil = m.share * (low * spin(inner) + high * spin(outer)) / (2.0 * b.pitch_radius);
  const double gap = 2.0 * b.radius, inside = b.pitch_radius - b.radius;
  const auto shear = [&](double radius, const Body& ring, Wrench& on_ring) {
    const double speed = radius * (spin(ring) - oil);
    if (speed == 0.0) return;
    const double re = 2.0 * std::abs(speed) * gap / m.viscosity, r = std::pow(gap / inside, 0.3);
    double c = 0.065 * std::pow(re, -0.2);
    if (re < 1e4) c = std::max(c, 1.03 / std::sqrt(re));
    if (re < 1e3) c = std::max(c, 2.0 / std::pow(re, 0.6));
    if (re < 1e2) c = std::max(c, 10.0 / re);
    const double stress = c * r * m.density * speed * std::abs(speed);
    const Vector moment = -stress * radius * 6.283185307179586 * radius * m.width * axis_of(ring);
    on_ring.moment += moment;
    total.loss.churning -= moment.dot(ring.rotating);
  };
  shear(inside, inner, on_inner);
  shear(b.pitch_radius + b.radius, outer, on_outer);
}

// J w' = M - w x J w.
Body rate_of(const BodyNumbers& numbers, const Body& body, const Wrench& load) {
  Body rate;
  rate.position = body.velocity;
  rate.velocity = load.force / numbers.mass;
  rate.attitude = cross_matrix(body.rotating) * body.attitude;
  const Matrix inertia = inertia_of(numbers, body);
  rate.rotating = inertia.inverse() * (load.moment - body.rotating.cross(inertia * body.rotating));
  return rate;
}

// A ring is turned by its drive, whose moment acts about the axis. A held one stays.
Body ring_rate(const BodyNumbers& numbers, const Body& ring, const Wrench& load, double acceleration,
               double& torque) {
  const Vector axis = axis_of(ring);
  torque = -load.moment.dot(axis);
  Body rate;
  rate.attitude = cross_matrix(axis * ring.rotating.dot(axis)) * ring.attitude;
  rate.rotating = acceleration * axis;
  if (numbers.mass == 0.0) return rate;
  Wrench driven = load;
  driven.moment += (torque + numbers.polar * acceleration) * axis;
  return rate_of(numbers, ring, driven);
}

template <class Take>
void for_each_body(const BallNumbers& b, const Bodies& bodies, const Bodies& rate, const Take& take) {
  const BodyNumbers ball{.mass = b.mass, .across = b.inertia, .polar = b.inertia};
  for (std::size_t j = 0; j < bodies.balls.size(); ++j) take(ball, bodies.balls[j], rate.balls[j]);
  take(b.cage, bodies.cage, rate.cage);
  take(b.inner_ring, bodies.inner, rate.inner);
  take(b.outer_ring, bodies.outer, rate.outer);
}

}  // namespace

Vector across(const Vector& axis, const Vector& v) {
  return v - v.dot(axis) * axis;
}

void Wrench::add(const Body& body, const Vector& point, const Vector& force_there) {
  force += force_there;
  moment += (point - body.position).cross(force_there);
}

Bodies Bodies::after(double time, const Bodies& rate) const {
  Bodies then = *this;
  const auto move = [&](Body& body, const Body& by) {
    body.position += time * by.position;
    body.velocity += time * by.velocity;
    body.attitude += time * by.attitude;
    body.rotating += time * by.rotating;
  };
  for (std::size_t j = 0; j < balls.size(); ++j) move(then.balls[j], rate.balls[j]);
  move(then.cage, rate.cage);
  move(then.inner, rate.inner);
  move(then.outer, rate.outer);
  return then;
}

Outcome outcome(const BallNumbers& b, const Surroundings& around, const Bodies& bodies) {
  Outcome result;
  Wrench on_cage, on_inner = around.on_inner, on_outer = around.on_outer;
  on_inner.moment = across(axis_of(bodies.inner), on_inner.moment);
  on_outer.moment = across(axis_of(bodies.outer), on_outer.moment);
  for (std::size_t j = 0; j < bodies.balls.size(); ++j) {
    const Body& ball = bodies.balls[j];
    Wrench on_ball;
    result.inner.push_back(roll(b, b.inner, ball, bodies.inner, on_ball, on_inner, result));
    result.outer.push_back(roll(b, b.outer, ball, bodies.outer, on_ball, on_outer, result));
    result.pocket.push_back(guide_ball(b, static_cast<int>(j), ball, bodies.cage, on_ball, on_cage, result));
    drag(b, ball, on_ball, result);
    Body rate;
    rate.position = ball.velocity;
    rate.velocity = on_ball.force / b.mass;
    rate.attitude.setZero();
    rate.rotating = on_ball.moment / b.inertia;
    result.rate.balls.push_back(rate);
  }
  if (b.land.present) {
    if (b.land.on_outer)
      guide_cage(b, bodies.cage, bodies.outer, on_cage, on_outer, result);
    else
      guide_cage(b, bodies.cage, bodies.inner, on_cage, on_inner, result);
  }
  const Vector cage_axis = axis_of(bodies.cage);
  const double cage_spin = bodies.cage.rotating.dot(cage_axis);
  on_cage.moment -= b.drag.cage_churning * cage_spin * std::abs(cage_spin) * cage_axis;
  result.loss.churning += b.drag.cage_churning * std::pow(std::abs(cage_spin), 3.0);
  result.rate.cage = rate_of(b.cage, bodies.cage, on_cage);
  stir(b, bodies.inner, bodies.outer, on_inner, on_outer, result);
  result.rate.inner =
      ring_rate(b.inner_ring, bodies.inner, on_inner, around.inner_acceleration, result.inner_torque);
  result.rate.outer =
      ring_rate(b.outer_ring, bodies.outer, on_outer, around.outer_acceleration, result.outer_torque);
  return result;
}

Momenta momentum_rate(const BallNumbers& b, const Bodies& bodies, const Bodies& rate) {
  Momenta sum;
  for_each_body(b, bodies, rate, [&](const BodyNumbers& numbers, const Body& body, const Body& by) {
    const Matrix inertia = inertia_of(numbers, body);
    sum.linear += numbers.mass * by.velocity;
    sum.angular += numbers.mass * body.position.cross(by.velocity) + inertia * by.rotating +
                   body.rotating.cross(inertia * body.rotating);
  });
  return sum;
}

Momenta momentum_scale(const BallNumbers& b, const Bodies& bodies, const Bodies& rate) {
  Momenta sum;
  for_each_body(b, bodies, rate, [&](const BodyNumbers& numbers, const Body& body, const Body& by) {
    sum.linear += numbers.mass * by.velocity.cwiseAbs();
    sum.angular.array() += numbers.mass * body.position.norm() * by.velocity.norm();
  });
  return sum;
}

double kinetic_power(const BallNumbers& b, const Bodies& bodies, const Bodies& rate) {
  double sum = 0.0;
  for_each_body(b, bodies, rate, [&](const BodyNumbers& numbers, const Body& body, const Body& by) {
    const Matrix inertia = inertia_of(numbers, body);
    sum += numbers.mass * body.velocity.dot(by.velocity) + body.rotating.dot(inertia * by.rotating);
  });
  return sum;
}

}  // namespace orbearing::reference::inertial_balls
