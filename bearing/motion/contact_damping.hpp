// Damping of a contact in proportion to its load, after Hunt and Crossley: nothing at first touch, never a
// pull.
#pragma once

#include <algorithm>

namespace orbearing::bearing::dynamics {

/// Load of a contact with its damping, and the power it loses.
struct DampedLoad {
  double load = 0.0;   // [N]  >= 0
  double power = 0.0;  // [W]  dissipated, >= 0
};

/// `elastic_load` [N] >= 0 grows by the share `damping` [s/m] per m/s of `approach_speed` [m/s] (positive
/// where the bodies come closer) [HuntCrossley1975], and is cut at zero.
inline DampedLoad damped_load(double elastic_load, double damping, double approach_speed) {
  const double load = elastic_load * std::max(0.0, 1.0 + damping * approach_speed);
  return {load, (load - elastic_load) * approach_speed};
}

}  // namespace orbearing::bearing::dynamics
