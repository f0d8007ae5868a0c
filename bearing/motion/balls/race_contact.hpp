// A ball in the groove of a ring: load, friction over the ellipse, couple against rolling. Written once for
// plain numbers and packs.
//
//         groove centre  o - - - - - -> n        The groove's centre lies on a circle about the ring's axis.
//          (ring)         \   d                  The ball is in contact where its own centre is further from
//                          o ball centre         it than the play; n then points on, to the contact.
//
// Outer ring: the circle is smaller than the pitch circle and n points outward; inner ring: the other way
// round. One expression serves both.
#pragma once

#include "bearing/contact/damping.hpp"
#include "bearing/contact/inlet_heating.hpp"
#include "bearing/motion/balls/bodies.hpp"

namespace orbearing::bearing::balls {

// A round scratch on a ball, which turns with the ball in space and strikes where it comes under a contact.
// Written once for plain numbers and packs.
//
//   s = R |n - p|      n: from the ball's centre to the contact, p: to the middle of the scratch
//   approach = distance - play - depth(s),   depth' : slope of the depth by s,   e = (n - p)/|n - p|
//   force on the ball   load depth' R (dn/dr)^T e,    moment on the ball   -load depth' R p x e
//
// the rest of the gradient of the contact's energy: their moments about the ring's axis cancel, since the
// ring is round.

/// A scratch in the axes of one ball, for one of its contacts.
template <class Number>
struct ScratchFromBall {
  Triple<Number> position;  // [-]  direction of its middle, in the ball's axes
  Number owned{};           // [-]  1 where the ball has it, else 0
};

/// Those of all balls at hand.
template <class Number>
struct ScratchesFromBall {
  int count = 0;
  ScratchFromBall<Number> spot[SpotNumbers::kMost];
};

/// Effect of the spots on a contact.
template <class Number>
struct SpotTouch {
  Number depth{};           // [m]
  Number rate{};            // [m/s]  of the depth
  Triple<Number> force{};   // [-]    on the ball, over the load
  Triple<Number> moment{};  // [m]    likewise
};

/// Motion of a contact's normal n, as in race_touch().
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
Triple<Number> normal_rate(const GrooveNumbers& groove, const Ball<Number>& ball,
                           const BodyFromBall<Number>& ring, const Triple<Number>& outward,
                           const Number& per_away, const Triple<Number>& normal, const Number& per_distance) {
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
SpotTouch<Number> spot_touch(const ScratchLaw& law, double radius, const ScratchesFromBall<Number>& spots,
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

/// Forces, motion and losses of one contact.
template <class Number>
struct RaceTouch {
  BallWrench<Number> on_ball;
  Number load{};            // [N]  with damping and squeeze, >= 0
  Number approach{};        // [m]  negative where they part
  Number contact_angle{};   // sine: axial part of n
  Number sliding_along{};   // [m/s]  race less ball, in the middle
  Number sliding_across{};  // [m/s]
  Number spin{};            // [rad/s]  race less ball about n
  Number entrainment{};     // [m/s]
  Number film{};            // [m]  central
  Number damping_power{}, sliding_power{}, spin_power{}, differential_power{}, rolling_power{};  // [W]
};

/// Depth of the scratches of the race at a contact.
template <class Number>
struct ElementDepth {
  Number depth{};     // [m]
  Number by_angle{};  // [m/rad]  its slope by the ball's angle about the ring's axis
};

/// `outward` and `along` from the ring's axis, in the ball's axes. The sine approximates the angle from a
/// scratch.
template <class Number>
ElementDepth<Number> element_depth(const ScratchNumbers& c, const Ball<Number>& ball, double turn,
                                   const Triple<Number>& outward, const Triple<Number>& along) {
  using namespace mechanics;
  ElementDepth<Number> sum;
  for (int i = 0; i < c.count; ++i) {
    const double angle = c.angle[i] + turn;
    const Triple<Number> scratch =
        in_axes_of(ball, Triple<double>{__builtin_cos(angle), __builtin_sin(angle), 0.0});
    const Number ahead = -dot(scratch, along), towards = dot(scratch, outward);
    const TrackDepth<Number> one = track_depth(c.law, c.track_radius, ahead, towards);
    sum.depth += one.depth;
    sum.by_angle += one.by_angle;
  }
  return sum;
}

/// `slopes` are written where kSlopes; those of scratches are left out.
template <bool kSlopes, class Law, class Number>
RaceTouch<Number> race_touch(const Law& law, const BallNumbers& c, const GrooveNumbers& groove,
                             const Ball<Number>& ball, const BodyFromBall<Number>& ring,
                             const ScratchesFromBall<Number>& spots, ContactSlopes<Number>& slopes) {
  using namespace mechanics;
  constexpr double kLeastLoad = 1e-6;  // [N]  keeps logarithms finite where there is none
  constexpr double kAtCentre = 1e-30;  // [m^2]  keeps the normal finite in the groove's centre
  RaceTouch<Number> touch;
  // Along the ring's axis and away from it.
  const Number along_axis = dot(ring.from_centre, ring.axis);
  const Triple<Number> away = ring.from_centre - scaled(along_axis, ring.axis);
  const Number per_away = inverse_root(dot(away, away));
  const Triple<Number> outward = scaled(per_away, away);
  const Number off_axis = 1.0 / per_away - groove.centre_radius;
  const Number off_plane = along_axis - groove.centre_axial;
  const Number square = off_axis * off_axis + off_plane * off_plane + kAtCentre;
  const Number per_distance = inverse_root(square);
  const Number distance = square * per_distance;
  ContactAxes<Number> axes;
  axes.normal = scaled(off_axis * per_distance, outward) + scaled(off_plane * per_distance, ring.axis);
  axes.along = cross(ring.axis, outward);
  axes.across = cross(axes.normal, axes.along);

  ElementDepth<Number> scratched;
  if (groove.scratch.count > 0)
    scratched = element_depth(groove.scratch, ball, ring.turn, outward, axes.along);
  SpotTouch<Number> spotted;
  if (spots.count > 0)
    spotted = spot_touch(&groove == &c.inner ? c.spots.on_inner : c.spots.on_outer, c.radius, spots,
                         {axes.normal, axes.along, axes.across, ring.axis,
                          normal_rate(groove, ball, ring, outward, per_away, axes.normal, per_distance),
                          ball.spin, per_away, per_distance});
  const Number approach = distance - groove.play - scratched.depth - spotted.depth;
  const auto touching = approach > Number{};
  touch.approach = approach;
  touch.contact_angle = axes.normal.z;
  const Number pressed = only(touching, approach);
  const Number root_approach = root(pressed);
  const Number elastic = groove.stiffness * pressed * root_approach;

  // The race relative to the ball at the contact, which lies by a ball's radius off its centre.
  const Triple<Number> turn = ring.rotating - ball.spin;
  const Triple<Number> slip =
      ring.velocity - ball.velocity + scaled(Number{} + c.radius, cross(turn, axes.normal));
  const Number past = dot(ball.velocity - ring.velocity, axes.along) * per_away;  // [rad/s] over the race
  const Number closing = -dot(slip, axes.normal) - scratched.by_angle * past - spotted.rate;
  const Sliding<Number> sliding{dot(slip, axes.along), dot(slip, axes.across), dot(turn, axes.along),
                                dot(turn, axes.across), dot(turn, axes.normal)};
  // Both surfaces relative to the contact, which goes round with the ball.
  const Number arm_out = c.radius * axes.normal.x;
  const Number carried = ball.orbital * (ball.radius + arm_out);
  const Triple<Number> on_ball = ball.velocity + scaled(Number{} + c.radius, cross(ball.spin, axes.normal));
  const Number rolling = on_ball.y + 0.5 * sliding.along * axes.along.y - carried;
  const Number entrainment = root(rolling * rolling + c.entrainment_scale * c.entrainment_scale);

  const auto normal = damped_load(elastic, groove.damping, closing);
  Number load = only(touching, normal.load), damping_power = only(touching, normal.power);
  BallSqueeze<Number> squeezed{};
  if (groove.squeeze.present()) {
    squeezed = groove.squeeze.at(groove.central_film, approach, elastic, entrainment, closing);
    load = larger(load + squeezed.load, Number{});
    damping_power = (load - elastic) * closing;
  }
  const auto loaded = load > Number{};
  const Number positive = load + kLeastLoad;
  const Number log_load = logarithm(positive), log_speed = logarithm(entrainment);
  const Number third = exponential((1.0 / 3.0) * log_load);
  const Number log_film = groove.central_film.log_film(log_load, log_speed);
  const LoadedEllipse<Number> ellipse{positive,
                                      groove.across * third,
                                      groove.along * third,
                                      groove.pressure * third,
                                      exponential(-log_film),
                                      groove.curvature,
                                      2.0 * c.radius};
  Traction<Number> traction;
  TractionSlopes<Number> friction;
  add_traction<kSlopes>(law, c.shear, c.points, ellipse, sliding, traction, friction);

  // Against rolling: as fast as the surfaces roll on each other.
  const Number turned = sliding.turn_across * groove.rolling_radius;
  const Number rolled = root(turned * turned + c.entrainment_scale * c.entrainment_scale);
  const Number log_rolled = logarithm(rolled);
  Number couple = groove.rolling_factor * groove.rolling.per_speed(log_rolled, log_load);
  if (groove.inlet_heating > 0.0)
    couple = couple * heated_inlet_share(2.0 * log_rolled + logarithm(groove.inlet_heating));
  const Number rolling_moment = couple * turned;

  touch.load = load;
  touch.sliding_along = sliding.along;
  touch.sliding_across = sliding.across;
  touch.spin = sliding.spin;
  touch.entrainment = entrainment;
  touch.film = exponential(log_film);
  const Number force[3] = {-load, only(loaded, traction.along), only(loaded, traction.across)};
  const Number moment[3] = {only(loaded, traction.spin), only(loaded, traction.turn_along),
                            only(loaded, traction.turn_across + rolling_moment)};
  touch.on_ball.force =
      scaled(force[0], axes.normal) + scaled(force[1], axes.along) + scaled(force[2], axes.across);
  // If the floor is inclined, the load pushes the ball along.
  if (groove.scratch.count > 0)
    touch.on_ball.force += scaled(load * scratched.by_angle * per_away, axes.along);
  if (spots.count > 0) touch.on_ball.force += scaled(load, spotted.force);
  // n x along = across, n x across = -along.
  touch.on_ball.moment = scaled(moment[0], axes.normal) +
                         scaled(moment[1] - c.radius * force[2], axes.along) +
                         scaled(moment[2] + c.radius * force[1], axes.across);
  if (spots.count > 0) touch.on_ball.moment += scaled(load, spotted.moment);
  touch.damping_power = damping_power;
  touch.sliding_power = force[1] * sliding.along + force[2] * sliding.across;
  touch.spin_power = moment[0] * sliding.spin;
  touch.rolling_power = only(loaded, rolling_moment * sliding.turn_across);
  touch.differential_power =
      moment[1] * sliding.turn_along + moment[2] * sliding.turn_across - touch.rolling_power;
  if constexpr (kSlopes) {
    const Number per_load = only(loaded, 1.0 / positive);
    slopes.axes = axes;
    slopes.arm = Number{} + c.radius;
    for (int i = 0; i < 3; ++i) {
      slopes.per_load[i] = i == 0 ? Number{} - 1.0 : force[i] * per_load;
      slopes.per_load[3 + i] = moment[i] * per_load;
    }
    const Number grown = only(loaded, damping_factor(groove.damping, closing));
    slopes.load_by_approach = 1.5 * groove.stiffness * root_approach * grown;
    slopes.load_by_speed = only(loaded, elastic * groove.damping);
    if (groove.squeeze.present()) {
      slopes.load_by_approach += only(loaded, squeezed.by_approach);
      slopes.load_by_speed += only(loaded, squeezed.by_closing);
    }
    slopes.rotating_stiffness = load * per_distance;
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) slopes.friction.by[i][k] = only(loaded, friction.by[i][k]);
    slopes.friction.by[2][2] += only(loaded, couple * groove.rolling_radius);
  }
  return touch;
}

/// Energy stored in the contact [J].
inline double race_energy(const GrooveNumbers& groove, double approach) {
  return approach > 0.0 ? 0.4 * groove.stiffness * approach * approach * __builtin_sqrt(approach) : 0.0;
}

}  // namespace orbearing::bearing::balls
