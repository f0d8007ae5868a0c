// Resistance of the oil at the inlet of a ball's contact to rolling. Written once for plain numbers and
// packs. No header of a library here.
//
//   F = F_1 u^m Q^n (1 + (A/B)^s)^(-1/s):   the force on each surface, of which the couple is 2 R_x F
//
//   regression   F = 2.86 E' R_x^2 k^0.348 G^0.022 U^0.66 W^0.47, without a second power law [Houpert1987]
//   computed     A, B of rigid bodies in oil of one viscosity and of elastic ones in oil that thickens, as
//                Reynolds' equation has them (film/reynolds): docs/reynolds.md
#pragma once

#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing {

/// Powers of speed and load, the blend with the second power law among them.
struct PointRolling {
  double speed = 0.66;       // [-]  m
  double load = 0.47;        // [-]  n
  double blend = 0.0;        // [-]  s; 0: a single power law
  double log_ratio = 0.0;    // [-]  ln (A/B)^s at 1 m/s and 1 N
  double ratio_speed = 0.0;  // [-]
  double ratio_load = 0.0;   // [-]

  /// F over F_1 and over u [s/m], from ln of rolling speed and load.
  template <class LogSpeed, class LogLoad>
  auto per_speed(const LogSpeed& log_speed, const LogLoad& log_load) const {
    using mechanics::exponential, mechanics::logarithm;
    const auto powers = (speed - 1.0) * log_speed + load * log_load;
    if (blend == 0.0) return exponential(powers);
    const auto ratio = exponential(ratio_speed * log_speed + ratio_load * log_load + log_ratio);
    return exponential(powers - (1.0 / blend) * logarithm(1.0 + ratio));
  }
};

}  // namespace orbearing::bearing
