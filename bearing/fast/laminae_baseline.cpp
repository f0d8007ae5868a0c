// The lamina kernel for one instruction set: the same source as the others, compiled with its own options.
#define ORBEARING_LANES lanes_baseline
#include "bearing/fast/lamina_kernel.hpp"
#include "bearing/fast/lane_laminae.hpp"

namespace orbearing::bearing::fast {

const LaminaKernel& baseline_laminae() {
  return lanes_baseline::kLaminaKernel;
}

}  // namespace orbearing::bearing::fast
