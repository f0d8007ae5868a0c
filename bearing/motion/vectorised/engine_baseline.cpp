// The engine for one instruction set: the same source as the others, compiled with their own options.
#define ORBEARING_PACKS packs_baseline
#include "bearing/motion/vectorised/engine.hpp"
#include "bearing/motion/vectorised/pack_solve.hpp"

namespace orbearing::bearing::vectorised {

Engine* baseline_engine(const Constants& constants, const RollerConstants& rollers) {
  return new packs_baseline::PackEngine(constants, rollers);
}

}  // namespace orbearing::bearing::vectorised
