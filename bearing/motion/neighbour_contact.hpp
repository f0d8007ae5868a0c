// Two neighbouring rollers of a full complement, which no cage keeps apart, where they touch.
//
//     t            n from the roller's centre to that of its neighbour, t = z x n; both spin alike, so that
//     ^            their surfaces slide on one another at the sum of their speeds
//   ( o )( o ) --> n
//
#pragma once

#include "bearing/contact/damping.hpp"
#include "bearing/contact/friction.hpp"
#include "bearing/contact/line_contact.hpp"
#include "bearing/plane.hpp"

namespace orbearing::bearing::motion {

/// The same for all rollers, fixed for a run. Assumption: they meet along their whole length, whatever their
/// profile and tilt, with the line contact of the races, whose law knows no radius.
struct NeighbourModel {
  LineContact elastic;
  double damping = 0.0;  // [s/m]
  CoulombFriction<double> friction;
};

/// What passes between two rollers.
struct NeighbourTouch {
  Wrench on_roller;             // the neighbour feels the opposite force and the moment at its own arm
  double load = 0.0;            // [N]    with damping
  double sliding = 0.0;         // [m/s]  surface of the neighbour less that of the roller, along t
  double energy = 0.0;          // [J]    stored
  double damping_power = 0.0;   // [W]    dissipated by both
  double friction_power = 0.0;  // [W]    dissipated by both
};

/// Of two rollers of the radii `radius` and `neighbour_radius` [m]. They touch in the middle of what they
/// overlap: both arms together are the distance of the centres, so that forces and moments balance.
NeighbourTouch neighbour_touch(const NeighbourModel& model, const BodyMotion& roller, double radius,
                               const BodyMotion& neighbour, double neighbour_radius);

}  // namespace orbearing::bearing::motion
