// Names of the inputs of a catalogue bearing, and of those that follow from them.
#pragma once

#include <string>
#include <vector>

namespace orbearing::app {

namespace catalogue_keys {
// Those that are no members of a machine: values of members follow from them.
inline constexpr const char *kCatalogue = "bearing.catalogue", *kMaterial = "bearing.cage.material",
                            *kPinClass = "bearing.fit.pin_class", *kPlanetClass = "bearing.fit.planet_class";
}  // namespace catalogue_keys

/// Inputs that follow where `bearing.designation` is given. Ratings are not among them: stated ratings
/// remain.
const std::vector<std::string>& paths_of_designation();

}  // namespace orbearing::app
