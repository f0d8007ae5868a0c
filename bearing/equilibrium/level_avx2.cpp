// The solver of level rollers on laminae for one instruction set, without fused operations: the same bits as
// the others.
#if defined(__x86_64__) && !defined(_WIN32)
#define ORBEARING_PACKS packs_avx2_level
#include "bearing/equilibrium/equilibrium_engine.hpp"
#include "bearing/equilibrium/level_contacts.hpp"

namespace orbearing::bearing::vectorised {

EquilibriumEngine* avx2_level_equilibrium(const EquilibriumConstants& constants) {
  return new packs_avx2_level::PackEquilibrium<packs_avx2_level::LevelContacts>(constants);
}

}  // namespace orbearing::bearing::vectorised

#endif
