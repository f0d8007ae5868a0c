// The solver of level rollers on laminae for one instruction set, without fused operations: the same bits as
// the others.
#define ORBEARING_PACKS packs_baseline_level
#include "bearing/equilibrium/level_packs.hpp"

namespace orbearing::bearing::vectorised {

LevelEngine* baseline_level_engine(const LevelConstants& constants) {
  return new packs_baseline_level::PackEquilibrium(constants);
}

}  // namespace orbearing::bearing::vectorised
