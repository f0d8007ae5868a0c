// A small ball bearing, for the tests of scratches.
#pragma once


#include "bearing/defect/scratched_bearing.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::defect {

/// Nine balls, a shaft of 30 turns a second, no scratch.
inline ScratchedBearing nine_balls() {
  ScratchedBearing in;
  in.bearing.elements = Balls{.count = 9, .diameter = 8e-3};
  in.bearing.pitch_diameter = 39e-3;
  in.bearing.radial_clearance = 4e-6;
  in.ring.mass = 0.2;
  in.load = 800.0;
  in.shaft_speed = 30.0 * constants::two_pi;
  return in;
}

inline ScratchedBearing scratched(Scratched race, ScratchForm form = ScratchForm::raised_cosine) {
  ScratchedBearing in = nine_balls();
  in.scratch = {.race = race, .width = 0.5e-3, .depth = 0.2e-3, .form = form};
  return in;
}

}  // namespace orbearing::bearing::defect
