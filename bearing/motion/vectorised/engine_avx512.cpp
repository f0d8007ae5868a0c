// The engine for one instruction set: the same source as the others, compiled with their own options.
#include "mechanics/packs/instruction_set.hpp"

#ifdef ORBEARING_HAS_AVX512
#define ORBEARING_PACKS packs_avx512
#include "bearing/motion/vectorised/engine.hpp"
#include "bearing/motion/vectorised/pack_solve.hpp"

namespace orbearing::bearing::vectorised {

Engine* avx512_engine(const Constants& constants, const RollerConstants& rollers) {
  return new packs_avx512::PackEngine(constants, rollers);
}

}  // namespace orbearing::bearing::vectorised

#endif
