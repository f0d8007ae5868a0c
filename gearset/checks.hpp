// Whether a set can be assembled, and whether its teeth are sound.
#pragma once

#include <string>

#include "gearset/parameters.hpp"
#include "gearset/warning.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::gearset {

/// Reasons why the set cannot be built; empty if it can. Each names what was found, what is required and a
/// remedy.
Warnings assembly_problems(const PlanetarySet& set);

/// Problems that follow from tooth numbers and planet positions only.
Warnings spacing_problems(const PlanetarySet& set);

/// Reasons why a basic rack can cut no teeth.
/// @param block of the case that states the rack: "gearset"
Warnings rack_problems(const BasicRack& rack, const std::string& block);

/// Faults of a set that can still run: undercut, and ends of teeth that reach where there is no involute.
Warnings tooth_warnings(const WorkingGeometry& geometry);

/// Room between the teeth of a ring and of the gear inside it where their tip circles cross, outside the path
/// of contact. Eq. (25) of gearset/README.md.
/// @return [m] along the ring's tip circle; negative where the tips foul each other; the ring's tip radius
/// where the circles do not cross
double ring_tip_clearance(const InternalMesh& mesh);
double ring_tip_clearance(const WorkingGeometry& geometry);

/// Faults of the teeth of an external gear in mesh with another, except undercut and contact ratio: tips of
/// the other beyond the end of its involute or in its roots.
/// @param distance [m] of the axes
/// @param working_angle [rad] transverse working pressure angle
/// @param gear, other what both are called
void warn_of_external_mesh(const ExternalTooth& tooth, const ExternalTooth& mate, double distance,
                           double working_angle, const std::string& gear, const std::string& other,
                           ToothWarnings& warnings);

/// Faults of a ring and the gear inside it, except undercut and contact ratio: tips beyond the end of an
/// involute, in the roots or fouling each other.
/// @param inside what the gear inside is called
void warn_of_internal_mesh(const InternalMesh& mesh, const std::string& inside, ToothWarnings& warnings);

}  // namespace orbearing::gearset
