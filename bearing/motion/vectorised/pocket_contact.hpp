// Rollers in the pockets of the cage, one roller a lane: the law of bearing/contact/pocket_law.hpp, its
// slopes turned from the axes of the pockets into those of the rollers.
#pragma once

#include "bearing/motion/vectorised/race_contact.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// What the pocket's slopes have beyond those by relative motion: those by the cage's rotation, and the
/// moment on the cage.
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

/// How the touch changes with one variable: forces ahead and along e, moments.
struct PocketRate {
  Pack ahead, along, moment, cage;
};

inline PocketRate operator+(const PocketRate& x, const PocketRate& y) {
  return {x.ahead + y.ahead, x.along + y.along, x.moment + y.moment, x.cage + y.cage};
}
inline PocketRate operator*(const Pack& scale, const PocketRate& x) {
  return {scale * x.ahead, scale * x.along, scale * x.moment, scale * x.cage};
}

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
  result.touched = any(touching);
  if (!result.touched) return result;
  const Pack speed_ahead = motion.w_r * a_r + motion.w_t * a_t;
  const Pack speed_along = motion.w_r * e_r + motion.w_t * e_t;
  const auto put = [&](const auto& touch) {
    using mechanics::value_of;
    const Pack ahead = only(touching, value_of(touch.ahead)), rubbed = only(touching, value_of(touch.along));
    result.on_roller.f_r = ahead * a_r + rubbed * e_r;
    result.on_roller.f_t = ahead * a_t + rubbed * e_t;
    result.on_roller.moment = only(touching, value_of(touch.roller_moment));
    result.cage_moment = only(touching, value_of(touch.cage_moment));
  };
  if constexpr (!WithSlopes) {
    put(law.touch(bar, radius, radius_deviation,
                  PocketMotion{offset, along, speed_ahead, speed_along, motion.spin, cage_speed}));
  } else {
    using mechanics::variable;
    enum { kOffset, kAlong, kSpeedAhead, kSpeedAlong, kSpin, kCageSpeed };
    const PocketMotion moving{variable<kOffset>(offset),          variable<kAlong>(along),
                              variable<kSpeedAhead>(speed_ahead), variable<kSpeedAlong>(speed_along),
                              variable<kSpin>(motion.spin),       variable<kCageSpeed>(spread(cage_speed))};
    const auto touch = law.touch(bar, radius, radius_deviation, moving);
    put(touch);
    const auto slope = [&](auto by) {
      return PocketRate{only(touching, by(touch.ahead)), only(touching, by(touch.along)),
                        only(touching, by(touch.roller_moment)), only(touching, by(touch.cage_moment))};
    };
    const PocketRate by_offset = slope([](const auto& x) { return x.template by<kOffset>(); });
    const PocketRate by_along = slope([](const auto& x) { return x.template by<kAlong>(); });
    const PocketRate by_speed_ahead = slope([](const auto& x) { return x.template by<kSpeedAhead>(); });
    const PocketRate by_speed_along = slope([](const auto& x) { return x.template by<kSpeedAlong>(); });
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
      turned(a_k * by_offset + e_k * by_along, roller.by_position[0][k], roller.by_position[1][k],
             roller.by_position[2][k], slopes.cage_by_position[k]);
      turned(a_k * by_speed_ahead + e_k * by_speed_along, roller.by_velocity[0][k], roller.by_velocity[1][k],
             roller.by_velocity[2][k], slopes.cage_by_velocity[k]);
    }
    turned(slope([](const auto& x) { return x.template by<kSpin>(); }), roller.by_spin[0], roller.by_spin[1],
           roller.by_spin[2], slopes.cage_by_spin);
    turned(slope([](const auto& x) { return x.template by<kCageSpeed>(); }), slopes.by_speed[0],
           slopes.by_speed[1], slopes.by_speed[2], slopes.cage_by_speed);
    // The cage turns by an angle: e turns ahead, ahead turns against e.
    PocketRate angle = offset * by_along + speed_ahead * by_speed_along + (-along) * by_offset +
                       (-speed_along) * by_speed_ahead;
    angle.ahead += only(touching, value_of(touch.along));
    angle.along -= only(touching, value_of(touch.ahead));
    turned(angle, slopes.by_angle[0], slopes.by_angle[1], slopes.by_angle[2], slopes.cage_by_angle);
  }
  return result;
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
