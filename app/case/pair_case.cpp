#include "app/case/pair_case.hpp"

#include "app/case/described_case.hpp"

namespace orbearing::app {

gearset::GearPair pair_of(const ResolvedCase& resolved) {
  return from_case<gearset::GearPair>(resolved);
}

}  // namespace orbearing::app
