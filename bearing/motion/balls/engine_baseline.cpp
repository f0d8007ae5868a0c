// The engine for one instruction set: the same source as the others, compiled with their own options.
#define ORBEARING_PACKS packs_baseline
#include "bearing/motion/balls/pack_stage.hpp"

namespace orbearing::bearing::balls {

Engine* baseline_engine(const BallNumbers& numbers) {
  return new packs_baseline::PackEngine(numbers);
}

}  // namespace orbearing::bearing::balls
