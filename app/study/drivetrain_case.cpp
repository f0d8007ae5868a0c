#include "app/study/drivetrain_case.hpp"

#include <algorithm>

#include "app/case/profile_case.hpp"
#include "app/study/refinements.hpp"
#include "app/study/simulation_choice.hpp"
#include "gearset/checks.hpp"

namespace orbearing::app {

namespace {

gearset::Member member_of(const std::string& name) {
  if (name == "ring") return gearset::Member::ring;
  return name == "carrier" ? gearset::Member::carrier : gearset::Member::sun;
}

double planet_bore_of(const ResolvedCase& in) {
  if (in.has("bearing.rollers")) return in.quantity("bearing.outside_diameter");
  return in.number("gearset.planet_bore_ratio") * in.quantity("gearset.module") *
         (in.integer("gearset.teeth.planet") - 2.5);
}

gearset::PlanetarySet set_of(const ResolvedCase& in) {
  return {.sun_teeth = in.integer("gearset.teeth.sun"),
          .planet_teeth = in.integer("gearset.teeth.planet"),
          .ring_teeth = in.integer("gearset.teeth.ring"),
          .planets = in.integer("gearset.planets"),
          .module = in.quantity("gearset.module"),
          .rack = {.pressure_angle = in.quantity("gearset.pressure_angle"),
                   .addendum = in.number("gearset.addendum"),
                   .clearance = in.number("gearset.clearance"),
                   .root_fillet_radius = in.number("gearset.root_fillet_radius")},
          .sun_shift = in.number("gearset.profile_shift.sun"),
          .ring_shift = in.number("gearset.profile_shift.ring"),
          .face_width = in.quantity("gearset.face_width"),
          .planet_bore = planet_bore_of(in),
          .density = in.quantity("material.density"),
          .fixed_member =
              in.has("gearset.fixed") ? member_of(in.choice("gearset.fixed")) : gearset::Member::ring};
}

bearing::Cage cage_of(const ResolvedCase& in) {
  if (!in.has("bearing.cage.width")) return {};
  return {.inner_diameter = in.quantity("bearing.cage.inner_diameter"),
          .outer_diameter = in.quantity("bearing.cage.outer_diameter"),
          .width = in.quantity("bearing.cage.width"),
          .density = in.quantity("bearing.cage.density"),
          .guidance =
              in.choice("bearing.cage.guidance") == "inner" ? bearing::Race::inner : bearing::Race::outer};
}

bearing::dynamics::DynamicsParameters dynamics_of(const ResolvedCase& in) {
  bearing::dynamics::DynamicsParameters out;
  using bearing::dynamics::TractionLaw;
  out.race.traction = in.choice("traction.law") == "limiting-shear" ? TractionLaw::limiting_shear
                                                                    : TractionLaw::regularised_coulomb;
  out.race.friction = in.number("traction.friction");
  out.race.sliding_scale = in.quantity("traction.sliding_scale");
  out.race.limiting_friction = in.number("traction.limiting_friction");
  out.race.rolling_resistance = in.flag("traction.rolling_resistance");
  out.race.damping = in.quantity("contact.damping");
  out.drag.on = in.flag("drag.enabled");
  out.drag.oil_density = in.quantity("lubricant.density");
  out.drag.oil_share = in.number("lubricant.share");
  out.support.stiffness = in.quantity("support.stiffness");
  out.support.damping_ratio = in.number("support.damping_ratio");
  return out;
}

bearing::dynamics::CageParameters cage_dynamics_of(const ResolvedCase& in) {
  bearing::dynamics::CageParameters out;
  out.pocket_clearance = in.quantity("bearing.cage.pocket_clearance");
  out.pocket_stiffness = in.quantity("bearing.cage.pocket_stiffness");
  out.pocket_damping = in.quantity("bearing.cage.pocket_damping");
  out.pocket_friction = in.number("bearing.cage.pocket_friction");
  if (in.has("bearing.cage.guide_land_diameter"))
    out.guide_diameter = in.quantity("bearing.cage.guide_land_diameter");
  out.guidance_film = in.choice("bearing.cage.guidance_film") == "as-printed"
                          ? bearing::dynamics::GuidanceFilm::as_printed
                          : bearing::dynamics::GuidanceFilm::short_bearing;
  out.largest_eccentricity = in.number("bearing.cage.largest_eccentricity");
  out.touch_down_stiffness = in.quantity("bearing.cage.touch_down_stiffness");
  return out;
}

gearset::Drive drive_of(const ResolvedCase& in) {
  return {.member = in.has("input.member") ? member_of(in.choice("input.member")) : gearset::Member::sun,
          .power = in.quantity("input.power"),
          .speed = in.quantity("input.speed")};
}

study::PlanetaryDrivetrain quasi_static_drivetrain(const ResolvedCase& in) {
  return {.set = set_of(in),
          .drive = drive_of(in),
          .bearing = bearing_of(in),
          .bearings_per_planet = in.integer("bearing.per_planet"),
          .inertia = {.own_orbit = in.flag("inertia.own_orbit"),
                      .coriolis = in.flag("inertia.coriolis"),
                      .carrier_centrifugal = in.flag("inertia.carrier_centrifugal"),
                      .euler = in.flag("inertia.euler")},
          .lubricant = {.viscosity = in.quantity("lubricant.viscosity"),
                        .pressure_viscosity = in.quantity("lubricant.pressure_viscosity")},
          .film_in_approach = in.flag("film.enabled"),
          .lambda = in.number("life.lambda"),
          .cage_positions = in.integer("numerics.cage_positions")};
}

}  // namespace

bearing::CylindricalRollerBearing bearing_of(const ResolvedCase& in) {
  return {.rollers = in.integer("bearing.rollers"),
          .roller_diameter = in.quantity("bearing.roller_diameter"),
          .roller_length = in.quantity("bearing.roller_length"),
          .pitch_diameter = in.quantity("bearing.pitch_diameter"),
          .radial_clearance = in.quantity("bearing.radial_clearance"),
          .bore = in.quantity("bearing.bore"),
          .outside_diameter = in.quantity("bearing.outside_diameter"),
          .width = in.quantity("bearing.width"),
          .material = {.youngs_modulus = in.quantity("material.youngs_modulus"),
                       .poisson_ratio = in.number("material.poisson_ratio"),
                       .density = in.quantity("material.density")},
          .contact_law = in.choice("contact.law") == "iso16281" ? bearing::ContactLaw::iso16281
                                                                : bearing::ContactLaw::palmgren,
          .cage = cage_of(in),
          .laminae = in.has("bearing.laminae") ? in.integer("bearing.laminae") : 0,
          .roller_profile = roller_profile_of(in)};
}

namespace {

bool has_displaced_pins(const ResolvedCase& in) {
  for (const char* path : {"gearset.dynamics.pin_error.radial", "gearset.dynamics.pin_error.tangential"}) {
    if (!in.has(path)) continue;
    const std::vector<double>& errors = in.list(path);
    if (std::any_of(errors.begin(), errors.end(), [](double error) { return error != 0.0; })) return true;
  }
  return false;
}

}  // namespace

study::PlanetaryDrivetrain drivetrain_without_gear_set(const ResolvedCase& in) {
  if (!in.has("bearing.rollers")) return {.set = set_of(in), .drive = drive_of(in)};
  study::PlanetaryDrivetrain out = quasi_static_drivetrain(in);
  out.dynamics = dynamics_of(in);
  out.dynamics.cage = cage_dynamics_of(in);
  out.steady_state = steady_state_of(in);
  out.exchange = exchange_of(in);
  out.mesh_variation = in.flag("gearset.mesh_variation");
  out.pins_displaced = has_displaced_pins(in);
  add_refinements(in, out);
  return out;
}

std::vector<std::string> gear_warnings(const ResolvedCase& resolved) {
  std::vector<std::string> texts;
  const auto add = [&](const std::string& prefix, const ResolvedCase& set) {
    for (const gearset::Warning& warning : gearset::tooth_warnings(gearset::working_geometry(set_of(set))))
      texts.push_back(prefix + warning.place + ": " + warning.text);
  };
  if (!resolved.shape().teeth) return texts;
  if (!resolved.shape().several) add("", resolved);
  for (const std::string& set : resolved.shape().sets) add(set_prefix(set), resolved.of_set(set));
  return texts;
}

}  // namespace orbearing::app
