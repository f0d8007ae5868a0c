// The lamina kernel for one instruction set: the same source as the others, compiled with its own options.
#include "mechanics/packs/instruction_set.hpp"

#ifdef ORBEARING_HAS_AVX2
#define ORBEARING_PACKS packs_avx2
#include "bearing/contact/lamina_kernel.hpp"
#include "bearing/contact/lamina_packs.hpp"

namespace orbearing::bearing::vectorised {

const LaminaKernel& avx2_laminae() {
  return packs_avx2::kLaminaKernel;
}

}  // namespace orbearing::bearing::vectorised

#endif
