// Makers of engines for each instruction set; each stands in its own file with its own compiler options.
#pragma once

#include "bearing/motion/vectorised/engine.hpp"

namespace orbearing::bearing::vectorised {

Engine* baseline_engine(const Constants& constants, const RollerConstants& rollers);
Engine* avx2_engine(const Constants& constants, const RollerConstants& rollers);
Engine* avx512_engine(const Constants& constants, const RollerConstants& rollers);

}  // namespace orbearing::bearing::vectorised
