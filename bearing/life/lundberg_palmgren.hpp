// Fatigue life of line contacts by Lundberg and Palmgren, Eqs. (35)-(41) of [Gai2025].
#pragma once

#include <Eigen/Core>

#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// Lives of both races and of the bearing, in revolutions of the turning race relative to the load.
struct BearingLife {
  double inner = 0.0;    // [rev]
  double outer = 0.0;    // [rev]
  double bearing = 0.0;  // [rev]
};

/// Basic dynamic capacity of one roller-race contact [N], Eq. (36) of [Gai2025]. `reduction_factor` is the
/// product lambda nu of ISO/TR 1281-1 (0.83 for cylindrical rollers) [-].
double contact_capacity(const Bearing& bearing, Race race, double reduction_factor);

/// Equivalent roller load [N] of a race: fourth-power mean where it turns relative to the load, power 4.5
/// where it stands, Eqs. (37) and (39) of [Gai2025]. `loads` [N] are taken at places evenly spaced on the
/// race, unloaded ones included.
double equivalent_load(const Eigen::Ref<const Eigen::ArrayXd>& loads, RaceMotion motion);

/// Life of one race [rev], Eqs. (38) and (40) of [Gai2025] with the capacity in the numerator; infinite at no
/// load.
double race_life(double capacity, double equivalent_load);

/// Life of the bearing [rev] from its races, Eq. (41) of [Gai2025] with the minus signs it lost in print.
double combined_life(double inner, double outer);

/// Life of `n` equal bearings, of which none may fail: Weibull's product law with slope 9/8. Any unit.
double system_life(double one_bearing, int n);

/// Both races and the bearing, for roller loads [N] at places evenly spaced on each race.
BearingLife lundberg_palmgren_life(const Bearing& bearing, double reduction_factor,
                                   const Eigen::Ref<const Eigen::ArrayXd>& inner_loads,
                                   const Eigen::Ref<const Eigen::ArrayXd>& outer_loads);

/// Hours from revolutions and the speed of the turning race relative to the load [rad/s]; infinite at rest.
double hours(double revolutions, double speed);

}  // namespace orbearing::bearing
