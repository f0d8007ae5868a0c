// How schemes of exchange between gears and bearings converge to the system solved as one.
#pragma once

#include <string>
#include <vector>

#include "coupling/study/drivetrain.hpp"

namespace orbearing::study {

/// A way to exchange, and the order with which its error shall fall where all is smooth.
struct Scheme {
  std::string name;
  cosim::CoupledOptions options;  // but for the window
  int expected_order = 1;         // [-]  of the error in the length of the window
};

/// Jacobi and Gauss-Seidel with extrapolation of degree 0, 1 and 2, and windows repeated until both sides
/// agree.
std::vector<Scheme> common_schemes();

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
  double stability_limit =
      0.0;  // [s]  shortest window at which explicit exchange (Jacobi, degree 0) ran away
};

struct ConvergenceOptions {
  double longest_window = 4e-5;         // [s]
  int halvings = 4;                     // windows from the longest one down
  long longest_windows = 8;             // whose length is the path; rollers are chaotic beyond 0.5 ms
  double allowed_length_error = 2e-13;  // [m]  of a step of a bearing, so that what is seen is the exchange's
  double allowed_share = 1e-8;          // [-]  of the gears
  double reference_length_error = 5e-14;  // [m]  of the system solved as one
  double shortest_limit = 1e-5;  // [s]  windows tried for stability, each by a sixth longer than the last
  double longest_limit = 1e-4;   // [s]
  double stability_path = 2e-3;  // [s]  in which an unstable exchange shall have run away
};

/// The drivetrain at its power and speed, from the balance of gears and bearings. Compared are the forces on
/// all planets at multiples of the longest window. @throws std::invalid_argument where it has no gears that
/// can move
SchemeConvergence scheme_convergence(const PlanetaryDrivetrain& drivetrain,
                                     const DrivetrainGeometry& geometry, const std::vector<Scheme>& schemes,
                                     const ConvergenceOptions& options = {});

}  // namespace orbearing::study
