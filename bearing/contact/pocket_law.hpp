// A roller that touches a bar of its cage pocket: the law once, for plain numbers, packs and both with their
// slopes.
//
//        a (ahead, sense of rotation)  The pocket's middle line runs from the cage's centre along e. The
//        ^       |bar|                 roller is off it by `offset` along a and touches a bar where
//   o----|---|---|---> e               |offset| exceeds half the clearance.
//  cage      |bar|
//
#pragma once

#include "bearing/contact/damping.hpp"
#include "bearing/contact/friction.hpp"
#include "bearing/contact/rigid_line_film.hpp"

namespace orbearing::bearing {

/// Motion of a roller relative to the cage's centre in the pocket's axes.
template <class Offset, class Along, class SpeedAhead, class SpeedAlong, class Spin, class CageSpeed>
struct PocketMotion {
  Offset offset;           // [m]      of the roller's centre, along a
  Along along;             // [m]      along e
  SpeedAhead speed_ahead;  // [m/s]    of the roller's centre less the cage's, along a
  SpeedAlong speed_along;  // [m/s]    along e
  Spin spin;               // [rad/s]  of the roller
  CageSpeed cage_speed;    // [rad/s]
};

template <class Offset, class Along, class SpeedAhead, class SpeedAlong, class Spin, class CageSpeed>
PocketMotion(Offset, Along, SpeedAhead, SpeedAlong, Spin, CageSpeed)
    -> PocketMotion<Offset, Along, SpeedAhead, SpeedAlong, Spin, CageSpeed>;

/// Force of a bar on the roller; the opposite acts on the cage at its own arm.
template <class Ahead, class Along, class RollerMoment, class CageMoment, class Power, class Sliding>
struct PocketTouch {
  Ahead ahead;                 // [N]    on the roller, along a
  Along along;                 // [N]    on the roller, along e: friction
  RollerMoment roller_moment;  // [N m]  about the roller's centre
  CageMoment cage_moment;      // [N m]  on the cage about its own centre
  Power power;                 // [W]    dissipated across the bar
  Sliding sliding;             // [m/s]  surface of the bar less that of the roller, along e
};

template <class Ahead, class Along, class RollerMoment, class CageMoment, class Power, class Sliding>
PocketTouch(Ahead, Along, RollerMoment, CageMoment, Power, Sliding)
    -> PocketTouch<Ahead, Along, RollerMoment, CageMoment, Power, Sliding>;

/// Force of the oil at both bars on the roller; the opposite acts on the cage at its own arm.
template <class Ahead, class Along, class RollerMoment, class CageMoment, class Power>
struct PocketOil {
  Ahead ahead;                 // [N]    on the roller, along a
  Along along;                 // [N]    on the roller, along e: shear
  RollerMoment roller_moment;  // [N m]  about the roller's centre
  CageMoment cage_moment;      // [N m]  on the cage about its own centre
  Power power;                 // [W]    dissipated
};

template <class Ahead, class Along, class RollerMoment, class CageMoment, class Power>
PocketOil(Ahead, Along, RollerMoment, CageMoment, Power)
    -> PocketOil<Ahead, Along, RollerMoment, CageMoment, Power>;

struct PocketLaw {
  double half_clearance = 0.0;  // [m]
  double stiffness = 0.0;       // [N/m]  of a bar
  double damping = 0.0;         // [s/m]
  CoulombFriction<double> friction;
  double viscous = 0.0;    // [Pa s m]  2 eta l of the oil before the bars; 0: they act when touched
  double roughness = 0.0;  // [m]       where asperities hold that oil

  bool with_film() const { return viscous > 0.0; }

  /// Compression [m] of the bar ahead (`bar` = 1) or behind (-1) by a roller whose radius is larger than
  /// stated by `deviation` [m]; negative without contact.
  template <class Bar, class Offset, class Deviation>
  auto depth(const Bar& bar, const Offset& offset, const Deviation& deviation) const {
    return offset * bar - (half_clearance - deviation);
  }

  /// Touch at `bar`, of a roller of `radius` [m], where the depth is positive.
  template <class Number, class... Parts>
  auto touch(const Number& bar, const Number& radius, const Number& deviation,
             const PocketMotion<Parts...>& m) const {
    const auto closing = (m.speed_ahead - m.cage_speed * m.along) * bar;
    const auto normal = damped_load(depth(bar, m.offset, deviation) * stiffness, damping, closing);
    const Number arm = bar * radius;
    const auto sliding = (m.spin - m.cage_speed) * arm - m.speed_along - m.cage_speed * m.offset;
    const auto rubbed = friction.force(normal.load, sliding);
    const auto ahead = -(normal.load * bar);
    return PocketTouch{ahead,        rubbed, -(rubbed * arm), (m.offset + arm) * rubbed - m.along * ahead,
                       normal.power, sliding};
  }

  /// Oil before both bars (rigid_line_film.hpp). A gap is held at the roughness, so that the film goes over
  /// into the touch without a jump. Surface speeds are along e, relative to the contact, which moves with the
  /// roller's centre and turns with the cage; at the bar behind the roller's surface runs the other way. With
  /// u the speed of the roller's surface, v that of the bar's and s the shear of the film, the surfaces are
  /// dragged by s (v - u) and by twice the shear of rolling, -s (u + v), together -2 s u, and the tilt of the
  /// pressure pushes the roller by 4 s (u + v)/2, with the drag 2 s v: both bars add their shears.
  template <class Number, class... Parts>
  auto oil(const Number& radius, const Number& deviation, const PocketMotion<Parts...>& m) const {
    using mechanics::larger, mechanics::root, mechanics::sign_of, mechanics::value_of;
    constexpr double kAtRest = 1e-20;  // [m/s]  far below any speed: a film at rest has an angle psi, too
    const RigidLineFilm<Number> film{Number{} + viscous, root(2.0 * radius)};
    const auto closing = m.speed_ahead - m.cage_speed * m.along;
    const auto roller_surface = (m.cage_speed - m.spin) * radius;
    const auto bar_surface = -(m.speed_along + m.cage_speed * m.offset);
    const auto before = [&](const auto& toward, const auto& closes, const auto& runs) {
      const auto gap = larger((half_clearance - deviation) - toward, Number{} + roughness);
      const auto rolling = 0.5 * (runs + bar_surface);
      return film.at(film.slenderness(gap), rolling * sign_of(value_of(rolling)) + kAtRest, closes);
    };
    const auto front = before(m.offset, closing, roller_surface);
    const auto rear = before(-m.offset, -closing, -roller_surface);
    const auto twice_shear = 2.0 * (front.shear + rear.shear);
    const auto ahead = rear.load - front.load;
    const auto along = twice_shear * bar_surface;
    const auto roller_moment = twice_shear * (roller_surface * radius);
    return PocketOil{
        ahead, along, roller_moment, m.offset * along - m.along * ahead - roller_moment,
        twice_shear * (roller_surface * roller_surface + bar_surface * bar_surface) - ahead * closing};
  }
};

}  // namespace orbearing::bearing
