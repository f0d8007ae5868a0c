// Oil and air between the rings, which go round as a whole with one speed: balls, cage and a turning ring
// drag them along, a standing ring holds them back, and oil that flows through has to be brought to that
// speed.
//
//     (7)  Z k (w_c - w)|w_c - w| r_m^3 + k_c (w_c - w)|w_c - w| + W_i(w_i - w) + W_o(w_o - w) = m' r_m^2 w
//     (8)  W(d) = 2 pi r^2 b rho C(Re) u |u|,  u = r d,  Re = 2 |u| t/nu
//
// Z balls of drag k u|u| on the pitch radius r_m, cage of moment k_c, throughput m' of oil that enters
// without swirl; walls of radius r and width b, t apart. C is half of the friction of one wall: between
// cylinders of which the inner one turns, what is in the middle goes at half its speed, so each wall bears
// the shear of the whole gap at twice its own u. Density of the mixture; kinematic viscosity of the oil,
// which carries its mass and its shear.
#pragma once

#include "bearing/motion/balls/numbers.hpp"

namespace orbearing::bearing::balls {

/// Share [-] of oil in the free volume of a bearing of `pitch_diameter` [m] through which `flow` [m^3/s]
/// passes, its rings at `speed` [rad/s] against each other: 1e5 W^0.37/(n d_m^1.7), W in cm^3/min, n in
/// rpm, d_m in mm [Parker1984]; of angular-contact balls of 35 and 120 mm bore with jets or oil through
/// the inner ring. At most 1; 1 at rest.
double filled_share(double flow, double pitch_diameter, double speed);

/// Torque [N m] over 1/2 pi rho w^2 R^4 b of a cylinder that turns in a standing one a gap t away, over
/// (t/R)^0.3, at the Reynolds number w R t/nu > 0 [BilgenBoulos1973]. The largest of its four regimes, each
/// of which is that where it holds, so that nothing jumps.
double cylinder_friction(double reynolds);

/// Torque of a ring's wall on the mixture that lags behind it by `difference` [rad/s]. [N m]
double wall_torque(const MixtureNumbers& mixture, double radius, double difference);

/// Speed of the mixture [rad/s] where ring speeds are given and balls go with the cage at pure rolling: the
/// root of Eq. (7), which there is but one of.
double mixture_speed(const MixtureNumbers& mixture, double inner_speed, double outer_speed);

/// `drag` where the mixture goes round as it does at these speeds of the rings [rad/s]: its share of the
/// cage's speed at pure rolling, at most 1 and at least 0, and coefficients of what balls and cage then have
/// to go through.
DragNumbers carried_drag(const DragNumbers& drag, double inner_speed, double outer_speed);

/// Losses of rotating rings at the walls: torque [N m] of the drive of each.
struct WallTorques {
  double inner = 0.0;
  double outer = 0.0;
};

/// At any speeds of the rings [rad/s], the mixture at its share of the cage's.
WallTorques wall_torques(const MixtureNumbers& mixture, double inner_speed, double outer_speed);

}  // namespace orbearing::bearing::balls
