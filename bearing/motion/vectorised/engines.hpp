// Makers of engines for each instruction set; each stands in its own file with its own compiler options.
#pragma once

#include "bearing/motion/vectorised/engine.hpp"

namespace orbearing::bearing::vectorised {

Engine* baseline_engine(const Constants& constants, const RollerConstants& rollers);
#if defined(__x86_64__) && !defined(_WIN32)
Engine* avx2_engine(const Constants& constants, const RollerConstants& rollers);
Engine* avx512_engine(const Constants& constants, const RollerConstants& rollers);
#endif

}  // namespace orbearing::bearing::vectorised
