// Rates of the rings and of the cage under what the rollers and the land do to them. Included by
// stage_matrix.hpp only.
#pragma once

#include "bearing/motion/vectorised/pack_engine.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Of the land on the cage; the land feels the opposite force.
template <class T>
struct LandForce {
  T x, y;    // [N]
  T moment;  // [N m]
};

template <class T>
LandForce<T> land_force(const LandConstants& land, const LandMotion<T>& motion) {
  if (!land.present) return {};
  const LandForces<T> now = land.law.forces(motion, land.speed);
  const T couple = 0.5 * (motion.offset_x * now.film_y - motion.offset_y * now.film_x);
  return {now.film_x + now.touch_x, now.film_y + now.touch_y,
          now.shear - couple + (land.law.side * land.law.cage_radius) * now.touch_friction};
}

template <bool WithSlopes, bool Caged>
void PackEngine::evaluate_rings(const double* x, double load_x, double load_y, const RingLoads& sums,
                                double* dx) {
  const double* cage = x + layout_.cage();
  const double* bore = x + layout_.bore();
  const double* pin = x + layout_.pin();
  double* cage_rate = dx + layout_.cage();
  double* bore_rate = dx + layout_.bore();
  double* pin_rate = dx + layout_.pin();
  const double* land = c_.land.on_bore ? bore : pin;
  const double offset[5] = {cage[0] - land[0], cage[1] - land[1], cage[3] - land[2], cage[4] - land[3],
                            cage[5]};
  double land_x = 0.0, land_y = 0.0, land_moment = 0.0;
  if constexpr (WithSlopes) {
    const auto variable = [&](int index) { return GuidanceDual::variable(offset[index], index); };
    const LandForce<GuidanceDual> force = land_force(
        c_.land, LandMotion<GuidanceDual>{variable(0), variable(1), variable(2), variable(3), variable(4)});
    land_x_ = force.x;
    land_y_ = force.y;
    land_moment_ = force.moment;
    cage_speed_ = cage[5];
    land_x = force.x.value;
    land_y = force.y.value;
    land_moment = force.moment.value;
  } else {
    const LandForce<double> force =
        land_force(c_.land, LandMotion<double>{offset[0], offset[1], offset[2], offset[3], offset[4]});
    land_x = force.x;
    land_y = force.y;
    land_moment = force.moment;
  }
  const double on_bore = c_.land.on_bore ? 1.0 : 0.0;
  const auto frame_x = [&](double px, double py, double vy, double orbit_radius) {
    return 2.0 * c_.coriolis_speed * vy + c_.centrifugal * (px + orbit_radius) + c_.euler * py;
  };
  const auto frame_y = [&](double px, double py, double vx, double orbit_radius) {
    return -2.0 * c_.coriolis_speed * vx + c_.centrifugal * py - c_.euler * (px + orbit_radius);
  };
  if constexpr (Caged) {
    cage_rate[0] = cage[3];
    cage_rate[1] = cage[4];
    cage_rate[2] = cage[5];
    cage_rate[3] =
        (sum(sums.cage.x) + land_x) / c_.cage_mass + frame_x(cage[0], cage[1], cage[4], c_.orbit_radius);
    cage_rate[4] =
        (sum(sums.cage.y) + land_y) / c_.cage_mass + frame_y(cage[0], cage[1], cage[3], c_.orbit_radius);
    cage_rate[5] = (sum(sums.cage_moment) + land_moment - c_.cage_drag * cage[5] * __builtin_fabs(cage[5])) /
                       c_.cage_inertia -
                   c_.euler;
  }
  // The load on the bore holds the planet's inertial load at the origin: here only what displacement adds.
  const double bore_x = sum(sums.bore.x), bore_y = sum(sums.bore.y);
  on_bore_ = {bore_x - on_bore * land_x, bore_y - on_bore * land_y,
              sum(sums.bore_moment) - (bore[0] * bore_y - bore[1] * bore_x) -
                  on_bore * (land_moment + offset[0] * land_y - offset[1] * land_x)};
  bore_rate[0] = bore[2];
  bore_rate[1] = bore[3];
  bore_rate[2] =
      (bore_x - on_bore * land_x + load_x) / c_.bore_mass + frame_x(bore[0], bore[1], bore[3], 0.0);
  bore_rate[3] =
      (bore_y - on_bore * land_y + load_y) / c_.bore_mass + frame_y(bore[0], bore[1], bore[2], 0.0);
  const double on_pin = 1.0 - on_bore;
  pin_rate[0] = pin[2];
  pin_rate[1] = pin[3];
  pin_rate[2] =
      (sum(sums.pin.x) - on_pin * land_x - c_.support_stiffness * pin[0] - c_.support_damping * pin[2]) /
          c_.pin_mass +
      frame_x(pin[0], pin[1], pin[3], c_.orbit_radius);
  pin_rate[3] =
      (sum(sums.pin.y) - on_pin * land_y - c_.support_stiffness * pin[1] - c_.support_damping * pin[3]) /
          c_.pin_mass +
      frame_y(pin[0], pin[1], pin[2], c_.orbit_radius);
}

inline void PackEngine::set_surroundings(const Surroundings& now) {
  c_.coriolis_speed = now.coriolis_speed;
  c_.centrifugal = now.centrifugal;
  c_.euler = now.euler;
  c_.outer.speed = now.bore_speed;
  races_.speed = {c_.inner.speed, now.bore_speed};
  if (c_.land.on_bore) c_.land.speed = now.bore_speed;
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
