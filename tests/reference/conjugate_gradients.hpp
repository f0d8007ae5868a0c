// Pressures >= 0 that close the gap wherever they act: conjugate gradients with a moving set of loaded
// elements.
#pragma once

#include <Eigen/Dense>

#include "tests/reference/rectangle_influence.hpp"

namespace orbearing::bearing::half_space {

/// Problem and state of the iteration of [PolonskyKeer1999]. Arrays (elements, rows).
struct ConjugateGradients {
  RectangleInfluence influence;
  double compliance = 0.0;  // [1/Pa]  1/(pi E*)
  Eigen::ArrayXXd area;     // [m^2]   of one element
  Eigen::ArrayXd count;     // [-]     elements that a row's one represents
  Eigen::ArrayXXd gap;      // [m]     of the undeformed bodies at approach zero
  double load = 0.0;        // [N]     0: the approach is given instead

  Eigen::ArrayXXd pressure;  // [Pa]   start and solution
  double approach = 0.0;     // [m]    given, or part of the solution
  double energy = 0.0;       // [J]    strain energy of the solution
  double residual = 0.0;     // [-]    see solve
  int iterations = 0;        // [-]

  /// Iterates until the rms distance of loaded surfaces and the overlap of unloaded ones are below
  /// `tolerance` of the greatest displacement. Throws std::runtime_error after `most_iterations`.
  void solve(double tolerance, int most_iterations);
};

}  // namespace orbearing::bearing::half_space
