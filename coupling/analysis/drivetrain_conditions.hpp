// Conditions on the inputs of a planetary drivetrain under which others have an effect.
#pragma once

#include <string>

#include "coupling/analysis/stated_drivetrain.hpp"

namespace orbearing::analysis {

/// Whether a planet whose tilt is computed tilts: its two ends differ in some input.
bool planets_tilt(const StatedSet& set);
/// Whether bearings whose tilt is computed have one: beside each other they tilt with the bent pin.
bool bearings_tilt(const StatedSet& set);
/// Whether the pin of a planet links the bearings on it, if tilts are computed: two on a pin that both walls
/// hold bend it equally.
bool pin_links_rows(const StatedSet& set);
/// Whether the planet's own properties affect a quasi-static bearing whatever its mass: it bends, tilts or is
/// pressed on a seat.
bool planet_counts_without_mass(const StatedSet& set);

/// Whether the springs between gears and carrier follow from the bearings.
bool bearings_make_springs(const StatedSet& set);
/// Whether the springs of a set depend on its loads: those of bearings do, and of teeth in loaded contact.
bool loads_make_springs(const StatedSet& set);
/// Whether one mesh at least has the stiffness that follows from its teeth.
bool teeth_make_meshes(const StatedSet& set);

/// Whether a part of a fit has another temperature than that of the sizes.
bool fits_are_warm(const StatedSet& set);
/// Whether the bearing's inner race is that of the pin, which moves with it.
bool pin_is_race(const StatedSet& set);
/// Whether the input speed does not grow.
bool speed_is_steady(const StatedSet& set);
/// Whether gears start at another speed than they run at.
bool gears_run_up(const StatedSet& set);

/// Whether the carrier of the set rotates; where no set is named, that of one of them.
bool carrier_rotates(const StatedDrivetrain& drivetrain, const std::string& set);
/// Whether results in motion name resonances of the gears: one set with cylindrical rollers whose meshes
/// vary.
bool resonances_are_named(const StatedDrivetrain& drivetrain);
/// Whether bearings without a cage move as one system with their gears, one way too.
bool is_one_system(const StatedDrivetrain& drivetrain);

}  // namespace orbearing::analysis
