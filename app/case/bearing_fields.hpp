// Defaults of a drivetrain and of its gears where a case states nothing: members of these structs hold the
// defaults of the fields.
#pragma once

#include "coupling/analysis/drivetrain.hpp"
#include "coupling/analysis/gear_model.hpp"

namespace orbearing::app {

inline analysis::PlanetaryDrivetrain default_drivetrain() {
  analysis::PlanetaryDrivetrain drivetrain;
  drivetrain.steady_state.observed_windows = 10;
  drivetrain.steady_state.integration.method = integration::Method::linearly_implicit;
  return drivetrain;
}

inline analysis::GearDynamicsChoice default_gears() {
  analysis::GearDynamicsChoice gears;
  gears.sun.support_stiffness = 1e8;
  gears.ring.support_stiffness = 1e9;
  gears.carrier.support_stiffness = 5e8;
  gears.bearing_stiffness = 3e8;
  gears.mesh_damping_ratio = 0.07;
  gears.bearing_damping_ratio = 0.05;
  gears.support_damping_ratio = 0.05;
  gears.backlash = 0.1e-3;
  return gears;
}

}  // namespace orbearing::app
