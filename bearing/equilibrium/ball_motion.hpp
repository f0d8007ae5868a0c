// Motion of a ball between its races, and conditions of that motion on them.
//
//        r ^      outer race        n = (cos a, sin a) from the outer to the inner groove centre, at each
//        race
//          |         \  n           t = (-sin a, cos a)
//          |        ball            the ball turns about an axis in the plane of r and z, which goes round
//          the
//          +---> z    \             bearing's axis with the ball's orbit
//                   inner race
//
// Both centres of contact roll without slip, which leaves one freedom: the spin about the outer normal. It is
// that of the least of
//
//     w_i (spin on the inner race)^2 + w_o (spin on the outer race)^2
//
// and each closure is a pair of weights. Spins are those of the ball against the race, about the normal.
#pragma once

#include "mechanics/described.hpp"
#include "mechanics/numbers.hpp"
#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing::equilibrium {

/// Condition for the direction of the ball's axis, and for the race that holds its gyroscopic moment.
enum class BallAttitude {
  minimum_friction,    // traction in proportion to slip, alike on both races: their least power
  hybrid,              // both races, by the moments with which they resist spin
  race_control,        // only the race with the larger resisting moment, after Jones [Harris2006]
  outer_race_control,  // only the outer race
};

constexpr described::Names<BallAttitude, 4> names_of(BallAttitude) {
  return {{{BallAttitude::minimum_friction, "minimum-friction"},
           {BallAttitude::hybrid, "hybrid"},
           {BallAttitude::race_control, "race-control"},
           {BallAttitude::outer_race_control, "outer-race-control"}}};
}

/// The gyroscopic moment by which races hold a ball whose axis goes round.
enum class GyroscopicMoment {
  balanced,            // it is the rate of the ball's angular momentum
  literature_variant,  // turned round, as in the equations of [Harris2006]
  none,                // left out
};

constexpr described::Names<GyroscopicMoment, 3> names_of(GyroscopicMoment) {
  return {{{GyroscopicMoment::balanced, "balanced"},
           {GyroscopicMoment::literature_variant, "as-printed"},
           {GyroscopicMoment::none, "none"}}};
}

/// Speeds of both rings [rad/s].
template <class Number>
struct RingSpeedsIn {
  Number inner{};
  Number outer{};

  bool at_rest() const { return inner == 0.0 && outer == 0.0; }
};
using RingSpeeds = RingSpeedsIn<double>;

/// Unit vector along a contact.
template <class T>
struct ContactNormal {
  T cosine;
  T sine;
};

/// Weights of both spins [any one unit].
template <class T>
struct SpinWeights {
  T inner;
  T outer;
};

template <class T>
struct BallMotion {
  T orbit;          // [rad/s]  of the ball about the bearing's axis
  T radial_spin;    // [rad/s]  of its own turning: along r
  T axial_spin;     // [rad/s]  along z, relative to the orbit
  T inner_spin;     // [rad/s]  on the race, about the normal
  T outer_spin;     // [rad/s]
  T inner_rolling;  // [m/s]    surface speed against the contact, equal on ball and race
  T outer_rolling;  // [m/s]
};

/// Motion of a ball of radius `ball` [m], its centre at `pitch` [m] from the axis.
template <class T, class Constant>
BallMotion<T> ball_motion(const ContactNormal<T>& inner, const ContactNormal<T>& outer,
                          const SpinWeights<T>& weights, const Constant& ball, const Constant& pitch,
                          const RingSpeedsIn<Constant>& speeds) {
  const T inner_arm = pitch - ball * inner.cosine, outer_arm = pitch + ball * outer.cosine;
  const T across = outer.cosine * inner.cosine + outer.sine * inner.sine;  // cos(a_o - a_i)
  const T along = outer.sine * inner.cosine - outer.cosine * inner.sine;   // sin(a_o - a_i)
  // All is linear in the spin s about the outer normal; the turning along t_o is the rolling there.
  const T arms = outer_arm * across + inner_arm;
  const T orbit_0 = (speeds.outer * outer_arm * across + speeds.inner * inner_arm) / arms;
  const T orbit_1 = ball * along / arms;
  const T rolling_0 = (1.0 / ball) * outer_arm * (speeds.outer - orbit_0);
  const T rolling_1 = (-1.0 / ball) * outer_arm * orbit_1;
  const T outer_0 = outer.sine * (orbit_0 - speeds.outer);
  const T outer_1 = 1.0 + orbit_1 * outer.sine;
  const T inner_0 = inner.sine * (orbit_0 - speeds.inner) - rolling_0 * along;
  const T inner_1 = across - rolling_1 * along + orbit_1 * inner.sine;
  const T spin = -((weights.inner * inner_0 * inner_1 + weights.outer * outer_0 * outer_1) /
                   (weights.inner * inner_1 * inner_1 + weights.outer * outer_1 * outer_1));
  const T orbit = orbit_0 + orbit_1 * spin;
  const T rolling = rolling_0 + rolling_1 * spin;
  return {.orbit = orbit,
          .radial_spin = outer.cosine * spin - outer.sine * rolling,
          .axial_spin = outer.sine * spin + outer.cosine * rolling,
          .inner_spin = inner_0 + inner_1 * spin,
          .outer_spin = outer_0 + outer_1 * spin,
          .inner_rolling = inner_arm * (speeds.inner - orbit),
          .outer_rolling = outer_arm * (speeds.outer - orbit)};
}

}  // namespace orbearing::bearing::equilibrium
