#include "coupling/analysis/stated_drivetrain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/geometry.hpp"
#include "coupling/analysis/carrier_revolution.hpp"
#include "gearset/drivetrain/power_flow.hpp"
#include "gearset/planet_angles.hpp"
#include "gearset/stepped_planet.hpp"
#include "mechanics/member_keys.hpp"

namespace orbearing::analysis {

namespace {

double planet_bore(const StatedSet& set) {
  const double outside = set.planets.bearing.outer.seat_diameter;
  if (outside > 0.0) return outside;
  constexpr double feet = 2.5;  // [module]  of two standard teeth
  return set.planet_bore_ratio * set.teeth.module *
         (set.teeth.planet_teeth / std::cos(set.teeth.helix_angle) - feet);
}

}  // namespace

bool is_anywhere_nonzero(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return value != 0.0; });
}

gearset::PlanetarySet with_bore(const StatedSet& stated) {
  gearset::PlanetarySet set = stated.teeth;
  set.planet_bore = planet_bore(stated);
  set.density = stated.planets.bearing.material.density;
  return set;
}

std::string key_in_case(const StatedSet& set, const std::string& key) {
  const mechanics::MemberKeys of(set);
  const double& outside = set.planets.bearing.outer.seat_diameter;
  return key == of(outside) && !(outside > 0.0) ? of(set.planet_bore_ratio) : key;
}

std::string unequal_loads_by(const StatedSet& set) {
  const mechanics::MemberKeys key(set);
  const GearDynamicsChoice& choice = set.gears.choice;
  for (const auto* errors : {&choice.pin_error_radial, &choice.pin_error_tangential})
    if (is_anywhere_nonzero(*errors)) return key(*errors);
  const bool positioned = !set.teeth.planet_angles.empty() && set.teeth.planets > 0;
  return positioned && gearset::is_unequally_spaced(set.teeth) ? key(set.teeth.planet_angles) : "";
}

PlanetaryDrivetrain drivetrain_of(const StatedSet& stated, const gearset::Drive& drive) {
  if (!stated.has_bearing()) return {.set = with_bore(stated), .drive = drive};
  PlanetaryDrivetrain out = stated.planets;
  out.set = with_bore(stated);
  out.drive = drive;
  if (stated.complement == Complement::full) out.bearing.cage = {};  // what is stated of one has no effect
  out.rows.type = stated.bearing_type;
  if (stated.has_balls())
    out.bearing.elements = bearing::Balls{out.rows.balls, out.rows.ball_diameter};
  else
    bearing::put_profile(stated.profile, out.bearing);
  out.bearing.inner.form = harmonics_of(stated.forms.inner);
  out.bearing.outer.form = harmonics_of(stated.forms.outer);
  out.uneven_planets = !unequal_loads_by(stated).empty();
  out.rated = rated_bearing(stated.rating, density_of_oil(out.dynamics.drag), out.dynamics.race.roughness);
  out.mounting.unmounted_clearance = out.bearing.radial_clearance;
  // Without inner ring the pin itself carries the race and moves with it, down to its hole; of a solid one a
  // hole of no account, since a bore is above 0.
  if (out.mounting.rings != bearing::Rings::both)
    out.bearing.inner.seat_diameter = std::max(out.mounting.pin_bore, 1e-3 * out.bearing.inner.seat_diameter);
  mount(out);
  return out;
}

bool is_helical(const StatedDrivetrain& drivetrain) {
  return std::ranges::any_of(drivetrain.sets,
                             [](const auto& one) { return one.set.teeth.helix_angle != 0.0; });
}

bool carrier_is_body(const StatedDrivetrain& drivetrain) {
  if (!drivetrain.is_single()) return false;
  const StatedSet& set = drivetrain.single();
  return !set.carrier.positions.empty() && !set.carrier.radial_stiffness.empty() && set.has_bearing() &&
         set.has_teeth() && set.teeth.fixed_member == gearset::Member::ring &&
         set.planets.rim != PlanetRim::elastic && !set.teeth.stepped.present() &&
         !set.second_planet.present() && set.bearing_type == bearing::PlanetBearingType::cylindrical_roller;
}

namespace {

gearset::ArrangedSet arranged(const NamedStatedSet& one) {
  const gearset::WillisTeeth teeth = gearset::willis_teeth(one.set.teeth);
  return {one.name, teeth.sun, teeth.planet, teeth.ring};
}

gearset::Arrangement arrangement_of_single(const StatedSet& set, gearset::Member driven) {
  gearset::Arrangement arrangement = gearset::arrangement_of(set.teeth, driven, "gearset");
  if (set.second_planet.present())
    arrangement.sets.front().ring_teeth = gearset::willis_teeth_of_pairs(set.teeth).ring;
  return arrangement;
}

}  // namespace

gearset::Arrangement arrangement_of_sets(const StatedDrivetrain& in) {
  if (in.is_single()) return arrangement_of_single(in.single(), in.drive.member);
  gearset::Arrangement arrangement{.shafts = in.shafts};
  std::ranges::transform(in.sets, std::back_inserter(arrangement.sets), arranged);
  return arrangement;
}

gearset::Arrangement arrangement_of(const StatedDrivetrain& in) {
  return with_parallel_stages(arrangement_of_sets(in), in.drive.parallel);
}

bool gears_can_move(const StatedDrivetrain& in) {
  return in.is_single() && !in.single().teeth.stepped.present() && !in.has_pairs() &&
         in.single().bearing_type == bearing::PlanetBearingType::cylindrical_roller;
}

namespace {

/// Speed of the member divided by the speed of the motor. [-]  0: the member is stationary
double ratio_to_motor(const gearset::Arrangement& arrangement, gearset::SpeedOf member) {
  using gearset::SpeedOf;
  const gearset::PowerFlow flow = gearset::power_flow(arrangement);
  const gearset::Speeds& speeds = flow.sets.front().speed;
  switch (member) {
    case SpeedOf::motor:
      break;
    case SpeedOf::load: {
      const auto load = std::ranges::find_if(arrangement.shafts, &gearset::Shaft::load);
      return flow.shafts.at(static_cast<std::size_t>(load - arrangement.shafts.begin())).speed;
    }
    case SpeedOf::sun:
      return speeds.sun;
    case SpeedOf::ring:
      return speeds.ring;
    case SpeedOf::carrier:
      return speeds.carrier;
    case SpeedOf::planet:
      return speeds.planet_relative;
  }
  return 1.0;
}

}  // namespace

double stated_speed_ratio(const StatedDrivetrain& in) {
  return ratio_to_motor(arrangement_of(in), in.drive.speed_of);
}

gearset::Drive drive_of(const StatedDrivetrain& in) {
  gearset::Drive drive = in.drive;
  const bool has_motor = !in.is_single() || in.single().has_teeth();
  if (has_motor && drive.speed_of != gearset::SpeedOf::motor)
    drive.motor_ratio = 1.0 / std::abs(stated_speed_ratio(in));
  return drive;
}

PowerOfMembers power_of(const StatedDrivetrain& in) {
  return power_of_members(arrangement_of(in), drive_of(in));
}

std::optional<gearset::Member> held_member_of(const StatedDrivetrain& in, const std::string& set) {
  const gearset::Arrangement arrangement = arrangement_of(in);
  for (const gearset::Shaft& shaft : arrangement.shafts)
    for (const gearset::SetMember& one : shaft.members)
      if (shaft.ground && arrangement.sets[one.set].name == set) return one.member;
  return std::nullopt;
}

namespace {

// Names of planets in pairs, which are modelled as two sets that share the power.
const std::vector<std::string> pair_names{"first_planet", "second_planet"};

std::vector<NamedSet> planets_of_pairs(const StatedDrivetrain& in) {
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(in));
  const gearset::Drive drive = drive_of(in);
  std::vector<NamedSet> planets;
  for (const std::string& name : pair_names) {
    PlanetaryDrivetrain drivetrain = drivetrain_of(in.single(), drive);
    drivetrain.of_pair = {in.single().second_planet, name == pair_names.back()};
    drivetrain.in_arrangement = flow.sets.front();
    drivetrain.mesh_variation = false;
    const DrivetrainGeometry geometry = derive(drivetrain);
    planets.push_back({name, std::move(drivetrain), geometry});
  }
  return planets;
}

// One of several, without its gears.
PlanetaryDrivetrain arranged_drivetrain(const StatedSet& set, const gearset::Drive& drive,
                                        const gearset::MemberRatios& ratios) {
  PlanetaryDrivetrain drivetrain = drivetrain_of(set, drive);
  drivetrain.in_arrangement = ratios;
  mount(drivetrain);
  return drivetrain;
}

NamedSet single_bearing_set(const StatedDrivetrain& in) {
  const StatedSet& set = in.single();
  PlanetaryDrivetrain drivetrain = drivetrain_of(set, drive_of(in));
  const DrivetrainGeometry geometry = derive(drivetrain);
  if (drivetrain.has_bearing() && drivetrain.bearing.has_rollers())
    drivetrain.gear_set = gears_built_once(drivetrain, set.gears, geometry);
  if (carrier_is_body(in)) {
    require_sound(set.carrier);
    drivetrain.carrier_mounting = set.carrier;
  }
  return {"", std::move(drivetrain), geometry};
}

}  // namespace

std::vector<std::string> bearing_set_names(const StatedDrivetrain& in) {
  if (in.has_pairs()) return pair_names;
  std::vector<std::string> names;
  if (in.is_single()) return names;
  for (const NamedStatedSet& one : in.sets)
    if (one.set.has_bearing()) names.push_back(one.name);
  return names;
}

std::vector<NamedSet> bearing_sets(const StatedDrivetrain& in) {
  if (in.has_pairs()) return planets_of_pairs(in);
  if (in.is_single()) return {single_bearing_set(in)};
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(in));
  const gearset::Drive drive = drive_of(in);
  std::vector<NamedSet> sets;
  for (std::size_t i = 0; i < in.sets.size(); ++i) {
    const auto& [name, set] = in.sets[i];
    if (!set.has_bearing()) continue;
    PlanetaryDrivetrain drivetrain = arranged_drivetrain(set, drive, flow.sets[i]);
    drivetrain.mesh_variation = false;  // gears of several sets do not move yet: they share loads at rest
    drivetrain.gear_set = gears_built_once(drivetrain, set.gears);
    const DrivetrainGeometry geometry = derive(drivetrain);
    sets.push_back({name, std::move(drivetrain), geometry});
  }
  return sets;
}

std::vector<NamedSet> stated_sets(const StatedDrivetrain& in) {
  std::vector<NamedSet> sets;
  for (const auto& [name, set] : in.sets)
    if (!in.is_single() || set.has_teeth() || set.has_bearing())
      sets.push_back({name, drivetrain_of(set, in.is_single() ? drive_of(in) : in.drive), {}});
  return sets;
}

std::vector<NamedSet> sets_without_bearing(const StatedDrivetrain& in) {
  std::vector<NamedSet> sets;
  if (in.is_single()) return sets;
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(in));
  const gearset::Drive drive = drive_of(in);
  for (std::size_t i = 0; i < in.sets.size(); ++i) {
    if (in.sets[i].set.has_bearing()) continue;
    PlanetaryDrivetrain drivetrain = drivetrain_of(in.sets[i].set, drive);
    drivetrain.in_arrangement = flow.sets[i];
    sets.push_back({in.sets[i].name, std::move(drivetrain), {}});
  }
  return sets;
}

PlanetaryDrivetrain moving_set(const StatedDrivetrain& in, const std::string& name) {
  if (in.is_single()) {
    PlanetaryDrivetrain drivetrain = drivetrain_of(in.single(), drive_of(in));
    if (in.single().has_bearing()) drivetrain.gear_set = gears_built_once(drivetrain, in.single().gears);
    return drivetrain;
  }
  const auto found = std::ranges::find(in.sets, name, &NamedStatedSet::name);
  const gearset::PowerFlow flow = gearset::power_flow(arrangement_of(in));
  PlanetaryDrivetrain drivetrain = arranged_drivetrain(
      found->set, drive_of(in), flow.sets[static_cast<std::size_t>(found - in.sets.begin())]);
  drivetrain.set.fixed_member = held_member_of(in, name).value();
  drivetrain.gear_set = gears_built_once(drivetrain, found->set.gears);
  return drivetrain;
}

}  // namespace orbearing::analysis
