// Energy that the set holds, and the powers that change it.
#pragma once

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// Energy in the frame of the carrier.
struct Energy {
  double kinetic = 0.0;      // [J]  of the motion relative to the nominal rotation
  double meshes = 0.0;       // [J]
  double bearings = 0.0;     // [J]  of the planets
  double supports = 0.0;     // [J]
  double centrifugal = 0.0;  // [J]  potential; zero where every body is in its nominal position

  double stored() const { return meshes + bearings + supports + centrifugal; }
  double total() const { return kinetic + stored(); }
};

/// Energy at `time` [s], without that of coupled bearings.
Energy energy(const SetModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x);

/// Powers that change the energy; between jumps of the stiffness d energy / dt = input() - loss(). At a jump
/// the stored energy itself jumps by 1/2 [k] approach^2.
struct PowerFlow {
  double drive = 0.0;      // [W]  driving and load torques, beyond those of the nominal rotation
  double stiffness = 0.0;  // [W]  of the change of stiffness, 1/2 k' approach^2, or of turning loaded teeth
  double error = 0.0;      // [W]  of moving the flanks: - force x error rate
  double frame = 0.0;      // [W]  of turning the frame: Euler terms, rates of the centrifugal potential,
                           //      dampers of the housing
  double mesh_loss = 0.0;  // [W]  dampers
  double bearing_loss = 0.0;  // [W]
  double support_loss = 0.0;  // [W]

  double input() const { return drive + stiffness + error + frame; }
  double loss() const { return mesh_loss + bearing_loss + support_loss; }
};

PowerFlow power_flow(const SetModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x);

}  // namespace orbearing::gearset::dynamics
