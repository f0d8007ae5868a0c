// The solver of a block of equilibria for one instruction set: the same source as the others, compiled with
// its own options.
#define ORBEARING_PACKS packs_baseline
#include "bearing/equilibrium/equilibrium_engine.hpp"
#include "bearing/equilibrium/equilibrium_packs.hpp"

namespace orbearing::bearing::vectorised {

EquilibriumEngine* baseline_equilibrium(const EquilibriumConstants& constants) {
  return new packs_baseline::PackEquilibrium<packs_baseline::WholeContacts>(constants);
}

}  // namespace orbearing::bearing::vectorised
