// A round scratch on a ball, which turns with the ball in space and strikes where it comes under a contact.
// Written once for plain numbers and packs.
//
//   s = R |n - p|      n: from the ball's centre to the contact, p: to the middle of the scratch
//   approach = distance - play - depth(s),   depth' : slope of the depth by s,   e = (n - p)/|n - p|
//   force on the ball   load depth' R (dn/dr)^T e,    moment on the ball   -load depth' R p x e
//
// the rest of the gradient of the contact's energy: their moments about the ring's axis cancel, since the ring is
// round.
#pragma once

#include "bearing/motion/balls/bodies.hpp"

namespace orbearing::bearing::balls {

/// A scratch as one contact of one ball sees it.
template <class Number>
struct SeenSpot {
  Triple<Number> position;  // [-]  direction of its middle, in the ball's axes
  Number owned{};        // [-]  1 where the ball has it, else 0
};

/// Those of all balls at hand.
template <class Number>
struct SeenSpots {
  int count = 0;
  SeenSpot<Number> spot[SpotNumbers::kMost];
};

/// What they do to a contact.
template <class Number>
struct SpotTouch {
  Number depth{};          // [m]
  Number rate{};           // [m/s]  of the depth
  Triple<Number> force{};  // [-]    on the ball, over the load
  Triple<Number> moment{}; // [m]    likewise
};

/// Motion of a contact's normal n, as race_touch() knows it.
template <class Number>
struct NormalMotion {
  Triple<Number> normal, along, across;  // [-]    across = n x along
  Triple<Number> axis;                   // [-]    of the ring
  Triple<Number> rate;                   // [1/s]  of n in space
  Triple<Number> spin;                   // [rad/s]  of the ball
  Number per_away, per_distance;         // [1/m]  from the ring's axis, from the groove's centre
};

/// In space, of the direction from the groove's centre to the ball's.
template <class Number>
Triple<Number> normal_rate(const GrooveNumbers& groove, const Ball<Number>& ball, const SeenBody<Number>& ring,
                           const Triple<Number>& outward, const Number& per_away, const Triple<Number>& normal,
                           const Number& per_distance) {
  const Triple<Number> axis_rate = cross(ring.rotating, ring.axis);
  const Triple<Number> centre = ring.velocity - cross(ring.rotating, ring.from_centre);
  const Triple<Number> moved = ball.velocity - centre;
  const Number along_axis = dot(ring.from_centre, ring.axis);
  const Number along_rate = dot(moved, ring.axis) + dot(ring.from_centre, axis_rate);
  const Triple<Number> away = moved - scaled(along_rate, ring.axis) - scaled(along_axis, axis_rate);
  const Triple<Number> outward_rate = scaled(per_away, away - scaled(dot(outward, away), outward));
  const Triple<Number> off =
      moved - scaled(groove.centre_radius, outward_rate) - scaled(groove.centre_axial, axis_rate);
  return scaled(per_distance, off - scaled(dot(normal, off), normal));
}

template <class Number>
SpotTouch<Number> spot_touch(const ScratchLaw& law, double radius, const SeenSpots<Number>& spots,
                             const NormalMotion<Number>& at) {
  using namespace mechanics;
  constexpr double kMiddle = 1e-24;  // keeps the direction finite where it does not matter
  SpotTouch<Number> sum;
  for (int i = 0; i < spots.count; ++i) {
    const Triple<Number>& position = spots.spot[i].position;
    const Triple<Number> off = at.normal - position;
    const Number square = dot(off, off) + kMiddle;
    const Number per_off = inverse_root(square), from_middle = radius * (square * per_off);
    const auto inside = (dot(at.normal, position) > Number{}) & (from_middle < Number{} + 0.5 * law.width) &
                        (spots.spot[i].owned > Number{});
    if (!any(inside)) continue;
    const DefectDepth<Number> one = defect_depth(law, from_middle);
    const Triple<Number> e = scaled(per_off, off);
    const Number slope = only(inside, radius * one.slope);
    sum.depth += only(inside, one.depth);
    sum.rate += slope * dot(e, at.rate - cross(at.spin, position));
    sum.force += scaled(slope * dot(e, cross(at.axis, at.normal)) * at.per_away, at.along) +
                 scaled(slope * dot(e, at.across) * at.per_distance, at.across);
    sum.moment += scaled(-slope, cross(position, e));
  }
  return sum;
}

}  // namespace orbearing::bearing::balls
