// Rollers in the pockets of the cage: dynamics/cage_pocket.hpp with slopes, one roller a lane.
#pragma once

#include "bearing/fast/race_contact.hpp"

namespace orbearing::bearing::fast::ORBEARING_LANES {

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
    // Slopes of (load, sliding) by a change of (offset, along, w_a, w_e, cage speed, spin).
    const auto put = [&](const Pack& offset_rate, const Pack& along_rate, const Pack& wa_rate,
                         const Pack& we_rate, const Pack& speed_rate, const Pack& spin_rate, Pack& out_a,
                         Pack& out_e, Pack& out_m, Pack& out_cage) {
      const Pack load_rate =
          steep * offset_rate + viscous * (wa_rate - cage_speed * along_rate - along * speed_rate);
      const Pack sliding_rate =
          (spin_rate - speed_rate) * arm - we_rate - cage_speed * offset_rate - offset * speed_rate;
      const Pack friction_rate = share * load_rate + by_sliding * sliding_rate;
      out_a = -bar * load_rate;
      out_e = friction_rate;
      out_m = -arm * friction_rate;
      out_cage = bar * (along_rate * load + along * load_rate) + offset_rate * friction +
                 (offset + arm) * friction_rate;
    };
    const Pack zero{};
    const auto to_polar = [&](const Pack& x_a, const Pack& x_e, Pack& x_r, Pack& x_t) {
      x_r = x_a * a_r + x_e * e_r;
      x_t = x_a * a_t + x_e * e_t;
    };
    Pack x_a, x_e;
    for (int k = 0; k < 2; ++k) {  // polar component k of position, then of velocity
      const Pack d_a = k == 0 ? a_r : a_t, d_e = k == 0 ? e_r : e_t;
      ContactSlopes<Pack>& roller = slopes.on_roller;
      put(d_a, d_e, zero, zero, zero, zero, x_a, x_e, roller.by_position[2][k], slopes.cage_by_position[k]);
      to_polar(x_a, x_e, roller.by_position[0][k], roller.by_position[1][k]);
      put(zero, zero, d_a, d_e, zero, zero, x_a, x_e, roller.by_velocity[2][k], slopes.cage_by_velocity[k]);
      to_polar(x_a, x_e, roller.by_velocity[0][k], roller.by_velocity[1][k]);
    }
    put(zero, zero, zero, zero, zero, spread(1.0), x_a, x_e, slopes.on_roller.by_spin[2],
        slopes.cage_by_spin);
    to_polar(x_a, x_e, slopes.on_roller.by_spin[0], slopes.on_roller.by_spin[1]);
    put(zero, zero, zero, zero, spread(1.0), zero, x_a, x_e, slopes.by_speed[2], slopes.cage_by_speed);
    to_polar(x_a, x_e, slopes.by_speed[0], slopes.by_speed[1]);
    // The cage turns by an angle: e turns ahead, ahead turns against e.
    put(-along, offset, -w_e, w_a, zero, zero, x_a, x_e, slopes.by_angle[2], slopes.cage_by_angle);
    to_polar(x_a + friction, x_e - f_a, slopes.by_angle[0], slopes.by_angle[1]);
  }
  return result;
}

}  // namespace orbearing::bearing::fast::ORBEARING_LANES
