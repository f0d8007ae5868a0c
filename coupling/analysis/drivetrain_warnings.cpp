#include "coupling/analysis/drivetrain_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "bearing/life/rating_lives.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "gearset/checks.hpp"
#include "mechanics/append.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/member_keys.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace {

using mechanics::append;
using mechanics::significant;

constexpr int kFour = 4, kSix = 6;  // digits

std::string mesh_load_text(const PlanetaryDrivetrain& drivetrain, const gearset::MeanLoads& loads) {
  return significant(std::hypot(loads.tangential_force, loads.radial_force) / drivetrain.bearings_per_planet,
                     kFour);
}

// Loads of the outer bearings of a planet on a stiff pin that hold a moment [N m].
std::string as_loads(const PlanetaryDrivetrain& drivetrain, double moment) {
  const std::vector<double> positions = axial_positions(drivetrain);
  double squares = 0.0;  // [m^2]  bearings on a stiff pin share a moment as their positions
  for (const double position : positions) squares += position * position;
  if (!(squares > 0.0)) return "a moment on the one bearing";
  return significant(moment * positions.back() / squares, kFour) +
         " N outward at one end and inward at the other on the outer bearings at " +
         significant(1e3 * positions.front(), kFour) + " and " + significant(1e3 * positions.back(), kFour) +
         " mm";
}

}  // namespace

std::vector<std::string> cage_warnings(const std::vector<NamedSet>& sets) {
  std::vector<std::string> warnings;
  for (const NamedSet& set : sets)
    if (set.drivetrain.bearing.has_cage() && set.drivetrain.dynamics.cage.guide_diameter == 0.0)
      warnings.push_back(
          set_prefix(set.name) +
          "bearing.cage.guide_land_diameter: 0; in motion (--fidelity dynamic and above) no land "
          "guides the cage. Only its pockets hold it, and it may leave the bearing");
  return warnings;
}

std::vector<std::string> clearance_warnings(const std::vector<NamedSet>& sets) {
  std::vector<std::string> warnings;
  for (const NamedSet& set : sets) {
    const bearing::Mounting& mounting = set.drivetrain.mounting;
    if (mounting.state != bearing::ClearanceState::unmounted) continue;
    const std::string prefix = set_prefix(set.name);
    if (!mounting.states_fits())
      warnings.push_back(prefix +
                         "bearing.fit: no interference given; the seats are assumed neither tight nor loose");
    if (!mounting.states_temperatures())
      warnings.push_back(prefix + "bearing.temperature: not given; all bodies are assumed at 20 degC");
  }
  return warnings;
}

std::vector<std::string> overturning_warnings(const std::vector<NamedSet>& sets) {
  std::vector<std::string> warnings;
  for (const NamedSet& set : sets) {
    const PlanetaryDrivetrain& drivetrain = set.drivetrain;
    if (drivetrain.set.helix_angle == 0.0 || drivetrain.seats.tilt == TiltState::computed ||
        !drivetrain.rows.is_cylindrical())  // in the equilibrium
      continue;
    const gearset::MeanLoads loads = bearing_duty(drivetrain, set.geometry).gears;
    const double moment = std::abs(loads.overturning_moment);
    warnings.push_back(
        set_prefix(set.name) + "gearset.helix_angle: the axial forces tilt a planet by a moment of " +
        significant(moment, kFour) +
        " N m at the case's input. The support of the tilt is assumed to carry this moment. On "
        "bearings on a stiff pin it is " +
        as_loads(drivetrain, moment) + ". Both meshes load each bearing with " +
        mesh_load_text(drivetrain, loads) +
        " N. bearing.tilt_state: computed includes the moment in the equilibrium");
  }
  return warnings;
}

mechanics::Problems slope_warnings(const PlanetaryDrivetrain& drivetrain) {
  mechanics::Problems warnings;
  if (drivetrain.seats.tilt != TiltState::computed) return warnings;
  const gearset::FlankModifications& flanks = drivetrain.set.flanks;
  const mechanics::MemberKeys key(flanks);
  const auto add = [&](const double& slope) {
    if (slope != 0.0)
      warnings.push_back({key(slope),
                          "moves the force of the teeth along the face; its moment on a planet is not "
                          "modelled, so that the computed tilt is too small"});
  };
  add(flanks.sun_slope);
  add(flanks.ring_slope);
  return warnings;
}

std::vector<std::string> planar_warnings() {
  return {
      "gearset.helix_angle: motion is that in the plane of the set; members are assumed fixed along their "
      "axes and aligned. Axial and tilting vibration is left out"};
}

namespace {

// Sets that transmit no torque, of several.
std::vector<std::string> idle_set_warnings(const gearset::Arrangement& arrangement) {
  std::vector<std::string> warnings;
  for (const std::size_t set : gearset::idle_sets(gearset::power_flow(arrangement)))
    warnings.push_back("sets." + arrangement.sets[set].name +
                       ": idle. It transmits no torque between its shafts; its planet bearings carry the "
                       "inertia of planets and rollers alone");
  return warnings;
}

gearset::Warnings tooth_warnings(const StatedSet& stated) {
  const gearset::PlanetarySet set = with_bore(stated);
  if (stated.second_planet.present())  // whose shifts are all stated
    return gearset::pair_tooth_warnings(set, stated.second_planet);
  gearset::Warnings warnings = gearset::tooth_warnings(gearset::working_geometry(set));
  append(gearset::ring_sign_warnings(set, stated.geometry), warnings);
  return warnings;
}

}  // namespace

std::vector<std::string> gear_warnings(const StatedDrivetrain& drivetrain) {
  std::vector<std::string> texts;
  if (drivetrain.is_single()) {
    if (!drivetrain.single().has_teeth()) return texts;
  } else {
    texts = idle_set_warnings(arrangement_of(drivetrain));
  }
  for (const auto& [name, set] : drivetrain.sets)
    for (const gearset::Warning& warning : tooth_warnings(set))
      texts.push_back(set_prefix(name) + key_in_case(set, warning.key) + ": " + warning.text);
  return texts;
}

std::vector<std::string> lamina_warnings(const std::vector<NamedSet>& sets) {
  constexpr int enough = 10;  // within 2 % of the life of many, the wind turbine's planets
  constexpr int least = bearing::rating::kLeastRatedLaminae;
  std::vector<std::string> warnings, rated;
  for (const NamedSet& set : sets) {
    const PlanetaryDrivetrain& drivetrain = set.drivetrain;
    if (!drivetrain.bearing.has_rollers() || drivetrain.bearing.rollers().laminae == 0) continue;
    const bearing::CylindricalRollers& rollers = drivetrain.bearing.rollers();
    const bool straight = std::holds_alternative<bearing::profile::Straight>(rollers.profile);
    const std::string found = set_prefix(set.name) + "bearing.laminae: " + std::to_string(rollers.laminae);
    const bool tilts = drivetrain.seats.tilt == TiltState::computed || drivetrain.misalignment.planet_tilt ||
                       drivetrain.misalignment.carrier_wind_up;
    if (rollers.laminae < enough && (tilts || !straight))
      warnings.push_back(found +
                         " resolve a profile or a tilt coarsely (one: not at all), which affects loads and "
                         "lives. Use " +
                         std::to_string(enough) + " or more");
    const bool left_out = drivetrain.rated.stated.stress_riser != bearing::rating::StressRiser::standard;
    if (rollers.laminae < least && straight)
      rated.push_back(found + " laminae of straight rollers; " +
                      (left_out ? "L10rh and L10mrh are left out, for which " : "") +
                      "ISO/TS 16281 requires at least " + std::to_string(least));
  }
  warnings.insert(warnings.end(), rated.begin(), rated.end());
  return warnings;
}

std::vector<std::string> soft_rim_warnings(const std::vector<NamedSet>& sets) {
  constexpr double stiffer = 2.0, least_gain = 0.02;  // as well as influences agree with finite elements
  std::vector<std::string> warnings;
  for (const NamedSet& set : sets) try {
      const double gain = gain_by_stiffer_rim(set.drivetrain, set.geometry, stiffer);
      if (gain > least_gain)
        warnings.push_back((sets.size() > 1 ? set_prefix(set.name) : "") +
                           "gearset.planet_rim: the rim is softer than that of the longest life. Twice as "
                           "stiff, the life at " +
                           significant(set.drivetrain.drive.speed * 30.0 / constants::pi, kSix) + " rpm is " +
                           significant(100.0 * gain, 3) +
                           " % longer. Increase its thickness or the modulus of its material");
    } catch (const std::runtime_error&) {  // no equilibrium there, which its own row reports
    }
  return warnings;
}

double inertial_field(const NamedSet& set) {
  const BearingDuty duty = bearing_duty(set.drivetrain, set.geometry);
  const double cage =
      bearing::kinematic_cage_speed(set.geometry.bearing, duty.point.inner_speed, duty.point.outer_speed);
  return std::max(std::pow(duty.gears.carrier_speed, 2) * set.geometry.gears.centre_distance,
                  cage * cage * set.geometry.bearing.pitch_radius);
}

}  // namespace orbearing::analysis
