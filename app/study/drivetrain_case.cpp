#include "app/study/drivetrain_case.hpp"

#include <algorithm>

#include "app/case/arrangement_case.hpp"
#include "app/case/profile_case.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/refinements.hpp"
#include "app/study/simulation_choice.hpp"
#include "app/units.hpp"
#include "bearing/profile/design.hpp"
#include "gearset/checks.hpp"
#include "gearset/drivetrain/power_flow.hpp"

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

void add_gears(const study::PlanetaryDrivetrain& drivetrain, const study::DrivetrainGeometry& geometry,
               std::vector<Derived>& rows) {
  const gearset::WorkingGeometry& gears = geometry.gears;
  rows.push_back(
      {"gearset.centre_distance", 1e3 * gears.centre_distance, "mm", "working, common to both meshes"});
  rows.push_back(
      {"gearset.profile_shift.planet", gears.planet_shift, "1", "from the common centre distance"});
  rows.push_back(
      {"gearset.sun_mesh.pressure_angle", kDegree * gears.sun_mesh.working_pressure_angle, "deg", "working"});
  rows.push_back({"gearset.ring_mesh.pressure_angle", kDegree * gears.ring_mesh.working_pressure_angle, "deg",
                  "working"});
  rows.push_back(
      {"gearset.sun_mesh.contact_ratio", gears.sun_mesh.contact_ratio, "1", "where the involutes end"});
  rows.push_back(
      {"gearset.ring_mesh.contact_ratio", gears.ring_mesh.contact_ratio, "1", "where the involutes end"});
  rows.push_back(
      {"gearset.planet_angle", 360.0 / drivetrain.set.planets, "deg", "between neighbouring planets"});
  rows.push_back(
      {"gearset.planet_mass", geometry.planet_mass, "kg", "gear body and outer rings of its bearings"});
}

void add_motion(const gearset::MeanLoads& gears, std::vector<Derived>& rows) {
  rows.push_back({"operation.carrier_speed", kRpm * gears.carrier_speed, "rpm", "Willis"});
  rows.push_back({"operation.planet_speed", kRpm * gears.planet_speed_relative, "rpm",
                  "relative to the carrier; negative: against carrier rotation"});
  rows.push_back({"operation.input_torque_sun", gears.sun_torque, "N.m", "on the sun"});
  rows.push_back({"operation.mesh_normal_force", gears.normal_force, "N", "one mesh of one planet"});
}

void add_duty(const study::BearingDuty& duty, std::vector<Derived>& rows) {
  add_motion(duty.gears, rows);
  rows.push_back({"operation.bore_load_x", duty.point.bore_load.x(), "N",
                  "gears and planet on one bearing, outward; cage and rollers not included"});
  rows.push_back(
      {"operation.bore_load_y", duty.point.bore_load.y(), "N", "the same, in the sense of rotation"});
}

void add_profile(const bearing::CylindricalRollerBearing& bearing, std::vector<Derived>& rows) {
  if (bearing.laminae == 0) return;
  const double half = 0.5 * bearing.roller_length;
  rows.push_back({"bearing.profile.outermost_drop",
                  1e6 * bearing::profile::drop(bearing.roller_profile, bearing::profile::kDropPlace * half),
                  "um", "relief of one roller at the outermost of 40 laminae"});
}

void add_bearing(const study::PlanetaryDrivetrain& drivetrain, const study::DrivetrainGeometry& geometry,
                 std::vector<Derived>& rows) {
  const bearing::RollerBearingGeometry& g = geometry.bearing;
  add_profile(drivetrain.bearing, rows);
  rows.push_back(
      {"bearing.inner_raceway_diameter", 2e3 * g.inner_radius, "mm", "pitch - roller - half clearance"});
  rows.push_back(
      {"bearing.outer_raceway_diameter", 2e3 * g.outer_radius, "mm", "pitch + roller + half clearance"});
  rows.push_back({"bearing.roller_mass", 1e3 * g.roller_mass, "g", "one roller"});
  rows.push_back({"bearing.cage.mass", 1e3 * g.cage_mass, "g", "ring less pockets"});
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

study::PlanetaryDrivetrain drivetrain_of(const ResolvedCase& in) {
  if (!in.has("bearing.rollers")) return {.set = set_of(in), .drive = drive_of(in)};
  study::PlanetaryDrivetrain out = quasi_static_drivetrain(in);
  out.dynamics = dynamics_of(in);
  out.dynamics.cage = cage_dynamics_of(in);
  out.steady_state = steady_state_of(in);
  out.exchange = exchange_of(in);
  out.mesh_variation = in.flag("gearset.mesh_variation");
  out.gear_set = [in] { return gear_model_of(in).parameters; };
  out.pins_displaced = has_displaced_pins(in);
  add_refinements(in, out);
  return out;
}

std::vector<std::string> bearing_set_names(const ResolvedCase& resolved) {
  std::vector<std::string> names;
  for (const std::string& set : resolved.shape().sets)
    if (resolved.has(set_prefix(set) + "bearing.rollers")) names.push_back(set);
  return names;
}

std::vector<study::NamedSet> bearing_sets(const ResolvedCase& resolved) {
  if (!resolved.shape().several) {
    study::PlanetaryDrivetrain drivetrain = drivetrain_of(resolved);
    const study::DrivetrainGeometry geometry = study::derive(drivetrain);
    return {{"", std::move(drivetrain), geometry}};
  }
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(resolved));
  const std::vector<std::string>& all = resolved.shape().sets;
  std::vector<study::NamedSet> sets;
  for (const std::string& name : bearing_set_names(resolved)) {
    study::PlanetaryDrivetrain drivetrain = drivetrain_of(resolved.of_set(name));
    const auto place = static_cast<std::size_t>(std::find(all.begin(), all.end(), name) - all.begin());
    drivetrain.in_arrangement = flow.sets[place];
    drivetrain.gear_set = nullptr;      // a model of one set, which knows neither its place nor its share
    drivetrain.pins_displaced = false;  // without that model none shares its load unevenly; the case warns
    const study::DrivetrainGeometry geometry = study::derive(drivetrain);
    sets.push_back({name, std::move(drivetrain), geometry});
  }
  return sets;
}

namespace {

std::vector<Derived> quantities_without_bearing(const ResolvedCase& resolved) {
  std::vector<Derived> rows;
  if (!resolved.shape().teeth) return rows;
  const study::PlanetaryDrivetrain drivetrain = drivetrain_of(resolved);
  study::DrivetrainGeometry geometry;
  geometry.gears = gearset::working_geometry(drivetrain.set);
  geometry.planet_mass = gearset::planet_body(drivetrain.set, geometry.gears).mass;
  add_gears(drivetrain, geometry, rows);
  add_motion(gearset::mean_loads(drivetrain.set, geometry.gears, drivetrain.drive), rows);
  return rows;
}

}  // namespace

std::vector<Derived> derived_quantities(const ResolvedCase& resolved) {
  if (!resolved.shape().several && !resolved.shape().bearing) return quantities_without_bearing(resolved);
  std::vector<Derived> rows;
  for (const study::NamedSet& set : bearing_sets(resolved)) {
    std::vector<Derived> of_set;
    add_gears(set.drivetrain, set.geometry, of_set);
    add_bearing(set.drivetrain, set.geometry, of_set);
    add_duty(study::bearing_duty(set.drivetrain, set.geometry), of_set);
    if (!resolved.has("support.stiffness"))  // of several sets, each has its own pin
      of_set.push_back({"support.stiffness", set.drivetrain.dynamics.support.stiffness, "N/m",
                        "of the pin at one bearing, from its dimensions"});
    for (Derived& row : of_set) {
      if (!set.name.empty()) row.path = set_prefix(set.name) + row.path;
      rows.push_back(std::move(row));
    }
  }
  return rows;
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
