// The waves of an elastic outer race as bodies of the motion, equation (16) of bearing/motion/README.md.
#pragma once

#include <vector>

#include "bearing/elastic_race.hpp"
#include "bearing/motion/parameters.hpp"
#include "bearing/motion/vectorised/constants.hpp"

namespace orbearing::bearing::motion {

/// `race` without the waves of a higher order than those that move.
ElasticRace moving_waves(ElasticRace race, const RimParameters& parameters);

/// In the order of equilibrium/elastic_waves.hpp; none for a rigid race. Throws std::invalid_argument, with
/// what was found and what is required, where a wave has no mass.
std::vector<vectorised::RimWave> rim_waves(const ElasticRace& race, const RimParameters& parameters);

}  // namespace orbearing::bearing::motion
