// The solver of level rollers on laminae for one instruction set, without fused operations: the same bits as
// the others.
#include "mechanics/packs/instruction_set.hpp"

#ifdef ORBEARING_HAS_AVX512
#define ORBEARING_PACKS packs_avx512_level
#include "bearing/equilibrium/level_packs.hpp"

namespace orbearing::bearing::vectorised {

LevelEngine* avx512_level_engine(const LevelConstants& constants) {
  return new packs_avx512_level::PackEquilibrium(constants);
}

}  // namespace orbearing::bearing::vectorised

#endif
