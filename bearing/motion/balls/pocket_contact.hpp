// A ball in its pocket: a cylinder along a radius of the cage, drawn out along the pitch circle where it is
// oblong, Eqs. (14) to (18) of [Chen2026]. Written once for plain numbers and packs.
//
//      axial ^   .--------.        Nearest point of the pocket's middle line to the ball: a straight part of
//            | (  o----o   )       length S_p, elsewhere its ends. The ball touches where it is further from
//            |   '--------'        it than the play.
//            +--------------> along the pitch circle
//
#pragma once

#include "bearing/contact/damping.hpp"
#include "bearing/motion/balls/bodies.hpp"

namespace orbearing::bearing::balls {

template <class Number>
struct PocketTouch {
  BallWrench<Number> on_ball;
  Number load{};      // [N]  >= 0
  Number driving{};   // [N]  part of it that drives the cage in the sense of rotation
  Number approach{};  // [m]  negative where they part
  Number damping_power{}, friction_power{};  // [W]
};

/// Direction of the pocket's middle line in the axes of its ball: `cosine` and `sine` of the pocket's angle
/// from the ball, in a cage whose axis is tilted by the shortest turn from the bearing's.
template <class Number>
Triple<Number> pocket_direction(const Triple<Number>& axis, const Number& cosine, const Number& sine) {
  const Number share = (axis.x * cosine + axis.y * sine) / (1.0 + axis.z);
  return {cosine - share * axis.x, sine - share * axis.y, -(share * (axis.z + 1.0))};
}

/// `slopes` are written where kSlopes.
template <bool kSlopes, class Number>
PocketTouch<Number> pocket_touch(const BallNumbers& c, const Ball<Number>& ball, const SeenBody<Number>& cage,
                                 const Triple<Number>& direction, ContactSlopes<Number>& slopes) {
  using namespace mechanics;
  constexpr double kAtCentre = 1e-30;  // [m^2]  keeps the normal finite in the pocket's middle
  const PocketNumbers& pocket = c.pocket;
  PocketTouch<Number> touch;
  const Triple<Number> ahead = cross(cage.axis, direction);
  const Number off_ahead = dot(cage.from_centre, ahead), off_axial = dot(cage.from_centre, cage.axis);
  const Number limit = Number{} + pocket.half_straight;
  const Number off = off_ahead - larger(smaller(off_ahead, limit), -limit);
  const Number square = off * off + off_axial * off_axial + kAtCentre;
  const Number per_distance = inverse_root(square);
  const Number distance = square * per_distance;
  ContactAxes<Number> axes;
  axes.normal = scaled(off * per_distance, ahead) + scaled(off_axial * per_distance, cage.axis);
  axes.along = direction;
  axes.across = cross(axes.normal, axes.along);
  const Number approach = distance - pocket.play;
  const auto touching = approach > Number{};
  touch.approach = approach;
  const Number pressed = only(touching, approach);
  const Number root_approach = root(pressed);
  const Number elastic = pocket.stiffness * pressed * root_approach;
  const Triple<Number> turn = cage.turning - ball.spin;
  const Triple<Number> slip =
      cage.velocity - ball.velocity + scaled(Number{} + c.radius, cross(turn, axes.normal));
  const Number closing = -dot(slip, axes.normal);
  const auto normal = damped_load(elastic, pocket.damping, closing);
  const Number load = only(touching, normal.load);
  const Number along = dot(slip, axes.along), across = dot(slip, axes.across);
  const Number per_sliding =
      inverse_root(along * along + across * across + pocket.sliding_scale * pocket.sliding_scale);
  const Number per_speed = pocket.friction * load * per_sliding;
  const Number force[3] = {-load, per_speed * along, per_speed * across};
  touch.load = load;
  touch.driving = load * off * per_distance;
  touch.on_ball.force =
      scaled(force[0], axes.normal) + scaled(force[1], axes.along) + scaled(force[2], axes.across);
  touch.on_ball.moment =
      scaled(c.radius * force[1], axes.across) - scaled(c.radius * force[2], axes.along);
  touch.damping_power = only(touching, normal.power);
  touch.friction_power = force[1] * along + force[2] * across;
  if constexpr (kSlopes) {
    const auto loaded = load > Number{};
    slopes.axes = axes;
    slopes.arm = Number{} + c.radius;
    const Number bend = per_speed * per_sliding * per_sliding;
    slopes.per_load[0] = Number{} - 1.0;
    slopes.per_load[1] = pocket.friction * per_sliding * along;
    slopes.per_load[2] = pocket.friction * per_sliding * across;
    for (int i = 3; i < 6; ++i) slopes.per_load[i] = Number{};
    slopes.load_by_approach =
        only(loaded, 1.5 * pocket.stiffness * root_approach * damping_factor(pocket.damping, closing));
    slopes.load_by_speed = only(loaded, elastic * pocket.damping);
    slopes.turning_stiffness = only(absolute(off) > Number{}, load * per_distance);
    slopes.friction = {};
    slopes.friction.by[0][0] = per_speed - bend * along * along;
    slopes.friction.by[1][0] = slopes.friction.by[0][1] = -(bend * along * across);
    slopes.friction.by[1][1] = per_speed - bend * across * across;
  }
  return touch;
}

/// Energy stored in the pocket [J].
inline double pocket_energy(const PocketNumbers& pocket, double approach) {
  return approach > 0.0 ? 0.4 * pocket.stiffness * approach * approach * __builtin_sqrt(approach) : 0.0;
}

}  // namespace orbearing::bearing::balls
