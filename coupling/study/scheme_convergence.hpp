// Convergence of schemes of exchange between gears and bearings to the system solved as one.
#pragma once

#include <string>
#include <vector>

#include "coupling/study/drivetrain.hpp"

namespace orbearing::study {

struct SchemeError {
  std::string scheme;
  double window = 0.0;       // [s]
  double force_error = 0.0;  // [-]  rms of all forces on planets over time, over their rms; NaN: unstable
  double energy_residual =
      0.0;  // [-]  sum of |residual| of all windows over the energy that passed the ports
};

struct SchemeOrder {
  std::string scheme;
  int expected = 1;  // [-]
  double measured =
      0.0;  // [-]  slope of the logarithms between the two shortest windows whose error still falls
  double stability_limit =
      0.0;  // [s]  shortest window found at which forces run away; NaN: none up to the longest tried
};

struct SchemeConvergence {
  double path = 0.0;  // [s]  compared
  std::vector<SchemeError> errors;
  std::vector<SchemeOrder> orders;
};

/// Convergence of Jacobi and Gauss-Seidel with extrapolation of degree 0, 1 and 2, and of windows repeated
/// until both sides agree. The drivetrain is at its power and speed and starts from the equilibrium of gears
/// and bearings. The forces on all planets are compared at multiples of the longest window. @throws
/// std::invalid_argument where it has no gears that can move
SchemeConvergence scheme_convergence(const PlanetaryDrivetrain& drivetrain,
                                     const DrivetrainGeometry& geometry);

}  // namespace orbearing::study
