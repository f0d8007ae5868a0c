// Makers of engines for each instruction set; each stands in its own file with its own compiler options.
#pragma once

#include "bearing/fast/engine.hpp"
#include "bearing/fast/equilibrium_engine.hpp"
#include "bearing/fast/lamina_kernel.hpp"

namespace orbearing::bearing::fast {

Engine* baseline_engine(const Constants& constants, const RollerConstants& rollers);
EquilibriumEngine* baseline_equilibrium(const EquilibriumConstants& constants);
const LaminaKernel& baseline_laminae();
#if defined(__x86_64__)
Engine* avx2_engine(const Constants& constants, const RollerConstants& rollers);
EquilibriumEngine* avx2_equilibrium(const EquilibriumConstants& constants);
const LaminaKernel& avx2_laminae();
Engine* avx512_engine(const Constants& constants, const RollerConstants& rollers);
EquilibriumEngine* avx512_equilibrium(const EquilibriumConstants& constants);
const LaminaKernel& avx512_laminae();
#endif

}  // namespace orbearing::bearing::fast
