// Cage on the lands of a ring: the law of bearing/contact/land_law.hpp at both ends of the cage's width, so
// that it also resists tilting. For plain numbers and for numbers with their slopes.
#pragma once

#include "bearing/motion/balls/bodies.hpp"

namespace orbearing::bearing::balls {

/// Of one land on the cage, at `place` [m] along the axis.
template <class T>
struct LandForce {
  T x, y;           // [N]
  T on_cage;        // [N m]  about the axis
  T on_ring;        // [N m]
  T power;          // [W]    dissipated
  T eccentricity;   // [-]
};

/// `offset` and `velocity` of the cage less the land, where the land is.
template <class T>
LandForce<T> land_force(const LandNumbers& land, const LandMotion<T>& motion, double land_speed) {
  using mechanics::root, mechanics::value_of;
  const LandForces<T> now = land.law.forces(motion, land_speed);
  const double arm = land.law.side * land.law.cage_radius;
  // The couple of the film's two forces, which act through both centres, is shared evenly by both surfaces.
  const T couple = 0.5 * (motion.offset_x * now.film_y - motion.offset_y * now.film_x);
  const T touch_couple = motion.offset_x * now.touch_y - motion.offset_y * now.touch_x;
  const T on_cage = now.shear - couple + arm * now.touch_friction;
  return {now.film_x + now.touch_x,
          now.film_y + now.touch_y,
          on_cage,
          -now.shear - couple - arm * now.touch_friction - touch_couple,
          now.touch_damping_power + now.touch_friction * now.touch_sliding -
              (now.film_x * now.squeeze_x + now.film_y * now.squeeze_y) +
              now.shear * (land_speed - motion.cage_speed),
          now.eccentricity};
}

/// Cage less land at `place` along the axes: offset x y, velocity x y, spin of the cage.
struct LandOffset {
  double by[5];
};
[[gnu::always_inline]] inline LandOffset land_offset(const Body& cage, const Body& ring, double place) {
  return {{cage.centre.x - ring.centre.x + place * (cage.axis.x - ring.axis.x),
           cage.centre.y - ring.centre.y + place * (cage.axis.y - ring.axis.y),
           cage.velocity.x - ring.velocity.x + place * (cage.axis_rate.x - ring.axis_rate.x),
           cage.velocity.y - ring.velocity.y + place * (cage.axis_rate.y - ring.axis_rate.y), cage.spin}};
}

}  // namespace orbearing::bearing::balls
