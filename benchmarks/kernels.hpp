// Small kernels, timed by Google Benchmark: medians of CPU time.
#pragma once

#include <map>

#include "coupling/analysis/drivetrain.hpp"

namespace orbearing::bench {

/// Times of single calls [ns] at 6000 rpm and zero clearance.
struct KernelTimes {
  double frozen_rhs = 0.0;  // plain equations of commit d33b5f5
  double rhs = 0.0;         // vectorised
  double jacobian = 0.0;    // vectorised, with the Jacobian
  double factor = 0.0;      // of 1 - g J
  double solve = 0.0;       // with the factors
  double step = 0.0;        // all of a step of the stepper
  double exponent = 0.0;    // of the step's cost over the number of rollers, fitted to 15, 30, 60, 120
  std::map<int, double> step_by_rollers;  // the same four
  double plain_static = 0.0;              // a quasi-static point, one cage angle, readable
  double fast_static = 0.0;   // the same as sweeps compute it, all angles of a pitch at once, one core
  double lamina = 0.0;        // one lamina of one contact of 40, with load, moment and their slopes
  double lamina_point = 0.0;  // a quasi-static point of 40 laminae with tilt, all cage angles
};

KernelTimes time_kernels(const analysis::PlanetaryDrivetrain& drivetrain);

}  // namespace orbearing::bench
