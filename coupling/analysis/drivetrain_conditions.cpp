#include "coupling/analysis/drivetrain_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "bearing/mounted_clearance.hpp"

namespace orbearing::analysis {

namespace {

constexpr double same = 1e-12;  // [m]  lengths that are stated as equal

// Whether values of bearings along the pin, or of points along a roller, are mirrored from one end to the
// other.
bool are_mirrored(const std::vector<double>& values, double sign) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i] - sign * values[values.size() - 1 - i]) > same) return false;
  return true;
}

// Clearances of bearings in the order of their places.
bool has_unlike_ends(const PinSeats& seats) {
  const std::vector<double>&position = seats.axial_positions, &clearance = seats.clearance_differences;
  std::vector<std::size_t> order(std::max(position.size(), clearance.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!position.empty() && (clearance.empty() || clearance.size() == position.size()))
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return position[a] < position[b]; });
  const auto sorted = [&](const std::vector<double>& values) {
    std::vector<double> out;
    for (const std::size_t i : order)
      if (i < values.size()) out.push_back(values[i]);
    return out;
  };
  return !are_mirrored(sorted(position), -1.0) || !are_mirrored(sorted(clearance), 1.0);
}

bool has_unlike_ends(const std::vector<double>& x, const std::vector<double>& drops) {
  return !are_mirrored(x, -1.0) || !are_mirrored(drops, 1.0);
}

// As stated, or of the bearings where no profile is.
bool has_unlike_roller_ends(const StatedSet& set) {
  using namespace bearing::profile;
  if (set.profile.kind)
    return set.profile.kind == Kind::table && has_unlike_ends(set.profile.x, set.profile.drops);
  const auto* table = std::get_if<Table>(&set.rollers().profile);
  return table != nullptr && has_unlike_ends(table->x, table->drop);
}

bool is_held_at_one_end(const StatedSet& set) {
  return set.planets.seats.ends != bearing::PinEnds::both;
}

bool is_cylindrical(const StatedSet& set) {
  return set.bearing_type == bearing::PlanetBearingType::cylindrical_roller;
}

}  // namespace

bool planets_tilt(const StatedSet& set) {
  const PinSeats& seats = set.planets.seats;
  return set.teeth.helix_angle != 0.0 || is_held_at_one_end(set) || set.teeth.stepped.present() ||
         seats.radial_inclination != 0.0 || seats.tangential_inclination != 0.0 || seats.carrier_twist ||
         has_unlike_ends(seats) || has_unlike_roller_ends(set);
}

bool bearings_tilt(const StatedSet& set) {
  return planets_tilt(set) || (set.has_bearing() && set.planets.bearings_per_planet > 1);
}

bool pin_links_rows(const StatedSet& set) {
  return is_held_at_one_end(set) || (set.has_bearing() && set.planets.bearings_per_planet > 2);
}

bool planet_counts_without_mass(const StatedSet& set) {
  return set.planets.rim == PlanetRim::elastic ||
         set.planets.mounting.state == bearing::ClearanceState::unmounted ||
         (set.planets.seats.tilt == TiltState::computed && planets_tilt(set));
}

bool bearings_make_springs(const StatedSet& set) {
  return set.has_bearing() && (!set.gears.choice.bearing_stiffness || set.planets.rim == PlanetRim::elastic);
}

bool loads_make_springs(const StatedSet& set) {
  return bearings_make_springs(set) || set.teeth.flanks.contact == gearset::ToothContact::loaded;
}

bool teeth_make_meshes(const StatedSet& set) {
  return set.has_teeth() && (!set.gears.choice.sun_mesh_stiffness || !set.gears.choice.ring_mesh_stiffness);
}

bool fits_are_warm(const StatedSet& set) {
  const bearing::Mounting& mounting = set.planets.mounting;
  return std::ranges::any_of(
      std::vector{mounting.pin_temperature, mounting.inner_ring_temperature, mounting.roller_temperature,
                  mounting.outer_ring_temperature, mounting.planet_temperature},
      [](const auto& temperature) { return temperature && *temperature != bearing::kSizesTemperature; });
}

bool pin_is_race(const StatedSet& set) {
  return set.planets.mounting.rings != bearing::Rings::both;
}

bool speed_is_steady(const StatedSet& set) {
  return set.planets.run_up.acceleration == 0.0;
}

bool gears_run_up(const StatedSet& set) {
  const gearset::dynamics::RunUp& run_up = set.gears.choice.run_up;
  return run_up.duration != 0.0 && run_up.from != 1.0;
}

namespace {

bool has_held_carrier(const StatedDrivetrain& drivetrain, std::size_t set) {
  return std::ranges::any_of(drivetrain.shafts, [&](const gearset::Shaft& shaft) {
    const gearset::SetMember carrier{set, gearset::Member::carrier};
    return shaft.ground && std::ranges::find(shaft.members, carrier) != shaft.members.end();
  });
}

}  // namespace

bool carrier_rotates(const StatedDrivetrain& drivetrain, const std::string& set) {
  if (drivetrain.is_single()) return drivetrain.single().teeth.fixed_member != gearset::Member::carrier;
  for (std::size_t i = 0; i < drivetrain.sets.size(); ++i)
    if ((set.empty() || set == drivetrain.sets[i].name) && !has_held_carrier(drivetrain, i)) return true;
  return false;
}

bool resonances_are_named(const StatedDrivetrain& drivetrain) {
  if (!drivetrain.is_single() || drivetrain.has_pairs()) return false;
  const StatedSet& set = drivetrain.single();
  return set.has_teeth() && set.has_bearing() && is_cylindrical(set) && set.planets.mesh_variation;
}

bool is_one_system(const StatedDrivetrain& drivetrain) {
  if (!drivetrain.is_single()) return false;
  const StatedSet& set = drivetrain.single();
  return set.has_teeth() && set.complement == Complement::full && speed_is_steady(set) &&
         set.planets.seats.tilt != TiltState::computed;
}

}  // namespace orbearing::analysis
