// A ball in its pocket: a cylinder along a radius of the cage, drawn out along the pitch circle where it is
// oblong, Eqs. (14) to (18) of [Chen2026]. Written once for plain numbers and packs.
//
//      axial ^   .--------.        Nearest point of the pocket's middle line to the ball: a straight part of
//            | (  o----o   )       length S_p, elsewhere its ends. The ball touches where it is further from
//            |   '--------'        it than the play.
//            +--------------> along the pitch circle
//
// Before they touch, oil may keep them apart (Eqs. (19) and (23) of [Chen2026], whose integrals over the film
// have the closed forms of bearing/contact/squeeze_film.hpp): on the side that is nearer and on the one
// opposite, so that a ball in the middle is held by squeeze only.
#pragma once

#include "bearing/contact/damping.hpp"
#include "bearing/motion/balls/bodies.hpp"

namespace orbearing::bearing::balls {

template <class Number>
struct PocketTouch {
  BallWrench<Number> on_ball;
  Number load{};      // [N]  of touch and film on the nearer side, less the film's on the other
  Number driving{};   // [N]  part of it that drives the cage in the sense of rotation
  Number approach{};  // [m]  negative where they part
  Number damping_power{}, friction_power{};  // [W]  of the touch
  Number film_power{};                       // [W]
};

/// Direction of the pocket's middle line in the axes of its ball: `cosine` and `sine` of the pocket's angle
/// from the ball, in a cage whose axis is tilted by the shortest turn from the bearing's.
template <class Number>
Triple<Number> pocket_direction(const Triple<Number>& axis, const Number& cosine, const Number& sine) {
  const Number share = (axis.x * cosine + axis.y * sine) / (1.0 + axis.z);
  return {cosine - share * axis.x, sine - share * axis.y, -(share * (axis.z + 1.0))};
}

/// Slopes of the oil on both sides of a ball, in the axes of its touch and about its own centre.
template <class Number>
struct PocketFilmSlopes {
  Number by_approach;                          // [N/m]      of the load
  Number by_speed;                             // [N s/m]
  Number by_along, by_across;                  // [N s/m]  of the load by sliding
  Number by_turning_along, by_turning_across;  // [N s]  by turning about either
  Number along, across;                        // [N s/m]    drag
  Number rotating;                             // [N m s]    against turning about either
};

/// Adds the oil on both sides of a ball `distance` [m] off the pocket's middle line along `axes.normal`; on
/// the other side the gap is wider by `longer` [m] in an oblong pocket. A film is entrained by half the speed
/// at which its surfaces slide: the contact is fixed in the pocket. A ball that moves round the middle
/// squeezes too: as much as outwards in the middle itself, less of it by (1 - e^2)/(1 + 2 e^2) off it, as in
/// a short journal bearing of the eccentricity e.
template <bool kSlopes, class Number>
void add_pocket_film(const BallNumbers& c, const ContactAxes<Number>& axes, const Number& distance,
                     const Number& longer, const Triple<Number>& approaching, const Triple<Number>& turn,
                     PocketTouch<Number>& touch, PocketFilmSlopes<Number>& slopes) {
  using namespace mechanics;
  const PocketNumbers& pocket = c.pocket;
  const RigidPointFilm& film = pocket.film;
  const Number rolling_along = c.radius * dot(turn, axes.across),
               rolling_across = c.radius * dot(turn, axes.along);
  Triple<Number> force{}, moment{};
  for (int i = 0; i < 2; ++i) {
    const double side = i == 0 ? 1.0 : -1.0;
    const Number gap = pocket.play - side * distance + (i == 0 ? Number{} : longer);
    // Pocket less ball; n x along = across, n x across = -along.
    const Number closing = -(side * dot(approaching, axes.normal));
    const Number along = dot(approaching, axes.along) + side * rolling_along;
    const Number across = dot(approaching, axes.across) - side * rolling_across;
    const RigidPointLoad<Number> now = film.at(gap, closing, 0.5 * along, 0.5 * across);
    const Number push = side * now.load, drag_along = now.shear * along, drag_across = now.shear * across;
    const Number couple_along = (0.5 * film.rolling_x) * c.radius * now.shear * rolling_along;
    const Number couple_across = (0.5 * film.rolling_y) * c.radius * now.shear * rolling_across;
    force += scaled(drag_along, axes.along) + scaled(drag_across, axes.across) - scaled(push, axes.normal);
    moment += scaled((side * c.radius) * drag_along + couple_along, axes.across) -
              scaled((side * c.radius) * drag_across - couple_across, axes.along);
    touch.load += push;
    touch.film_power += now.load * closing + drag_along * along + drag_across * across +
                        (couple_along * rolling_along + couple_across * rolling_across) / c.radius;
    if constexpr (kSlopes) {
      slopes.by_approach -= now.by_gap;
      slopes.by_speed += now.by_closing;
      slopes.by_along += (0.5 * side) * now.by_ux;
      slopes.by_across += (0.5 * side) * now.by_uy;
      slopes.by_turning_across += (0.5 * c.radius) * now.by_ux;
      slopes.by_turning_along -= (0.5 * c.radius) * now.by_uy;
      slopes.along += now.shear;
      slopes.across += now.shear;
      slopes.rotating += (c.radius * c.radius) * now.shear;
    }
  }
  const Number least = Number{} + film.least_gap,
               eccentricity = smaller(distance / pocket.play, Number{} + 1.0);
  const Number off = eccentricity * eccentricity;
  const Number both =
      1.0 / larger(pocket.play - distance, least) + 1.0 / larger(pocket.play + distance + longer, least);
  const Number round = (film.squeeze * film.size) * both * (1.0 - off) / (1.0 + 2.0 * off);
  const Number moving = dot(approaching, axes.across);
  force += scaled(round * moving, axes.across);
  if constexpr (kSlopes) slopes.across += round;
  touch.film_power += round * moving * moving;
  touch.on_ball.force += force;
  touch.on_ball.moment += moment;
}

/// Slopes are written where kSlopes.
template <bool kSlopes, class Number>
PocketTouch<Number> pocket_touch(const BallNumbers& c, const Ball<Number>& ball,
                                 const BodyFromBall<Number>& cage, const Triple<Number>& direction,
                                 ContactSlopes<Number>& slopes, PocketFilmSlopes<Number>& film) {
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
  const Triple<Number> turn = cage.rotating - ball.spin;
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
  touch.on_ball.moment = scaled(c.radius * force[1], axes.across) - scaled(c.radius * force[2], axes.along);
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
    slopes.rotating_stiffness = only(absolute(off) > Number{}, load * per_distance);
    slopes.friction = {};
    slopes.friction.by[0][0] = per_speed - bend * along * along;
    slopes.friction.by[1][0] = slopes.friction.by[0][1] = -(bend * along * across);
    slopes.friction.by[1][1] = per_speed - bend * across * across;
  }
  if constexpr (kSlopes)
    film = PocketFilmSlopes<Number>{Number{}, Number{}, Number{}, Number{}, Number{},
                                    Number{}, Number{}, Number{}, Number{}};
  if (pocket.film.present()) {
    const Number longer = (2.0 * pocket.half_straight) * absolute(off) * per_distance;
    add_pocket_film<kSlopes>(c, axes, distance, longer, cage.velocity - ball.velocity, turn, touch, film);
  }
  return touch;
}

/// Energy stored in the pocket [J].
inline double pocket_energy(const PocketNumbers& pocket, double approach) {
  return approach > 0.0 ? 0.4 * pocket.stiffness * approach * approach * __builtin_sqrt(approach) : 0.0;
}

}  // namespace orbearing::bearing::balls
