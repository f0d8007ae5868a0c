// Small cases of every kind, and for each field a value that differs: what the test of all fields changes.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "app/case/case_file.hpp"
#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_table.hpp"
#include "app/case/machines.hpp"

namespace orbearing::app::fields_test {

/// A set of gears and a bearing, indented for a case of one set; small, so that motion in time is short.
inline const std::string kGears = R"(gearset:
  planets: 2
  teeth: {sun: 37, planet: 22, ring: 79}
  module: 3 mm
  profile_shift: {sun: 0.2618, ring: 0.4146}
  face_width: 28 mm
  dynamics: {observed_periods: 8, settling_periods: 100, backlash: 0.1 mm}
)";

/// Below gears: bearings that hold the carrier.
inline const std::string kCarrier = R"(  carrier:
    bearing_positions: [-30 mm, 30 mm]
    bearing_stiffness: [2e8 N/m, 2e8 N/m]
)";

inline const std::string kBearing = R"(bearing:
  type: cylindrical-roller
  per_planet: 1
  rollers: 8
  roller_diameter: 5.24 mm
  roller_length: 5.7 mm
  pitch_diameter: 35.64 mm
  radial_clearance: 5 um
  bore: 25 mm
  outside_diameter: 46 mm
  width: 11.9 mm
  cage:
    inner_diameter: 33.44 mm
    outer_diameter: 38.54 mm
    width: 9 mm
    density: 1310 kg/m3
    guide_land_diameter: 38.88 mm
)";

inline const std::string kDrivetrain = R"(name: all fields
source: none
model: planetary-drivetrain
input: {power: 150 kW, speed: 18000 rpm}
)";

// Coarse steps: the tests check whether a field has an effect, not how much.
inline const std::string kShortRun =
    "simulation: {observed_revolutions: 1, most_revolutions: 2, length_error: 2e-6 mm}\n";

inline std::string indented(const std::string& block) {
  std::string text = "    ";
  for (const char c : block) text += c == '\n' ? std::string("\n    ") : std::string(1, c);
  return text.substr(0, text.size() - 4);
}

inline std::string multi_stage() {
  const std::string set = indented(kGears) + indented(kBearing);
  return kDrivetrain + kShortRun +
         "shafts:\n  input: [motor, first.sun]\n  middle: [first.carrier, second.sun]\n"
         "  output: [second.carrier, load]\n  housing: [ground, first.ring, second.ring]\n"
         "sets:\n  first:\n" +
         set + "  second:\n" + set;
}

inline const std::string kToothless = R"(name: masses and springs
source: none
model: planetary-drivetrain
gearset:
  planets: 3
  pressure_angle: 24.6 deg
  dynamics:
    sun: {mass: 0.4 kg, equivalent_mass: 0.39 kg}
    ring: {mass: 2.35 kg, equivalent_mass: 3 kg}
    carrier: {mass: 5.43 kg, equivalent_mass: 6.29 kg}
    planet: {mass: 0.66 kg, equivalent_mass: 0.61 kg}
    mesh_stiffness: {sun: 5e8 N/m, ring: 5e8 N/m}
)";

inline const std::string kPair = R"(name: a pair
source: none
model: gear-pair
pair: {teeth: [30, 40], module: 2 mm, face_width: 20 mm, bore: 25 mm}
)";

inline const std::string kRollers = R"(name: a roller bearing
source: none
model: roller-bearing
load: {radial: 3000 N}
)";

inline const std::string kBalls = R"(name: a ball bearing
source: none
model: ball-bearing
load: {radial: 1000 N}
bearing: {balls: 7, ball_diameter: 11.5 mm, pitch_diameter: 43.5 mm, radial_clearance: 0 um,
          bore: 25 mm, outside_diameter: 62 mm, width: 17 mm}
)";

inline const std::string kBallsInTime = R"(name: a ball bearing in time
source: none
model: ball-bearing
load: {radial: 400 N}
bearing:
  balls: 9
  ball_diameter: 7 mm
  pitch_diameter: 36 mm
  radial_clearance: 5 um
  bore: 25 mm
  width: 11.9 mm
  cage:
    inner_diameter: 33.44 mm
    outer_diameter: 38.54 mm
    width: 9 mm
    density: 1310 kg/m3
    guide_land_diameter: 38.88 mm
    largest_eccentricity: 0.2
operation: {shaft_speed: 6000 rpm}
simulation: {duration: 0.02 s, samples: 50, length_error: 2e-6 mm, settling_band: 0.2}
)";

// A bearing with a scratched race: one text for both rungs, but for the signal.
inline std::string scratched(const std::string& signal) {
  return R"(name: a scratched race
source: none
model: raceway-defect
load: {radial: 400 N}
operation: {shaft_speed: 6000 rpm}
bearing:
  balls: 9
  ball_diameter: 7 mm
  pitch_diameter: 36 mm
  radial_clearance: 5 um
  outer_ring_mass: 0.1 kg
  cage:
    inner_diameter: 33.44 mm
    outer_diameter: 38.54 mm
    width: 9 mm
    density: 1310 kg/m3
    guide_land_diameter: 38.88 mm
    largest_eccentricity: 0.2
defect: {race: inner, width: 0.6 mm, depth: 0.1 mm}
)" + signal;
}

inline const std::string kScratch = scratched(
    "signal: {sampling_rate: 60 kHz, revolutions: 3, settling_revolutions: 0.5, length_error: 1e-8 mm}\n");
inline const std::string kScratchInMotion = scratched(
    "signal: {sampling_rate: 30 kHz, revolutions: 2, settling_revolutions: 0.5}\n"
    "simulation: {length_error: 2e-6 mm}\n");

inline const std::string kScratchedRollers = R"(name: a scratched roller bearing
source: none
model: raceway-defect
load: {radial: 400 N}
operation: {shaft_speed: 6000 rpm}
bearing: {rollers: 12, roller_diameter: 6 mm, roller_length: 8 mm, pitch_diameter: 36 mm, radial_clearance: 5 um, outer_ring_mass: 0.1 kg}
defect: {race: roller, width: 0.6 mm, depth: 0.1 mm}
signal: {sampling_rate: 60 kHz, revolutions: 3, settling_revolutions: 0.5, length_error: 1e-8 mm}
)";

// As short as the low-pass of the instrument allows.
inline const std::string kScratchedPlanet =
    "defect: {race: roller, width: 0.3 mm, depth: 0.1 mm}\n"
    "signal: {sampling_rate: 60 kHz, carrier_revolutions: 0.5, carrier_settling: 0.02}\n"
    "simulation: {length_error: 2e-6 mm}\n";

inline const std::string kDuplex = R"(name: a pair of ball bearings
source: none
model: duplex-pair
arrangement: face-to-face
preload: 540 N
bearing: {balls: 20, ball_diameter: 14.288 mm, pitch_diameter: 125.25 mm, contact_angle: 20 deg, radial_clearance: 0 um}
spindle: {mass: 10 kg, first_lever: 29 mm, second_lever: 28 mm, diameter: 100 mm}
housing: {mass: 30 kg, inertia: 0.2 kg.m2}
linear: {mass: 9 kg, first_lever: 15 mm, second_lever: 17 mm, inertia_x: 0.047 kg.m2, inertia_y: 0.045 kg.m2}
)";

inline const std::string kSpinFilm = R"(name: a contact that rolls and spins
source: none
model: spin-film
contact: {rolling_radius: 6 mm, ellipticity: 7, modulus: 226 GPa}
points: [[500 N, 5 m/s, 200 rad/s]]
)";

// Pins with position errors: quasi-static loads then depend on the whole compliance under the planets.
inline std::string displaced_pins() {
  std::string gears = kGears;
  const std::string block = "dynamics: {";
  gears.insert(gears.find(block) + block.size(), "pin_error: {tangential: [4 um, 0 um]}, ");
  return kDrivetrain + gears + kBearing + kShortRun;
}

/// Elements of planets other than caged cylindrical rollers, instead of those.
inline std::string planet_bearing(const std::string& elements) {
  std::string bearing = kBearing;
  const std::size_t begin = bearing.find("  type:"), end = bearing.find("  pitch_diameter:");
  return bearing.replace(begin, end - begin, elements);
}

inline const std::string kPlanetBalls =
    planet_bearing("  type: deep-groove-ball\n  per_planet: 1\n  balls: 9\n  ball_diameter: 5.24 mm\n");
inline const std::string kPlanetSpherical = planet_bearing(
    "  type: spherical-roller\n  per_planet: 1\n  rollers: 8\n  roller_diameter: 5.24 mm\n"
    "  roller_length: 5.7 mm\n  rows: {contact_angle: 10 deg}\n");

inline std::string planet_tapered() {
  std::string bearing = planet_bearing(
      "  type: tapered-roller\n  per_planet: 2\n  rollers: 8\n  roller_diameter: 5.24 mm\n"
      "  roller_length: 5.7 mm\n  rows: {contact_angle: 12 deg, arrangement: back-to-back}\n");
  const std::string clearance = "radial_clearance: 5 um";
  return bearing.replace(bearing.find(clearance), clearance.size(), "radial_clearance: 0 um");
}

inline std::string planet_without_cage() {
  const std::string bearing = planet_bearing(
      "  type: cylindrical-roller\n  per_planet: 1\n  complement: full\n  rollers: 21\n"
      "  roller_diameter: 5.24 mm\n  roller_length: 5.7 mm\n  rings: none\n");
  return bearing.substr(0, bearing.find("  cage:"));
}

struct Base {
  std::string name;
  std::string text;
  std::string set{};               // of several sets, the one whose fields are changed
  AnalysisSet but{};               // analyses that are left out
  bool reader_may_refuse = false;  // other values, which do not fit its bearings
};

inline std::string rollers_case() {
  std::string bearing = kBearing;
  const std::string own = "  per_planet: 1\n";
  return kRollers + bearing.erase(bearing.find(own), own.size());
}

/// Run of a scratched ball bearing: of the ring alone, or of all that moves.
inline AnalysisId run_of_scratches(bool in_time) {
  return std::ranges::find_if(machine_analyses(),
                              [&](const MachineAnalysis& one) {
                                return one.model == raceway_defect && one.in_time == in_time;
                              })
      ->used;
}

inline const std::vector<Base>& bases() {
  static const std::vector<Base> all{
      {"bearing_in_a_set", kDrivetrain + kGears + kCarrier + kBearing + kShortRun},
      // Loads by displaced pins are tested quasi-static, and in motion as one system; modes, meshes and a
      // single bearing do not depend on them, gears alone are tested in the case before, and the other
      // fidelities in motion have the same fields and take much longer.
      {"displaced_pins", displaced_pins(), "",
       AnalysisId::dynamic | AnalysisId::co_simulated | analyses_with(analysis::Physics::vibration) |
           AnalysisId::mesh | AnalysisId::fmu_bearing | AnalysisId::gears | AnalysisId::fmu_gearset},
      {"gears_alone", kDrivetrain + kGears},
      {"masses_and_springs", kToothless},
      {"multi_stage", multi_stage(), "first"},
      {"pair_of_gears", kPair},
      {"roller_bearing", rollers_case()},
      {"ball_bearing", kBalls},
      {"ball_bearing_in_time", kBallsInTime},
      {"raceway_defect", kScratch, "", run_of_scratches(true)},
      {"raceway_defect_in_motion", kScratchInMotion, "", run_of_scratches(false)},
      {"scratched_rollers", kScratchedRollers},
      {"scratched_planet", kDrivetrain + kGears + kBearing + kScratchedPlanet, "",
       all_of_drivetrains().without(AnalysisId::planet_defect)},
      {"duplex_pair", kDuplex},
      {"spin_film", kSpinFilm},
      // Other bearings of planets, by what is computed of them alone.
      {"planets_on_balls", kDrivetrain + kGears + kPlanetBalls, "",
       all_of_drivetrains().without(AnalysisId::quasi_static), true},
      {"planets_on_tapered_rollers", kDrivetrain + kGears + planet_tapered(), "",
       all_of_drivetrains().without(AnalysisId::quasi_static), true},
      {"planets_on_spherical_rollers", kDrivetrain + kGears + kPlanetSpherical, "",
       all_of_drivetrains().without(AnalysisId::quasi_static), true},
      {"planets_without_cage", kDrivetrain + kGears + planet_without_cage() + kShortRun, "",
       all_of_drivetrains().without(AnalysisId::dynamic), true}};
  return all;
}

/// Another value of a field, and the other inputs that it requires for an effect.
struct Change {
  std::string value;
  std::vector<std::string> beside{};    // in the case that it is compared with as well
  std::vector<std::string> together{};  // with the value alone
};

/// Values that no rule finds. Paths without the set's prefix.
inline const std::map<std::string, Change>& stated_changes() {
  const std::string shelf = "bearing.clearance_state=unmounted";
  const std::string laminae = "bearing.laminae=20", kind = "bearing.profile.kind=";
  const std::string land = "bearing.cage.guide_land_diameter=38.88 mm";
  const std::vector<std::string> table{laminae, kind + "table", "bearing.profile.x=[-4 mm, 0 mm, 4 mm]",
                                       "bearing.profile.drops=[5 um, 0 um, 5 um]"};
  const std::vector<std::string> tilting{laminae, "bearing.tilt_state=computed"};
  const std::vector<std::string> kawase{laminae, kind + "fujiwara-kawase"};
  const std::vector<std::string> run_up{"input.acceleration=1000 rpm/s", "simulation.run_up_time=0.003 s"};
  const std::vector<std::string> gears_run_up{"gearset.dynamics.run_up.from=0.5",
                                              "gearset.dynamics.run_up.duration=0.01 s"};
  const std::vector<std::string> film{"life.viscosity_ratio=2", "life.contamination_factor=0.4"};
  const std::vector<std::string> clean{"life.viscosity_ratio=2", "life.cleanliness=high"};
  const std::vector<std::string> rotating{"lubricant.kinematic_viscosity=20 mm2/s", "life.cleanliness=high",
                                          "operation.shaft_speed=1000 rpm"};
  const std::vector<std::string> rotating_balls{"operation.shaft_speed=9000 rpm"};
  const std::vector<std::string> filmed{"film.enabled=true", "operation.shaft_speed=9000 rpm"};
  const std::vector<std::string> heated{"heat.enabled=true"};
  const std::vector<std::string> loaded{"gearset.tooth_contact=loaded"};
  const std::vector<std::string> relieved{"gearset.tooth_contact=loaded", "gearset.tip_relief.sun=20 um",
                                          "gearset.tip_relief.planet=20 um", "gearset.tip_relief.ring=20 um"};
  // The planet's own gear again, beside the first.
  const std::vector<std::string> stepped{laminae, "bearing.tilt_state=computed",
                                         "gearset.stepped_planet.offset=28 mm",
                                         "gearset.stepped_planet.profile_shift=-0.46"};
  std::vector<std::string> stepped_whole = stepped;
  stepped_whole.emplace_back("gearset.stepped_planet.teeth=22");
  const std::vector<std::string> hardly_damped{"gearset.dynamics.damping_ratio.mesh=0.001",
                                               "gearset.dynamics.damping_ratio.bearing=0.001",
                                               "gearset.dynamics.damping_ratio.support=0.001"};
  const std::vector<std::string> pair{
      "bearing.type=tapered-roller",           "bearing.per_planet=2",
      "bearing.radial_clearance=0 um",         "bearing.rows.contact_angle=12 deg",
      "bearing.rows.arrangement=back-to-back", "gearset.helix_angle=12 deg"};
  std::vector<std::string> both = run_up;
  both.insert(both.end(), gears_run_up.begin(), gears_run_up.end());
  static const std::map<std::string, Change> all{
      {"gearset.carrier.bearing_positions", {"[-30 mm, 27 mm]"}},
      {"gearset.carrier.bearing_stiffness", {"[2e8 N/m, 3e8 N/m]"}},
      {"gearset.carrier.bearing_clearance", {"[10 um, 20 um]"}},
      {"gearset.carrier.housing_stiffness",
       {"[2e8 N/m, 0 N/m, 0 N/m, 1e7 N/m, 0 N/m, 0 N/m, 0 N/m, 1e8 N/m, 0 N/m, 0 N/m, 0 N/m, 0 N/m, "
        "0 N/m, 0 N/m, 2e8 N/m, 0 N/m, 0 N/m, 0 N/m, 1e7 N/m, 0 N/m, 0 N/m, 1e8 N/m, 0 N/m, 0 N/m, "
        "0 N/m, 0 N/m, 0 N/m, 0 N/m, 2e8 N/m, 0 N/m, 0 N/m, 0 N/m, 0 N/m, 0 N/m, 0 N/m, 1e8 N/m]"}},
      {"gearset.carrier.centre_of_mass", {"5 mm"}},
      {"gearset.carrier.axis_tilt", {"6 deg"}},
      {"gearset.carrier.rotor_force", {"[100 N, 0 N, 0 N]"}},
      {"gearset.carrier.rotor_moment", {"[5 N.m, 0 N.m]"}},
      // Back flanks without rotation: a rotor that wedges planets into their meshes.
      {"gearset.dynamics.backlash", {"1 um", {"gearset.carrier.rotor_force=[20000 N, 0 N, 0 N]"}}},
      {"input.member", {"carrier"}},
      {"input.speed_of", {"load"}},
      {"input.torque", {"77 N.m"}},
      {"input.torque_curve", {"[{speed: 1 rpm, torque: 70 N.m}, {speed: 1e6 rpm, torque: 70 N.m}]"}},
      {"spectrum", {"[{power: 140 kW, speed: 17000 rpm, share: 1}]"}},
      {"support.stiffness", {"6e8 N/m"}},
      {"bearing.tilt_state", {"computed", {laminae}}},
      {"bearing.rows.contact_angle", {"14 deg", pair}},
      {"bearing.rows.arrangement", {"face-to-face", pair}},
      {"bearing.rows.distance", {"15 mm", pair}},
      {"bearing.rows.preload", {"500 N", pair}},
      {"bearing.rows.approach", {"5 um", pair}},
      {"bearing.axial_places", {"[4 mm]", tilting}},
      {"bearing.clearance_differences", {"[10 um]", tilting}},
      {"support.pin_ends", {"one", tilting}},
      {"support.pin_span", {"40 mm", {laminae, "bearing.tilt_state=computed", "support.pin_ends=one"}}},
      {"support.pin_diameter",
       {"14 mm", {laminae, "bearing.tilt_state=computed", "support.pin_ends=flexpin"}}},
      {"gearset.dynamics.sun.tilt_stiffness", {"1e5 N.m/rad"}},
      {"gearset.dynamics.sun.axial_stiffness", {"1e7 N/m"}},
      {"gearset.dynamics.planet.axial_stiffness", {"1e7 N/m"}},
      {"support.carrier_twist_stiffness", {"1e5 N.m/rad", tilting}},
      {"support.pin_inclination.radial", {"0.03 deg", tilting}},
      {"support.pin_inclination.tangential", {"0.03 deg", tilting}},
      {"input.acceleration", {"1100 rpm/s", run_up}},
      {"simulation.run_up_time", {"0.004 s", run_up}},
      {"inertia.euler", {"false", both}},
      {"inertia.gravity", {"9.81 m/s2"}},
      {"gearset.fixed", {"sun", {"input.member=carrier"}}},
      {"gearset.planets", {"4"}},
      {"gearset.planet_angles", {"[0 deg, 170.6897 deg]"}},
      {"gearset.helix_angle", {"12 deg"}},
      {"gearset.sun_thrust", {"carrier", {"gearset.helix_angle=12 deg"}}},
      {"pair.helix_angle", {"12 deg"}},
      {"gearset.addendum_of.sun", {"0.9"}},
      {"gearset.addendum_of.planet", {"0.9"}},
      {"gearset.addendum_of.ring", {"0.9"}},
      {"gearset.clearance_of.sun", {"0.3"}},
      {"gearset.clearance_of.planet", {"0.3"}},
      {"gearset.clearance_of.ring", {"0.3"}},
      {"gearset.web.thickness", {"0.3"}},
      {"gearset.web.rim", {"2", {"gearset.web.thickness=0.3"}}},
      {"gearset.tooth_contact", {"loaded"}},
      {"gearset.tip_relief.sun", {"20 um", loaded}},
      {"gearset.tip_relief.planet", {"20 um", loaded}},
      {"gearset.tip_relief.ring", {"20 um", loaded}},
      {"gearset.tip_relief.length", {"2", relieved}},
      {"gearset.tip_relief.form", {"parabolic", relieved}},
      {"gearset.lead_crown.sun", {"15 um", loaded}},
      {"gearset.lead_crown.planet", {"15 um", loaded}},
      {"gearset.lead_crown.ring", {"15 um", loaded}},
      {"gearset.lead_slope.sun", {"15 um", loaded}},
      {"gearset.lead_slope.ring", {"15 um", loaded}},
      {"pair.web.thickness", {"0.3"}},
      {"pair.web.rim", {"2", {"pair.web.thickness=0.3"}}},
      {"parallel_stage.front", {"[30, 31]"}},
      {"parallel_stage.behind", {"[30, 31]"}},
      {"gearset.stepped_planet.teeth", {"22", stepped}},
      {"gearset.stepped_planet.module", {"3.01 mm", stepped_whole}},
      {"gearset.stepped_planet.profile_shift", {"-0.45", stepped_whole}},
      {"gearset.stepped_planet.face_width", {"27 mm", stepped_whole}},
      {"gearset.stepped_planet.offset", {"29 mm", stepped_whole}},
      {"gearset.teeth.sun", {"35"}},
      {"gearset.teeth.planet", {"21"}},
      {"gearset.teeth.ring", {"81"}},
      {"gearset.dynamics.sun.mass", {"1.3 kg"}},
      {"gearset.dynamics.sun.equivalent_mass", {"1.3 kg"}},
      {"gearset.dynamics.ring.mass", {"3.1 kg"}},
      {"gearset.dynamics.carrier.mass", {"3.1 kg"}},
      {"gearset.dynamics.carrier.equivalent_mass", {"3.1 kg"}},
      {"gearset.dynamics.planet.mass", {"0.8 kg"}},
      {"gearset.dynamics.planet.equivalent_mass", {"0.8 kg"}},
      {"gearset.dynamics.planet.bearing_stiffness", {"2.5e8 N/m"}},
      {"gearset.dynamics.mesh_stiffness.sun", {"4e8 N/m"}},
      {"gearset.dynamics.mesh_stiffness.ring", {"4e8 N/m"}},
      {"gearset.dynamics.sun.torsional_stiffness", {"1e7 N/m"}},
      {"gearset.dynamics.ring.torsional_stiffness", {"1e7 N/m"}},
      {"gearset.dynamics.carrier.torsional_stiffness", {"1e7 N/m"}},
      {"lubricant.grade", {"ISO VG 460", {"film.enabled=true", "operation.shaft_speed=9000 rpm"}}},
      {"lubricant.viscosity_40", {"460 mm2/s", {"film.enabled=true", "operation.shaft_speed=9000 rpm"}}},
      {"lubricant.viscosity_100",
       {"40 mm2/s",
        {"lubricant.viscosity_40=460 mm2/s", "film.enabled=true", "operation.shaft_speed=9000 rpm"}}},
      {"lubricant.temperature",
       {"50 degC", {"lubricant.grade=ISO VG 220", "film.enabled=true", "operation.shaft_speed=9000 rpm"}}},
      {"lubricant.viscosity_index",
       {"50", {"lubricant.grade=ISO VG 220", "film.enabled=true", "operation.shaft_speed=9000 rpm"}}},
      {"life.viscosity_ratio_by", {"film", {"lubricant.grade=ISO VG 32"}}},
      {"bearing.radial_clearance", {"8 um"}},
      {"bearing.cage.material", {"brass"}},
      {"bearing.complement", {"full", {}, {"bearing.rollers=21"}}},
      {"bearing.neighbour_friction", {"0.3", {"bearing.complement=full", "bearing.rollers=21"}}},
      {"bearing.rings", {"none"}},
      {"bearing.fit.inner_interference", {"4 um", {shelf}}},
      {"bearing.fit.outer_interference", {"40 um", {shelf}}},  // the teeth open less at this speed
      {"bearing.fit.pin_class", {"k5", {shelf}}},
      {"bearing.fit.planet_class", {"P6", {shelf}}},
      {"bearing.fit.pin_bore", {"10 mm", {shelf, "bearing.fit.inner_interference=6 um"}}},
      {"bearing.fit.expansion", {"12e-6 K-1", {shelf, "bearing.temperature.inner_ring=60 degC"}}},
      {"bearing.temperature.pin", {"50 degC", {shelf, "bearing.fit.inner_interference=6 um"}}},
      {"bearing.temperature.inner_ring", {"50 degC", {shelf}}},
      {"bearing.temperature.rollers", {"50 degC", {shelf}}},
      {"bearing.temperature.outer_ring", {"50 degC", {shelf}}},
      {"bearing.temperature.planet", {"30 degC", {shelf, "bearing.fit.outer_interference=20 um"}}},
      {"bearing.outside_diameter", {"48 mm"}},
      {"simulation.observed_share", {"0.5"}},
      {"simulation.settling_band", {"1e-4"}},
      {"gearset.dynamics.ring.equivalent_mass",
       {"3.3 kg", {"gearset.dynamics.ring.torsional_stiffness=1e9 N/m"}}},
      {"gearset.dynamics.run_up.from", {"0.9", gears_run_up}},
      {"gearset.dynamics.run_up.duration", {"0.02 s", gears_run_up}},
      {"gearset.dynamics.settling_periods", {"200", hardly_damped}},
      {"gearset.dynamics.pin_error.radial", {"[0 um, 10 um]"}},
      {"gearset.dynamics.pin_error.tangential", {"[0 um, 10 um]"}},
      {"gearset.dynamics.transmission_error.sun", {"[0 um, 3 um, 1 um]"}},
      {"gearset.dynamics.transmission_error.ring", {"[0 um, 3 um, 1 um]"}},
      {"bearing.cage.outer_diameter", {"38.2 mm"}},
      {"bearing.cage.guidance", {"inner", {}, {"bearing.cage.guide_land_diameter=33 mm"}}},
      {"bearing.cage.guide_land_diameter", {"39 mm", {land}}},
      {"bearing.cage.largest_eccentricity", {"0.1", {land}}},
      {"bearing.cage.touch_down_stiffness", {"2e7 N/m", {land, "bearing.cage.largest_eccentricity=0.1"}}},
      {"bearing.cage.pocket_roughness", {"20 um", {"bearing.cage.pocket_film=hydrodynamic"}}},
      {"bearing.laminae", {"20"}},
      {"bearing.misalignment.planet_tilt", {"1 mrad", {laminae}}},
      {"bearing.misalignment.carrier_wind_up", {"1 mrad", {laminae}}},
      {"bearing.profile.kind", {"circular", {laminae}}},
      {"bearing.profile.drop", {"7 um", {laminae, kind + "circular"}}},
      {"bearing.profile.design_load", {"700 N", {laminae, kind + "lundberg"}}},
      {"bearing.profile.chamfer_length", {"1 mm", {laminae, kind + "chamfer"}}},
      {"bearing.profile.straight_length", {"2 mm", {laminae, kind + "straight-circular"}}},
      {"bearing.profile.k1",
       {"1.5", {laminae, kind + "fujiwara-kawase", "bearing.profile.design_load=700 N"}}},
      {"bearing.profile.k2", {"0.8", kawase}},
      {"bearing.profile.end_drop", {"9 um", kawase}},
      {"bearing.profile.x", {"[-3 mm, 0 mm, 3 mm]", table}},
      {"bearing.profile.drops", {"[6 um, 0 um, 6 um]", table}},
      {"bearing.roller_diameter_deviation", {"[1 um]"}},
      {"contact.roughness", {"1 um", {"contact.lubrication=mixed"}}},
      {"contact.boundary_friction", {"0.13", {"contact.lubrication=mixed"}}},
      {"film.enabled", {"true", rotating_balls}},
      {"film.solver", {"reynolds", {"contact.ellipticity=3", "points=[[20 N, 5 m/s, 200 rad/s]]"}}},
      {"contact.length",
       {"10 mm", {"film.solver=reynolds", "points=[[600 N, 5 m/s, 0 rad/s]]"}, {"contact.ellipticity=null"}}},
      {"lubricant.viscosity", {"0.02 Pa.s", filmed}},
      {"lubricant.pressure_viscosity", {"2e-8 Pa-1", filmed}},
      {"operation.speeds", {"[1000 rpm, 2000 rpm]"}},
      {"operation.load_factors", {"[2]"}},
      {"points", {"[[600 N, 5 m/s, 200 rad/s]]"}},
      {"traction.limiting_friction", {"0.08", {"traction.law=limiting-shear"}}},
      {"simulation.load_drift",
       {"1e-9", {"simulation.most_revolutions=4", "simulation.load_drift=0.9", "simulation.cage_drift=0.9"}}},
      {"simulation.load_error_share", {"1e-3"}},
      {"traction.sliding_share", {"1e-3"}},
      {"simulation.cage_drift",
       {"1e-9", {"simulation.most_revolutions=4", "simulation.load_drift=0.9", "simulation.cage_drift=0.9"}}},
      {"bearing.cage.pocket_straight", {"0.1 mm"}},
      {"simulation.step", {"2 us", {"simulation.form=printed"}}},
      {"heat.surroundings", {"35 degC", heated}},
      {"heat.contact_conductance", {"4 W/K", heated}},
      {"heat.oil_conductance", {"5 W/K", heated}},
      {"heat.fit_conductance", {"10 W/K", heated}},
      {"heat.housing_conductance", {"5 W/K", heated}},
      {"heat.shaft_conductance", {"2 W/K", heated}},
      {"lubricant.flow", {"0.1 L/min", heated}},
      {"heat.expansion", {"20e-6 K-1", heated}},
      {"heat.sizes_temperature", {"30 degC", heated}},
      {"heat.inlet", {"30 degC", {"heat.enabled=true", "lubricant.flow=0.1 L/min"}}},
      {"heat.viscosity_temperature", {"60 degC", heated}},
      {"heat.viscosity_slope", {"0.02 K-1", {"traction.inlet_heating=goksem-hargreaves"}}},
      {"heat.model", {"oil", {"heat.enabled=true", "lubricant.flow=0.1 L/min"}}},
      {"lubricant.fill", {"parker", {"lubricant.flow=0.1 L/min"}}},
      {"traction.starvation", {"skf", {"bearing.outside_diameter=52 mm"}}},
      {"traction.pressure_law", {"roelands", {"traction.law=limiting-shear"}}},
      {"traction.largest_barus_exponent", {"2", {"traction.law=limiting-shear"}}},
      {"traction.eyring_stress", {"0.004 GPa", {"traction.law=ree-eyring"}}},
      {"rotor.mass", {"0.3 kg"}},
      {"rotor.inertia", {"1e-4 kg.m2"}},
      {"operation.shaft_acceleration", {"2e6 rpm/s"}},
      {"load.tilt", {"1 mrad"}},
      {"load.moment", {"2 N.m"}},
      {"load.moment_across", {"2 N.m"}},
      {"bearing.first_element_angle", {"7 deg"}},
      {"load.axial", {"200 N"}},
      {"bearing.contact_angle", {"15 deg"}},
      {"bearing.dynamic_capacity", {"12345 N"}},
      {"bearing.static_capacity", {"23456 N", film}},
      {"bearing.fatigue_load_limit", {"1234 N", film}},
      {"life.method", {"iso-16281"}},
      {"life.contamination_factor", {"0.5", film}},
      {"life.viscosity_ratio", {"2.1", film}},
      {"life.cleanliness", {"low", clean}},
      {"life.lubrication", {"oil-bath", clean}},
      {"lubricant.kinematic_viscosity", {"30 mm2/s", rotating}},
      {"gearset.centre_distance", {"500 mm"}},  // checks of what follows: refused
      {"gearset.profile_shift.planet", {"0.9"}},
      {"operation.shaft_speed", {"1200 rpm", rotating}},
      {"operation.outer_speed", {"-1200 rpm", rotating}},
      {"defect.angle", {"7 deg"}},
      {"defect.depth", {"5 um"}},  // less than a ball sinks
      {"defect.more_angles", {"[40 deg]"}},
      {"defect.form", {"edges"}},
      {"defect.profile", {"[0, 0.3, 1, 0.3, 0]", {}, {"defect.form=profile"}}},
      {"defect.element", {"2"}},
      {"defect.planet", {"2"}},
      {"defect.set", {"second"}},
      {"defect.bearing", {"2", {"bearing.per_planet=2"}}},
      {"defect.also", {"outer"}},
      {"defect.also_angle", {"20 deg", {"defect.also=outer"}}},
      {"signal.carrier_revolutions", {"0.6"}},
      {"signal.carrier_settling", {"0.04"}},
      {"signal.run_up_from", {"0.8"}},
      {"signal.band", {"[1 kHz, 4 kHz]"}},
      {"equilibrium.ball_inertia", {"false", rotating_balls}},
      {"equilibrium.ball_attitude", {"outer-race-control", rotating_balls}},
      {"equilibrium.gyroscopic_moment", {"none", rotating_balls}},
      {"arrangement", {"back-to-back"}},
      {"spacer_difference", {"2 um"}},
      {"spindle.inertia_x", {"0.03 kg.m2", {}, {"spindle.inertia_y=0.03 kg.m2", "spindle.diameter=null"}}},
      {"spindle.inertia_y", {"0.03 kg.m2", {}, {"spindle.inertia_x=0.03 kg.m2", "spindle.diameter=null"}}},
      {"response.position", {"40 mm"}},
      {"life.minimum_load", {"0.03", {"spectrum=[{power: 140 kW, speed: 17000 rpm, share: 1}]"}}},
      {"requirements.life", {"1000 h"}},
      {"requirements.life_key", {"L10h", {"requirements.life=1000 h"}}},
      {"requirements.contact_pressure_max", {"1500 MPa"}},
      {"requirements.S0", {"3"}},
      {"requirements.kappa", {"0.4"}},
      {"requirements.load_share", {"1.2"}},
      {"pair.teeth", {"[30, 41]"}},
      {"pair.driven_bore", {"31 mm"}},
      {"pair.kind", {"internal", {"pair.teeth=[20, 51]"}}},
      {"pair.ring_outside_ratio", {"1.3", {"pair.teeth=[20, 51]", "pair.kind=internal"}}},
      {"pair.profile_shift", {"[0.1, 0]"}}};
  return all;
}

/// Waves are stated in blocks of three lists.
inline Change wave_change(const std::string& path) {
  const std::string block = path.substr(0, path.rfind('.'));
  const std::vector<std::string> beside{block + ".order=[2]", block + ".amplitude=[1 um]"};
  if (path.ends_with("order")) return {"[3]", beside};
  if (path.ends_with("amplitude")) return {"[2 um]", beside};
  return {"[30 deg]", beside};
}

inline Change quantity_change(const std::string& given) {
  constexpr double factor = 1.04;  // near enough to stay in range and within the checks of consistency
  const WrittenQuantity now = *split_quantity(given).value;
  return {fmt::format("{} {}", factor * now.value, now.unit)};
}

/// Whether the case refuses any other value of the field: a rim that bends and a tilt that is computed are
/// for one set whose planets carry equal loads.
inline bool stays_as_it_is(const Field& field, const ResolvedCase& in) {
  const bool rim = field.path == "gearset.planet_rim";
  const bool of_tilt = field.path == "bearing.tilt_state" || field.path == "bearing.axial_places" ||
                       field.path == "bearing.clearance_differences" ||
                       field.path.starts_with("support.pin_") ||
                       field.path == "support.carrier_twist_stiffness";
  if (field.path == "heat.model" && in.model() == roller_bearing) return true;  // the oil alone
  const bool of_balls = field.path == "bearing.balls" || field.path == "bearing.ball_diameter";
  if (of_balls && in.model() == planetary_drivetrain) return true;  // beside the rollers of the base
  if (field.path.starts_with("bearing.rows.") &&
      (in.has("gearset.dynamics.pin_error.tangential") || in.has("defect.race")))
    return true;
  const bool alone = !in.shape().several && !in.has("bearing.rollers");  // a rim that rests on no rollers
  // Planets in pairs have no carrier with bearings, which the base has: PlanetsInPairs tests them.
  if (field.path.starts_with("gearset.second_planet.")) return true;
  const bool stepped = field.path.starts_with("gearset.stepped_planet.");  // whose bearings find their tilt
  return ((rim || of_tilt || stepped) && in.has("gearset.dynamics.pin_error.tangential")) ||
         ((rim || stepped) && alone) ||
         ((of_tilt || stepped || field.path == "gearset.planet_angles") && in.shape().several);
}

/// The change of `path` in the case `in`; an empty value for a field that has but one.
inline Change change_of(const Field& field, const ResolvedCase& in, const std::string& path) {
  if (field.path == "gearset.planets" && in.has("gearset.dynamics.pin_error.tangential"))
    return {"4", {}, {"gearset.dynamics.pin_error.tangential=[4 um, 0 um, 0 um, 0 um]"}};
  const bool rollers = (in.model() & with_rollers) != 0;
  if (field.path == "bearing.complement" && (in.model() & planetary_drivetrain) == 0)
    return {"full", {"bearing.rollers=21"}};  // quasi-static bearings have their number, and no pocket
  if (field.path == "bearing.designation")
    return {rollers ? "NU 204" : in.model() == duplex_pair ? "7205 A" : "6204"};
  if (field.path == "bearing.catalogue") {  // a row of the designation's name with other numbers
    const std::string own =
        "designation,family,bore_mm,outside_diameter_mm,width_mm,inner_raceway_mm,dynamic_capacity_kN,"
        "static_capacity_kN,contact_angle_deg\n";
    if (rollers)
      return {own + "NU 204,cylindrical-roller,20,48,14,26.5,20,20,\n", {"bearing.designation=NU 204"}};
    return in.model() == duplex_pair
               ? Change{own + "7205 A,angular-contact-ball,25,52,15,,15,9.5,30\n",
                        {"bearing.designation=7205 A"}}
               : Change{own + "6204,deep-groove-ball,20,47,14,,11,6,\n", {"bearing.designation=6204"}};
  }
  if (field.path == "bearing.clearance_class")
    return {"C3",
            rollers ? std::vector<std::string>{} : std::vector<std::string>{"bearing.designation=6204"}};
  if (field.path == "operation.shaft_speed" && (in.model() & model_sets::single_scratched) != 0)
    return {"6400 rpm"};
  if (in.model() == roller_bearing) {  // whose quasi-static friction has oil and heat of its own
    std::vector<std::string> rotating{"lubricant.kinematic_viscosity=20 mm2/s", "life.cleanliness=high",
                                      "operation.shaft_speed=1000 rpm"};
    if (field.path == "traction.starvation") return {"replenished", rotating};
    if (field.path == "lubricant.share") return {"0.1", rotating};
    if (field.path == "lubricant.flow") return {"0.1 L/min", rotating};
    rotating.insert(rotating.end(), {"heat.model=oil", "lubricant.flow=0.1 L/min"});
    if (field.path == "heat.enabled") return {"true", rotating};
    rotating.emplace_back("heat.enabled=true");
    if (field.path == "heat.inlet") return {"30 degC", rotating};
  }
  if (field.path == "traction.starvation" && in.model() == planetary_drivetrain) return {"skf"};
  if (field.path == "heat.viscosity_slope" && in.model() == planetary_drivetrain)
    return {"0.02 K-1", {"film.inlet_heating=gupta", "traction.inlet_heating=goksem-hargreaves"}};
  if (field.path == "life.method" && !in.shape().several && in.has("bearing.balls"))
    return {"iso-281"};  // of balls in planets the default gives the life of iso-16281
  if (const auto stated = stated_changes().find(field.path); stated != stated_changes().end())
    return stated->second;
  if (field.path.find(".out_of_roundness.") != std::string::npos ||
      field.path.find(".waviness.") != std::string::npos)
    return wave_change(field.path);
  const std::string now = in.has(path) ? in.given(path) : "";
  if (now.empty() && (field.kind == Kind::integer || field.kind == Kind::number)) return {};
  switch (field.kind) {
    case Kind::flag:
      return {now == "true" ? "false" : "true"};
    case Kind::choice:
      for (const std::string& choice : field.choices)
        if (choice != now) return {choice};
      return {};
    case Kind::integer:
      return {fmt::format("{}", in.integer(path) + 1)};
    case Kind::number: {
      const double more = 1.04 * in.number(path);
      return {fmt::format("{}", more > field.range.most ? 0.96 * in.number(path) : more)};
    }
    case Kind::quantity:
      return now.empty() ? Change{} : quantity_change(now);
    default:
      return {};
  }
}

}  // namespace orbearing::app::fields_test
