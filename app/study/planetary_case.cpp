#include "app/study/planetary_case.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include "app/case/arrangement_case.hpp"
#include "app/case/bearing_type.hpp"
#include "app/case/catalogue_case.hpp"
#include "app/case/check_table.hpp"
#include "app/case/defect_case.hpp"
#include "app/case/described_case.hpp"
#include "app/case/set_case.hpp"
#include "app/case/use_conditions.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/mesh_study.hpp"
#include "app/units.hpp"
#include "bearing/equilibrium/inclined_rows.hpp"
#include "bearing/life/inclined_rating.hpp"
#include "bearing/profile/profile.hpp"
#include "coupling/study/tilting_planet.hpp"
#include "gearset/drivetrain/power_flow.hpp"
#include "gearset/planet_angles.hpp"
#include "gearset/stepped_planet.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

// Those at which teeth fit, on which stated ones are rounded.
void add_planet_angles(const gearset::PlanetarySet& set, std::vector<Derived>& rows) {
  std::vector<double> angles = gearset::angles_of_planets(set);
  angles.push_back(angles.front() + 2.0 * constants::pi);
  double least = angles.back(), most = 0.0;
  for (std::size_t n = 0; n + 1 < angles.size(); ++n) {
    least = std::min(least, angles[n + 1] - angles[n]);
    most = std::max(most, angles[n + 1] - angles[n]);
  }
  const std::string path = "gearset.planet_angle";
  if (!gearset::is_unequally_spaced(set)) {
    rows.push_back({path, kDegree * most, "deg", "between neighbouring planets"});
    return;
  }
  rows.push_back({path + ".least", kDegree * least, "deg", "between neighbouring planets"});
  rows.push_back({path + ".most", kDegree * most, "deg", "between neighbouring planets"});
}

// Quantities of one planet of a pair and its own meshes; the mesh of both belongs to the second.
void add_planet_of_pair(const study::PlanetaryDrivetrain& drivetrain,
                        const study::DrivetrainGeometry& geometry, std::vector<Derived>& rows) {
  const gearset::PlanetOfPair& planet = *drivetrain.of_pair;
  const gearset::PlanetPairGeometry pair = gearset::planet_pair_geometry(drivetrain.set, planet.pair);
  const auto add_mesh = [&](const char* name, const gearset::MeshGeometry& mesh) {
    const std::string path = std::string("gearset.") + name;
    rows.push_back({path + ".pressure_angle", kDegree * mesh.working_pressure_angle, "deg", "working"});
    rows.push_back({path + ".contact_ratio", mesh.contact_ratio, "1", "where the involutes end"});
  };
  rows.push_back({"gearset.centre_distance", per_milli * geometry.gears.centre_distance, "mm",
                  "of the planet's axis from the sun's"});
  if (planet.second) {
    add_mesh("planet_mesh", pair.planet_mesh);
    add_mesh("ring_mesh", pair.ring_mesh);
    rows.push_back({"gearset.planet_distance", per_milli * pair.between, "mm", "axes of both planets"});
    rows.push_back({"gearset.pair_angle", kDegree * pair.angle, "deg",
                    "from the first planet to the second round the carrier"});
  } else {
    add_mesh("sun_mesh", pair.sun_mesh);
  }
  rows.push_back(
      {"gearset.planet_mass", geometry.planet_mass, "kg", "gear body and outer rings of its bearings"});
}

void add_gears(const study::PlanetaryDrivetrain& drivetrain, const study::DrivetrainGeometry& geometry,
               std::vector<Derived>& rows) {
  if (drivetrain.of_pair) return add_planet_of_pair(drivetrain, geometry, rows);
  const gearset::WorkingGeometry& gears = geometry.gears;
  rows.push_back(
      {"gearset.centre_distance", 1e3 * gears.centre_distance, "mm", "working, common to both meshes"});
  constexpr double round_off = 1e-12;
  rows.push_back({"gearset.profile_shift.planet",
                  std::abs(gears.planet_shift) < round_off ? 0.0 : gears.planet_shift, "1",
                  "from the common centre distance"});
  rows.push_back(
      {"gearset.sun_mesh.pressure_angle", kDegree * gears.sun_mesh.working_pressure_angle, "deg", "working"});
  rows.push_back({"gearset.ring_mesh.pressure_angle", kDegree * gears.ring_mesh.working_pressure_angle, "deg",
                  "working"});
  rows.push_back(
      {"gearset.sun_mesh.contact_ratio", gears.sun_mesh.contact_ratio, "1", "where the involutes end"});
  rows.push_back(
      {"gearset.ring_mesh.contact_ratio", gears.ring_mesh.contact_ratio, "1", "where the involutes end"});
  if (drivetrain.set.helix_angle != 0.0) {
    rows.push_back({"gearset.transverse_module",
                    1e3 * drivetrain.set.module / std::cos(drivetrain.set.helix_angle), "mm",
                    "normal module / cos(helix angle)"});
    rows.push_back(
        {"gearset.base_helix_angle", kDegree * gears.base_helix_angle, "deg", "at the base cylinders"});
    rows.push_back({"gearset.overlap_ratio", gears.overlap_ratio, "1", "face width in axial pitches"});
  }
  for (Derived& row : circle_quantities("gearset.", gear_circles(gears))) rows.push_back(std::move(row));
  if (gears.second)
    rows.push_back({"gearset.stepped_planet.length", per_milli * gearset::gear_planes(drivetrain.set).length,
                    "mm", "of a planet with both gears, from whose middle the places of bearings count"});
  add_planet_angles(drivetrain.set, rows);
  rows.push_back(
      {"gearset.planet_mass", geometry.planet_mass, "kg", "gear body and outer rings of its bearings"});
}

void add_motion(const gearset::PlanetarySet& set, const gearset::MeanLoads& gears,
                std::vector<Derived>& rows) {
  rows.push_back({"operation.carrier_speed", kRpm * gears.carrier_speed, "rpm", "Willis"});
  rows.push_back({"operation.planet_speed", kRpm * gears.planet_speed_relative, "rpm",
                  "relative to the carrier; negative: against carrier rotation"});
  rows.push_back({"operation.input_torque_sun", gears.sun_torque, "N.m", "on the sun"});
  rows.push_back(
      {"operation.mesh_normal_force", gears.normal_force, "N", "one mesh of one planet, transverse"});
  if (set.stepped.present()) {
    rows.push_back({"operation.ring_mesh_normal_force", gears.ring_normal_force, "N",
                    "one ring mesh of one planet, at its second gear"});
    rows.push_back(
        {"operation.couple.outward", gears.couple_outward, "N.m",
         "of both meshes about the middle of a planet: leans its axis outward at positive places"});
    rows.push_back({"operation.couple.ahead", gears.couple_ahead, "N.m",
                    "the same in the sense of the carrier's rotation"});
  }
  if (gears.axial_force == 0.0) return;
  rows.push_back({"operation.mesh_axial_force", gears.axial_force, "N",
                  "sun on one planet, along the carrier's axis; the ring's is opposite"});
  rows.push_back({"operation.overturning_moment", gears.overturning_moment, "N.m",
                  "of both on one planet, about the tangential axis"});
  const gearset::AxialReactions held = gearset::axial_reactions(set, gears);
  rows.push_back({"operation.thrust.sun", held.sun, "N", "from the housing on the sun"});
  rows.push_back({"operation.thrust.carrier", held.carrier, "N", "from the housing on the carrier"});
  rows.push_back({"operation.thrust.ring", held.ring, "N", "from the housing on the ring"});
}

void add_motor_speed(const gearset::Drive& drive, std::vector<Derived>& rows) {
  if (drive.speed_of != gearset::SpeedOf::motor)
    rows.push_back({"operation.motor_speed", kRpm * drive.motor_speed(), "rpm",
                    "of the shaft by which the power enters, from input.speed of input.speed_of"});
}

void add_duty(const study::PlanetaryDrivetrain& drivetrain, const study::BearingDuty& duty,
              std::vector<Derived>& rows) {
  add_motion(drivetrain.set, duty.gears, rows);
  add_motor_speed(drivetrain.drive, rows);
  const std::string whose =
      drivetrain.uneven_planets ? "; planets carry unlike loads, this is their mean" : "";
  rows.push_back({"operation.bore_load_x", duty.point.bore_load.x(), "N",
                  "gears and planet on one bearing, outward; cage and rollers not included" + whose});
  rows.push_back(
      {"operation.bore_load_y", duty.point.bore_load.y(), "N", "the same, in the sense of rotation" + whose});
}

void add_profile(const bearing::Bearing& bearing, std::vector<Derived>& rows) {
  if (!bearing.has_rollers() || bearing.rollers().laminae == 0) return;
  const double half = 0.5 * bearing.rollers().length;
  rows.push_back(
      {"bearing.profile.outermost_drop",
       1e6 * bearing::profile::drop(bearing.rollers().profile, bearing::profile::kDropPosition * half), "um",
       "relief of one roller at 39/40 of half its length"});
}

void add_bearing(const study::PlanetaryDrivetrain& drivetrain, const study::DrivetrainGeometry& geometry,
                 std::vector<Derived>& rows) {
  const bearing::BearingGeometry& g = geometry.bearing;
  add_profile(drivetrain.bearing, rows);
  rows.push_back(
      {"bearing.inner_raceway_diameter", 2e3 * g.inner_radius, "mm", "pitch - roller - half clearance"});
  rows.push_back(
      {"bearing.outer_raceway_diameter", 2e3 * g.outer_radius, "mm", "pitch + roller + half clearance"});
  if (drivetrain.bearing.has_rollers())
    rows.push_back({"bearing.roller_mass", 1e3 * g.element_mass, "g", "one roller"});
  if (drivetrain.rows.is_tapered())
    rows.push_back(
        {"bearing.rows.roller_included_angle",
         kDegree * bearing::taper_of(drivetrain.bearing.element_diameter(), drivetrain.bearing.pitch_diameter,
                                     drivetrain.rows.contact_angle),
         "deg", "of a tapered roller, whose races meet on the bearing's axis"});
  if (std::isfinite(geometry.rim_over_module))
    rows.push_back({"gearset.rim_over_module", geometry.rim_over_module, "1",
                    "rim of a planet between roots and bore, in normal modules"});
  if (drivetrain.bearing.has_cage())
    rows.push_back({"bearing.cage.mass", 1e3 * g.cage_mass, "g", "ring less pockets"});
  const bearing::rating::StatedRatings& stated = drivetrain.rated.stated;
  const bearing::rating::Ratings& ratings = geometry.rating.ratings;
  if (!stated.dynamic_capacity)
    rows.push_back({"bearing.dynamic_capacity", ratings.dynamic_capacity, "N", "C of ISO 281"});
  if (!stated.static_capacity)
    rows.push_back({"bearing.static_capacity", ratings.static_capacity, "N", "C_0 of ISO 76"});
  if (!stated.fatigue_load_limit)
    rows.push_back({"bearing.fatigue_load_limit", ratings.fatigue_load_limit, "N", "C_u of ISO 281, by C_0"});
}

// From the shelf to the running bearing, and how it runs at each swept speed.
void add_clearance(const ResolvedCase& resolved, const study::NamedSet& set, std::vector<Derived>& rows) {
  if (set.drivetrain.mounting.state == bearing::ClearanceState::operating) return;
  const auto add = [&](const std::string& path, double value, double per_unit, const char* unit,
                       const std::string& meaning) {
    rows.push_back({"bearing.clearance." + path, per_unit * value, unit, meaning});
  };
  const bearing::ClearanceChain chain = study::clearance_chain(set.drivetrain);
  add("unmounted", chain.unmounted, per_micro, "um", "before mounting");
  add("after_fits", chain.fitted, per_micro, "um", "mounted, cold, at rest");
  add("at_temperatures", chain.warm, per_micro, "um", "the same, warm");
  add("operating", chain.operating, per_micro, "um",
      "the same, at the case's speed: that of the computation");
  add("inner_seat_pressure", chain.inner_pressure, per_mega, "MPa",
      "between pin and inner ring in operation; 0: they separate");
  add("outer_seat_pressure", chain.outer_pressure, per_mega, "MPa",
      "between outer ring and planet in operation; 0: they separate");
  constexpr std::size_t most_speeds = 24;
  for (const SweepAxis& axis : resolved.axes()) {
    if (axis.path != kSpeedPath || axis.values.size() > most_speeds) continue;
    for (std::size_t i = 0; i < axis.values.size(); ++i) {
      study::NamedSet there = set;
      study::turn_at(axis.numbers[i], there.drivetrain, there.geometry);
      add("operating", there.drivetrain.bearing.radial_clearance, per_micro, "um", "at " + axis.values[i]);
    }
  }
}

bool states_any(const ResolvedCase& in, const std::string& set, std::initializer_list<const char*> paths) {
  return std::any_of(paths.begin(), paths.end(), [&](const char* path) { return in.has(set + path); });
}

}  // namespace

std::vector<std::string> cage_warnings(const ResolvedCase& resolved) {
  std::vector<std::string> warnings;
  for (const std::string& set : prefixes_of_sets(resolved)) {
    const std::string land = set + "bearing.cage.guide_land_diameter";
    if (!resolved.has(set + "bearing.cage.inner_diameter") || !resolved.has(land) ||
        resolved.quantity(land) != 0.0 || is_full_complement(resolved, set))
      continue;
    warnings.push_back(land +
                       ": 0; in motion (--fidelity dynamic and above) no land guides the cage. Only its "
                       "pockets hold it, and it may leave the bearing");
  }
  return warnings;
}

std::vector<std::string> prefixes_of_sets(const ResolvedCase& resolved) {
  if (!resolved.shape().several) return {""};
  std::vector<std::string> prefixes;
  for (const std::string& set : resolved.shape().sets) prefixes.push_back(set_prefix(set));
  return prefixes;
}

std::vector<std::string> clearance_warnings(const ResolvedCase& resolved) {
  std::vector<std::string> warnings;
  for (const std::string& set : prefixes_of_sets(resolved)) {
    const std::string state = set + "bearing.clearance_state";
    if (!resolved.has(state) || resolved.choice(state) != "unmounted") continue;
    if (!states_any(resolved, set, {"bearing.fit.inner_interference", "bearing.fit.outer_interference"}))
      warnings.push_back(set +
                         "bearing.fit: no interference given; the seats are assumed neither tight nor loose");
    if (!states_any(
            resolved, set,
            {"bearing.temperature.pin", "bearing.temperature.inner_ring", "bearing.temperature.rollers",
             "bearing.temperature.outer_ring", "bearing.temperature.planet"}))
      warnings.push_back(set + "bearing.temperature: not given; all bodies are assumed at 20 degC");
  }
  return warnings;
}

namespace {

// Built at its first use, from any thread: teeth take a while, and each analysis uses them again.
std::function<gearset::dynamics::SetParameters()> gears_built_once(
    const ResolvedCase& in, const study::PlanetaryDrivetrain& drivetrain,
    const std::optional<study::DrivetrainGeometry>& known = {}) {
  struct Built {
    std::once_flag once;
    gearset::dynamics::SetParameters set;
  };
  return [in, drivetrain, known, built = std::make_shared<Built>()] {
    std::call_once(built->once, [&] { built->set = gear_model_of(in, drivetrain, known).parameters; });
    return built->set;
  };
}

// How the housing holds the carrier, where it is taken as a body. Throws BadInput where lists do not fit.
std::optional<gearset::spatial::CarrierMounting> carrier_mounting_of(const ResolvedCase& in) {
  if (!carrier_is_body(in, "")) return std::nullopt;
  const auto mounting = from_case<gearset::spatial::CarrierMounting>(in);
  try {
    study::require_sound(mounting);
  } catch (const std::invalid_argument& error) {
    throw BadInput(in.file() + ": " + error.what());
  }
  return mounting;
}

}  // namespace

std::vector<std::string> overturning_warnings(const ResolvedCase& resolved) {
  std::vector<std::string> warnings;
  if (!is_helical(resolved)) return warnings;
  for (const study::NamedSet& set : bearing_sets(resolved)) {
    const study::PlanetaryDrivetrain& drivetrain = set.drivetrain;
    if (drivetrain.set.helix_angle == 0.0 || drivetrain.seats.tilt == study::TiltState::computed ||
        !drivetrain.rows.is_cylindrical())  // in the equilibrium
      continue;
    const gearset::MeanLoads gears = study::bearing_duty(drivetrain, set.geometry).gears;
    const std::vector<double> positions = study::axial_positions(drivetrain);
    double squares = 0.0;  // [m^2]  bearings on a stiff pin share a moment as their places
    for (const double position : positions) squares += position * position;
    const double moment = std::abs(gears.overturning_moment);
    const std::string as_loads =
        squares > 0.0
            ? fmt::format(
                  "{:.4g} N outward at one end and inward at the other on the outer bearings at "
                  "{:.4g} and {:.4g} mm",
                  moment * positions.back() / squares, 1e3 * positions.front(), 1e3 * positions.back())
            : std::string("a moment on the one bearing");
    warnings.push_back(
        fmt::format("{}gearset.helix_angle: the axial forces tilt a planet by a moment of {:.4g} N m at the "
                    "case's input. The support of the tilt is assumed to carry this moment. On bearings on a "
                    "stiff pin it is {}. Both meshes load each bearing with {:.4g} N. bearing.tilt_state: "
                    "computed includes the moment in the equilibrium",
                    set.name.empty() ? "" : set_prefix(set.name), moment, as_loads,
                    std::hypot(gears.tangential_force, gears.radial_force) / drivetrain.bearings_per_planet));
  }
  return warnings;
}

std::vector<std::string> slope_warnings(const ResolvedCase& in) {
  std::vector<std::string> warnings;
  const char* tilt = "bearing.tilt_state";
  if (!in.has(tilt) || in.choice(tilt) != "computed") return warnings;
  for (const std::string path : {"gearset.lead_slope.sun", "gearset.lead_slope.ring"})
    if (in.has(path) && in.quantity(path) != 0.0)
      warnings.push_back(path + ": " + in.given(path) +
                         " moves the force of the teeth along the face; its moment on a planet is not "
                         "modelled, so that the computed tilt is too small");
  return warnings;
}

study::PlanetaryDrivetrain drivetrain_of(const ResolvedCase& in) {
  study::PlanetaryDrivetrain out = drivetrain_without_gear_set(in);
  if (has_planet_bearing(in)) out.gear_set = gears_built_once(in, out);
  return out;
}

namespace {

// Names of planets in pairs, which are modelled as two sets that share the power.
const std::vector<std::string> kPairNames{"first_planet", "second_planet"};

std::vector<study::NamedSet> planets_of_pairs(const ResolvedCase& resolved) {
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(resolved));
  std::vector<study::NamedSet> planets;
  for (const std::string& name : kPairNames) {
    study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(resolved);
    drivetrain.of_pair = {second_planet_of(resolved), name == kPairNames.back()};
    drivetrain.in_arrangement = flow.sets.front();
    drivetrain.mesh_variation = false;
    const study::DrivetrainGeometry geometry = study::derive(drivetrain);
    planets.push_back({name, std::move(drivetrain), geometry});
  }
  return planets;
}

}  // namespace

std::vector<std::string> bearing_set_names(const ResolvedCase& resolved) {
  if (has_planet_pairs(resolved)) return kPairNames;
  std::vector<std::string> names;
  for (const std::string& set : resolved.shape().sets)
    if (has_planet_bearing(resolved, set_prefix(set))) names.push_back(set);
  return names;
}

namespace {

// One of several, without its gears.
study::PlanetaryDrivetrain arranged_drivetrain(const ResolvedCase& resolved, const ResolvedCase& of_set,
                                               const std::string& name, const gearset::PowerFlow& flow) {
  const std::vector<std::string>& all = resolved.shape().sets;
  study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(of_set);
  drivetrain.drive = drive_of(resolved);
  drivetrain.in_arrangement = flow.sets[static_cast<std::size_t>(std::ranges::find(all, name) - all.begin())];
  study::mount(drivetrain);
  return drivetrain;
}

}  // namespace

study::PlanetaryDrivetrain scratched_drivetrain_of(const ResolvedCase& resolved) {
  if (!resolved.shape().several) return drivetrain_of(resolved);
  const std::string& name = resolved.text(kScratchedSet);
  const ResolvedCase of_set = resolved.of_set(name);
  study::PlanetaryDrivetrain drivetrain =
      arranged_drivetrain(resolved, of_set, name, gearset::power_flow(arrangement_of(resolved)));
  drivetrain.set.fixed_member = held_member_of(resolved, name).value();
  drivetrain.gear_set = gears_built_once(of_set, drivetrain);
  return drivetrain;
}

std::vector<study::NamedSet> bearing_sets(const ResolvedCase& resolved) {
  if (has_planet_pairs(resolved)) return planets_of_pairs(resolved);
  if (!resolved.shape().several) {
    study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(resolved);
    const study::DrivetrainGeometry geometry = study::derive(drivetrain);
    if (resolved.has("bearing.rollers"))
      drivetrain.gear_set = gears_built_once(resolved, drivetrain, geometry);
    drivetrain.carrier_mounting = carrier_mounting_of(resolved);
    return {{"", std::move(drivetrain), geometry}};
  }
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(resolved));
  std::vector<study::NamedSet> sets;
  for (const std::string& name : bearing_set_names(resolved)) {
    const ResolvedCase of_set = resolved.of_set(name);
    study::PlanetaryDrivetrain drivetrain = arranged_drivetrain(resolved, of_set, name, flow);
    drivetrain.mesh_variation = false;  // gears of several sets do not move yet: they share loads at rest
    drivetrain.gear_set = gears_built_once(of_set, drivetrain);
    const study::DrivetrainGeometry geometry = study::derive(drivetrain);
    sets.push_back({name, std::move(drivetrain), geometry});
  }
  return sets;
}

namespace {

gearset::WorkingGeometry add_gears_alone(const study::PlanetaryDrivetrain& drivetrain,
                                         std::vector<Derived>& rows) {
  study::DrivetrainGeometry geometry;
  geometry.gears = gearset::working_geometry(drivetrain.set);
  geometry.planet_mass = gearset::planet_body(drivetrain.set, geometry.gears).mass;
  add_gears(drivetrain, geometry, rows);
  return geometry.gears;
}

// With the load that a pin takes from its planet.
void add_motion_without_bearing(const study::PlanetaryDrivetrain& drivetrain,
                                const gearset::WorkingGeometry& gears, const gearset::MeanLoads& loads,
                                std::vector<Derived>& rows) {
  add_motion(drivetrain.set, loads, rows);
  const double outward = gearset::planet_body(drivetrain.set, gears).mass * loads.carrier_speed *
                         loads.carrier_speed * gears.centre_distance;
  rows.push_back({"operation.pin_load_x", loads.radial_force + outward, "N",
                  "both meshes and the planet's gear on its pin, outward"});
  rows.push_back({"operation.pin_load_y", loads.tangential_force, "N", "the same, in the sense of rotation"});
}

std::vector<Derived> quantities_without_bearing(const ResolvedCase& resolved) {
  std::vector<Derived> rows;
  if (!resolved.shape().teeth) return rows;
  const study::PlanetaryDrivetrain drivetrain = drivetrain_of(resolved);
  const gearset::WorkingGeometry gears = add_gears_alone(drivetrain, rows);
  add_motion_without_bearing(drivetrain, gears, gearset::mean_loads(drivetrain.set, gears, drivetrain.drive),
                             rows);
  add_motor_speed(drivetrain.drive, rows);
  return rows;
}

// Quantities of the sets without a bearing, in a case of several sets.
void add_sets_without_bearing(const ResolvedCase& resolved, std::vector<Derived>& rows) {
  if (!resolved.shape().several) return;
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(resolved));
  const std::vector<std::string>& names = resolved.shape().sets;
  for (std::size_t set = 0; set < names.size(); ++set) {
    const std::string& name = names[set];
    if (has_planet_bearing(resolved, set_prefix(name))) continue;
    std::vector<Derived> of_set;
    const study::PlanetaryDrivetrain drivetrain = drivetrain_of(resolved.of_set(name));
    const gearset::WorkingGeometry gears = add_gears_alone(drivetrain, of_set);
    add_motion_without_bearing(drivetrain, gears,
                               gearset::mean_loads(drivetrain.set, gears, flow.sets[set], drive_of(resolved)),
                               of_set);
    for (Derived& row : of_set)
      rows.push_back({set_prefix(name) + row.path, row.value, row.unit, row.meaning});
  }
}

// [m]  IT7 of ISO 286-1: 16 i, i = 0.45 D^(1/3) + 0.001 D in um, D in mm.
double tolerance_grade_7(double size) {
  const double mm = per_milli * size;
  return 16e-6 * (0.45 * std::cbrt(mm) + 0.001 * mm);
}

// Effect of uneven load sharing: one pin off by js7 at the centre distance. No rows where the case states its
// errors, or where planets that carry unequal loads are refused.
void add_load_sharing(const ResolvedCase& in, const study::NamedSet& set, std::vector<Derived>& rows) {
  const std::string path = "gearset.dynamics.pin_error.tangential";
  if (in.shape().several || set.drivetrain.uneven_planets || in.has("gearset.planet_angles") ||
      has_stepped_planets(in) || has_planet_pairs(in))
    return;
  const double error = 0.5 * tolerance_grade_7(set.geometry.gears.centre_distance);
  std::string errors = fmt::format("[{:.6g} um", per_micro * error);
  for (int planet = 1; planet < set.drivetrain.set.planets; ++planet) errors += ", 0 um";
  try {
    const char* tilt = "bearing.tilt_state";
    const bool tilts = in.has(tilt) && in.choice(tilt) == "computed";
    // The pin remains the same, though its ends have an effect only where tilts are computed.
    const std::string pin = fmt::format("{:.17g} N/m", set.drivetrain.dynamics.support.stiffness);
    const ResolvedCase aligned =
        tilts ? in.with(tilt, std::string("stated")).with("support.stiffness", pin) : in;
    std::vector<study::NamedSet> one_off = bearing_sets(aligned.with(path, errors + "]"));
    one_off.front().drivetrain.carrier_mounting.reset();
    const study::PointResult point = study::evaluate(one_off);
    if (point.planets.empty()) return;
    const std::string off =
        fmt::format("with one pin off by {:.2g} um (js7 of ISO 286-1), planets on springs{}",
                    per_micro * error, tilts ? "; without the computed tilt" : "");
    const auto largest = std::ranges::max_element(point.planets, {}, &study::PlanetResult::load_share);
    rows.push_back({"one_pin_off.load_share", largest->load_share, "1",
                    "K_gamma: load of the most loaded planet over the mean " + off});
    if (tilts) return;  // the life includes the tilt
    const bearing::rating::Life life = governing_life(in);
    double shortest = std::numeric_limits<double>::infinity();
    for (const study::PlanetResult& planet : point.planets)
      shortest = std::min(shortest, bearing::rating::hours_of(life, planet.life_hours, planet.rated_hours));
    rows.push_back({"one_pin_off.shortest_life", shortest, "h",
                    std::string(bearing::rating::hours_key(life)) + " of the most loaded bearing " + off});
  } catch (const BadInput&) {  // where such a pin is refused
  }
}

}  // namespace

namespace {

std::vector<Derived> quantities_of_sets(const ResolvedCase& resolved) {
  if (!resolved.shape().several && !resolved.shape().bearing) return quantities_without_bearing(resolved);
  std::vector<Derived> rows;
  for (const study::NamedSet& set : bearing_sets(resolved)) {
    std::vector<Derived> of_set;
    add_gears(set.drivetrain, set.geometry, of_set);
    add_bearing(set.drivetrain, set.geometry, of_set);
    const auto add = [&](const char* path, const auto& add_rows) {
      const std::vector<Derived> more = or_reason(path, [&] {
        std::vector<Derived> own;
        add_rows(own);
        return own;
      });
      of_set.insert(of_set.end(), more.begin(), more.end());
    };
    add("bearing.clearance", [&](std::vector<Derived>& own) { add_clearance(resolved, set, own); });
    add("operation", [&](std::vector<Derived>& own) {
      add_duty(set.drivetrain, study::bearing_duty(set.drivetrain, set.geometry), own);
    });
    add("one_pin_off", [&](std::vector<Derived>& own) { add_load_sharing(resolved, set, own); });
    if (!resolved.has("support.stiffness"))  // of several sets, each has its own pin
      of_set.push_back({"support.stiffness", set.drivetrain.dynamics.support.stiffness, "N/m",
                        "of the pin at one bearing, from its dimensions"});
    for (Derived& row : of_set) {
      if (!set.name.empty()) row.path = set_prefix(set.name) + row.path;
      rows.push_back(std::move(row));
    }
  }
  add_sets_without_bearing(resolved, rows);
  return rows;
}

// Load speed and overall ratio with parallel stages; without them the ratio is that of the sets.
void add_overall_ratio(const ResolvedCase& resolved, std::vector<Derived>& rows) {
  if (!resolved.shape().several && !resolved.shape().teeth) return;
  const gearset::Arrangement arrangement = arrangement_of(resolved);
  if (std::ranges::none_of(arrangement.sets, &gearset::ArrangedSet::is_parallel)) return;
  const auto load = std::ranges::find_if(arrangement.shafts, &gearset::Shaft::load);
  const gearset::ShaftFlow flow =
      gearset::power_flow(arrangement).shafts.at(static_cast<std::size_t>(load - arrangement.shafts.begin()));
  rows.push_back({"operation.load_speed", kRpm * flow.speed * drive_of(resolved).motor_speed(), "rpm",
                  "of the shaft by which the power leaves, behind all stages"});
  rows.push_back({"operation.overall_ratio", flow.speed, "1",
                  "speed of the load over that of the motor, all stages; negative: against it"});
}

}  // namespace

std::vector<Derived> derived_quantities(const ResolvedCase& resolved) {
  std::vector<Derived> rows = quantities_of_sets(resolved);
  add_overall_ratio(resolved, rows);
  return rows;
}

void describe_power(described::Record& record, const ResolvedCase& resolved) {
  using namespace described;
  const gearset::Arrangement arrangement = arrangement_of(resolved);
  const gearset::PowerFlow flow = gearset::power_flow(arrangement);
  const gearset::Drive drive = drive_of(resolved);
  const double speed = drive.motor_speed(), power = drive.power;
  record.table("power_flow", "member", "speeds, torques and power of all members", flow.members,
               [&](Record& row, const gearset::MemberFlow& of) {
                 const gearset::ArrangedSet& set = arrangement.sets[of.member.set];
                 row.value("set", "of gears", set.name);
                 row.value("member", "of the set", gearset::member_word(set, of.member.member));
                 row.value("shaft", "that carries it", arrangement.shafts[of.shaft].name);
                 row.value("speed_rpm", dimension::angular_speed, "of the member", speed * of.speed);
                 row.value("torque_N_m", dimension::torque, "from the shaft on the member",
                           power / speed * of.torque);
                 row.value("power_W", dimension::heat, "positive where it enters the set", power * of.power);
                 row.value("share", dimension::ratio, "of the input power", of.power);
               });
  if (const std::vector<std::size_t> idle = gearset::idle_sets(flow); !idle.empty())
    record.value("idle_sets", "that transmit no torque",
                 each(idle, [&](std::size_t set) { return arrangement.sets[set].name; }));
  record.child(
      "power_circulation", "members that carry more than the input", gearset::power_circulation(flow),
      [&](Record& circulation, const gearset::PowerCirculation& of) {
        circulation.value("present", "whether power circulates", of.present());
        circulation.value("largest_share", dimension::ratio,
                          "of the input power, carried by one member; without losses, which act on all that "
                          "circulates and so change torques by that many times their share",
                          of.largest_share);
        circulation.value(
            "members", "that carry more than the input",
            each(of.members, [&](const gearset::SetMember& member) { return name_of(arrangement, member); }));
      });
}

namespace {

// Along the roller whose most loaded lamina carries most on the inner race.
std::vector<double> pressures_along(const study::NamedSet& set, const study::LaminaRecord& laminae,
                                    const std::vector<double>& loads, bearing::Race race) {
  const bearing::Bearing& bearing = set.drivetrain.bearing;
  const bearing::PlanetRows& rows = set.drivetrain.rows;
  const bearing::BearingGeometry geometry =
      rows.is_cylindrical() ? set.geometry.bearing
                            : bearing::geometry_of(bearing::rating::upright(bearing, rows));
  const auto count = static_cast<std::ptrdiff_t>(laminae.lamina_position.size());
  const auto most = std::ranges::max_element(laminae.inner_load) - laminae.inner_load.begin();
  std::vector<double> pressures;
  for (std::ptrdiff_t k = 0; k < count; ++k)
    pressures.push_back(bearing::hertz_pressure(
        static_cast<double>(count) * loads[static_cast<std::size_t>(most / count * count + k)],
        bearing::equivalent_radius(geometry, race), bearing.rollers().length, bearing.material));
  return pressures;
}

}  // namespace

std::vector<RollerLoads> roller_loads(const ResolvedCase& resolved) {
  std::vector<RollerLoads> all;
  for (study::NamedSet& set : bearing_sets(resolved)) {
    set.drivetrain.carrier_mounting.reset();  // it moves no roller of the set's plane
    study::PointResult point = study::evaluate(set.drivetrain, set.geometry, study::Fidelity::quasi_static);
    all.push_back({std::move(set), std::move(point)});
  }
  return all;
}

void describe(described::Record& row, const RollerLoads& loads) {
  using namespace described;
  const study::LoadDistribution& by_position = loads.point.distribution;
  row.value("set", "of gears; empty in a case of one set", loads.set.name);
  row.array("angle_deg", dimension::angle,
            "position in the load zone, from the outward radial direction towards carrier rotation",
            {"position"}, by_position.angle);
  row.array("inner_load_N", dimension::force, "load of a roller on the inner race", {"position"},
            by_position.inner_load);
  row.array("outer_load_N", dimension::force, "load of a roller on the outer race", {"position"},
            by_position.outer_load);
  const study::LaminaRecord laminae = loads.point.laminae.value_or(study::LaminaRecord{});
  row.array("along_mm", dimension::length,
            "middle of a lamina, from the middle of the roller; none of whole contacts", {"lamina"},
            laminae.lamina_position);
  row.array("inner_pressure_MPa", dimension::pressure,
            "pressure along the most loaded roller on the inner race, after Hertz", {"lamina"},
            pressures_along(loads.set, laminae, laminae.inner_load, bearing::Race::inner));
  row.array("outer_pressure_MPa", dimension::pressure,
            "pressure along the same roller on the outer race, after Hertz", {"lamina"},
            pressures_along(loads.set, laminae, laminae.outer_load, bearing::Race::outer));
}

void describe(described::Record& record, const std::vector<RollerLoads>& sets) {
  record.table("roller_loads", "set", "loads of the rollers of one bearing by position", sets);
}

}  // namespace orbearing::app
