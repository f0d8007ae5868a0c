// The reducer of [Gai2025] with gears and bearings that act on each other, smooth enough for tests of orders:
// mesh stiffness that varies without jumps.
#pragma once

#include <cmath>

#include "coupling/analysis/gear_model.hpp"
#include "coupling/analysis/planet_stiffness.hpp"
#include "coupling/cosim/planetary_coupling.hpp"
#include "gearset/mesh/planetary_meshes.hpp"
#include "tests/reducer.hpp"

namespace orbearing::example {

/// Bodies and meshes of the reducer, as its case states them by default.
inline gearset::dynamics::SetParameters reducer_gears(const analysis::PlanetaryDrivetrain& drivetrain) {
  const analysis::DrivetrainGeometry geometry = analysis::derive(drivetrain);
  const gearset::MeanLoads loads = gearset::mean_loads(drivetrain.set, geometry.gears, drivetrain.drive);
  const gearset::PlanetaryMeshes meshes = gearset::planetary_meshes(
      drivetrain.set, geometry.gears, {}, {},
      gearset::mesh_motion(loads.sun_torque, loads.sun_speed - loads.carrier_speed));
  analysis::GearDynamicsChoice choice;
  choice.mesh_damping_ratio = choice.bearing_damping_ratio = 0.05;
  choice.backlash = 100e-6;
  choice.support_damping_ratio = 0.05;
  choice.sun.support_stiffness = choice.ring.support_stiffness = choice.carrier.support_stiffness = 1e8;
  return geometric_set(choice, drivetrain.set, geometry.gears, meshes,
                       drivetrain.bearings_per_planet * geometry.bearing.outer_ring_mass,
                       planet_bearing_stiffness(drivetrain, geometry));
}

/// With real meshes, whose stiffness jumps, or with smooth ones.
inline analysis::PlanetaryDrivetrain coupled_reducer(bool smooth) {
  analysis::PlanetaryDrivetrain drivetrain = reducer();
  drivetrain.dynamics.race.film_in_approach = true;
  gearset::dynamics::SetParameters gears = reducer_gears(drivetrain);
  if (smooth)
    for (gearset::dynamics::Mesh* mesh : {&gears.sun_mesh, &gears.ring_mesh}) {
      const double mean = mesh->stiffness.mean();
      mesh->stiffness = gearset::PeriodicCurve(
          [mean](double f) { return mean * (1.0 + 0.2 * std::cos(2.0 * M_PI * f)); }, {}, 200);
    }
  drivetrain.gear_set = [gears] { return gears; };
  return drivetrain;
}

}  // namespace orbearing::example
