// The engine of engine_avx512.cpp in packs of half the length, for as few balls as one of them holds.
#include "mechanics/packs/instruction_set.hpp"

#ifdef ORBEARING_HAS_AVX512
#define ORBEARING_PACKS packs_short_avx512
#define ORBEARING_REGISTER_LANES 4
#include "bearing/motion/balls/pack_stage.hpp"

namespace orbearing::bearing::balls {

Engine* short_avx512_engine(const BallNumbers& numbers) {
  return new packs_short_avx512::PackEngine(numbers);
}

}  // namespace orbearing::bearing::balls

#endif
