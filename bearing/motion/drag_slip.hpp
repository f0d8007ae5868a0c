// How far cage and rollers stay behind pure rolling where oil holds them back and the loaded contacts can
// drive no more: drag against traction, in closed form.
#pragma once

#include <cmath>

#include "bearing/motion/model.hpp"

namespace orbearing::bearing::motion {

/// 1 or -1: that of pure rolling, which a cage that stands has too.
inline double sense_of_orbit(const BearingModel& model) {
  const double rolling =
      kinematic_cage_speed(model.geometry, model.point.inner_speed, model.point.outer_speed);
  return rolling < 0.0 ? -1.0 : 1.0;
}

/// Force [N] on the pitch circle against the orbit at the orbital speed `speed` [rad/s]: drag of all rollers
/// and of the cage, and what the land does to a cage that is centred in it (negative where the land drives).
inline double resistance_to_orbit(const BearingModel& model, double speed) {
  const double pitch = 0.5 * (model.geometry.inner_radius + model.geometry.outer_radius);
  const double along = sense_of_orbit(model);
  double resistance =
      -along * static_cast<double>(model.layout.rollers) * model.orbit_drag.force(pitch * speed) -
      along * model.cage_drag.force(speed) / pitch;
  if (!model.land.present) return resistance;
  const double land_speed = model.land.on_bore ? model.point.outer_speed : model.point.inner_speed;
  const LandMotion<double> centred{0.0, 0.0, 0.0, 0.0, speed};
  return resistance - along * model.land.law.force(centred, land_speed).on_cage / pitch;
}

/// Slip [-] of the orbit, 1 - speed / speed at pure rolling, at which the regularised Coulomb traction of
/// the loaded rollers holds the resistance to their orbit. Drag along the pitch circle and no moment about
/// its axis leave a roller the same friction at both races, so that both slide by s omega_k d_m / 2:
///
///   2 mu sum(Q) sigma / sqrt(sigma^2 + s_0^2) = resistance at (1 - s) omega_k,   sigma = s omega_k d_m / 2
///
/// with Q the smaller of a roller's loads at both races: a roller that only one race touches takes its spin
/// from that race and drives nothing. Left out: churning by the rollers' spin and friction in the pockets, so
/// that the motion slips more, and resistance to rolling F. That has the sense of the outer race, 2 F R_o/r_m
/// on a roller that no other touches (bearing/motion/README.md, Eq. 6): a bore that turns carries rollers
/// along, and the motion slips less; about a shaft that turns it slips more. 1 where traction moves neither
/// rollers nor cage; 0 where nothing resists.
/// @param loads [N] Q of all rollers, their sum
inline double drag_slip(const BearingModel& model, double loads) {
  const double rolling =
      kinematic_cage_speed(model.geometry, model.point.inner_speed, model.point.outer_speed);
  const double pitch = 0.5 * (model.geometry.inner_radius + model.geometry.outer_radius);
  const CoulombFriction<double>& friction = model.inner.friction.coulomb;
  const auto excess = [&](double slip) {  // of traction over resistance
    return 2.0 * friction.force(loads, slip * std::abs(rolling) * pitch) -
           resistance_to_orbit(model, (1.0 - slip) * rolling);
  };
  double low = 0.0, high = 1.0;
  if (excess(low) >= 0.0) return 0.0;
  if (excess(high) < 0.0) return 1.0;
  for (int halved = 0; halved < 50; ++halved) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace orbearing::bearing::motion
