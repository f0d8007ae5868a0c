#include "gearset/dynamics/bodies.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "gearset/planet_body.hpp"
#include "gearset/warning.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using constants::pi;

[[noreturn]] void refuse(const std::string& outline, double found, const std::string& required) {
  throw std::domain_error(outline + ": found " + millimetres(found) + "; required: " + required);
}

Body body_of(const PlanetarySet& set, const SectionMoments& section, double radius) {
  const double mass_per_area = set.density * set.face_width;
  return {mass_per_area * section.area, mass_per_area * section.polar_second_moment / (radius * radius),
          radius};
}

SectionMoments annulus(double inner, double outer) {
  return {pi * (outer * outer - inner * inner), pi / 2.0 * (std::pow(outer, 4) - std::pow(inner, 4))};
}

Body external_gear(const PlanetarySet& set, const ExternalTooth& tooth, double bore,
                   const std::string& name) {
  if (!(bore >= 0.0 && bore < 2.0 * tooth.root_radius))
    refuse(name, bore, "less than the root diameter, " + millimetres(2.0 * tooth.root_radius));
  return body_of(set, section_moments(tooth, 0.5 * bore), tooth.base_radius);
}

Body ring_gear(const PlanetarySet& set, const RingTooth& tooth, double outside) {
  if (!(outside > 2.0 * tooth.root_radius))
    refuse("outside diameter of the ring", outside,
           "more than the root diameter, " + millimetres(2.0 * tooth.root_radius));
  return body_of(set, section_moments(tooth, 0.5 * outside), tooth.base_radius);
}

Body carrier_body(const PlanetarySet& set, const WorkingGeometry& geometry, const BodyOutlines& outlines) {
  if (!(outlines.carrier_plates > 0.0))
    refuse("thickness of the carrier's plates", outlines.carrier_plates, "more than 0 mm");
  const double reach =
      geometry.centre_distance + 0.5 * (0.5 * outlines.planet_bore + geometry.planet.root_radius);
  const SectionMoments disc = annulus(0.0, reach);
  PlanetarySet plates = set;
  plates.face_width = outlines.carrier_plates;
  return body_of(plates, disc, geometry.centre_distance);
}

}  // namespace

SetBodies set_bodies(const PlanetarySet& set, const WorkingGeometry& geometry, const BodyOutlines& outlines) {
  SetBodies bodies{.sun = external_gear(set, geometry.sun, outlines.sun_bore, "bore of the sun"),
                   .ring = ring_gear(set, geometry.ring, outlines.ring_outside),
                   .carrier = carrier_body(set, geometry, outlines),
                   .planet = external_gear(set, geometry.planet, outlines.planet_bore, "bore of the planet")};
  // Rings of the bearings lie as a thin hoop within the bore.
  const double hoop_radius = 0.5 * outlines.planet_bore;
  bodies.planet.mass += outlines.extra_planet_mass;
  bodies.planet.inertia += outlines.extra_planet_mass * std::pow(hoop_radius / bodies.planet.radius, 2);
  return bodies;
}

double reference_centre_distance(const PlanetarySet& set) {
  return 0.5 * set.module * (set.sun_teeth + set.planet_teeth) / std::cos(set.helix_angle);
}

double default_support_stiffness(const PlanetarySet& set, Member member, double youngs_modulus) {
  struct Known {
    double stiffness;  // [N/m]
    double size;       // [m]
  };
  constexpr double steel = 206e9;  // [Pa]
  const auto similar = [&](const Known& known, double size) {
    return known.stiffness * (size / known.size) * (youngs_modulus / steel);
  };
  const double transverse_module = set.module / std::cos(set.helix_angle);
  if (member == Member::sun) return similar({1e8, 0.111}, transverse_module * set.sun_teeth);
  if (member == Member::ring) return similar({1e9, 0.237}, transverse_module * set.ring_teeth);
  return similar({5e8, 0.0885}, reference_centre_distance(set));
}

double default_sun_tilt_stiffness(const PlanetarySet& set, double support, double youngs_modulus) {
  const double sun = set.module / std::cos(set.helix_angle) * set.sun_teeth;
  const double diameter = 0.5 * sun, length = 2.5 * diameter;  // [m]  of the shaft
  const double own = youngs_modulus * pi / 64.0 * std::pow(diameter, 4) / length;
  return own * support / default_support_stiffness(set, Member::sun, youngs_modulus);
}

double default_backlash(const PlanetarySet& set) {
  const double normal = 2.0 / 3.0 * (0.06e-3 + 0.0005 * reference_centre_distance(set) + 0.03 * set.module);
  const double base_helix = std::asin(std::sin(set.helix_angle) * std::cos(set.rack.pressure_angle));
  return normal / std::cos(base_helix);
}

}  // namespace orbearing::gearset::dynamics
