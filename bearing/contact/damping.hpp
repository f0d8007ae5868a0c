// Damping of a contact in proportion to its load, after Hunt and Crossley: nothing at first touch, never a
// pull. For plain numbers, packs and both with their slopes. No header of a library here: files compiled for
// special instruction sets include it.
#pragma once

#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing {

/// By what an elastic load grows at `approach_speed` [m/s], positive where the bodies come closer: the share
/// `damping` [s/m] per m/s, cut at zero [HuntCrossley1975].
template <class Damping, class Speed>
auto damping_factor(const Damping& damping, const Speed& approach_speed) {
  using mechanics::larger, mechanics::value_of;
  const auto grown = 1.0 + approach_speed * damping;
  return larger(grown, mechanics::Plain<decltype(value_of(grown))>{});
}

/// Load of a contact with its damping, and the power it loses.
template <class Load, class Power>
struct DampedLoad {
  Load load;    // [N]  >= 0
  Power power;  // [W]  dissipated, >= 0
};

/// `elastic_load` [N] >= 0 with its damping.
template <class Load, class Damping, class Speed>
auto damped_load(const Load& elastic_load, const Damping& damping, const Speed& approach_speed) {
  const auto load = elastic_load * damping_factor(damping, approach_speed);
  const auto power = (load - elastic_load) * approach_speed;
  return DampedLoad<decltype(elastic_load * damping_factor(damping, approach_speed)),
                    decltype((load - elastic_load) * approach_speed)>{load, power};
}

}  // namespace orbearing::bearing
