// The solver of a block of equilibria for one instruction set: the same source as the others, compiled with
// its own options.
#if defined(__x86_64__) && !defined(_WIN32)
#define ORBEARING_PACKS packs_avx2
#include "bearing/equilibrium/equilibrium_engine.hpp"
#include "bearing/equilibrium/equilibrium_packs.hpp"

namespace orbearing::bearing::vectorised {

EquilibriumEngine* avx2_equilibrium(const EquilibriumConstants& constants) {
  return new packs_avx2::PackEquilibrium<packs_avx2::WholeContacts>(constants);
}

}  // namespace orbearing::bearing::vectorised

#endif
