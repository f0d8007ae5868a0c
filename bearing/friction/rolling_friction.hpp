// Friction of a bearing at pure rolling, by the contact laws of the motion in time: what a run at rest can
// say of it in a millisecond. Loads are those of the balance; cage and rolling elements turn at kinematic
// speed.
//
//   rollers   rolling    sum over contacts 2 F u, F of contact/friction.hpp (Reynolds' equation, isothermal,
//                        flooded), u the rolling speed; on the outer race under Q_i + m r w_c^2
//             drag       of the orbit and of the spin in an oil-air mixture at rest, 5 % of oil
//   balls     rolling    sum over contacts M u/R_x, M the couple of [Houpert1987]
//             differential slip and spin: the ellipse of contact slides as a whole such that no force along
//             is
//                        left, and oil is sheared by [JohnsonTevaarwerk1977]
//             drag       of balls, cage and the walls of the rings, the mixture carried round
//
// Left out: the sliding that carries rolling resistance and drag (a thousandth of the load), pockets and land
// of the cage, heating of the oil at the inlet, starvation.
#pragma once

#include <Eigen/Core>

#include "bearing/equilibrium/ball_motion.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing::friction {

/// Power lost by cause [W].
struct RollingFriction {
  double rolling = 0.0;
  double idle = 0.0;  // of it: of elements outside the load zone, on the outer race under inertia
  double differential_slip = 0.0;  // because ellipses of contact are curved; of balls
  double spin = 0.0;               // of balls
  double drag = 0.0;

  double total() const { return rolling + differential_slip + spin + drag; }
};

/// Rings turn at `speeds` in a housing. `inner_load` [N] (rollers).
RollingFriction roller_friction(const Bearing& bearing, const Eigen::Ref<const Eigen::ArrayXd>& inner_load,
                                const equilibrium::RingSpeeds& speeds, const Lubricant& oil);

/// `balance` is that of balls that turn; `load` that on the inner ring. The bearing states its cage and the
/// width of its rings, on which the drag depends.
RollingFriction ball_friction(const Bearing& bearing, const equilibrium::RingState& balance,
                              const equilibrium::RingLoad& load, const equilibrium::RingSpeeds& speeds,
                              const Lubricant& oil);

}  // namespace orbearing::bearing::friction
