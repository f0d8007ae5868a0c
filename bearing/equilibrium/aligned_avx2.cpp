// The solver of level rollers on laminae for one instruction set, without fused operations: the same bits as
// the others.
#include "mechanics/packs/instruction_set.hpp"

#ifdef ORBEARING_HAS_AVX2
#define ORBEARING_PACKS packs_avx2_aligned
#include "bearing/equilibrium/aligned_packs.hpp"

namespace orbearing::bearing::vectorised {

AlignedEngine* avx2_aligned_engine(const AlignedConstants& constants) {
  return new packs_avx2_aligned::PackEquilibrium(constants);
}

}  // namespace orbearing::bearing::vectorised

#endif
