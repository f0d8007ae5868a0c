// Rates of the rings and of the cage under what the rollers and the land do to them. Included by
// stage_matrix.hpp only.
#pragma once

#include "bearing/motion/vectorised/pack_engine.hpp"

namespace orbearing::bearing::vectorised::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

/// Force of the land on the cage, with its slopes kept for the matrix. It is a long chain of dependent
/// operations and independent of the rollers: started before them, it runs in parallel with them.
template <bool WithSlopes>
LandForce<double> PackEngine::evaluate_land(const double* x) {
  const double* cage = x + layout_.cage();
  if constexpr (WithSlopes) cage_speed_ = cage[5];
  if (!c_.land.present) return {};
  const double* land = x + (c_.land.on_bore ? layout_.bore() : layout_.pin());
  const double land_speed = c_.land.on_bore ? c_.outer.speed : c_.inner.speed;
  const double offset[5] = {cage[0] - land[0], cage[1] - land[1], cage[3] - land[2], cage[4] - land[3],
                            cage[5]};
  if constexpr (WithSlopes) {
    const auto variable = [&](int index) { return register_variable(offset[index], index); };
    const LandForce<RegisterDual> force = c_.land.law.force(
        LandMotion<RegisterDual>{variable(0), variable(1), variable(2), variable(3), variable(4)},
        land_speed);
    land_x_ = force.x;
    land_y_ = force.y;
    land_moment_ = force.on_cage;
    return {.x = force.x.value, .y = force.y.value, .on_cage = force.on_cage.value};
  } else {
    return c_.land.law.force(LandMotion<double>{offset[0], offset[1], offset[2], offset[3], offset[4]},
                             land_speed);
  }
}

template <bool Caged>
void PackEngine::evaluate_rings(const double* x, double load_x, double load_y, const RingLoads& sums,
                                const LandForce<double>& guided, double* dx) {
  const double* cage = x + layout_.cage();
  const double* bore = x + layout_.bore();
  const double* pin = x + layout_.pin();
  double* cage_rate = dx + layout_.cage();
  double* bore_rate = dx + layout_.bore();
  double* pin_rate = dx + layout_.pin();
  const double* land = c_.land.on_bore ? bore : pin;
  const double land_x = guided.x, land_y = guided.y;
  const double on_bore = c_.land.on_bore ? 1.0 : 0.0;
  double of_rollers[8];
  sums_of({sums.pin.x, sums.pin.y, sums.bore.x, sums.bore.y, sums.bore_moment, sums.cage.x, sums.cage.y,
           sums.cage_moment},
          of_rollers);
  const auto& [pin_x, pin_y, bore_x, bore_y, bore_moment, cage_x, cage_y, cage_moment] = of_rollers;
  const CarrierFrame& frame = c_.frame;
  if constexpr (Caged) {
    const PlaneAcceleration added = inertial_acceleration(frame, cage[0], cage[1], cage[3], cage[4]);
    cage_rate[0] = cage[3];
    cage_rate[1] = cage[4];
    cage_rate[2] = cage[5];
    cage_rate[3] = (cage_x + land_x) / c_.cage_mass + added.x + c_.gravity.x;
    cage_rate[4] = (cage_y + land_y) / c_.cage_mass + added.y + c_.gravity.y;
    cage_rate[5] =
        (cage_moment + guided.on_cage - c_.cage_drag * cage[5] * __builtin_fabs(cage[5])) / c_.cage_inertia -
        frame.euler;
  }
  // The load on the bore holds the planet's weight, and its inertial load at the origin: here only what
  // displacement adds.
  on_bore_ = {bore_x - on_bore * land_x, bore_y - on_bore * land_y,
              bore_moment - (bore[0] * bore_y - bore[1] * bore_x) -
                  on_bore * (guided.on_cage + (cage[0] - land[0]) * land_y - (cage[1] - land[1]) * land_x)};
  bore_rate[0] = bore[2];
  bore_rate[1] = bore[3];
  CarrierFrame centred = frame;
  centred.orbit_radius = 0.0;
  const PlaneAcceleration to_bore = inertial_acceleration(centred, bore[0], bore[1], bore[2], bore[3]);
  bore_rate[2] = (bore_x - on_bore * land_x + load_x) / c_.bore_mass + to_bore.x;
  bore_rate[3] = (bore_y - on_bore * land_y + load_y) / c_.bore_mass + to_bore.y;
  const double on_pin = 1.0 - on_bore;
  const PlaneAcceleration to_pin = inertial_acceleration(frame, pin[0], pin[1], pin[2], pin[3]);
  pin_rate[0] = pin[2];
  pin_rate[1] = pin[3];
  pin_rate[2] =
      (pin_x - on_pin * land_x - c_.support_stiffness * pin[0] - c_.support_damping * pin[2]) / c_.pin_mass +
      to_pin.x + c_.gravity.x;
  pin_rate[3] =
      (pin_y - on_pin * land_y - c_.support_stiffness * pin[1] - c_.support_damping * pin[3]) / c_.pin_mass +
      to_pin.y + c_.gravity.y;
}

inline void PackEngine::set_surroundings(const Surroundings& now) {
  put_surroundings(now, c_);
  races_.speed = {c_.inner.speed, c_.outer.speed};
}

}  // namespace orbearing::bearing::vectorised::ORBEARING_PACKS
