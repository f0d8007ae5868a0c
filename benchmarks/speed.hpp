// Ratios of time between integrators, and of simulated to computing time.
#pragma once

#include <vector>

#include "benchmarks/accuracy.hpp"

namespace orbearing::bench {

/// Where the middle half of some values lies.
struct Quartiles {
  double lower = 0.0, median = 0.0, upper = 0.0;
};
/// By linear interpolation between the ordered values, of which there is at least one.
Quartiles quartiles(std::vector<double> values);

/// How many times faster the fast path is than `method` at its tolerance: over pairs of runs taken in turn, CPU
/// time of this thread.
Quartiles speedup(Trial& trial, Method method, double tolerance);

/// Simulated over computing time: the fast path, loads watched, over at least one cage revolution from the
/// settled state; median of three.
double real_time(const Duty& duty);

/// Wall time [s] of twelve speeds, 0.13 s simulated each from the quasi-static state, on two threads; median
/// of five.
double sweep_seconds(const study::PlanetaryDrivetrain& drivetrain, double clearance);

double median(std::vector<double> values);

}  // namespace orbearing::bench
