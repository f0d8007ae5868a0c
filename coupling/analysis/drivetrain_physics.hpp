// By which physics each input of a planetary drivetrain changes a result. An analysis states the physics that
// it holds, and thereby which inputs it uses.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "bearing/defect/scratch.hpp"
#include "coupling/analysis/planet_scratch.hpp"
#include "coupling/analysis/stated_drivetrain.hpp"
#include "coupling/analysis/vibration_record.hpp"
#include "mechanics/item_set.hpp"

namespace orbearing::analysis {

enum class Physics {
  everywhere,     // gears and bearings alike
  planet,         // teeth and all that a planet is made of
  gear_bodies,    // masses and springs of the gears
  thrust,         // axial forces of helical gears
  central_teeth,  // teeth and bodies of sun and ring, without effect on planets at rest
  output,         // what lies behind the sets
  gear_motion,    // gears in motion
  balance,        // what rollers carry, under a static load too
  carrier,        // the same, but only of a bearing that a carrier takes round
  walls,          // the carrier's, which hold the pins: gears and rollers in motion
  pin,            // what holds the bearing: its springs, and rollers in motion
  load_sharing,   // unlike loads of the planets
  positions,      // of the planets on the carrier, by which their loads differ and their meshes follow one
                  // another
  at_rest,        // bearings at rest, and those in motion that start from them
  motion,         // rollers and cage in motion
  euler,          // the carrier's speed that changes
  life,           // effect of the rollers' loads on life
  run,            // means over time
  run_up,         // speeds that grow
  defect,         // a bearing with scratches in motion
  exchange,       // windows of a co-simulation
  carrier_body,   // the carrier in three dimensions, held by its own bearings

  // Of no input by itself: what else distinguishes analyses.
  equilibrium,  // of rollers at rest alone: a mean over one roller pitch
  springs,      // bearings between gears and carrier as springs
  vibration,    // small, about an equilibrium
  rated_lives,  // lives with all that ratings state
  coupled,      // gears and bearings act on each other at every moment
};
using PhysicsSet = mechanics::ItemSet<Physics>;

/// All members of a drivetrain that a case states by a row beside them.
struct DrivetrainRows {
  StatedSet set;
  gearset::Drive drive;
  bearing::defect::Scratch scratch;
  ScratchedPosition position;
  PlanetSampling sampling;
  EnvelopeBand band;
};
template <class Visitor>
void describe(Visitor& visit, DrivetrainRows& m) {
  using namespace described;
  members(visit, m, part(m.set), part(m.drive), part(m.scratch), part(m.position), part(m.sampling),
          part(m.band));
}

/// The physics of each input, by its key. Inputs of the rating have none.
const std::map<std::string, Physics, std::less<>>& physics_of_inputs();

}  // namespace orbearing::analysis
