// A planetary drivetrain as a case states it, and what its parts are put together to: gears with their
// planet bearings, shafts, drive and carrier.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bearing/catalogue/catalogue_bearing.hpp"
#include "bearing/profile/stated_profile.hpp"
#include "bearing/race_waves.hpp"
#include "coupling/analysis/multi_stage.hpp"
#include "coupling/analysis/planet_rating.hpp"
#include "coupling/analysis/power_of_members.hpp"
#include "coupling/analysis/set_gears.hpp"
#include "gearset/drivetrain/arrangement.hpp"
#include "gearset/planet_pair.hpp"
#include "gearset/spatial/spatial_set.hpp"
#include "gearset/stated_geometry.hpp"

namespace orbearing::analysis {

/// Rollers of one row: separated by a cage, or in contact with one another.
enum class Complement { caged, full };

constexpr described::Names<Complement, 2> names_of(Complement) {
  return {{{Complement::caged, "caged"}, {Complement::full, "full"}}};
}

/// One planetary set, with the bearings of its planets if it has any.
struct StatedSet {
  gearset::PlanetarySet teeth;  // without the bore of the planets; no teeth: masses and stiffnesses instead
  gearset::SecondPlanet second_planet;
  gearset::StatedGeometry geometry;  // values that follow from the teeth, stated as a check
  double planet_bore_ratio = 0.7;    // [-]  of a planet without a bearing: bore over module x (teeth - 2.5)
  bearing::PlanetBearingType bearing_type = bearing::PlanetBearingType::cylindrical_roller;
  Complement complement = Complement::caged;
  bearing::catalogue::CatalogueBearing catalogue;
  PlanetaryDrivetrain planets;              // bearings, seats and motion; its gears and drive are beside it
  bearing::profile::StatedProfile profile;  // of the rollers; none: that of the bearings of `planets`
  bearing::RaceForms forms;
  PlanetRating rating;
  SetGears gears;
  gearset::spatial::CarrierMounting carrier;  // of a single set

  bool has_teeth() const { return teeth.sun_teeth > 0; }
  bool has_balls() const { return bearing_type == bearing::PlanetBearingType::deep_groove_ball; }
  bool has_bearing() const { return planets.bearing.element_count() > 0 || planets.rows.balls > 0; }
  const bearing::CylindricalRollers& rollers() const { return planets.bearing.rollers(); }
};
template <class Visitor>
void describe(Visitor& visit, StatedSet& m) {
  using namespace described;
  members(visit, m, part(m.teeth), part(m.second_planet), part(m.geometry),
          internal(m.planet_bore_ratio, "gearset.planet_bore_ratio"),
          internal(m.bearing_type, "bearing.type"), internal(m.complement, "bearing.complement"),
          part(m.catalogue), part(m.planets), part(m.profile), part(m.forms), part(m.rating), part(m.gears),
          part(m.carrier));
}

/// The set with the bore that its bearings fill, and its density.
gearset::PlanetarySet with_bore(const StatedSet& set);

/// The input that a finding of the gears is about: without a bearing a planet's bore is that of another one.
std::string key_in_case(const StatedSet& set, const std::string& key);

/// Whether one of the values is another than 0.
bool is_anywhere_nonzero(const std::vector<double>& values);

/// The key by which planets carry unequal loads: pins with position errors, or planets at unequal angles;
/// empty: none does.
std::string unequal_loads_by(const StatedSet& set);

/// The set at that drive, without the motion of its gears (gears_built_once).
PlanetaryDrivetrain drivetrain_of(const StatedSet& set, const gearset::Drive& drive);

/// A set with its name; a single one has none.
struct NamedStatedSet {
  std::string name;
  StatedSet set;
};

/// One set that is driven by itself, or several with the shafts that join their members.
struct StatedDrivetrain {
  std::vector<NamedStatedSet> sets;
  std::vector<gearset::Shaft> shafts;  // none: a single set
  gearset::Drive drive;                // with its parallel stages, and the speed as it is stated

  bool is_single() const { return shafts.empty(); }
  /// The one set. To be called where there is one.
  const StatedSet& single() const { return sets.front().set; }
  bool has_pairs() const { return is_single() && single().second_planet.present(); }
};

/// Whether some set has helical teeth.
bool is_helical(const StatedDrivetrain& drivetrain);

/// Whether the carrier is taken as a body in three dimensions: bearings hold it, in a set whose ring stands
/// still and whose rims, planets and bearings are such as that model has.
bool carrier_is_body(const StatedDrivetrain& drivetrain);

/// The sets on their shafts, without and with parallel stages.
gearset::Arrangement arrangement_of_sets(const StatedDrivetrain& drivetrain);
gearset::Arrangement arrangement_of(const StatedDrivetrain& drivetrain);

/// Whether the motion of its gears is modelled: one set of single planets with one gear each, whose bearings,
/// if any, have cylindrical rollers.
bool gears_can_move(const StatedDrivetrain& drivetrain);

/// Speed of the member whose speed is stated, over that of the motor. [-]  0: it is stationary
double stated_speed_ratio(const StatedDrivetrain& drivetrain);

/// The drive, with the speed of the motor by that of the member whose speed is stated.
gearset::Drive drive_of(const StatedDrivetrain& drivetrain);

/// Speeds, torques and power of every member.
PowerOfMembers power_of(const StatedDrivetrain& drivetrain);

/// The member of one of several sets that the housing holds; none: all of them rotate.
std::optional<gearset::Member> held_member_of(const StatedDrivetrain& drivetrain, const std::string& set);

/// Names of the sets with bearings where there are several, and of both planets of pairs; none of a single
/// set.
std::vector<std::string> bearing_set_names(const StatedDrivetrain& drivetrain);

/// The sets with bearings, in the order of the case; of planets in pairs one for each of both. A single set
/// without bearings is among them.
/// @throws std::invalid_argument where lists of the carrier's bearings do not fit
std::vector<NamedSet> bearing_sets(const StatedDrivetrain& drivetrain);

/// All sets, with or without bearings, each driven as a single one; without their gears' motion and what
/// follows from the inputs.
std::vector<NamedSet> stated_sets(const StatedDrivetrain& drivetrain);

/// The sets without bearings among several, as they are driven.
std::vector<NamedSet> sets_without_bearing(const StatedDrivetrain& drivetrain);

/// One set whose gears and bearings move as one: the single one, or the named one of several, at the speeds
/// and torques that its members have there.
PlanetaryDrivetrain moving_set(const StatedDrivetrain& drivetrain, const std::string& name);

}  // namespace orbearing::analysis
