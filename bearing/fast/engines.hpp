// Makers of engines for each instruction set; each stands in its own file with its own compiler options.
#pragma once

#include "bearing/fast/engine.hpp"
#include "bearing/fast/equilibrium_engine.hpp"

namespace orbearing::bearing::fast {

Engine* baseline_engine(const Constants& constants, const RollerConstants& rollers);
EquilibriumEngine* baseline_equilibrium(const EquilibriumConstants& constants);
#if defined(__x86_64__) && !defined(_WIN32)
Engine* avx2_engine(const Constants& constants, const RollerConstants& rollers);
EquilibriumEngine* avx2_equilibrium(const EquilibriumConstants& constants);
Engine* avx512_engine(const Constants& constants, const RollerConstants& rollers);
EquilibriumEngine* avx512_equilibrium(const EquilibriumConstants& constants);
#endif

}  // namespace orbearing::bearing::fast
