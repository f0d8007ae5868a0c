// The lamina kernel for one instruction set: the same source as the others, compiled with its own options.
#include "mechanics/packs/instruction_set.hpp"

#ifdef ORBEARING_HAS_AVX512
#define ORBEARING_PACKS packs_avx512
#include "bearing/contact/lamina_kernel.hpp"
#include "bearing/contact/lamina_packs.hpp"

namespace orbearing::bearing::vectorised {

const LaminaKernel& avx512_laminae() {
  return packs_avx512::kLaminaKernel;
}

}  // namespace orbearing::bearing::vectorised

#endif
