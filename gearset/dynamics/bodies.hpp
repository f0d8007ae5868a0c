// Masses and inertias of the members of a set from its geometry.
#pragma once

#include "gearset/parameters.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::gearset::dynamics {

/// Outlines that tooth numbers and module do not fix.
struct BodyOutlines {
  double sun_bore = 0.0;           // [m]  diameter
  double ring_outside = 0.0;       // [m]  diameter
  double planet_bore = 0.0;        // [m]  diameter
  double carrier_plates = 0.0;     // [m]  thickness of both side plates together
  double extra_planet_mass = 0.0;  // [kg]  rings of its bearings that turn with it, at the bore
};

/// Mass, and moment of inertia / radius^2 with the radius of the member's u.
struct Body {
  double mass = 0.0;     // [kg]
  double inertia = 0.0;  // [kg]
  double radius = 0.0;   // [m]  base radius; centre distance for the carrier
};

/// All bodies of a set; the planet's is that of one.
struct SetBodies {
  Body sun;
  Body ring;
  Body carrier;
  Body planet;
};

/// Sun and planet solid from teeth to bore, ring from its teeth to its outside. The carrier is two discs that
/// reach from the axis to the middle of the planets' rims. Shafts and flanges are not included.
/// @throws std::domain_error where an outline leaves no body under the teeth
SetBodies set_bodies(const PlanetarySet& set, const WorkingGeometry& geometry, const BodyOutlines& outlines);

/// Radial stiffness of the support of a member without a stated design. [N/m]  Assumption: similar designs,
/// whose stiffness is proportional to modulus and size. For steel: 1e8 N/m for a sun of 111 mm (an overhung
/// shaft of half that diameter, 2.5 of its diameters long, has 3 E I/l^3 = 1.08e8 N/m), 5e8 N/m for a carrier
/// in two bearings at a centre distance of 88.5 mm, 1e9 N/m for a ring of 237 mm in its housing; sizes at the
/// reference circles.
double default_support_stiffness(const PlanetarySet& set, Member member, double youngs_modulus);

/// Stiffness of the same shaft of the sun, whose radial stiffness is `support` [N/m], against tilting of the
/// sun by a moment only: E I/l where that is the default, and in proportion. [N m/rad]
double default_sun_tilt_stiffness(const PlanetarySet& set, double support, double youngs_modulus);

/// Least backlash recommended by ISO/TR 10064-2, along the line of action in the transverse section. [m]
/// 2/3 (0.06 + 0.0005 a + 0.03 m_n) mm, normal to the teeth; a by the reference circles.
double default_backlash(const PlanetarySet& set);

/// By the reference circles. [m]
double reference_centre_distance(const PlanetarySet& set);

}  // namespace orbearing::gearset::dynamics
