// The lamina kernel for one instruction set: the same source as the others, compiled with its own options.
#define ORBEARING_PACKS packs_baseline
#include "bearing/contact/lamina_kernel.hpp"
#include "bearing/contact/lamina_packs.hpp"

namespace orbearing::bearing::vectorised {

const LaminaKernel& baseline_laminae() {
  return packs_baseline::kLaminaKernel;
}

}  // namespace orbearing::bearing::vectorised
