// Forces and accelerations of all planets at one instant.
#pragma once

#include "gearset/dynamics/equations.hpp"

namespace orbearing::gearset::dynamics {

/// One entry or column a planet.
struct SetSnapshot {
  Eigen::ArrayXd sun_mesh_force;   // [N]  along the line of action; negative on the back flank
  Eigen::ArrayXd ring_mesh_force;  // [N]
  Eigen::Array2Xd bearing_force;   // [N]      of its bearing on the planet, outward and tangential
  Eigen::Array2Xd acceleration;    // [m/s^2]  of the planet in the carrier's frame
  Eigen::Array2Xd in_housing;      // [m/s^2]  of the planet in the housing, along the same axes
  bool separated = false;          // some loaded flank has parted
};

/// Fills `out`, which keeps its memory from call to call. `dx` is a workspace of the state's size.
void take_snapshot(const PlanetarySetEquations& equations, double time,
                   const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::VectorXd& dx, SetSnapshot& out);

}  // namespace orbearing::gearset::dynamics
