// Characteristic values of a pressure along the roller: peaks, edges, loads of laminae.
#pragma once

#include "bearing/pressure/contact.hpp"

namespace orbearing::bearing::half_space {

/// Length over which a peak is a mean, as a share of the roller's: a sharp corner's pressure has no other
/// value.
inline constexpr double kGauge = 0.01;

/// The ends, as a share of the roller's length each.
inline constexpr double kEnd = 0.1;

/// Greatest mean [Pa] of `pressure` over kGauge of the length, within `begin` to `end` [m].
double greatest_mean(const LengthGrid& grid, const Eigen::ArrayXd& pressure, double begin, double end);

/// Fills peak, edge pressure and ratio, and the greatest element from the pressure along the middle; load and
/// moment from the line load.
void measure(const LengthGrid& grid, RollerContactPressure& solution);

/// Load [N] of each of `laminae` equal parts of the length.
Eigen::ArrayXd lamina_loads(const RollerContactPressure& solution, int laminae);

/// Hertz's half-width [m] where the load is: its mean over the length, weighted by the line load; 0 without load.
double mean_half_width(const RollerContactPressure& solution);

/// Pressure [Pa] by which each of `laminae` equal parts of the length fatigues, Eqs. (5) and (6) of the README:
/// the mean of ninth powers, over the part, of the pressure along the middle averaged over one half-width. The
/// damage of a straight roller with sharp ends has a limit by them, and does not depend on `laminae`.
Eigen::ArrayXd fatigue_pressures(const RollerContactPressure& solution, int laminae);

}  // namespace orbearing::bearing::half_space
