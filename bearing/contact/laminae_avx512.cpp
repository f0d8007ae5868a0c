// The lamina kernel for one instruction set: the same source as the others, compiled with its own options.
#if defined(__x86_64__) && !defined(_WIN32)
#define ORBEARING_PACKS packs_avx512
#include "bearing/contact/lamina_kernel.hpp"
#include "bearing/contact/lamina_packs.hpp"

namespace orbearing::bearing::vectorised {

const LaminaKernel& avx512_laminae() {
  return packs_avx512::kLaminaKernel;
}

}  // namespace orbearing::bearing::vectorised

#endif
