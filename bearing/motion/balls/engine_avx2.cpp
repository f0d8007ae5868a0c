// The engine for one instruction set: the same source as the others, compiled with their own options.
#include "mechanics/packs/instruction_set.hpp"

#ifdef ORBEARING_HAS_AVX2
#define ORBEARING_PACKS packs_avx2
#include "bearing/motion/balls/pack_stage.hpp"

namespace orbearing::bearing::balls {

Engine* avx2_engine(const BallNumbers& numbers) {
  return new packs_avx2::PackEngine(numbers);
}

}  // namespace orbearing::bearing::balls

#endif
