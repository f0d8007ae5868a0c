#include "coupling/analysis/set_quantities.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>

#include "bearing/equilibrium/inclined_rows.hpp"
#include "bearing/profile/profile.hpp"
#include "coupling/analysis/set_meshes.hpp"
#include "gearset/planet_angles.hpp"
#include "gearset/stepped_planet.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

using described::Dimension;
using described::Record;
namespace dimension = described::dimension;

namespace {

// Result of `compute`, or why there is none.
template <class Compute>
auto computed_or_reason(const Compute& compute) -> Computed<typename decltype(compute())::value_type> {
  try {
    return {.value = compute()};
  } catch (const std::exception& error) {
    return {.failure = error.what()};
  }
}

std::optional<MountedClearance> mounted_clearance(const NamedSet& set,
                                                  const std::vector<NamedSpeed>& speeds) {
  if (set.drivetrain.mounting.state == bearing::ClearanceState::operating) return std::nullopt;
  MountedClearance found{clearance_chain(set.drivetrain)};
  for (const NamedSpeed& at : speeds) {
    NamedSet there = set;
    turn_at(at.speed, there.drivetrain, there.geometry);
    found.at_speeds.emplace_back(at.text, there.drivetrain.bearing.radial_clearance);
  }
  return found;
}

// [m]  IT7 of ISO 286-1: 16 i, i = 0.45 D^(1/3) + 0.001 D in um, D in mm.
double tolerance_grade_7(double size) {
  const double mm = 1e3 * size;
  return 16e-6 * (0.45 * std::cbrt(mm) + 0.001 * mm);
}

// js7, to six digits of a micrometre, as a drawing would state it. [m]
double pin_tolerance(double centre_distance) {
  constexpr int digits = 6;
  constexpr double per_micro = 1e6;
  const std::string text =
      mechanics::significant(per_micro * (0.5 * tolerance_grade_7(centre_distance)), digits);
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded / per_micro;
}

// Whether the errors of a pin may be varied: planets carry equal loads, and are ones that can carry others.
bool may_share_unevenly(const NamedSet& set) {
  const PlanetaryDrivetrain& drivetrain = set.drivetrain;
  return set.name.empty() && !drivetrain.uneven_planets && drivetrain.set.planet_angles.empty() &&
         !drivetrain.set.stepped.present() && !drivetrain.of_pair && drivetrain.rows.is_cylindrical();
}

std::optional<OnePinOff> one_pin_off(const NamedSet& set, SetGears gears) {
  if (!may_share_unevenly(set)) return std::nullopt;
  PlanetaryDrivetrain drivetrain = set.drivetrain;
  OnePinOff found{.error = pin_tolerance(set.geometry.gears.centre_distance),
                  .without_tilt = drivetrain.seats.tilt == TiltState::computed};
  gears.choice.pin_error_tangential.assign(static_cast<std::size_t>(drivetrain.set.planets), 0.0);
  gears.choice.pin_error_tangential.front() = found.error;
  drivetrain.uneven_planets = true;
  drivetrain.seats.tilt = TiltState::stated;
  drivetrain.carrier_mounting.reset();
  drivetrain.gear_set = gears_built_once(drivetrain, gears, set.geometry);
  try {
    drivetrain.gear_set();
  } catch (const std::domain_error&) {  // gears without a body, which other quantities report
    return std::nullopt;
  }
  const PointResult point = evaluate(drivetrain, set.geometry);
  if (point.planets.empty()) return std::nullopt;
  found.load_share = std::ranges::max_element(point.planets, {}, &PlanetResult::load_share)->load_share;
  found.governing =
      bearing::rating::governing_life(drivetrain.rated.method, drivetrain.rated.oil.has_value());
  found.shortest_life = std::numeric_limits<double>::infinity();
  for (const PlanetResult& planet : point.planets)
    found.shortest_life =
        std::min(found.shortest_life,
                 bearing::rating::hours_of(found.governing, planet.life_hours, planet.rated_hours));
  return found;
}

}  // namespace

SetQuantities quantities_of(const NamedSet& set, const SetGears& gears,
                            const std::vector<NamedSpeed>& speeds) {
  return {
      .set = set,
      .clearance = computed_or_reason([&] { return mounted_clearance(set, speeds); }),
      .duty = computed_or_reason([&] { return std::optional(bearing_duty(set.drivetrain, set.geometry)); }),
      .one_pin_off = computed_or_reason([&] { return one_pin_off(set, gears); })};
}

GearSetQuantities quantities_of_gears(const PlanetaryDrivetrain& drivetrain) {
  GearSetQuantities found{.drivetrain = drivetrain};
  found.geometry.gears = gearset::working_geometry(drivetrain.set);
  found.geometry.planet_mass = gearset::planet_body(drivetrain.set, found.geometry.gears).mass;
  found.loads = drivetrain.in_arrangement
                    ? gearset::mean_loads(drivetrain.set, found.geometry.gears, *drivetrain.in_arrangement,
                                          drivetrain.drive)
                    : gearset::mean_loads(drivetrain.set, found.geometry.gears, drivetrain.drive);
  return found;
}

namespace {

// Angles at which teeth fit, on which stated ones are rounded.
void describe_planet_angles(Record& record, const gearset::PlanetarySet& set) {
  std::vector<double> angles = gearset::angles_of_planets(set);
  angles.push_back(angles.front() + constants::two_pi);
  double least = angles.back(), most = 0.0;
  for (std::size_t n = 0; n + 1 < angles.size(); ++n) {
    least = std::min(least, angles[n + 1] - angles[n]);
    most = std::max(most, angles[n + 1] - angles[n]);
  }
  const auto add = [&](const char* key, double angle) {
    record.value(key, dimension::angle, "between neighbouring planets", angle);
  };
  if (!gearset::is_unequally_spaced(set)) return add("gearset.planet_angle_deg", most);
  add("gearset.planet_angle.least_deg", least);
  add("gearset.planet_angle.most_deg", most);
}

void describe_pressure_angle(Record& record, const std::string& mesh, const gearset::MeshGeometry& of) {
  record.value("gearset." + mesh + ".pressure_angle_deg", dimension::angle, "working",
               of.working_pressure_angle);
}
void describe_contact_ratio(Record& record, const std::string& mesh, const gearset::MeshGeometry& of) {
  record.value("gearset." + mesh + ".contact_ratio", dimension::ratio, "where the involutes end",
               of.contact_ratio);
}

void describe_planet_mass(Record& record, const DrivetrainGeometry& geometry) {
  record.value("gearset.planet_mass_kg", dimension::mass, "gear body and outer rings of its bearings",
               geometry.planet_mass);
}

// One planet of a pair and its own meshes; the mesh of both belongs to the second.
void describe_planet_of_pair(Record& record, const PlanetaryDrivetrain& drivetrain,
                             const DrivetrainGeometry& geometry) {
  const gearset::PlanetOfPair& planet = *drivetrain.of_pair;
  const gearset::PlanetPairGeometry pair = gearset::planet_pair_geometry(drivetrain.set, planet.pair);
  const auto add_mesh = [&](const char* name, const gearset::MeshGeometry& mesh) {
    describe_pressure_angle(record, name, mesh);
    describe_contact_ratio(record, name, mesh);
  };
  record.value("gearset.centre_distance_mm", dimension::length, "of the planet's axis from the sun's",
               geometry.gears.centre_distance);
  if (planet.second) {
    add_mesh("planet_mesh", pair.planet_mesh);
    add_mesh("ring_mesh", pair.ring_mesh);
    record.value("gearset.planet_distance_mm", dimension::length, "axes of both planets", pair.between);
    record.value("gearset.pair_angle_deg", dimension::angle,
                 "from the first planet to the second round the carrier", pair.angle);
  } else {
    add_mesh("sun_mesh", pair.sun_mesh);
  }
  describe_planet_mass(record, geometry);
}

void describe_helix(Record& record, const gearset::PlanetarySet& set, const gearset::WorkingGeometry& gears) {
  if (set.helix_angle == 0.0) return;
  constexpr Dimension in_millimetres{"length", "mm", "mm", ""};  // so that round modules stay round
  record.value("gearset.transverse_module_mm", in_millimetres, "normal module / cos(helix angle)",
               1e3 * set.module / std::cos(set.helix_angle));
  record.value("gearset.base_helix_angle_deg", dimension::angle, "at the base cylinders",
               gears.base_helix_angle);
  record.value("gearset.overlap_ratio", dimension::ratio, "face width in axial pitches", gears.overlap_ratio);
}

void describe_circles(Record& record, const GearCircles& gear) {
  const auto add = [&](const char* circle, double diameter, const char* meaning) {
    record.value("gearset." + gear.gear + "." + circle + "_diameter_mm", dimension::length, meaning,
                 diameter);
  };
  add("tip", gear.tip, "of the tip circle");
  add("reference", gear.reference, "of the reference circle");
  add("pitch", gear.pitch,
      gear.at_ring ? "of the working pitch circle in the sun mesh" : "of the working pitch circle");
  if (gear.at_ring) add("ring_pitch", *gear.at_ring, "of the working pitch circle in the ring mesh");
  add("base", gear.base, "of the base circle");
  add("root", gear.root, "of the root circle");
}

void describe_gears(Record& record, const PlanetaryDrivetrain& drivetrain,
                    const DrivetrainGeometry& geometry) {
  if (drivetrain.of_pair) return describe_planet_of_pair(record, drivetrain, geometry);
  const gearset::WorkingGeometry& gears = geometry.gears;
  constexpr double round_off = 1e-12;
  record.value("gearset.centre_distance_mm", dimension::length, "working, common to both meshes",
               gears.centre_distance);
  record.value("gearset.profile_shift.planet", dimension::ratio, "from the common centre distance",
               std::abs(gears.planet_shift) < round_off ? 0.0 : gears.planet_shift);
  describe_pressure_angle(record, "sun_mesh", gears.sun_mesh);
  describe_pressure_angle(record, "ring_mesh", gears.ring_mesh);
  describe_contact_ratio(record, "sun_mesh", gears.sun_mesh);
  describe_contact_ratio(record, "ring_mesh", gears.ring_mesh);
  describe_helix(record, drivetrain.set, gears);
  for (const GearCircles& gear : gear_circles(gears)) describe_circles(record, gear);
  if (gears.second)
    record.value("gearset.stepped_planet.length_mm", dimension::length,
                 "of a planet with both gears, from whose middle the places of bearings count",
                 gearset::gear_planes(drivetrain.set).length);
  describe_planet_angles(record, drivetrain.set);
  describe_planet_mass(record, geometry);
}

void describe_axial_forces(Record& record, const gearset::PlanetarySet& set,
                           const gearset::MeanLoads& loads) {
  if (loads.axial_force == 0.0) return;
  record.value("operation.mesh_axial_force_N", dimension::force,
               "sun on one planet, along the carrier's axis; the ring's is opposite", loads.axial_force);
  record.value("operation.overturning_moment_N_m", dimension::torque,
               "of both on one planet, about the tangential axis", loads.overturning_moment);
  const gearset::AxialReactions held = gearset::axial_reactions(set, loads);
  record.value("operation.thrust.sun_N", dimension::force, "from the housing on the sun", held.sun);
  record.value("operation.thrust.carrier_N", dimension::force, "from the housing on the carrier",
               held.carrier);
  record.value("operation.thrust.ring_N", dimension::force, "from the housing on the ring", held.ring);
}

void describe_loads(Record& record, const gearset::PlanetarySet& set, const gearset::MeanLoads& loads) {
  record.value("operation.carrier_speed_rpm", dimension::angular_speed, "Willis", loads.carrier_speed);
  record.value("operation.planet_speed_rpm", dimension::angular_speed,
               "relative to the carrier; negative: against carrier rotation", loads.planet_speed_relative);
  record.value("operation.input_torque_sun_N_m", dimension::torque, "on the sun", loads.sun_torque);
  record.value("operation.mesh_normal_force_N", dimension::force, "one mesh of one planet, transverse",
               loads.normal_force);
  if (set.stepped.present()) {
    record.value("operation.ring_mesh_normal_force_N", dimension::force,
                 "one ring mesh of one planet, at its second gear", loads.ring_normal_force);
    record.value("operation.couple.outward_N_m", dimension::torque,
                 "of both meshes about the middle of a planet: leans its axis outward at positive places",
                 loads.couple_outward);
    record.value("operation.couple.ahead_N_m", dimension::torque,
                 "the same in the sense of the carrier's rotation", loads.couple_ahead);
  }
  describe_axial_forces(record, set, loads);
}

void describe_motor_speed(Record& record, const gearset::Drive& drive) {
  if (drive.speed_of != gearset::SpeedOf::motor)
    record.value("operation.motor_speed_rpm", dimension::angular_speed,
                 "of the shaft by which the power enters, from input.speed of input.speed_of",
                 drive.motor_speed());
}

void describe_duty(Record& record, const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty) {
  describe_loads(record, drivetrain.set, duty.gears);
  describe_motor_speed(record, drivetrain.drive);
  const std::string whose =
      drivetrain.uneven_planets ? "; planets carry unlike loads, this is their mean" : "";
  record.value("operation.bore_load_x_N", dimension::force,
               "gears and planet on one bearing, outward; cage and rollers not included" + whose,
               duty.point.bore_load.x());
  record.value("operation.bore_load_y_N", dimension::force, "the same, in the sense of rotation" + whose,
               duty.point.bore_load.y());
}

void describe_capacities(Record& record, const PlanetaryDrivetrain& drivetrain,
                         const DrivetrainGeometry& geometry) {
  const bearing::rating::StatedRatings& stated = drivetrain.rated.stated;
  const bearing::rating::Ratings& ratings = geometry.rating.ratings;
  if (!stated.dynamic_capacity)
    record.value("bearing.dynamic_capacity_N", dimension::force, "C of ISO 281", ratings.dynamic_capacity);
  if (!stated.static_capacity)
    record.value("bearing.static_capacity_N", dimension::force, "C_0 of ISO 76", ratings.static_capacity);
  if (!stated.fatigue_load_limit)
    record.value("bearing.fatigue_load_limit_N", dimension::force, "C_u of ISO 281, by C_0",
                 ratings.fatigue_load_limit);
}

void describe_profile_drop(Record& record, const bearing::Bearing& bearing) {
  if (!bearing.has_rollers() || bearing.rollers().laminae == 0) return;
  const double half = 0.5 * bearing.rollers().length;
  record.value("bearing.profile.outermost_drop_um", dimension::small_length,
               "relief of one roller at 39/40 of half its length",
               bearing::profile::drop(bearing.rollers().profile, bearing::profile::kDropPosition * half));
}

void describe_bearing(Record& record, const PlanetaryDrivetrain& drivetrain,
                      const DrivetrainGeometry& geometry) {
  constexpr Dimension in_grams{"mass", "kg", "g", "", 1e-3};
  const bearing::BearingGeometry& g = geometry.bearing;
  const bearing::Bearing& bearing = drivetrain.bearing;
  describe_profile_drop(record, bearing);
  record.value("bearing.inner_raceway_diameter_mm", dimension::length, "pitch - roller - half clearance",
               2.0 * g.inner_radius);
  record.value("bearing.outer_raceway_diameter_mm", dimension::length, "pitch + roller + half clearance",
               2.0 * g.outer_radius);
  if (bearing.has_rollers()) record.value("bearing.roller_mass_g", in_grams, "one roller", g.element_mass);
  if (drivetrain.rows.is_tapered())
    record.value(
        "bearing.rows.roller_included_angle_deg", dimension::angle,
        "of a tapered roller, whose races meet on the bearing's axis",
        bearing::taper_of(bearing.element_diameter(), bearing.pitch_diameter, drivetrain.rows.contact_angle));
  if (std::isfinite(geometry.rim_over_module))
    record.value("gearset.rim_over_module", dimension::ratio,
                 "rim of a planet between roots and bore, in normal modules", geometry.rim_over_module);
  if (bearing.has_cage()) record.value("bearing.cage.mass_g", in_grams, "ring less pockets", g.cage_mass);
  describe_capacities(record, drivetrain, geometry);
}

void describe_clearance(Record& record, const MountedClearance& of) {
  const auto add = [&](const std::string& key, const Dimension& unit, const std::string& meaning,
                       double value) { record.value("bearing.clearance." + key, unit, meaning, value); };
  const Dimension &length = dimension::small_length, &pressure = dimension::pressure;
  add("unmounted_um", length, "before mounting", of.chain.unmounted);
  add("after_fits_um", length, "mounted, cold, at rest", of.chain.fitted);
  add("at_temperatures_um", length, "the same, warm", of.chain.warm);
  add("operating_um", length, "the same, at the case's speed: that of the computation", of.chain.operating);
  add("inner_seat_pressure_MPa", pressure, "between pin and inner ring in operation; 0: they separate",
      of.chain.inner_pressure);
  add("outer_seat_pressure_MPa", pressure, "between outer ring and planet in operation; 0: they separate",
      of.chain.outer_pressure);
  for (const auto& [speed, clearance] : of.at_speeds) add("operating_um", length, "at " + speed, clearance);
}

void describe_one_pin_off(Record& record, const OnePinOff& of) {
  constexpr int digits = 2;
  const std::string off = "with one pin off by " + mechanics::significant(1e6 * of.error, digits) +
                          " um (js7 of ISO 286-1), planets on springs" +
                          (of.without_tilt ? "; without the computed tilt" : "");
  record.value("one_pin_off.load_share", dimension::ratio,
               "K_gamma: load of the most loaded planet over the mean " + off, of.load_share);
  if (of.without_tilt) return;  // the life includes the tilt
  record.value("one_pin_off.shortest_life_h", dimension::hours,
               std::string(bearing::rating::hours_key(of.governing)) + " of the most loaded bearing " + off,
               of.shortest_life);
}

template <class Value, class Describe>
void describe_computed(Record& record, const char* key, const Computed<Value>& of, const Describe& describe) {
  if (of.value) describe(*of.value);
  if (!of.failure.empty())
    record.value(key, dimension::ratio, "not computed: " + of.failure, described::kAbsent);
}

}  // namespace

void describe(Record& record, const SetQuantities& of) {
  const PlanetaryDrivetrain& drivetrain = of.set.drivetrain;
  describe_gears(record, drivetrain, of.set.geometry);
  describe_bearing(record, drivetrain, of.set.geometry);
  describe_computed(record, "bearing.clearance", of.clearance,
                    [&](const MountedClearance& clearance) { describe_clearance(record, clearance); });
  describe_computed(record, "operation", of.duty,
                    [&](const BearingDuty& duty) { describe_duty(record, drivetrain, duty); });
  describe_computed(record, "one_pin_off", of.one_pin_off,
                    [&](const OnePinOff& off) { describe_one_pin_off(record, off); });
  record.value("support.stiffness_N_per_m", dimension::stiffness,
               "of the pin at one bearing, from its dimensions", drivetrain.dynamics.support.stiffness);
}

void describe(Record& record, const GearSetQuantities& of) {
  const gearset::WorkingGeometry& gears = of.geometry.gears;
  const gearset::MeanLoads& loads = of.loads;
  describe_gears(record, of.drivetrain, of.geometry);
  describe_loads(record, of.drivetrain.set, loads);
  const double outward =
      of.geometry.planet_mass * loads.carrier_speed * loads.carrier_speed * gears.centre_distance;
  record.value("operation.pin_load_x_N", dimension::force,
               "both meshes and the planet's gear on its pin, outward", loads.radial_force + outward);
  record.value("operation.pin_load_y_N", dimension::force, "the same, in the sense of rotation",
               loads.tangential_force);
  if (!of.drivetrain.in_arrangement) describe_motor_speed(record, of.drivetrain.drive);
}

}  // namespace orbearing::analysis
