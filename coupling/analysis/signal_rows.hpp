// Rows of inputs that the signals of a single scratched bearing and of a gear set have in common.
#pragma once

#include "mechanics/described.hpp"

namespace orbearing::analysis {

inline auto sampling_rate_row(double& rate) {
  using namespace described;
  return input(rate, "signal.sampling_rate", "sampling rate of the vibration",
               {.dimension = dimension::frequency,
                .range = {1e-3, 1e5},
                .reason = "a typical rate of instruments, far above the vibration of the ring",
                .numerical = true});
}

inline auto run_up_row(double& from) {
  using namespace described;
  return input(
      from, "signal.run_up_from",
      "speed at the start as a share of the speed, with a linear run-up; spectra are then over orders of the "
      "shaft, in a gear set of the carrier",
      {.range = {.least = 0.05, .most = 1.0}, .reason = "a steady speed"});
}

}  // namespace orbearing::analysis
