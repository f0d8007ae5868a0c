// Conditions under which inputs of the friction of moving balls have an effect.
#pragma once

#include <vector>

#include "bearing/motion/balls/parameters.hpp"
#include "mechanics/conditional.hpp"

namespace orbearing::analysis {

/// For inputs whose motion of the balls is `moving_balls(inputs)`. Besides the friction of the races, that of
/// the cage builds up over the same sliding speed, and other laws have the same limit.
template <class Inputs>
std::vector<mechanics::Conditional<Inputs>> conditions_of_ball_friction() {
  using bearing::TractionLaw;
  return {
      {.keys = {"traction.sliding_scale"},
       .premises = {{.on = {"bearing.cage.pocket_friction"},
                     .holds = [](const Inputs& in) { return moving_balls(in).cage.pocket_friction != 0.0; }}},
       .beside_row = true},
      {.keys = {"traction.sliding_scale"},
       .premises = {{.on = {"bearing.cage.guide_land_diameter"},
                     .holds = [](const Inputs& in) { return moving_balls(in).cage.guide_diameter != 0.0; }}},
       .beside_row = true},
      {.keys = {"traction.limiting_friction"},
       .premises = {{.on = {"traction.law"},
                     .holds =
                         [](const Inputs& in) {
                           return moving_balls(in).race.traction == TractionLaw::ree_eyring;
                         },
                     .value = "ree-eyring"}},
       .beside_row = true},
      {.keys = {"traction.largest_barus_exponent"},
       .premises = {
           {.on = {"traction.law"},
            .holds = [](const Inputs& in) { return nature_of(moving_balls(in).race.traction).shears_oil; },
            .value = "limiting-shear|ree-eyring"}}}};
}

}  // namespace orbearing::analysis
