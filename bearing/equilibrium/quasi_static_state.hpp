// The balance of a roller bearing at one cage angle, and how it was found.
#pragma once

#include <Eigen/Core>
#include <string>

#include "mechanics/convex_search.hpp"

namespace orbearing::bearing {

/// How the search for the balance of the ring ended.
struct SolverReport : mechanics::SearchReport {
  std::string message{};  // empty where converged
};

/// Equilibrium at one cage angle. Arrays are over rollers.
struct QuasiStaticState {
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  // [m]  outer ring relative to inner ring
  Eigen::VectorXd waves;      // [m]  of an elastic race, as RingCoordinates has them
  Eigen::ArrayXd angle;       // [rad]  place of each roller
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  // [N/m]  of the ring against its displacement
  Eigen::ArrayXd inner_load;  // [N]
  Eigen::ArrayXd outer_load;  // [N]
  SolverReport report;
};

}  // namespace orbearing::bearing
