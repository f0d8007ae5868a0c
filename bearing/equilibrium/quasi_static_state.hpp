// Static equilibrium of a roller bearing at one cage angle, and the report of its search.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "bearing/equilibrium/tilted_roller.hpp"
#include "mechanics/convex_search.hpp"

namespace orbearing::bearing {

/// Result of the search for the static equilibrium of the ring.
struct SolverReport : mechanics::SearchReport {
  std::string message{};  // empty where converged
};

/// Equilibrium at one cage angle. Arrays are over rollers.
struct QuasiStaticState {
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  // [m]  outer ring relative to inner ring, middle
  Eigen::VectorXd waves;                                   // [m]  of an elastic outer race, elastic_waves.hpp
  Eigen::ArrayXd angle;                                    // [rad]  position of each roller
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();     // [N/m]  of the ring against its displacement
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  // [N m]  of the rollers on the bore, against its tilt
  Eigen::ArrayXd inner_load;                         // [N]
  Eigen::ArrayXd outer_load;                         // [N]
  std::vector<laminae::RollerState> rollers;         // of whole contacts loads and stiffness only
  SolverReport report;
};

}  // namespace orbearing::bearing
