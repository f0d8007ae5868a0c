// Lag of cage and rollers behind pure rolling, or lead: drag of the oil, rolling resistance and the guidance
// of the cage against the traction of the loaded rollers.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "bearing/motion/model.hpp"

namespace orbearing::bearing::motion {

/// Loads at rest of a roller at evenly spaced positions of its orbit, the first of them on the x axis.
struct LoadsOfOrbit {
  Eigen::ArrayXd inner;  // [N]  (positions)
  Eigen::ArrayXd outer;  // [N]  (positions)
};

/// Force [N] on the pitch circle against the orbit at the orbital speed `speed` [rad/s]: drag of all rollers
/// and of the cage, and what the land does to a cage that is centred in it (negative where the land drives).
double resistance_to_orbit(const BearingModel& model, double speed);

/// Resistance to the orbit at pure rolling over the largest traction of the loaded rollers, 2 mu sum(Q) with
/// Q the smaller of a roller's loads at both races. Above 1 they cannot hold pure rolling.
double drag_over_traction(const BearingModel& model, const LoadsOfOrbit& loads);

/// Slip [-] of the cage, 1 - speed / speed at pure rolling, at which no mean moment is left on it. A roller
/// follows its pocket once around the orbit under its loads at rest:
///
///   orbital speed   w_r = w (1 - c n / r_m),  c the cage's centre, n the direction to the roller
///   spin            I dspin/dt = moments of traction, rolling resistance, churning and friction at the bar
///   on the bar      N = traction and rolling resistance of both races - drag - inertia in the carrier's
///   field outer load      that at rest + m r_m (w_r^2 - w_k^2 + 2 W (w_r - w_k)),  w_k at pure rolling
///
/// The cage is where the film of its land, and touch-down, hold the forces of all bars and its weight in the
/// carrier's field; drag, the shear of the land and the bars give the moment. Left out: clearance of the
/// pockets, and loads that vary by vibration or impacts. Requires a cage and traction of the surfaces.
/// Docs: docs/slip_and_branches.md, with its error.
std::optional<double> drag_slip(const BearingModel& model, const LoadsOfOrbit& loads);

}  // namespace orbearing::bearing::motion
