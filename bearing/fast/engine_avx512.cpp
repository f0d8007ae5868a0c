// The engines for one instruction set: the same source as the others, compiled with their own options.
#if defined(__x86_64__) && !defined(_WIN32)
#define ORBEARING_LANES lanes_avx512
#include "bearing/fast/engines.hpp"
#include "bearing/fast/lane_equilibrium.hpp"
#include "bearing/fast/lane_open.hpp"

namespace orbearing::bearing::fast {

Engine* avx512_engine(const Constants& constants, const RollerConstants& rollers) {
  return new lanes_avx512::LaneEngine(constants, rollers);
}

EquilibriumEngine* avx512_equilibrium(const EquilibriumConstants& constants) {
  return new lanes_avx512::LaneEquilibrium(constants);
}

}  // namespace orbearing::bearing::fast

#endif
