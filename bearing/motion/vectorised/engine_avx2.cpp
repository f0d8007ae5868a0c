// The engine for one instruction set: the same source as the others, compiled with their own options.
#include "mechanics/packs/instruction_set.hpp"

#ifdef ORBEARING_HAS_AVX2
#define ORBEARING_PACKS packs_avx2
#include "bearing/motion/vectorised/engine.hpp"
#include "bearing/motion/vectorised/pack_solve.hpp"

namespace orbearing::bearing::vectorised {

Engine* avx2_engine(const Constants& constants, const RollerConstants& rollers) {
  return new packs_avx2::PackEngine(constants, rollers);
}

}  // namespace orbearing::bearing::vectorised

#endif
