// The reducer with gears and all planet bearings as one system, for tests.
#pragma once

#include "coupling/system/coupled_model.hpp"
#include "tests/gear_sets.hpp"
#include "tests/unit/cosim/driven_reducer.hpp"

namespace orbearing::test {

inline system::CoupledSetup coupled_reducer() {
  system::CoupledSetup setup;
  setup.gears.set = gearset::dynamics::test::reducer_dynamics();
  setup.gears.set.planet.coupled_bearing = true;
  setup.gears.operation = gearset::dynamics::test::reducer_operation(6000.0 * M_PI / 30.0);
  setup.bearing = driven_reducer();
  setup.bearing.orbit_radius = setup.gears.set.carrier.radius;
  setup.bearing.dynamics.bore_mass = 0.5 * setup.gears.set.planet.mass;
  return setup;
}

/// The same with oil that takes the energy of impacts on races and bars.
inline system::CoupledSetup oiled_reducer() {
  system::CoupledSetup setup = coupled_reducer();
  setup.bearing.dynamics.race.squeeze = true;
  setup.bearing.dynamics.cage.pocket_film = bearing::motion::PocketFilm::hydrodynamic;
  return setup;
}

}  // namespace orbearing::test
