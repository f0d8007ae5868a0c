// Analyses by number, and sets of them.
#pragma once

#include "mechanics/item_set.hpp"

namespace orbearing::app {

/// Analyses of planetary drivetrains, in the order in which they are listed to users, each with a row in
/// drivetrain_analyses.cpp; after them the rows of machines (machine_rows.hpp).
enum class AnalysisId : unsigned {
  quasi_static,     // run and sweep of a drivetrain, rung by rung
  dynamic,          // of one set
  dynamic_of_sets,  // of several: their meshes give mean forces
  co_simulated,
  monolithic,
  crown,
  gears,  // run --gears, and run of a set without a bearing
  modes,
  modes_at_speed,
  mesh,
  fmu_bearing,
  fmu_gearset,
  planet_defect,  // run of a drivetrain with a scratched planet bearing
  planet_stiffness,
  carrier,  // the carrier as a body, over a revolution
  first_of_machines
};

using AnalysisSet = mechanics::ItemSet<AnalysisId>;

constexpr AnalysisSet operator|(AnalysisId one, AnalysisId other) {
  return {one, other};
}

}  // namespace orbearing::app
