// Area, mass and inertia of the planet gear from its true tooth form.
#pragma once

#include "gearset/parameters.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::gearset {

/// The gear body of one planet, teeth and rim down to its bore; rings and rollers of its bearings not
/// included.
struct PlanetBody {
  double area = 0.0;          // [m^2]     transverse
  double mass = 0.0;          // [kg]
  double inertia = 0.0;       // [kg m^2]  polar, about the planet's own axis
  double first_moment = 0.0;  // [kg m]  along the axis about the middle of the planet; zero but of two gears
};

/// The planet of a set, with both gears of a stepped one. Eqs. (21) and (22) of gearset/README.md.
/// @throws std::domain_error if the bore leaves no rim under the tooth root
PlanetBody planet_body(const PlanetarySet& set, const WorkingGeometry& geometry);

/// Transverse area and polar second moment of a gear's cross-section.
struct SectionMoments {
  double area = 0.0;                 // [m^2]
  double polar_second_moment = 0.0;  // [m^4]
};

/// @param bore_radius [m] at most the root radius
SectionMoments section_moments(const ExternalTooth& tooth, double bore_radius);
/// @param outside_radius [m] at least the root radius
SectionMoments section_moments(const RingTooth& tooth, double outside_radius);

}  // namespace orbearing::gearset
