// Conditions of the use of fields that follow from several values at once.
#pragma once

#include <string_view>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

/// Whether the stiffness of the meshes follows from a parameter, beside those that make the planets
/// themselves (drivetrain_uses.cpp).
bool makes_meshes(std::string_view path);

/// Whether a planet whose tilt is computed tilts: its two ends differ in some input.
bool planets_tilt(const ResolvedCase& in, std::string_view set);
/// Whether bearings whose tilt is computed have one: beside each other they tilt with the bent pin.
bool bearings_tilt(const ResolvedCase& in, std::string_view set);
/// Whether the pin of a planet links the bearings on it, if tilts are computed: two on a pin that both walls
/// hold bend it equally.
bool pin_links_rows(const ResolvedCase& in, std::string_view set);

/// Whether the carrier of the set rotates; where no set is named, that of one of them.
bool carrier_rotates(const ResolvedCase& in, std::string_view set);
/// The same, and the masses that rotate with it have centrifugal loads.
bool carrier_pulls(const ResolvedCase& in, std::string_view set);
/// Whether the planet's own properties affect a quasi-static bearing: by its mass, or since it bends, tilts
/// or is pressed on a seat.
bool planet_counts_at_rest(const ResolvedCase& in, std::string_view set);
/// Whether the carrier of a single set is a body in three dimensions: its bearings are stated, the housing
/// holds the ring, and rims do not link the springs of a planet.
bool carrier_is_body(const ResolvedCase& in, std::string_view set);
/// Whether the springs between gears and carrier follow from the bearings.
bool bearings_make_springs(const ResolvedCase& in, std::string_view set);
/// Whether the springs of a set depend on its loads: those of bearings do, and of teeth in loaded contact.
bool loads_make_springs(const ResolvedCase& in, std::string_view set);
/// Whether one mesh at least has the stiffness that follows from its teeth.
bool teeth_make_meshes(const ResolvedCase& in, std::string_view set);
/// Whether a spring of the set follows from the elasticity of the material.
bool material_makes_springs(const ResolvedCase& in, std::string_view set);
/// Whether a spring of the set follows from its modulus: those, and supports.
bool modulus_makes_springs(const ResolvedCase& in, std::string_view set);
/// Whether a part of a fit has another temperature than that of the sizes.
bool fits_are_warm(const ResolvedCase& in, std::string_view set);
/// Whether planet bearings of the set, or of any, have rollers; so of other models.
bool planets_have_rollers(const ResolvedCase& in, std::string_view set);
/// Whether results in motion name resonances of the gears: one set with cylindrical rollers whose meshes
/// vary.
bool resonances_are_named(const ResolvedCase& in, std::string_view set);
/// Whether bearings without a cage move as one system with their gears, one way too.
bool is_one_system(const ResolvedCase& in, std::string_view set);
/// Whether the bearing's inner race is that of the pin, which moves with it.
bool pin_is_race(const ResolvedCase& in, std::string_view set);
/// Whether the input speed does not grow.
bool speed_is_steady(const ResolvedCase& in, std::string_view set);
/// Whether gears start at another speed than they run at.
bool gears_run_up(const ResolvedCase& in, std::string_view set);

}  // namespace orbearing::app
