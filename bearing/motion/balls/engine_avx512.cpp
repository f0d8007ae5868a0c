// The engine for one instruction set: the same source as the others, compiled with their own options.
#include "mechanics/packs/instruction_set.hpp"

#ifdef ORBEARING_HAS_AVX512
#define ORBEARING_PACKS packs_avx512
#include "bearing/motion/balls/pack_stage.hpp"

namespace orbearing::bearing::balls {

Engine* avx512_engine(const BallNumbers& numbers) {
  return new packs_avx512::PackEngine(numbers);
}

}  // namespace orbearing::bearing::balls

#endif
