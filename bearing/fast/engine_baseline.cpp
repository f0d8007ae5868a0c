// The engines for one instruction set: the same source as the others, compiled with their own options.
#define ORBEARING_LANES lanes_baseline
#include "bearing/fast/engines.hpp"
#include "bearing/fast/lane_equilibrium.hpp"
#include "bearing/fast/lane_open.hpp"

namespace orbearing::bearing::fast {

Engine* baseline_engine(const Constants& constants, const RollerConstants& rollers) {
  return new lanes_baseline::LaneEngine(constants, rollers);
}

EquilibriumEngine* baseline_equilibrium(const EquilibriumConstants& constants) {
  return new lanes_baseline::LaneEquilibrium(constants);
}

}  // namespace orbearing::bearing::fast
