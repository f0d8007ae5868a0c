// The solver of level rollers on laminae for one instruction set, without fused operations: the same bits as
// the others.
#define ORBEARING_PACKS packs_baseline_level
#include "bearing/equilibrium/equilibrium_engine.hpp"
#include "bearing/equilibrium/level_contacts.hpp"

namespace orbearing::bearing::vectorised {

EquilibriumEngine* baseline_level_equilibrium(const EquilibriumConstants& constants) {
  return new packs_baseline_level::PackEquilibrium<packs_baseline_level::LevelContacts>(constants);
}

}  // namespace orbearing::bearing::vectorised
