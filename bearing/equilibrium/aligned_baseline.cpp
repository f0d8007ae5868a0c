// The solver of level rollers on laminae for one instruction set, without fused operations: the same bits as
// the others.
#define ORBEARING_PACKS packs_baseline_aligned
#include "bearing/equilibrium/aligned_packs.hpp"

namespace orbearing::bearing::vectorised {

AlignedEngine* baseline_aligned_engine(const AlignedConstants& constants) {
  return new packs_baseline_aligned::PackEquilibrium(constants);
}

}  // namespace orbearing::bearing::vectorised
