// Where the planets of a set stand on their carrier.
#pragma once

#include <vector>

#include "gearset/parameters.hpp"
#include "gearset/warning.hpp"

namespace orbearing::gearset {

/// Places all round at equal steps from zero. [rad] anticlockwise
std::vector<double> even_places(int planets);

/// Places of the planets of a set, [rad] anticlockwise from the first: evenly, or as stated, on the places
/// where teeth fit, Eq. (23) of gearset/README.md; of a set without teeth as they are stated.
std::vector<double> planet_places(const PlanetarySet& set);

/// Whether planets follow one another at unequal steps.
bool stands_unevenly(const PlanetarySet& set);

/// Reasons why planets cannot stand where they are stated to: their number, their order, teeth that do not
/// fit there. Empty if they can.
Warnings place_problems(const PlanetarySet& set);

/// The least angle between neighbours [rad]; a whole turn of a planet alone.
double least_step(const std::vector<double>& places);

}  // namespace orbearing::gearset
