// Names of the inputs of a catalogue bearing, and of those that follow from them.
#pragma once

#include <string>
#include <vector>

namespace orbearing::app {

namespace catalogue_keys {
inline constexpr const char *kDesignation = "bearing.designation", *kCatalogue = "bearing.catalogue",
                            *kDynamic = "bearing.dynamic_capacity", *kStatic = "bearing.static_capacity",
                            *kLimit = "bearing.fatigue_load_limit", *kClass = "bearing.clearance_class",
                            *kClearance = "bearing.radial_clearance", *kState = "bearing.clearance_state",
                            *kMaterial = "bearing.cage.material", *kComplement = "bearing.complement",
                            *kRings = "bearing.rings", *kRollers = "bearing.rollers",
                            *kDensity = "bearing.cage.density", *kPinClass = "bearing.fit.pin_class",
                            *kPlanetClass = "bearing.fit.planet_class",
                            *kInnerFit = "bearing.fit.inner_interference",
                            *kOuterFit = "bearing.fit.outer_interference";
}  // namespace catalogue_keys

/// Inputs that follow where `bearing.designation` is given. Ratings are not among them: stated ratings
/// remain.
const std::vector<std::string>& paths_of_designation();

}  // namespace orbearing::app
