// Ratios of time between integrators, and of simulated to computing time.
#pragma once

#include "benchmarks/accuracy.hpp"
#include "benchmarks/quartiles.hpp"

namespace orbearing::bench {

/// Ratio of speeds: the fast path in `trial` over `method` at its tolerance in `theirs`, which leaves
/// out effects that the equations of that method do not include: over pairs of runs taken in turn, CPU time
/// of this thread.
Quartiles speedup(Trial& trial, Trial& theirs, Method method, double tolerance);

/// Simulated over computing time: the fast path, loads watched, over at least one cage revolution from the
/// settled state; median of three.
double real_time(const Duty& duty);

/// Wall time [s] of twelve speeds, 0.13 s simulated each from the quasi-static state, on two threads; median
/// of five.
double sweep_seconds(const analysis::PlanetaryDrivetrain& drivetrain, double clearance);

}  // namespace orbearing::bench
