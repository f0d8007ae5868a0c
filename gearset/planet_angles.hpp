// Angular positions of the planets of a set on their carrier.
#pragma once

#include <string>
#include <vector>

#include "gearset/parameters.hpp"
#include "gearset/warning.hpp"

namespace orbearing::gearset {

/// Angles all round at equal steps from zero. [rad] anticlockwise
std::vector<double> even_angles(int planets);

/// Angles of the planets of a set, [rad] anticlockwise from the first: evenly, or as stated, on the angles
/// where teeth fit, Eq. (23) of gearset/README.md; of a set without teeth as they are stated.
std::vector<double> angles_of_planets(const PlanetarySet& set);

/// Those of `set.planets` planets nearest to equal steps at which teeth fit, as a case would state them: "[0
/// deg, 92.3077 deg, ...]". Empty where two of them are one.
std::string nearest_to_even(const PlanetarySet& set);

/// Whether planets follow one another at unequal steps.
bool is_unequally_spaced(const PlanetarySet& set);

/// Reasons why planets cannot be at the stated positions: their number, their order, teeth that do not fit
/// there. Empty if they can.
Warnings position_problems(const PlanetarySet& set);

/// The least angle between neighbours [rad]; a whole turn for a single planet.
double least_step(const std::vector<double>& angles);

}  // namespace orbearing::gearset
