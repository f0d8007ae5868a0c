// Cage on the land of a ring: a short journal bearing with squeeze and whirl, and touch-down. The law once,
// for plain numbers and for numbers with their slopes. No header of a library here: files compiled for
// special instruction sets include it.
#pragma once

#include "bearing/contact/damping.hpp"
#include "bearing/contact/friction.hpp"

namespace orbearing::bearing {

/// Cage less land, but for the speed.
template <class T>
struct LandMotion {
  T offset_x, offset_y;      // [m]
  T velocity_x, velocity_y;  // [m/s]
  T cage_speed;              // [rad/s]
};

/// Forces of film and touch-down on cage and land.
template <class T>
struct LandForce {
  T x{}, y{};        // [N]    on the cage, opposite on the land
  T on_cage{};       // [N m]  about its axis
  T on_land{};       // [N m]
  T power{};         // [W]    dissipated
  T eccentricity{};  // [-]    of the clearance
};

/// The same by film and touch-down.
template <class T>
struct LandForces {
  T eccentricity;          // [-]    of the clearance
  T film_x, film_y;        // [N]    of the film on the cage
  T squeeze_x, squeeze_y;  // [m/s]  velocity of squeezing
  T shear;                 // [N m]  of the film on the cage, opposite on the land
  T touch_x, touch_y;      // [N]    of touch-down on the cage
  T touch_friction;        // [N]    along the tangent
  T touch_sliding;         // [m/s]
  T touch_damping_power;   // [W]    dissipated
};

/// Resistance of the half film to the squeeze velocity v': force = -film_scale * resistance * v', with the
/// integral of u u^T / (1 - eps cos)^3 over the half circle towards v' in axes (along the eccentricity,
/// across it).
template <class T>
struct FilmResistance {
  T along;   // [-]
  T mixed;   // [-]
  T across;  // [-]
};

/// Resistance at `eccentricity` [-] < 1 against a squeeze towards the unit vector (`towards_x`, `towards_y`)
/// in axes along the eccentricity and across it: with t = towards, D = 1 - (eps t_y)^2, w = sqrt(1 - eps^2)
/// and a = pi/2 + atan(eps t_x / w),
///
///     along w^5 = (1 + 2 eps^2) a + eps w t_x (3 + 2 t_y^2 - 5 (eps t_y)^2) / D^2
///     across w^3 = a + eps w t_x (1 - 2 t_y^2 + (eps t_y)^2) / D^2
///     mixed = 2 eps t_y^3 / D^2.
///
/// These are what the substitution 1 - eps cos(theta) = (1 - eps^2) / (1 + eps cos(gamma)) of
/// [Sommerfeld1904] gives in the short bearing of [Ocvirk1952], once both ends of the half circle, opposite
/// to each other, are put in. Its steady state is Eqs. (24) and (25) of [Gai2025].
template <class T>
FilmResistance<T> half_film_resistance(const T& eccentricity, const T& towards_x, const T& towards_y) {
  using mechanics::arc_tangent, mechanics::inverse_root;
  constexpr double kQuarterTurn = 1.5707963267948966192313216916398;
  const T eps_square = eccentricity * eccentricity, across_square = towards_y * towards_y;
  const T both = eps_square * across_square;
  const T per_root = inverse_root(1.0 - eps_square), per_square = per_root * per_root;
  const T slant = eccentricity * towards_x * per_root;
  const T share = 1.0 / (1.0 - both);
  const T share_square = share * share;
  const T angle = kQuarterTurn + arc_tangent(slant);
  const T end = slant * share_square;  // over w^2
  return {((1.0 + 2.0 * eps_square) * angle * per_square + end * (3.0 + 2.0 * across_square - 5.0 * both)) *
              (per_square * per_root),
          2.0 * eccentricity * towards_y * across_square * share_square,
          (angle * per_square + end * (1.0 - 2.0 * across_square + both)) * per_root};
}

struct LandLaw {
  double side = 1.0;                  // [-]  +1: the land is outside the cage, -1: inside
  double clearance = 0.0;             // [m]  radial
  double cage_radius = 0.0;           // [m]  of the cage's guided surface
  double largest_eccentricity = 0.0;  // [-]  of the clearance: the film is held at this, touch-down begins
  double film_scale = 0.0;            // [N s/m]  lands eta L^3 R / c^3
  double shear_scale = 0.0;           // [N m s]  2 pi eta R^3 lands L / c
  double stiffness = 0.0;             // [N/m]    of touch-down
  double damping = 0.0;               // [s/m]
  CoulombFriction<double> friction;

  /// Film and touch-down between the cage and a land that turns at `land_speed` [rad/s]. The film depends on
  /// the velocity of the cage less what half the sum of both rotations gives it, so that the force does not
  /// depend on the frame. The couple of the film's two forces, which act through both centres, is shared
  /// evenly by both surfaces.
  template <class T>
  LandForce<T> force(const LandMotion<T>& motion, double land_speed) const {
    const LandForces<T> now = forces(motion, land_speed);
    const double arm = side * cage_radius;
    const T couple = 0.5 * (motion.offset_x * now.film_y - motion.offset_y * now.film_x);
    const T touch_couple = motion.offset_x * now.touch_y - motion.offset_y * now.touch_x;
    return {now.film_x + now.touch_x,
            now.film_y + now.touch_y,
            now.shear - couple + arm * now.touch_friction,
            -now.shear - couple - arm * now.touch_friction - touch_couple,
            now.touch_damping_power + now.touch_friction * now.touch_sliding -
                (now.film_x * now.squeeze_x + now.film_y * now.squeeze_y) +
                now.shear * (land_speed - motion.cage_speed),
            now.eccentricity};
  }

  /// [J]  stored by touch-down with the cage `offset` [m] off the land's centre.
  double energy(double offset) const {
    const double depth = offset - largest_eccentricity * clearance;
    return depth > 0.0 ? 0.5 * stiffness * depth * depth : 0.0;
  }

  /// Those of force(), by film and touch-down.
  template <class T>
  LandForces<T> forces(const LandMotion<T>& motion, double land_speed) const {
    using mechanics::inverse_root, mechanics::value_of;
    constexpr double kNoDirection = 1e-12;  // [-]  of the clearance: below it the film has no direction
    LandForces<T> result{};
    const T length_square = motion.offset_x * motion.offset_x + motion.offset_y * motion.offset_y;
    T length{}, e_x = T{} + 1.0, e_y{};
    if (value_of(length_square) > 0.0) {
      const T inverse = inverse_root(length_square);
      length = length_square * inverse;
      if (value_of(length) > kNoDirection * clearance) {
        e_x = motion.offset_x * inverse;
        e_y = motion.offset_y * inverse;
      }
    }
    result.eccentricity = length * (1.0 / clearance);
    const T held = value_of(result.eccentricity) < largest_eccentricity ? result.eccentricity
                                                                        : T{} + largest_eccentricity;
    add_film(motion, land_speed, held, e_x, e_y, result);
    const T depth = length - largest_eccentricity * clearance;
    if (value_of(depth) > 0.0) add_touch_down(motion, land_speed, length, depth, e_x, e_y, result);
    return result;
  }

 private:
  template <class T>
  void add_film(const LandMotion<T>& motion, double land_speed, const T& held, const T& e_x, const T& e_y,
                LandForces<T>& result) const {
    using mechanics::inverse_root, mechanics::value_of;
    const T mean_speed = 0.5 * (motion.cage_speed + land_speed);
    result.squeeze_x = motion.velocity_x + mean_speed * motion.offset_y;
    result.squeeze_y = motion.velocity_y - mean_speed * motion.offset_x;
    const T along = result.squeeze_x * e_x + result.squeeze_y * e_y;
    const T across = result.squeeze_y * e_x - result.squeeze_x * e_y;
    T force_along{}, force_across{};
    const T speed_square = along * along + across * across;
    if (value_of(speed_square) > 0.0) {
      const T per_speed = inverse_root(speed_square);
      const FilmResistance<T> film = half_film_resistance(held, T(along * per_speed), T(across * per_speed));
      force_along = -film_scale * (film.along * along + film.mixed * across);
      force_across = -film_scale * (film.mixed * along + film.across * across);
    }
    result.film_x = force_along * e_x - force_across * e_y;
    result.film_y = force_along * e_y + force_across * e_x;
    result.shear = shear_scale * (land_speed - motion.cage_speed) * inverse_root(1.0 - held * held);
  }

  template <class T>
  void add_touch_down(const LandMotion<T>& motion, double land_speed, const T& length, const T& depth,
                      const T& e_x, const T& e_y, LandForces<T>& result) const {
    const T closing = motion.velocity_x * e_x + motion.velocity_y * e_y;
    const auto normal = damped_load(T(stiffness * depth), damping, closing);
    const double cage_arm = side * cage_radius;
    result.touch_sliding = land_speed * (cage_arm + length) - motion.cage_speed * cage_arm -
                           (motion.velocity_y * e_x - motion.velocity_x * e_y);
    result.touch_friction = friction.force(normal.load, result.touch_sliding);
    result.touch_x = -normal.load * e_x - result.touch_friction * e_y;
    result.touch_y = result.touch_friction * e_x - normal.load * e_y;
    result.touch_damping_power = normal.power;
  }
};

}  // namespace orbearing::bearing
