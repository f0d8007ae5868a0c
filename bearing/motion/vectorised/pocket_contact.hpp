// Rollers in the pockets of the cage: dynamics/cage_pocket.hpp with slopes, one roller a lane.
#pragma once

#include "bearing/motion/vectorised/race_contact.hpp"

namespace orbearing::bearing::fast::ORBEARING_PACKS {

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

/// `e_r`, `e_t`: direction of each pocket in polar axes of its roller.
template <bool WithSlopes>
PocketForce pocket_contact(const Constants& c, const Pack& radius, const Mask& present, const Pack& e_r,
                           const Pack& e_t, double cage_speed, const RelativeMotion<Pack>& motion,
                           PocketSlopes& slopes) {
  const Pack a_r = -e_t, a_t = e_r;  // ahead
  const Pack offset = motion.d_r * a_r + motion.d_t * a_t;
  const Pack along = motion.d_r * e_r + motion.d_t * e_t;
  const Pack depth = absolute(offset) - (c.half_clearance - (radius - c.roller_radius));
  const Mask touching = present & (depth > 0.0);
  PocketForce result;
  result.touched = any(touching);
  if (!result.touched) return result;
  const Pack bar = with_sign_of(spread(1.0), offset);
  const Pack w_a = motion.w_r * a_r + motion.w_t * a_t;
  const Pack w_e = motion.w_r * e_r + motion.w_t * e_t;
  const Pack growth = 1.0 + c.pocket_damping * bar * (w_a - cage_speed * along);
  const Mask pressed = touching & (growth > 0.0);
  const Pack load = only(pressed, c.pocket_stiffness * depth * growth);
  const Pack arm = bar * radius;
  const Pack sliding = (motion.spin - cage_speed) * arm - w_e - cage_speed * offset;
  const Pack square = sliding * sliding + c.pocket_sliding_scale * c.pocket_sliding_scale;
  const Pack share = c.pocket_friction * sliding / root(square);
  const Pack friction = load * share;
  const Pack f_a = -bar * load;
  result.on_roller.f_r = f_a * a_r + friction * e_r;
  result.on_roller.f_t = f_a * a_t + friction * e_t;
  result.on_roller.moment = -arm * friction;
  result.on_roller.load = bar * load;
  result.cage_moment = along * bar * load + (offset + arm) * friction;
  if constexpr (WithSlopes) {
    const Pack by_sliding = only(pressed, load * c.pocket_friction * c.pocket_sliding_scale *
                                              c.pocket_sliding_scale / (square * root(square)));
    const Pack steep = only(pressed, bar * c.pocket_stiffness * growth);  // load by offset
    const Pack viscous =
        only(pressed, c.pocket_stiffness * depth * c.pocket_damping * bar);  // by w_a - speed along
    // What follows from a change of load and sliding speed: forces ahead and along e, moments.
    struct Rate {
      Pack a, e, moment, cage;
    };
    const auto follow = [&](const Pack& load_rate, const Pack& sliding_rate) {
      const Pack friction_rate = share * load_rate + by_sliding * sliding_rate;
      return Rate{-bar * load_rate, friction_rate, -arm * friction_rate,
                  bar * along * load_rate + (offset + arm) * friction_rate};
    };
    const auto put = [&](const Rate& rate, Pack& out_r, Pack& out_t, Pack& out_moment, Pack& out_cage) {
      out_r = rate.a * a_r + rate.e * e_r;
      out_t = rate.a * a_t + rate.e * e_t;
      out_moment = rate.moment;
      out_cage = rate.cage;
    };
    ContactSlopes<Pack>& roller = slopes.on_roller;
    for (int k = 0; k < 2; ++k) {  // polar component k of position, then of velocity
      const Pack d_a = k == 0 ? a_r : a_t, d_e = k == 0 ? e_r : e_t;
      Rate position = follow(steep * d_a - viscous * cage_speed * d_e, -cage_speed * d_a);
      position.cage += bar * load * d_e + friction * d_a;
      put(position, roller.by_position[0][k], roller.by_position[1][k], roller.by_position[2][k],
          slopes.cage_by_position[k]);
      put(follow(viscous * d_a, -d_e), roller.by_velocity[0][k], roller.by_velocity[1][k],
          roller.by_velocity[2][k], slopes.cage_by_velocity[k]);
    }
    const Pack by_spin = by_sliding * arm;
    roller.by_spin[0] = by_spin * e_r;
    roller.by_spin[1] = by_spin * e_t;
    roller.by_spin[2] = -arm * by_spin;
    slopes.cage_by_spin = (offset + arm) * by_spin;
    put(follow(-viscous * along, -(arm + offset)), slopes.by_speed[0], slopes.by_speed[1], slopes.by_speed[2],
        slopes.cage_by_speed);
    // The cage turns by an angle: e turns ahead, ahead turns against e.
    Rate angle = follow(-steep * along - viscous * (w_e + cage_speed * offset), cage_speed * along - w_a);
    angle.a += friction;
    angle.e -= f_a;
    angle.cage += bar * load * offset - friction * along;
    put(angle, slopes.by_angle[0], slopes.by_angle[1], slopes.by_angle[2], slopes.cage_by_angle);
  }
  return result;
}

}  // namespace orbearing::bearing::fast::ORBEARING_PACKS
