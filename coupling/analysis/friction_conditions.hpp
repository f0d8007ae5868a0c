// Conditions under which inputs of the friction of moving balls have an effect.
#pragma once

#include <vector>

#include "bearing/motion/balls/parameters.hpp"
#include "mechanics/conditional.hpp"
#include "mechanics/member_keys.hpp"

namespace orbearing::analysis {

/// For inputs whose motion of the balls is `moving_balls(inputs)`. Besides the friction of the races, that of
/// the cage builds up over the same sliding speed.
template <class Inputs>
std::vector<mechanics::Conditional<Inputs>> conditions_of_ball_friction(
    const Inputs& m, const mechanics::MemberKeys<Inputs>& key) {
  const bearing::motion::RaceContactParameters& race = moving_balls(m).race;
  const std::string &scale = key(race.sliding_scale), &law = key(race.traction);
  return {
      {.keys = {scale},
       .premises = {{.on = {key(moving_balls(m).cage.pocket_friction)},
                     .holds = [](const Inputs& in) { return moving_balls(in).cage.pocket_friction != 0.0; }}},
       .beside_row = true},
      {.keys = {scale},
       .premises = {{.on = {key(moving_balls(m).cage.guide_diameter)},
                     .holds = [](const Inputs& in) { return moving_balls(in).cage.guide_diameter != 0.0; }}},
       .beside_row = true},
      {.keys = {key(race.largest_barus_exponent)},
       .premises = {
           {.on = {law},
            .holds = [](const Inputs& in) { return nature_of(moving_balls(in).race.traction).shears_oil; },
            .value = bearing::kLawsOfOil.text}}}};
}

}  // namespace orbearing::analysis
