// Forces on one ball between rotating rings, and its forces on the inner ring: Eqs. (9), (10) and (12) of
// README.md, for constants and positions of any number type.
#pragma once

#include <optional>

#include "bearing/equilibrium/ball_motion.hpp"
#include "bearing/film/spin_film.hpp"

namespace orbearing::bearing::equilibrium {

/// Race that controls the direction of a ball's axis, under race control.
enum class SpinControl { outer, inner };

/// Law of one race. `Number` is that of all constants.
template <class Number>
struct BallRaceLaw {
  Number constant{};                   // [N/m^1.5]
  Number distance{};                   // [m]  of the centres of ball and groove, just touching
  Number ellipse{};                    // [m^2/m]  a^2 + b^2 over approach
  Number pivot{};                      // [m/m^0.5]  a E over root of approach
  film::ApproachLawIn<Number> film{};  // with a film only
};

/// Contacts of a ball with both races, and its motion between them.
template <class T>
struct BallContacts {
  ContactNormal<T> inner, outer;
  T inner_approach, outer_approach;  // [m]
  T inner_load, outer_load;          // [N]
  BallMotion<T> motion;
};

/// Forces caused by a ball's motion, besides the contact loads.
template <class T>
struct BallMotionForces {
  T centrifugal{}, gyroscopic{};         // [N], [N m]
  T inner_traction{}, outer_traction{};  // [N]  on the ball along t
};

template <class T>
struct BallForcesOf {
  T ball_r, ball_z;  // [N]    on the ball
  T ring_r, ring_z;  // [N]    on the inner ring
  T ring_moment;     // [N m]  on it about its groove centre, such that it tilts forward
  T inner_load, outer_load;
};

namespace ball_detail {

// Distance of the centres of ball and groove, with its direction. A groove ends where its surface is
// vertical: beyond, it continues as a plane across the axis, so that a ring which has left its balls does not
// meet them from behind.
template <class T>
T distance(const T& radial, const T& axial, ContactNormal<T>& normal) {
  if (mechanics::value_of(radial) > 0.0) {
    const T length = mechanics::root(radial * radial + axial * axial);
    const T inverse = 1.0 / length;
    normal = {radial * inverse, axial * inverse};
    return length;
  }
  const double side = mechanics::value_of(axial) < 0.0 ? -1.0 : 1.0;
  normal = {T{}, T{} + side};
  return side * axial;
}

template <class T, class Constant>
T hertz(const Constant& constant, const T& approach) {
  if (mechanics::value_of(approach) <= 0.0) return T{};
  return constant * (approach * mechanics::root(approach));
}

// Share of rolling on the inner race, by its load over the load for full rolling; smooth, since an
// equilibrium may lie between both.
template <class T, class Constant>
T hold_of(const T& load, const Constant& whole) {
  using mechanics::value_of;
  if (!(value_of(load) > 0.0)) return T{};
  if (!(value_of(load) < value_of(whole))) return T{} + 1.0;
  const T share = (1.0 / whole) * load;
  return share * share * (3.0 - 2.0 * share);
}

template <class T>
BallMotion<T> between(const BallMotion<T>& a, const BallMotion<T>& b, const T& share) {
  const auto mean = [&](const T& of_a, const T& of_b) { return of_a + share * (of_b - of_a); };
  return {.orbit = mean(a.orbit, b.orbit),
          .radial_spin = mean(a.radial_spin, b.radial_spin),
          .axial_spin = mean(a.axial_spin, b.axial_spin),
          .inner_spin = mean(a.inner_spin, b.inner_spin),
          .outer_spin = mean(a.outer_spin, b.outer_spin),
          .inner_rolling = mean(a.inner_rolling, b.inner_rolling),
          .outer_rolling = mean(a.outer_rolling, b.outer_rolling)};
}

}  // namespace ball_detail

/// Common constants of the balls of one row.
template <class Number>
struct BallLaw {
  BallRaceLaw<Number> inner{}, outer{};
  Number ball_radius{};        // [m]
  Number pitch_radius{};       // [m]
  Number groove_radius{};      // [m]  of the inner race
  Number mass{};               // [kg]
  Number moment_of_inertia{};  // [kg m^2]
  Number holding_load{};       // [N]  on the inner race, from which a ball rolls on it
  RingSpeedsIn<Number> speeds{};
  BallAttitude attitude = BallAttitude::minimum_friction;
  GyroscopicMoment gyroscopic_moment = GyroscopicMoment::balanced;
  bool filmed = false;

  /// At the position of the ball from the outer groove centre and of the inner one from the ball [m].
  template <class T, class Outer, class Inner>
  BallContacts<T> contacts(const Outer& outer_r, const Outer& outer_z, const Inner& inner_r,
                           const Inner& inner_z) const {
    ContactNormal<Outer> outer_normal;
    ContactNormal<Inner> inner_normal;
    const Outer outer_approach = ball_detail::distance(outer_r, outer_z, outer_normal) - outer.distance;
    const Inner inner_approach = ball_detail::distance(inner_r, inner_z, inner_normal) - inner.distance;
    return {.inner = {T{} + inner_normal.cosine, T{} + inner_normal.sine},
            .outer = {T{} + outer_normal.cosine, T{} + outer_normal.sine},
            .inner_approach = T{} + inner_approach,
            .outer_approach = T{} + outer_approach,
            .inner_load = T{} + ball_detail::hertz(inner.constant, inner_approach),
            .outer_load = T{} + ball_detail::hertz(outer.constant, outer_approach),
            .motion = {}};
  }

  /// Adds the motion, and a film's loads, to contacts. The closure weighs spins by Hertz's loads, also where
  /// a film then gives the loads. A ball that leaves the inner race is held by the outer one alone, and the
  /// cage takes it along with the speed of a ball that the inner race touches opposite to the outer one.
  template <class T>
  BallMotionForces<T> add_motion(SpinControl control, BallContacts<T>& at) const {
    using mechanics::root, mechanics::value_of;
    const SpinWeights<T> outer_alone{T{}, T{} + 1.0};
    const T hold = ball_detail::hold_of(at.inner_load, holding_load);
    const bool held = value_of(hold) > 0.0, rolls = value_of(hold) >= 1.0;
    const bool on_outer = value_of(at.outer_load) > 0.0;
    T inner_share{};  // of the gyroscopic moment over the diameter
    if (held) {
      SpinWeights<T> weights = outer_alone;
      if (attitude == BallAttitude::race_control && control == SpinControl::inner) {
        weights = {T{} + 1.0, T{}};
        inner_share = hold;
      } else if (attitude == BallAttitude::minimum_friction) {
        weights.inner = inner.ellipse * (at.inner_load * at.inner_approach);
        weights.outer = on_outer ? outer.ellipse * (at.outer_load * at.outer_approach) : T{};
        inner_share = 2.0 * (at.inner_load / (at.inner_load + at.outer_load));
      } else if (attitude == BallAttitude::hybrid) {
        weights.inner = inner.pivot * (at.inner_load * root(at.inner_approach));
        weights.outer = on_outer ? outer.pivot * (at.outer_load * root(at.outer_approach)) : T{};
        inner_share = 2.0 * (weights.inner / (weights.inner + weights.outer));
      }
      at.motion = ball_motion(at.inner, at.outer, weights, ball_radius, pitch_radius, speeds);
    }
    if (!rolls) {
      const BallMotion<T> taken =
          ball_motion(at.outer, at.outer, outer_alone, ball_radius, pitch_radius, speeds);
      at.motion = held ? ball_detail::between(taken, at.motion, hold) : taken;
    }
    const T outer_share = 2.0 - inner_share;
    if (filmed) {
      const auto& motion = at.motion;
      at.inner_load = film::load_at(inner.film, at.inner_approach, motion.inner_rolling, motion.inner_spin);
      at.outer_load = film::load_at(outer.film, at.outer_approach, motion.outer_rolling, motion.outer_spin);
    }
    const double sign = gyroscopic_moment == GyroscopicMoment::balanced             ? 1.0
                        : gyroscopic_moment == GyroscopicMoment::literature_variant ? -1.0
                                                                                    : 0.0;
    BallMotionForces<T> forces;
    forces.centrifugal = mass * pitch_radius * (at.motion.orbit * at.motion.orbit);
    forces.gyroscopic = (sign * moment_of_inertia) * (at.motion.orbit * at.motion.radial_spin);
    const T pull = (0.5 / ball_radius) * forces.gyroscopic;
    forces.inner_traction = inner_share * pull;
    forces.outer_traction = -(outer_share * pull);
    return forces;
  }

  /// All forces of a ball in motion, at such a position.
  template <class T, class Outer, class Inner>
  BallForcesOf<T> forces(const Outer& outer_r, const Outer& outer_z, const Inner& inner_r,
                         const Inner& inner_z, SpinControl control) const {
    BallContacts<T> at = contacts<T>(outer_r, outer_z, inner_r, inner_z);
    const BallMotionForces<T> moved = add_motion(control, at);
    const T inner_force_r = at.inner_load * at.inner.cosine - moved.inner_traction * at.inner.sine;
    const T inner_force_z = at.inner_load * at.inner.sine + moved.inner_traction * at.inner.cosine;
    const T outer_force_r = at.outer_load * at.outer.cosine + moved.outer_traction * at.outer.sine;
    const T outer_force_z = at.outer_load * at.outer.sine - moved.outer_traction * at.outer.cosine;
    return {.ball_r = inner_force_r - outer_force_r + moved.centrifugal,
            .ball_z = inner_force_z - outer_force_z,
            .ring_r = -inner_force_r,
            .ring_z = -inner_force_z,
            .ring_moment = groove_radius * moved.inner_traction,
            .inner_load = at.inner_load,
            .outer_load = at.outer_load};
  }
};

}  // namespace orbearing::bearing::equilibrium
