// From a resolved case of the model planetary-drivetrain to the parameters of its set with teeth.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "gearset/parameters.hpp"
#include "gearset/planet_pair.hpp"
#include "gearset/stated_geometry.hpp"

namespace orbearing::app {

// Inputs of a case that make the planets of a set carry unequal loads.

/// Whether the case has a list at `path` with a value that is not zero.
bool is_anywhere_nonzero(const ResolvedCase& resolved, std::string_view path);

/// The path of the value by which planets carry unequal loads: pins with position errors, or planets at
/// unequal angles; empty: none does. For the one set of a case, or for one of several by
/// ResolvedCase::of_set().
std::string uneven_planets_by(const ResolvedCase& resolved);

/// The set with the bore that its bearings fill; where it has none, with the bore that the case states as a
/// share of the root diameter of standard teeth.
gearset::PlanetarySet set_of(const ResolvedCase& resolved);

/// The same without bore and density, also of a case with values that are missing.
gearset::PlanetarySet stated_set(const ResolvedCase& resolved);

/// Whether the planets of the one set, or of one of several by ResolvedCase::of_set(), have two gears.
bool has_stepped_planets(const ResolvedCase& resolved);

/// Whether planets are in pairs, and the second planet of such a pair.
bool has_planet_pairs(const ResolvedCase& resolved);
gearset::SecondPlanet second_planet_of(const ResolvedCase& resolved);

/// The input that a warning of the gears is about: without a bearing a planet's bore is that of another
/// input.
std::string location_in_case(const ResolvedCase& resolved, const std::string& location);

/// Values of the set that the case states as a check.
gearset::StatedGeometry stated_geometry(const ResolvedCase& resolved);

/// Refuses a stated centre distance or planet shift that does not follow from teeth, module and shifts. Both
/// are checks alone: results follow from the independent values.
void check_stated_geometry(CheckedCase& resolved);

/// Warnings on a negative profile shift of the ring: it is legal, but sources by DIN 3960 print it for a
/// positive shift. They give both readings where the other could be assembled too and no stated value
/// excludes it.
std::vector<std::string> ring_sign_warnings(const ResolvedCase& resolved);

}  // namespace orbearing::app
