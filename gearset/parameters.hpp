// Parameters of a planetary gear set and of its drive. SI units throughout.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearset/flank_modifications.hpp"
#include "mechanics/described.hpp"

namespace orbearing::gearset {

/// The three coaxial members of a simple planetary gear set.
enum class Member { sun, ring, carrier };

constexpr described::Names<Member, 3> names_of(Member) {
  return {{{Member::sun, "sun"}, {Member::ring, "ring"}, {Member::carrier, "carrier"}}};
}

/// Body that supports the axial bearing of a helical sun.
enum class SunThrust { housing, carrier };

constexpr described::Names<SunThrust, 2> names_of(SunThrust) {
  return {{{SunThrust::housing, "housing"}, {SunThrust::carrier, "carrier"}}};
}

/// Basic rack profile; lengths in units of the module (ISO 53). For helical teeth it is that of the section
/// normal to them, and the module is the normal one [ISO21771].
struct BasicRack {
  double pressure_angle = 0.3490658503988659;  // [rad]     20 degrees
  double addendum = 1.0;                       // [module]  of the gear: h_a*
  double clearance = 0.25;                     // [module]  bottom clearance: c*
  double root_fillet_radius = 0.38;            // [module]  rho_f*
};

/// Rack of the block "gearset." or "pair." of a case.
template <class Visitor>
void describe_rack(Visitor& visit, BasicRack& m, const std::string& block) {
  using namespace described;
  const std::string_view rack = "the basic rack of ISO 53";
  members(visit, m,
          input(m.pressure_angle, block + "pressure_angle", "normal pressure angle of the basic rack",
                {.dimension = dimension::angle, .range = {10.0, 35.0}, .reason = rack}),
          input(m.addendum, block + "addendum", "addendum of the basic rack, in modules",
                {.range = {0.5, 1.5}, .reason = rack}),
          input(m.clearance, block + "clearance", "bottom clearance of the basic rack, in modules",
                {.range = {0.0, 0.6}, .reason = rack}),
          input(m.root_fillet_radius, block + "root_fillet_radius",
                "root fillet radius of the basic rack, in modules", {.range = {0.0, 0.6}, .reason = rack}));
}

/// Tooth heights of a single gear that differ from the rack's; none: as the rack.
struct OwnHeights {
  std::optional<double> addendum;  // [module]
  std::optional<double>
      clearance;  // [module]  under its own tips, added to its addendum: the depth of its roots
};

/// Heights of the sun, a planet or the ring.
template <class Visitor>
void describe_heights(Visitor& visit, OwnHeights& m, const std::string& gear) {
  using namespace described;
  members(
      visit, m,
      input(m.addendum, "gearset.addendum_of." + gear,
            "addendum of the " + gear + ", in modules; gearset.addendum if absent", {.range = {0.5, 1.5}}),
      input(m.clearance, "gearset.clearance_of." + gear,
            "bottom clearance of the " + gear +
                ", root depth minus addendum, in modules; gearset.clearance if absent",
            {.range = {0.0, 0.6}}));
}

/// The disc that carries the rim of a gear, for the web factor of ISO 6336.
struct Web {
  std::optional<double> thickness;  // [-]       of the disc over the face width; none: a gear of one piece
  double rim = 3.5;                 // [module]  thickness of the rim under the roots
};

template <class Visitor>
void describe_web(Visitor& visit, Web& m, const std::string& block) {
  using namespace described;
  members(
      visit, m,
      input(
          m.thickness, block + "web.thickness",
          "thickness of the disc that carries the rim, as a share of the face width; of one piece if absent",
          {.range = {0.2, 1.2}}),
      input(m.rim, block + "web.rim", "thickness of the rim under the roots, in modules",
            {.range = {1.0, 50.0},
             .reason = "corresponds to the web factor of 0.862 that [Reboucas2021] has for discs of a "
                       "quarter of the face",
             .where = {block.empty() ? "pair.web.thickness" : "gearset.web.thickness"}}));
}

/// Row of a helix angle, of the block of a case to which it belongs.
inline described::Row<double> helix_row(double& member, const std::string& block, std::string_view first) {
  return described::input(
      member, block + "helix_angle",
      "helix angle at the reference circle; positive: the teeth of the " + std::string(first) +
          " are right-handed",
      {.dimension = described::dimension::angle, .range = {-45.0, 45.0}, .reason = "spur gears"});
}

/// A second gear on each planet, which meshes with the ring instead of the first. Without teeth there is
/// none.
struct SteppedPlanet {
  int teeth = 0;
  std::optional<double> module;      // [m]       of the ring mesh; none: that of the sun mesh
  std::optional<double> shift;       // [module]  none: 0; the centre distance follows from it and the ring's
  std::optional<double> face_width;  // [m]       none: as the first gear
  double offset = 0.0;               // [m]       of the middle of its face from that of the first gear

  bool present() const { return teeth > 0; }
};

template <class Visitor>
void describe(Visitor& visit, SteppedPlanet& m) {
  using namespace described;
  const Where beside{"gearset.stepped_planet.teeth"};
  members(
      visit, m,
      input(m.teeth, "gearset.stepped_planet.teeth",
            "teeth of a second gear on each planet, which meshes with the ring; gearset.teeth.planet then "
            "meshes "
            "with the sun alone; one gear on each planet if absent",
            {.range = {5, 2000}, .may_be_absent = true}),
      input(m.module, "gearset.stepped_planet.module", "module of the ring mesh; gearset.module if absent",
            {.dimension = dimension::length, .range = positive(100.0), .where = beside}),
      input(m.shift, "gearset.stepped_planet.profile_shift",
            "profile shift of the second gear, in modules; with the ring's it makes the centre distance; 0 "
            "if absent",
            {.range = {-2.0, 2.0}, .where = beside}),
      input(m.face_width, "gearset.stepped_planet.face_width",
            "width of the teeth of the second gear and the ring; gearset.face_width if absent",
            {.dimension = dimension::length, .range = positive(1e4), .where = beside}),
      input(m.offset, "gearset.stepped_planet.offset",
            "axial distance of the middle of the second gear's face from that of the first; positive towards "
            "positive places of bearings",
            {.dimension = dimension::length, .range = {-1e4, 1e4}, .where = beside}));
}

/// Parameters of one planetary set, its planets alike.
struct PlanetarySet {
  int sun_teeth = 0;
  int planet_teeth = 0;
  int ring_teeth = 0;
  int planets = 0;
  double module = 0.0;  // [m]
  BasicRack rack;
  double sun_shift = 0.0;  // [module]  profile shift; the planet's follows from the common centre distance
  double ring_shift =
      0.0;  // [module]  positive outward, as of the external gear that fills the ring's spaces
  double face_width = 0.0;   // [m]
  double planet_bore = 0.0;  // [m]       diameter of the hole that the planet's bearings fill
  double density = 7850.0;   // [kg/m^3]
  Member fixed_member = Member::ring;
  double helix_angle = 0.0;  // [rad]  at the reference circle; positive: the sun is right-handed, the planets
                             //        and the ring left-handed
  SunThrust sun_thrust = SunThrust::housing;
  OwnHeights sun_heights;
  OwnHeights planet_heights;
  OwnHeights ring_heights;
  Web web;  // of the softer gear of each mesh
  FlankModifications flanks;
  std::vector<double> planet_angles;  // [rad]  (planets)  anticlockwise from the first; empty: equal steps
  SteppedPlanet stepped;
};

template <class Visitor>
void describe(Visitor& visit, PlanetarySet& m) {
  using namespace described;
  const auto count = [](int& member, std::string path, std::string meaning, Range range) {
    return input(member, std::move(path), std::move(meaning), {.range = range});
  };
  const auto length = [](double& member, std::string path, std::string meaning, double most) {
    return input(member, std::move(path), std::move(meaning),
                 {.dimension = dimension::length, .range = positive(most)});
  };
  const Details shift{.range = {-2.0, 2.0}};
  members(
      visit, m,
      input(m.fixed_member, "gearset.fixed", "member held by the housing",
            {.reason = "the most common reduction gear"}),
      count(m.planets, "gearset.planets", "number of planets", {1, 24}),
      input(m.planet_angles, "gearset.planet_angles",
            "angular positions of the planets, anticlockwise from the first one at 0 deg. Whole steps of 360 "
            "deg/(sun + ring teeth), rounded by at most 0.005 deg; equal steps if absent",
            {.dimension = dimension::angle, .range = {0.0, 360.0, true, false}}),
      count(m.sun_teeth, "gearset.teeth.sun", "teeth of the sun", {5, 2000}),
      count(m.planet_teeth, "gearset.teeth.planet", "teeth of a planet", {5, 2000}),
      count(m.ring_teeth, "gearset.teeth.ring", "teeth of the ring", {15, 4000}),
      length(m.module, "gearset.module", "normal module", 100.0),
      part(m.rack, [&] { describe_rack(visit, m.rack, "gearset."); }),
      input(m.sun_shift, "gearset.profile_shift.sun", "profile shift of the sun, in modules", shift),
      input(m.ring_shift, "gearset.profile_shift.ring",
            "profile shift of the ring, in modules, positive outward", shift),
      length(m.face_width, "gearset.face_width", "width of the teeth", 1e4), apart(m.planet_bore),
      apart(m.density), helix_row(m.helix_angle, "gearset.", "sun"),
      input(
          m.sun_thrust, "gearset.sun_thrust",
          "support of the sun's axial bearing: the housing, or the carrier, whose own bearing transmits the "
          "thrust",
          {.reason = "the sun's shaft has its own bearing", .where = {"gearset.helix_angle"}}),
      part(m.sun_heights, [&] { describe_heights(visit, m.sun_heights, "sun"); }),
      part(m.planet_heights, [&] { describe_heights(visit, m.planet_heights, "planet"); }),
      part(m.ring_heights, [&] { describe_heights(visit, m.ring_heights, "ring"); }),
      part(m.web, [&] { describe_web(visit, m.web, "gearset."); }), part(m.flanks), part(m.stepped));
}

/// Teeth of two external gears on shafts of their own: of the gear nearer to the motor, then of its mate.
/// [1, 1] is no stage.
using StageTeeth = std::array<int, 2>;

/// Stages without losses, in the order in which the power passes them. Alike gears change nothing but the
/// sense of rotation.
struct ParallelStages {
  std::vector<StageTeeth> front = {{1, 1}};   // between motor and planetary sets
  std::vector<StageTeeth> behind = {{1, 1}};  // between planetary sets and load
};

template <class Visitor>
void describe(Visitor& visit, ParallelStages& m) {
  using namespace described;
  const auto stages = [](std::vector<StageTeeth>& member, std::string path, std::string meaning) {
    return input(member, std::move(path), std::move(meaning), {.range = {1, 2000}, .reason = "none"});
  };
  members(
      visit, m,
      stages(m.front, "parallel_stage.front",
             "teeth of a parallel stage between motor and planetary sets: the motor's gear and its mate; of "
             "several stages a list of such pairs in the order from the motor"),
      stages(
          m.behind, "parallel_stage.behind",
          "teeth of a parallel stage between planetary sets and load: the gear on their shaft and its mate; "
          "of several stages a list of such pairs in the order to the load"));
}

/// Whose speed a drive states. Motor and load are the shafts by which power enters and leaves, parallel
/// stages included.
enum class SpeedOf { motor, load, sun, ring, carrier, planet };

constexpr described::Names<SpeedOf, 6> names_of(SpeedOf) {
  return {{{SpeedOf::motor, "motor"},
           {SpeedOf::load, "load"},
           {SpeedOf::sun, "sun"},
           {SpeedOf::ring, "ring"},
           {SpeedOf::carrier, "carrier"},
           {SpeedOf::planet, "planet"}}};
}

/// The power that enters the set, and where. The member that is neither fixed nor driven delivers.
struct Drive {
  Member member = Member::sun;
  double power = 0.0;  // [W]
  double speed = 0.0;  // [rad/s]  of `speed_of`, relative to the housing; of a planet relative to its pin
  ParallelStages parallel{};
  double application_factor = 1.0;  // [-]  K_A of ISO 6336-1
  SpeedOf speed_of = SpeedOf::motor;
  double motor_ratio =
      1.0;  // [-]  speed of the motor over `speed`: of the driven member, or before a stage in front

  /// Power that loads teeth and bearings. [W]
  double load_power() const { return application_factor * power; }
  /// [rad/s]
  double motor_speed() const { return speed * motor_ratio; }
  /// Speed of the driven member itself, behind all stages in front. Eq. (40) of gearset/README.md. [rad/s]
  double driven_speed() const {
    double of_shaft = motor_speed();
    for (const StageTeeth& teeth : parallel.front) of_shaft = of_shaft * teeth[0] / teeth[1];
    return of_shaft;
  }
};

template <class Visitor>
void describe(Visitor& visit, Drive& m) {
  using namespace described;
  members(
      visit, m,
      input(m.member, "input.member", "member by which the power enters",
            {.reason = "the most common reduction gear"}),
      input(m.power, "input.power", "input power", {.dimension = dimension::power, .range = {1e-6, 1e7}}),
      input(m.application_factor, "input.application_factor",
            "K_A of ISO 6336-1: teeth and bearings carry the loads of this multiple of the power; with a "
            "spectrum 1",
            {.range = {0.1, 10.0}, .reason = "input.power is the load that acts"}),
      input(m.speed, "input.speed",
            "speed of the driven member relative to the housing; before parallel stages in front of it that "
            "of the motor; of another member where input.speed_of names it",
            {.dimension = dimension::angular_speed, .range = {1e-3, 1e6}}),
      input(m.speed_of, "input.speed_of",
            "member whose speed is input.speed, also in sweeps, torque curves and spectra. motor, load: the "
            "shafts by which power enters and leaves; planet: relative to its pin",
            {.reason = "power, torque and speed are those of one shaft"}),
      apart(m.motor_ratio), part(m.parallel));
}

/// The rack of one gear of a set.
inline BasicRack rack_of(const PlanetarySet& set, const OwnHeights& own) {
  BasicRack rack = set.rack;
  rack.addendum = own.addendum.value_or(rack.addendum);
  rack.clearance = own.clearance.value_or(rack.clearance);
  return rack;
}

}  // namespace orbearing::gearset
