// Rollers in the pockets of the cage, one roller a lane: the law of bearing/contact/pocket_law.hpp, its
// slopes turned from the axes of the pockets into those of the rollers.
#pragma once

#include "bearing/motion/vectorised/race_contact.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Slopes of the pocket in addition to those by relative motion: those by the cage's rotation, and the moment
/// on the cage.
struct PocketSlopes {
  ContactSlopes<Pack> on_roller;  // by motion of the roller relative to the cage's centre
  Pack by_angle[3];               // of (f_r, f_t, moment) by the cage angle
  Pack by_speed[3];               // and by its speed
  Pack cage_by_position[2];       // of the moment on the cage
  Pack cage_by_velocity[2];
  Pack cage_by_spin;
  Pack cage_by_angle;
  Pack cage_by_speed;
};

struct PocketForce {
  ContactForce<Pack> on_roller;
  Pack cage_moment{};  // [N m]
  bool touched = false;
};

/// Forces ahead and along e and moments, or how they change with one variable.
struct PocketRate {
  Pack ahead{}, along{}, moment{}, cage{};

  PocketRate& operator+=(const PocketRate& x) {
    ahead += x.ahead;
    along += x.along;
    moment += x.moment;
    cage += x.cage;
    return *this;
  }
};

inline PocketRate operator+(PocketRate x, const PocketRate& y) {
  return x += y;
}
inline PocketRate operator*(const Pack& scale, const PocketRate& x) {
  return {scale * x.ahead, scale * x.along, scale * x.moment, scale * x.cage};
}

/// The variables of the law as forward differentiation numbers them.
enum PocketVariable { kOffset, kAlong, kSpeedAhead, kSpeedAlong, kSpin, kCageSpeed, kPocketVariables };

/// Touch and oil of a pack of rollers with their slopes.
struct PocketSum {
  PocketRate force;
  PocketRate by[kPocketVariables];

  /// Adds the touch in the lanes of `where`.
  template <bool WithSlopes, class Touch>
  void add(const Mask& where, const Touch& touch) {
    using mechanics::value_of;
    const auto part = [&](auto of) {
      return PocketRate{only(where, of(touch.ahead)), only(where, of(touch.along)),
                        only(where, of(touch.roller_moment)), only(where, of(touch.cage_moment))};
    };
    force += part([](const auto& x) { return value_of(x); });
    if constexpr (WithSlopes) {
      by[kOffset] += part([](const auto& x) { return x.template by<kOffset>(); });
      by[kAlong] += part([](const auto& x) { return x.template by<kAlong>(); });
      by[kSpeedAhead] += part([](const auto& x) { return x.template by<kSpeedAhead>(); });
      by[kSpeedAlong] += part([](const auto& x) { return x.template by<kSpeedAlong>(); });
      by[kSpin] += part([](const auto& x) { return x.template by<kSpin>(); });
      by[kCageSpeed] += part([](const auto& x) { return x.template by<kCageSpeed>(); });
    }
  }
};

/// `e_r`, `e_t`: direction of each pocket in polar axes of its roller.
template <bool WithSlopes>
PocketForce pocket_contact(const PocketLaw& law, double stated_radius, const Pack& radius,
                           const Mask& present, const Pack& e_r, const Pack& e_t, double cage_speed,
                           const RelativeMotion<Pack>& motion, PocketSlopes& slopes) {
  const Pack a_r = -e_t, a_t = e_r;  // ahead
  const Pack offset = motion.d_r * a_r + motion.d_t * a_t;
  const Pack along = motion.d_r * e_r + motion.d_t * e_t;
  const Pack bar = with_sign_of(spread(1.0), offset);
  const Pack radius_deviation = radius - stated_radius;
  const Mask touching = present & (law.depth(bar, offset, radius_deviation) > 0.0);
  PocketForce result;
  result.touched = law.with_film() || any(touching);
  if (!result.touched) return result;
  const Pack speed_ahead = motion.w_r * a_r + motion.w_t * a_t;
  const Pack speed_along = motion.w_r * e_r + motion.w_t * e_t;
  PocketSum sum;
  const auto act = [&](const auto& moving) {
    if (any(touching)) sum.add<WithSlopes>(touching, law.touch(bar, radius, radius_deviation, moving));
    if (law.with_film()) sum.add<WithSlopes>(present, law.oil(radius, radius_deviation, moving));
  };
  if constexpr (WithSlopes) {
    using mechanics::variable;
    act(PocketMotion{variable<kOffset>(offset), variable<kAlong>(along), variable<kSpeedAhead>(speed_ahead),
                     variable<kSpeedAlong>(speed_along), variable<kSpin>(motion.spin),
                     variable<kCageSpeed>(spread(cage_speed))});
  } else {
    act(PocketMotion{offset, along, speed_ahead, speed_along, motion.spin, spread(cage_speed)});
  }
  result.on_roller.f_r = sum.force.ahead * a_r + sum.force.along * e_r;
  result.on_roller.f_t = sum.force.ahead * a_t + sum.force.along * e_t;
  result.on_roller.moment = sum.force.moment;
  result.cage_moment = sum.force.cage;
  if constexpr (WithSlopes) {
    const auto turned = [&](const PocketRate& rate, Pack& out_r, Pack& out_t, Pack& out_moment,
                            Pack& out_cage) {
      out_r = rate.ahead * a_r + rate.along * e_r;
      out_t = rate.ahead * a_t + rate.along * e_t;
      out_moment = rate.moment;
      out_cage = rate.cage;
    };
    ContactSlopes<Pack>& roller = slopes.on_roller;
    for (int k = 0; k < 2; ++k) {  // polar component k of position, then of velocity
      const Pack &a_k = k == 0 ? a_r : a_t, &e_k = k == 0 ? e_r : e_t;
      turned(a_k * sum.by[kOffset] + e_k * sum.by[kAlong], roller.by_position[0][k], roller.by_position[1][k],
             roller.by_position[2][k], slopes.cage_by_position[k]);
      turned(a_k * sum.by[kSpeedAhead] + e_k * sum.by[kSpeedAlong], roller.by_velocity[0][k],
             roller.by_velocity[1][k], roller.by_velocity[2][k], slopes.cage_by_velocity[k]);
    }
    turned(sum.by[kSpin], roller.by_spin[0], roller.by_spin[1], roller.by_spin[2], slopes.cage_by_spin);
    turned(sum.by[kCageSpeed], slopes.by_speed[0], slopes.by_speed[1], slopes.by_speed[2],
           slopes.cage_by_speed);
    // The cage turns by an angle: e turns ahead, ahead turns against e.
    PocketRate angle = offset * sum.by[kAlong] + speed_ahead * sum.by[kSpeedAlong] +
                       (-along) * sum.by[kOffset] + (-speed_along) * sum.by[kSpeedAhead];
    angle.ahead += sum.force.along;
    angle.along -= sum.force.ahead;
    turned(angle, slopes.by_angle[0], slopes.by_angle[1], slopes.by_angle[2], slopes.cage_by_angle);
  }
  return result;
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
