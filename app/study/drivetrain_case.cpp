#include "app/study/drivetrain_case.hpp"

#include <boost/math/constants/constants.hpp>

#include "gearset/checks.hpp"

namespace orbearing::app {

namespace {

using boost::math::double_constants::pi;
constexpr double kRpm = 30.0 / pi;      // per rad/s
constexpr double kDegree = 180.0 / pi;  // per rad

gearset::Member member_of(const std::string& name) {
  if (name == "ring") return gearset::Member::ring;
  return name == "carrier" ? gearset::Member::carrier : gearset::Member::sun;
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
          .planet_bore = in.quantity("bearing.outside_diameter"),
          .density = in.quantity("material.density"),
          .fixed_member = member_of(in.choice("gearset.fixed"))};
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
  out.ripple.amplitude = in.quantity("gearset.mesh_ripple.amplitude");
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

integration::SteadyStateOptions steady_state_of(const ResolvedCase& in) {
  integration::SteadyStateOptions out;
  out.observed_windows = in.integer("simulation.observed_revolutions");
  out.most_windows = in.integer("simulation.most_revolutions");
  out.load_drift = in.number("simulation.load_drift");
  out.cage_drift = in.number("simulation.cage_drift");
  out.allowed_length_error = in.quantity("simulation.length_error");
  out.integration.method = in.choice("simulation.integrator") == "dopri5"
                               ? integration::Method::dopri5
                               : integration::Method::linearly_implicit;
  return out;
}

study::PlanetaryDrivetrain quasi_static_drivetrain(const ResolvedCase& in) {
  return {.set = set_of(in),
          .drive = {.member = member_of(in.choice("input.member")),
                    .power = in.quantity("input.power"),
                    .speed = in.quantity("input.speed")},
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

void add_motion(const study::BearingDuty& duty, std::vector<Derived>& rows) {
  rows.push_back({"operation.carrier_speed", kRpm * duty.gears.carrier_speed, "rpm", "Willis"});
  rows.push_back({"operation.planet_speed", kRpm * duty.gears.planet_speed_relative, "rpm",
                  "relative to the carrier; negative: against carrier rotation"});
  rows.push_back({"operation.input_torque_sun", duty.gears.sun_torque, "N.m", "on the sun"});
  rows.push_back({"operation.mesh_normal_force", duty.gears.normal_force, "N", "one mesh of one planet"});
  rows.push_back({"operation.bore_load_x", duty.point.bore_load.x(), "N",
                  "gears and planet on one bearing, outward; cage and rollers not included"});
  rows.push_back(
      {"operation.bore_load_y", duty.point.bore_load.y(), "N", "the same, in the sense of rotation"});
}

void add_bearing(const study::DrivetrainGeometry& geometry, std::vector<Derived>& rows) {
  const bearing::RollerBearingGeometry& g = geometry.bearing;
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
          .cage = cage_of(in)};
}

study::PlanetaryDrivetrain drivetrain_of(const ResolvedCase& in) {
  study::PlanetaryDrivetrain out = quasi_static_drivetrain(in);
  out.dynamics = dynamics_of(in);
  out.dynamics.cage = cage_dynamics_of(in);
  out.steady_state = steady_state_of(in);
  return out;
}

std::vector<Derived> derived_quantities(const study::PlanetaryDrivetrain& drivetrain,
                                        const study::DrivetrainGeometry& geometry) {
  std::vector<Derived> rows;
  add_gears(drivetrain, geometry, rows);
  add_bearing(geometry, rows);
  add_motion(study::bearing_duty(drivetrain, geometry), rows);
  return rows;
}

std::vector<std::string> gear_warnings(const study::DrivetrainGeometry& geometry) {
  std::vector<std::string> texts;
  for (const gearset::Warning& warning : gearset::tooth_warnings(geometry.gears))
    texts.push_back(warning.place + ": " + warning.text);
  return texts;
}

}  // namespace orbearing::app
