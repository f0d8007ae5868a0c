// The balance of a roller bearing at one cage angle, and how it was found.
#pragma once

#include <Eigen/Core>
#include <string>

namespace orbearing::bearing {

/// How the solver ended. Loads of a state that did not converge are those of the last iterate: ask before
/// use.
struct SolverReport {
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;  // [N]  force out of balance on the outer ring
  std::string message;
};

/// Equilibrium at one cage angle. Arrays are over rollers.
struct QuasiStaticState {
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  // [m]  outer ring relative to inner ring
  Eigen::ArrayXd angle;                                    // [rad]  place of each roller
  Eigen::ArrayXd inner_load;                               // [N]
  Eigen::ArrayXd outer_load;                               // [N]
  SolverReport report;
};

}  // namespace orbearing::bearing
