// The rungs of the ladder of models.
#pragma once

namespace orbearing::study {

/// How the planet bearing is computed, from rung to rung of the ladder.
enum class Fidelity {
  quasi_static,
  dynamic,       // in time, driven by the gears: one way
  co_simulated,  // gears and all bearings act on each other, each with its own integrator
  monolithic,    // the same as one system of equations
};

}  // namespace orbearing::study
