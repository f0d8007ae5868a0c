// Balls and rings in the coordinates of their contacts: positions, velocities and rotations, in the axes of
// one ball's own radius. Written once for plain numbers and packs.
//
// A ring's position is its centre and the direction of its axis, whose components across the bearing's axis
// are state variables. Rings and cage are solids of revolution, so their angle of rotation matters to pockets
// and defects only. A ball is described by cylindrical coordinates about the bearing's axis and by the
// components of its rotation in the axes (radial, tangential, axial) of its position.
#pragma once

#include "bearing/motion/balls/numbers.hpp"
#include "mechanics/triple.hpp"

namespace orbearing::bearing::balls {

using mechanics::Triple;

/// A ring or the cage.
struct Body {
  Triple<double> centre;     // [m]
  Triple<double> axis;       // [-]      unit vector
  Triple<double> velocity;   // [m/s]    of the centre
  Triple<double> axis_rate;  // [1/s]
  double spin = 0.0;         // [rad/s]  about the axis
  double turn = 0.0;         // [rad]    since the start: where its scratches are
};

/// From `x`: centre x y z, axis x y; and `v`: their rates.
[[gnu::always_inline]] inline Body body_at(const double* x, const double* v, double spin, double turn = 0.0) {
  const double z = __builtin_sqrt(1.0 - x[3] * x[3] - x[4] * x[4]);
  return {{x[0], x[1], x[2]},
          {x[3], x[4], z},
          {v[0], v[1], v[2]},
          {v[3], v[4], -(x[3] * v[3] + x[4] * v[4]) / z},
          spin,
          turn};
}

/// Angular velocity of a body [rad/s].
[[gnu::always_inline]] inline Triple<double> rotating(const Body& body) {
  return cross(body.axis, body.axis_rate) + scaled(body.spin, body.axis);
}

/// Cylindrical coordinates of a ball, with the direction of its radius.
template <class Number>
struct Ball {
  Number radius, axial;     // [m]
  Number cosine, sine;      // [-]  of its angle
  Triple<Number> velocity;  // [m/s]    radial, tangential, axial
  Triple<Number> spin;      // [rad/s]  of the ball in space
  Number orbital;           // [rad/s]
};

/// A vector of the bearing's axes in those of a ball.
template <class Number>
Triple<Number> in_axes_of(const Ball<Number>& ball, const Triple<double>& v) {
  return {v.x * ball.cosine + v.y * ball.sine, v.y * ball.cosine - v.x * ball.sine, Number{} + v.z};
}
/// And back.
template <class Number>
Triple<Number> in_bearing_axes(const Ball<Number>& ball, const Triple<Number>& v) {
  return {v.x * ball.cosine - v.y * ball.sine, v.x * ball.sine + v.y * ball.cosine, v.z};
}

/// The vector at length 1.
[[gnu::always_inline]] inline Triple<double> unit(const Triple<double>& v) {
  return scaled(1.0 / __builtin_sqrt(dot(v, v)), v);
}

/// A body in the axes of one ball.
template <class Number>
struct BodyFromBall {
  Triple<Number> from_centre;  // [m]      of the ball
  Triple<Number> axis;         // [-]
  Triple<Number> velocity;     // [m/s]    of the body's material where the ball's centre is
  Triple<Number> rotating;     // [rad/s]
  double turn = 0.0;           // [rad]    since the start
};

template <class Number>
BodyFromBall<Number> seen(const Ball<Number>& ball, const Body& body) {
  BodyFromBall<Number> s;
  const Triple<Number> centre = in_axes_of(ball, body.centre);
  s.from_centre = {ball.radius - centre.x, -centre.y, ball.axial - centre.z};
  s.axis = in_axes_of(ball, body.axis);
  s.rotating = in_axes_of(ball, rotating(body));
  s.velocity = in_axes_of(ball, body.velocity) + cross(s.rotating, s.from_centre);
  s.turn = body.turn;
  return s;
}

/// Force through a ball's centre and moment about it, in the ball's axes.
template <class Number>
struct BallWrench {
  Triple<Number> force{};   // [N]
  Triple<Number> moment{};  // [N m]

  BallWrench& operator+=(const BallWrench& other) {
    force += other.force;
    moment += other.moment;
    return *this;
  }
};

/// Axes of a contact: unit vectors in the ball's own axes, from its centre to the contact (n), and along and
/// across as in bearing/contact/ellipse_traction.hpp.
template <class Number>
struct ContactAxes {
  Triple<Number> normal, along, across;
};

/// Slopes of a contact's wrench on the ball, in the axes (n, along, across) of force and moment about the
/// contact: what a matrix 1 - g J takes of it. All by the motion of the other body relative to the ball.
template <class Number>
struct ContactSlopes {
  ContactAxes<Number> axes;
  Number arm;                       // [m]  from the ball's centre to the contact
  Number per_load[6];               // wrench over normal load; [0] is -1
  Number load_by_approach;          // [N/m]
  Number load_by_speed;             // [N s/m]
  Number rotating_stiffness;        // [N/m]  of the normal's direction, across
  TractionSlopes<Number> friction;  // with the couple against rolling
};

// Relative position of cage and ring at both ends of the cage's width. The law of
// bearing/contact/land_law.hpp holds at each land, so that the lands also resist tilting.

/// Cage less land at `position` along the axes: offset x y, velocity x y, spin of the cage.
struct LandOffset {
  double by[5];
};
[[gnu::always_inline]] inline LandOffset land_offset(const Body& cage, const Body& ring, double position) {
  return {{cage.centre.x - ring.centre.x + position * (cage.axis.x - ring.axis.x),
           cage.centre.y - ring.centre.y + position * (cage.axis.y - ring.axis.y),
           cage.velocity.x - ring.velocity.x + position * (cage.axis_rate.x - ring.axis_rate.x),
           cage.velocity.y - ring.velocity.y + position * (cage.axis_rate.y - ring.axis_rate.y), cage.spin}};
}

}  // namespace orbearing::bearing::balls
