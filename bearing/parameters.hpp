// What the user states about a bearing of rollers or balls and what lies around it. SI units throughout. The
// rows beneath each structure say what its members are for (mechanics/described.hpp).
#pragma once

#include <vector>

#include "bearing/profile/profile.hpp"
#include "mechanics/described.hpp"
#include "mechanics/material.hpp"

namespace orbearing::bearing {

using mechanics::Material;

/// Oil at the running temperature.
struct Lubricant {
  double viscosity = 0.0;           // [Pa s]  dynamic, at atmospheric pressure
  double pressure_viscosity = 0.0;  // [1/Pa]  Barus coefficient
};

/// Defaults are those of DynamicsParameters.
template <class Visitor>
void describe(Visitor& visit, Lubricant& m) {
  using namespace described;
  members(visit, m,
          field(m.viscosity, "lubricant.viscosity", Felt::carrier,
                "dynamic viscosity at the inlet, at running temperature",
                {.models = with_rollers,
                 .dimension = dimension::viscosity,
                 .range = {1e-5, 100.0},
                 .reason = "a gear oil when warm",
                 .fmu = InFmu::parameter}),
          field(m.pressure_viscosity, "lubricant.pressure_viscosity", Felt::carrier,
                "pressure-viscosity coefficient at running temperature",
                {.models = with_rollers,
                 .dimension = dimension::pressure_viscosity,
                 .range = {0.1, 100.0},
                 .reason = "a mineral oil when warm",
                 .written = "Pa-1",
                 .fmu = InFmu::parameter}));
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
    return field(member, std::move(path), Felt::carrier, std::move(meaning),
                 {.models = with_rollers,
                  .required_by = planetary_drivetrain,
                  .dimension = dimension::length,
                  .range = positive(1e4),
                  .fmu = InFmu::parameter});
  };
  members(visit, m, length(m.inner_diameter, "bearing.cage.inner_diameter", "inner diameter of the cage"),
          length(m.outer_diameter, "bearing.cage.outer_diameter", "outer diameter of the cage"),
          length(m.width, "bearing.cage.width", "axial width of the cage"),
          field(m.density, "bearing.cage.density", Felt::carrier, "density of the cage",
                {.models = with_rollers,
                 .required_by = planetary_drivetrain,
                 .dimension = dimension::density,
                 .range = positive(25000.0),
                 .fmu = InFmu::parameter}),
          field(m.guidance, "bearing.cage.guidance", Felt::carrier, "ring that guides the cage",
                {.models = planetary_drivetrain,
                 .reason = "inertia of the carrier frame throws the cage outward"}));
}

/// Stiffness of one roller-to-race line contact.
enum class ContactLaw {
  palmgren,  // 8.06e4 l^(8/9) for one contact [N, mm]
  iso16281,  // 35948 l^(8/9) for both contacts in series [N, mm]
};

constexpr described::Names<ContactLaw, 2> names_of(ContactLaw) {
  return {{{ContactLaw::palmgren, "palmgren"}, {ContactLaw::iso16281, "iso16281"}}};
}

/// One wave of a race that is not round: its radius grows by amplitude cos(order * angle + phase).
struct RaceHarmonic {
  int order = 2;           // [-]    waves around the race: 2 for an oval
  double amplitude = 0.0;  // [m]
  double phase = 0.0;      // [rad]
  bool turning = false;    // true: angle from a mark on the race (waviness made into it); false: from the
                           // outward direction (a shape that loads hold while the race turns through it)
};

/// How a film takes part in the approach of roller and race.
enum class FilmApproach {
  added,       // elastic approach = geometric approach + film
  as_printed,  // film subtracted, Eqs. (4) and (19) of [Gai2025]: see bearing/contact/printed_film.hpp
};

constexpr described::Names<FilmApproach, 2> names_of(FilmApproach) {
  return {{{FilmApproach::added, "added"}, {FilmApproach::as_printed, "as-printed"}}};
}

/// Cylindrical roller bearing between a pin (inner race) and the bore of a planet (outer race).
struct CylindricalRollerBearing {
  int rollers = 0;
  double roller_diameter = 0.0;   // [m]
  double roller_length = 0.0;     // [m]  effective contact length
  double pitch_diameter = 0.0;    // [m]
  double radial_clearance = 0.0;  // [m]  internal clearance in diametral measure (ISO 5753)
  double bore = 0.0;              // [m]  of the inner ring
  double outside_diameter = 0.0;  // [m]  of the outer ring
  double width = 0.0;             // [m]
  Material material;
  ContactLaw contact_law = ContactLaw::palmgren;
  Cage cage;
  std::vector<RaceHarmonic> inner_form;           // of the pin's race; none: round
  std::vector<RaceHarmonic> outer_form;           // of the bore's race
  std::vector<double> roller_diameter_deviation;  // [m]  (rollers)  from roller_diameter; missing ones: 0
  int laminae = 0;                  // into which each contact is cut; 0: one load over its length
  profile::Profile roller_profile;  // of one roller; with laminae only, as the next two
  profile::Profile inner_race_profile;
  profile::Profile outer_race_profile;
};

/// Rows of rollers and balls alike.
inline described::Row<double> pitch_diameter_row(double& pitch_diameter) {
  using namespace described;
  return field(pitch_diameter, "bearing.pitch_diameter", Felt::balance,
               "diameter of the circle of centres of rollers or balls",
               {.models = with_rollers | ball_bearing,
                .required_by = with_rollers | ball_bearing,
                .dimension = dimension::length,
                .range = positive(1e4),
                .fmu = InFmu::parameter});
}
inline described::Row<double> radial_clearance_row(double& radial_clearance) {
  using namespace described;
  return field(radial_clearance, "bearing.radial_clearance", Felt::balance,
               "internal clearance in diametral measure (ISO 5753); negative is interference",
               {.models = with_rollers | ball_bearing,
                .required_by = with_rollers | ball_bearing,
                .dimension = dimension::small_length,
                .range = {-100.0, 2000.0},
                .fmu = InFmu::parameter});
}

/// A case states forms and profiles by several fields each (app/case).
template <class Visitor>
void describe(Visitor& visit, CylindricalRollerBearing& m) {
  using namespace described;
  const auto length = [](double& member, std::string path, Felt felt, unsigned models, unsigned required_by,
                         std::string meaning) {
    return field(member, std::move(path), felt, std::move(meaning),
                 {.models = models,
                  .required_by = required_by,
                  .dimension = dimension::length,
                  .range = positive(1e4),
                  .fmu = InFmu::parameter});
  };
  members(
      visit, m,
      field(m.rollers, "bearing.rollers", Felt::balance, "number of rollers",
            {.models = with_rollers, .required_by = with_rollers, .range = {3, 500}, .fmu = InFmu::constant}),
      length(m.roller_diameter, "bearing.roller_diameter", Felt::balance, with_rollers, with_rollers,
             "diameter of a roller"),
      length(m.roller_length, "bearing.roller_length", Felt::balance, with_rollers, with_rollers,
             "effective contact length of a roller"),
      pitch_diameter_row(m.pitch_diameter), radial_clearance_row(m.radial_clearance),
      length(m.bore, "bearing.bore", Felt::pin, with_rollers, planetary_drivetrain,
             "bore of the inner ring, and diameter of the pin, whose stiffness follows from it where "
             "support.stiffness is left out"),
      length(m.outside_diameter, "bearing.outside_diameter", Felt::planet, with_rollers, planetary_drivetrain,
             "outside diameter of the outer ring"),
      length(m.width, "bearing.width", Felt::carrier, with_rollers, planetary_drivetrain,
             "width of the rings"),
      part(m.cage), part(m.material),
      field(m.contact_law, "contact.law", Felt::balance,
            "stiffness of roller and race: Palmgren's for each contact, or ISO/TS 16281's for both",
            {.models = with_rollers, .reason = "each contact on its own, as the film needs it"}),
      field(m.laminae, "bearing.laminae", Felt::life,
            "laminae into which each contact is cut, for profile and misalignment",
            {.models = with_rollers, .range = {1, 200}}),
      internal(m.inner_form, "bearing.inner_race.form"), internal(m.outer_form, "bearing.outer_race.form"),
      field(
          m.roller_diameter_deviation, "bearing.roller_diameter_deviation", Felt::motion,
          "by how much single rollers are larger than roller_diameter, from the first on",
          {.models = planetary_drivetrain, .dimension = dimension::small_length, .range = {-1000.0, 1000.0}}),
      internal(m.roller_profile, "bearing.profile"),
      internal(m.inner_race_profile, "bearing.inner_race.profile"),
      internal(m.outer_race_profile, "bearing.outer_race.profile"));
}

/// One row of balls between two grooved races.
struct BallBearing {
  int balls = 0;                   // [-]
  double ball_diameter = 0.0;      // [m]
  double pitch_diameter = 0.0;     // [m]
  double inner_osculation = 0.52;  // [-]    groove radius over ball diameter
  double outer_osculation = 0.53;  // [-]
  double contact_angle = 0.0;      // [rad]  nominal: without load where the clearance is zero
  double radial_clearance = 0.0;   // [m]    diametral; beyond what the nominal contact angle takes
  double first_element = 0.0;      // [rad]  place of the first ball, from the radial load
  Material material;
};

template <class Visitor>
void describe(Visitor& visit, BallBearing& m) {
  using namespace described;
  const Details groove{.models = ball_bearing,
                       .range = {.least = 0.5, .most = 1.0, .least_allowed = false},
                       .reason = "the grooves for which ISO 281 states f_c"};
  members(visit, m,
          field(m.balls, "bearing.balls", Felt::lone, "number of balls",
                {.models = ball_bearing, .required_by = ball_bearing, .range = {3, 500}}),
          field(m.ball_diameter, "bearing.ball_diameter", Felt::lone, "diameter of a ball",
                {.models = ball_bearing,
                 .required_by = ball_bearing,
                 .dimension = dimension::length,
                 .range = positive(1e4)}),
          pitch_diameter_row(m.pitch_diameter),
          field(m.contact_angle, "bearing.contact_angle", Felt::lone, "nominal contact angle",
                {.models = ball_bearing,
                 .dimension = dimension::angle,
                 .range = {0.0, 85.0},
                 .reason = "a deep-groove bearing"}),
          field(m.inner_osculation, "bearing.inner_osculation", Felt::lone,
                "radius of the inner groove over ball diameter", groove),
          field(m.outer_osculation, "bearing.outer_osculation", Felt::lone,
                "radius of the outer groove over ball diameter", groove),
          radial_clearance_row(m.radial_clearance), apart(m.first_element), part(m.material));
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
  const Details of_a_switch{.models = planetary_drivetrain, .reason = "nothing left out"};
  members(visit, m,
          field(m.own_orbit, "inertia.own_orbit", Felt::carrier,
                "inertia of the rollers' orbit about the bearing", of_a_switch),
          field(m.coriolis, "inertia.coriolis", Felt::carrier, "Coriolis terms of the carrier frame",
                of_a_switch),
          field(m.carrier_centrifugal, "inertia.carrier_centrifugal", Felt::carrier,
                "centrifugal terms of the carrier frame", of_a_switch),
          field(m.euler, "inertia.euler", Felt::euler, "terms of the carrier's angular acceleration",
                of_a_switch));
}

/// How the frame of the bearing moves: at rest for a bearing in a housing.
struct CarrierMotion {
  double speed = 0.0;         // [rad/s]    Omega
  double acceleration = 0.0;  // [rad/s^2]  dOmega/dt
  double orbit_radius = 0.0;  // [m]        r_c, from the sun axis to the pin axis
};

}  // namespace orbearing::bearing
