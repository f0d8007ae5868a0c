// Parameters of a bearing, of rollers or balls, and of the parts around it. SI units throughout. The rows
// below each structure state the purpose of its members (mechanics/described.hpp).
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bearing/profile/profile.hpp"
#include "bearing/race_harmonic.hpp"
#include "mechanics/described.hpp"
#include "mechanics/material.hpp"

namespace orbearing::bearing {

using mechanics::Material;

/// Oil at the running temperature.
struct Lubricant {
  double viscosity = 0.0;           // [Pa s]  dynamic, at atmospheric pressure
  double pressure_viscosity = 0.0;  // [1/Pa]  Barus coefficient

  bool operator==(const Lubricant&) const = default;
};

/// The default of cases.
inline constexpr Lubricant warm_gear_oil{.viscosity = 0.01, .pressure_viscosity = 1.5e-8};

template <class Visitor>
void describe(Visitor& visit, Lubricant& m) {
  using namespace described;
  members(
      visit, m,
      input(m.viscosity, "lubricant.viscosity", "dynamic viscosity at the inlet, at running temperature",
            {.dimension = dimension::viscosity, .range = {1e-5, 100.0}, .reason = "a gear oil when warm"}),
      input(m.pressure_viscosity, "lubricant.pressure_viscosity",
            "pressure-viscosity coefficient at running temperature",
            {.dimension = dimension::pressure_viscosity,
             .range = {0.1, 100.0},
             .reason = "a mineral oil when warm",
             .written = "Pa-1"}));
}

/// The race on whose land the cage is centred.
enum class Race { inner, outer };

constexpr described::Names<Race, 2> names_of(Race) {
  return {{{Race::outer, "outer"}, {Race::inner, "inner"}}};
}

/// Cage of a roller bearing: a ring with one rectangular pocket for each roller.
struct Cage {
  double inner_diameter = 0.0;  // [m]
  double outer_diameter = 0.0;  // [m]
  double width = 0.0;           // [m]
  double density = 0.0;         // [kg/m^3]
  Race guidance = Race::outer;
};

template <class Visitor>
void describe(Visitor& visit, Cage& m) {
  using namespace described;
  const auto length = [](double& member, std::string path, std::string meaning) {
    return input(member, std::move(path), std::move(meaning),
                 {.dimension = dimension::length, .range = positive(1e4)});
  };
  members(visit, m, length(m.inner_diameter, "bearing.cage.inner_diameter", "inner diameter of the cage"),
          length(m.outer_diameter, "bearing.cage.outer_diameter", "outer diameter of the cage"),
          length(m.width, "bearing.cage.width", "axial width of the cage"),
          input(m.density, "bearing.cage.density", "density of the cage",
                {.dimension = dimension::density, .range = positive(25000.0)}),
          input(m.guidance, "bearing.cage.guidance", "ring that guides the cage",
                {.reason = "inertia of the carrier frame loads the cage outward"}));
}

/// Stiffness of one roller-to-race line contact.
enum class ContactLaw {
  palmgren,  // 8.06e4 l^(8/9) for one contact [N, mm]
  iso16281,  // 35948 l^(8/9) for both contacts in series [N, mm]
};

constexpr described::Names<ContactLaw, 2> names_of(ContactLaw) {
  return {{{ContactLaw::palmgren, "palmgren"}, {ContactLaw::iso16281, "iso16281"}}};
}

/// Motion of a race relative to the load: every point of a rotating one passes the load zone.
enum class RaceMotion { rotating, stationary };

struct RaceMotions {
  RaceMotion inner = RaceMotion::rotating;
  RaceMotion outer = RaceMotion::stationary;
};

/// One ring with its race.
struct Ring {
  double seat_diameter = 0.0;      // [m]  bore of the inner ring, outside diameter of the outer one
  std::vector<RaceHarmonic> form;  // of the race; none: round
  profile::Profile profile;        // of the race along rollers cut into laminae
  double osculation = 0.52;        // [-]  radius of a ball's groove over ball diameter
};

/// Cylindrical rollers of one row.
struct CylindricalRollers {
  static constexpr const char* kind = "cylindrical rollers";

  int count = 0;
  double diameter = 0.0;                   // [m]
  double length = 0.0;                     // [m]  effective contact length
  int laminae = 0;                         // into which each contact is cut; 0: one load over its length
  std::vector<double> diameter_deviation;  // [m]  (rollers)  from diameter; missing ones: 0
  profile::Profile profile;                // of one roller; with laminae only. A case states how it is made
                                           // (profile/stated_profile.hpp)
};

/// Balls of one row.
struct Balls {
  static constexpr const char* kind = "balls";

  int count = 0;
  double diameter = 0.0;       // [m]
  double contact_angle = 0.0;  // [rad]  nominal: without load where the clearance is zero
};

using Elements = std::variant<CylindricalRollers, Balls>;

/// `elements` as those of one kind. Throws std::invalid_argument where they are of another.
template <class Kind, class AnyElements>
auto& elements_of_kind(AnyElements& elements) {
  if (auto* found = std::get_if<Kind>(&elements)) return *found;
  const char* found = std::visit([](const auto& row) { return row.kind; }, elements);
  throw std::invalid_argument(std::string("rolling elements of the bearing: found ") + found +
                              "; required: " + Kind::kind);
}

/// One row of rolling elements between two rings: of a planet the inner ring sits on the pin, the outer race
/// is in the planet's bore.
struct Bearing {
  Ring inner;
  Ring outer{.osculation = 0.53};
  Cage cage;
  Elements elements;
  double pitch_diameter = 0.0;  // [m]
  double radial_clearance =
      0.0;             // [m]    internal clearance in diametral measure (ISO 5753); of balls beyond
                       //        what the nominal contact angle takes
  double width = 0.0;  // [m]    of the rings
  Material material;
  ContactLaw contact_law = ContactLaw::palmgren;  // of rollers
  RaceMotions motions{RaceMotion::stationary,
                      RaceMotion::rotating};  // of a planet, whose load is fixed to its pin
  double first_element =
      0.0;  // [rad]  angle of the first element from the radial load, under a static load; a
            //        motion and a quasi-static pitch state where they begin

  const Ring& ring(Race race) const { return race == Race::inner ? inner : outer; }
  RaceMotion motion(Race race) const { return race == Race::inner ? motions.inner : motions.outer; }
  /// Else a full complement, whose rollers touch one another.
  bool has_cage() const { return cage.width > 0.0; }
  bool has_rollers() const { return std::holds_alternative<CylindricalRollers>(elements); }

  /// For uses with one kind of elements only. Throws std::invalid_argument where they are of the other.
  const CylindricalRollers& rollers() const { return elements_of_kind<CylindricalRollers>(elements); }
  CylindricalRollers& rollers() { return elements_of_kind<CylindricalRollers>(elements); }
  const Balls& balls() const { return elements_of_kind<Balls>(elements); }
  Balls& balls() { return elements_of_kind<Balls>(elements); }

  int element_count() const {
    return std::visit([](const auto& row) { return row.count; }, elements);
  }
  double element_diameter() const {  // [m]
    return std::visit([](const auto& row) { return row.diameter; }, elements);
  }
  double contact_angle() const { return has_rollers() ? 0.0 : balls().contact_angle; }  // [rad]  nominal
};

/// D cos(alpha)/d_m [-], with the nominal contact angle.
inline double slenderness(const Bearing& bearing) {
  return bearing.element_diameter() * std::cos(bearing.contact_angle()) / bearing.pitch_diameter;
}

inline auto laminae_row(int& laminae) {
  using namespace described;
  return input(laminae, "bearing.laminae", "number of laminae of each contact, for profile and misalignment",
               {.range = {1, 200}, .may_be_absent = true, .numerical = true});
}

template <class Visitor>
void describe(Visitor& visit, CylindricalRollers& m) {
  using namespace described;
  const auto length = [](double& member, std::string path, std::string meaning) {
    return input(member, std::move(path), std::move(meaning),
                 {.dimension = dimension::length, .range = positive(1e4)});
  };
  members(visit, m, input(m.count, "bearing.rollers", "number of rollers", {.range = {3, 500}}),
          length(m.diameter, "bearing.roller_diameter", "diameter of a roller"),
          length(m.length, "bearing.roller_length", "effective contact length of a roller"),
          laminae_row(m.laminae),
          input(m.diameter_deviation, "bearing.roller_diameter_deviation",
                "diameter of each roller minus roller_diameter, from the first roller on",
                {.dimension = dimension::small_length, .range = {-1000.0, 1000.0}}),
          internal(m.profile, "bearing.profile"));
}

template <class Visitor>
void describe(Visitor& visit, Balls& m) {
  using namespace described;
  members(visit, m, input(m.count, "bearing.balls", "number of balls", {.range = {3, 500}}),
          input(m.diameter, "bearing.ball_diameter", "diameter of a ball",
                {.dimension = dimension::length, .range = positive(1e4)}),
          input(m.contact_angle, "bearing.contact_angle", "nominal contact angle",
                {.dimension = dimension::angle, .range = {0.0, 85.0}, .reason = "a deep-groove bearing"}));
}

/// Rows of one ring under `name`, "inner" or "outer". `seat` is that of its diameter. A case states forms and
/// profiles by several fields each (app/case).
template <class Visitor, class Seat>
void describe(Visitor& visit, Ring& m, const std::string& name, const Seat& seat, bool grooved) {
  using namespace described;
  const auto groove = input(m.osculation, "bearing." + name + "_osculation",
                            "radius of the " + name + " groove over ball diameter",
                            {.range = {.least = 0.5, .most = 1.4, .least_allowed = false},
                             .reason = "the grooves for which ISO 281 states f_c"});
  const std::string race = "bearing." + name + "_race";
  members(visit, m, seat, internal(m.form, race + ".form"), internal(m.profile, race + ".profile"),
          part(m.osculation, [&] {
            if (grooved) visit_row(visit, groove);
          }));
}

inline auto pitch_diameter_row(double& pitch_diameter) {
  using namespace described;
  return input(pitch_diameter, "bearing.pitch_diameter",
               "diameter of the circle of centres of rollers or balls",
               {.dimension = dimension::length, .range = positive(1e4)});
}

template <class Visitor>
void describe(Visitor& visit, Bearing& m) {
  using namespace described;
  const auto of_rings = [](double& member, std::string path, std::string meaning) {
    return input(member, std::move(path), std::move(meaning),
                 {.dimension = dimension::length, .range = positive(1e4)});
  };
  const auto bore = of_rings(m.inner.seat_diameter, "bearing.bore",
                             "bore of the inner ring and diameter of the pin; without support.stiffness the "
                             "pin stiffness is derived from it");
  const auto outside =
      of_rings(m.outer.seat_diameter, "bearing.outside_diameter", "outside diameter of the outer ring");
  const bool grooved = !m.has_rollers();
  members(
      visit, m,
      part(m.elements, [&] { std::visit([&](auto& elements) { describe(visit, elements); }, m.elements); }),
      pitch_diameter_row(m.pitch_diameter),
      input(m.radial_clearance, "bearing.radial_clearance",
            "internal clearance in diametral measure (ISO 5753); negative is interference",
            {.dimension = dimension::small_length, .range = {-100.0, 2000.0}}),
      part(m.inner, [&] { describe(visit, m.inner, "inner", bore, grooved); }),
      part(m.outer, [&] { describe(visit, m.outer, "outer", outside, grooved); }),
      of_rings(m.width, "bearing.width", "width of the rings"), part(m.cage), part(m.material),
      input(m.contact_law, "contact.law",
            "stiffness of roller and race: Palmgren's for each contact, or ISO/TS 16281's for both",
            {.reason = "each contact separately, as the film requires"}),
      apart(m.motions),  // of a single bearing a case states operation.turning_race
      input(m.first_element, "bearing.first_element_angle",
            "angle of the first rolling element from the radial load",
            {.dimension = dimension::angle,
             .range = {-360.0, 360.0},
             .reason = "the first one is on the line of the radial load"}));
}

/// Which inertial loads of the carrier frame act on the bodies in it.
struct InertiaSwitches {
  bool own_orbit = true;            // r theta'^2 of the rollers about the bearing axis
  bool coriolis = true;             // 2 Omega r theta', 2 Omega r', 2 Omega x'
  bool carrier_centrifugal = true;  // Omega^2 r and Omega^2 r_c
  bool euler = true;                // all terms in dOmega/dt
};

template <class Visitor>
void describe(Visitor& visit, InertiaSwitches& m) {
  using namespace described;
  const Details of_a_switch{.reason = "nothing left out"};
  members(
      visit, m,
      input(m.own_orbit, "inertia.own_orbit", "inertia of the rollers' orbit about the bearing", of_a_switch),
      input(m.coriolis, "inertia.coriolis", "Coriolis terms of the carrier frame", of_a_switch),
      input(m.carrier_centrifugal, "inertia.carrier_centrifugal", "centrifugal terms of the carrier frame",
            of_a_switch),
      input(m.euler, "inertia.euler", "terms of the carrier's angular acceleration", of_a_switch));
}

/// Motion of the frame of the bearing: at rest for a bearing in a housing.
struct CarrierMotion {
  double speed = 0.0;         // [rad/s]    Omega
  double acceleration = 0.0;  // [rad/s^2]  dOmega/dt
  double orbit_radius = 0.0;  // [m]        r_c, from the sun axis to the pin axis
};

}  // namespace orbearing::bearing
