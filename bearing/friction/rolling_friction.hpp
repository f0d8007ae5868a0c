// Friction of a bearing at pure rolling, by the contact laws of the motion in time: what a run at rest can
// say of it in a millisecond. Loads are those of static equilibrium; cage and rolling elements turn at
// kinematic speed.
//
//   rollers   rolling    sum over contacts 2 F u, F of contact/friction.hpp (Reynolds' equation, flooded), u
//   the
//                        rolling speed; on the outer race under Q_i + m r w_c^2
//             drag       of rollers, cage and the walls of the rings in a mixture of 5 % of oil that is
//             carried
//                        round (motion/balls/mixture.hpp); the spin of rollers
//   balls     rolling    sum over contacts M u/R_x, M the couple of contact/point_rolling.hpp (Reynolds'
//   equation)
//             differential slip and spin: the ellipse of contact slides as a whole such that no force along
//             is
//                        left, and oil is sheared by [JohnsonTevaarwerk1977]
//             drag       of balls, cage and the walls of the rings, the mixture carried round
//
// Shear warms the inlets where the oil states the slope of its viscosity (contact/inlet_heating.hpp). Inlets
// of rollers end where the oil ends: at the gap of two layers of the thickness that all oil of the mixture
// has, spread evenly over races, rollers and cage, or where the oil that returns between two rollers piles up
// (replenishment.hpp). A light contact is still affected by oil at a hundred times its film:
//
//   F = F_0 exp(-12 eta u R l/(X F_0)),  X = sqrt(2 R 2 t),  t = share * free volume/wetted surface
//
// The exponent is the pressure that the far inlet adds (Reynolds' equation of parabolas). The exponential is
// that of rigid cylinders within 12 % down to a third of F_0, as computed by quadrature (a test).
//
// Left out: the sliding that carries rolling resistance and drag (a thousandth of the load), pockets and land
// of the cage, elastic hysteresis.
#pragma once

#include <Eigen/Core>

#include "bearing/equilibrium/ball_motion.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/motion/parameters.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing::friction {

/// Power lost by cause [W].
struct RollingFriction {
  double rolling = 0.0;
  double flooded_rolling = 0.0;     // the same if inlets had no end
  double isothermal_rolling = 0.0;  // and were not heated
  double regression_rolling = 0.0;  // of rollers: as `rolling`, by the regression of motion::RollingLaw
  double idle = 0.0;  // of it: of elements outside the load zone, on the outer race under inertia
  double differential_slip = 0.0;  // because ellipses of contact are curved; of balls
  double spin = 0.0;               // of balls
  double drag = 0.0;

  double total() const { return rolling + differential_slip + spin + drag; }
  RollingFriction& operator+=(const RollingFriction& other);
  RollingFriction& operator*=(double factor);
};

/// Beginning of the oil before a contact of rollers.
enum class InletEnd {
  none,         // anywhere
  layer,        // at the layer of all oil of the mixture, oil_layer()
  replenished,  // where as much leaves as returns, replenishment.hpp
};

/// Deviations from isothermal oil without end.
struct Inlets {
  double viscosity_slope = 0.0;   // [1/K]  by which the viscosity falls; 0: isothermal
  InletEnd end = InletEnd::none;  // of rollers
  double starvation = 1.0;        // [-]  of the rolling resistance of rollers that a formula leaves
};

/// Oil and air round the rollers.
struct RollerMixture {
  double oil_share = motion::OilDragParameters{}.oil_share;  // [-]
  double flow = 0.0;                                         // [m^3/s]  of oil, brought to its speed
};

/// Thickness [m] of the oil of a mixture with `share` [-] of it, spread evenly over all that it wets.
double oil_layer(const Bearing& bearing, double share);

/// Share [-] of the flooded resistance of a line contact, `far` [-] being what the inlet beyond its end adds,
/// 12 eta u R l/(X F_0).
double ended_inlet_share(double far);

/// Rings turn at `speeds` in a housing. `inner_load` [N] (rollers).
RollingFriction roller_friction(const Bearing& bearing, const Eigen::Ref<const Eigen::ArrayXd>& inner_load,
                                const equilibrium::RingSpeeds& speeds, const Lubricant& oil,
                                const Inlets& inlets = {}, const RollerMixture& mixture = {});

/// `balance` is that of balls that turn; `load` that on the inner ring. The bearing states its cage and the
/// width of its rings, on which the drag depends.
RollingFriction ball_friction(const Bearing& bearing, const equilibrium::RingState& balance,
                              const equilibrium::RingLoad& load, const equilibrium::RingSpeeds& speeds,
                              const Lubricant& oil, const Inlets& inlets = {});

}  // namespace orbearing::bearing::friction
