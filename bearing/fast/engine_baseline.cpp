// The engine for one instruction set: the same source as the others, compiled with its own options.
#define ORBEARING_LANES lanes_baseline
#include "bearing/fast/engines.hpp"
#include "bearing/fast/lane_solve.hpp"

namespace orbearing::bearing::fast {

Engine* baseline_engine(const Constants& constants, const RollerConstants& rollers) {
  return new lanes_baseline::LaneEngine(constants, rollers);
}

}  // namespace orbearing::bearing::fast
