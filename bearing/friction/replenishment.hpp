// Ends of the inlets of rollers, by their oil balance. A roller meets more oil than it lets through: its film
// is what the roller before left. The oil that the mixture returned to both surfaces meanwhile, a layer of
// thickness s, accumulates before the contact until as much leaves past both ends of the roller.
//
//   (1)  s u l = 2 c u X^3/R                    X = (s R l/(2 c))^(1/3)
//   (2)  s = sum of both surfaces of  (share) tau/(rho u') t
//
// u rolling speed, l length, R equivalent radius, X distance from the contact to where the oil begins.
//
// (1) is Reynolds' equation in oil of one viscosity at gaps x^2/(2 R), far beyond the film, with no pressure
// at x = X and past the end. Far from the end p = 16 eta u R^2 (1/x^3 - 1/X^3). Within about X of it the
// difference is a series of x^(-5/2) J_5/2(k x/X) exp(-k y/X), J_5/2(k) = 0, and what leaves there is
//
//   c = sum of 2 b/(k^2 J_7/2(k)),  b = (2/pi)^(1/2) k^(1/2)/3 + J_7/2(k)/k;   c = 0.0932
//
// (2) is Reynolds' analogy: mixture that gives a wall its momentum, shear stress tau at a difference of speed
// u', brings its oil along. tau is that of the drag: walls of Eq. (8) in motion/balls/mixture.hpp, rollers by
// the coefficient of their churning. t is the time since the last contact: the passage of two rollers on a
// race, half a turn of a roller. All oil that arrives stays; none comes back along the race from the ends.
#pragma once

#include "bearing/equilibrium/ball_motion.hpp"
#include "bearing/geometry.hpp"
#include "bearing/motion/balls/numbers.hpp"

namespace orbearing::bearing::friction {

/// c of Eq. (1) [-].
inline constexpr double kEndFlow = 0.0932;

/// X [m] of Eq. (1), `returned` [m] being s.
double inlet_length(double equivalent_radius, double roller_length, double returned);

/// s [m] of Eq. (2) before the contacts of a race, the rings at `speeds`: `share` [-] of oil in a mixture
/// that is carried round with the drag `drag`.
double returned_oil(const Bearing& bearing, const BearingGeometry& geometry, Race race,
                    const equilibrium::RingSpeeds& speeds, const balls::DragNumbers& drag, double share);

}  // namespace orbearing::bearing::friction
