// What the user states about a bearing of rollers or balls and what lies around it. SI units throughout.
#pragma once

#include <vector>

#include "bearing/profile/profile.hpp"
#include "mechanics/material.hpp"

namespace orbearing::bearing {

using mechanics::Material;

/// Oil at the running temperature.
struct Lubricant {
  double viscosity = 0.0;           // [Pa s]  dynamic, at atmospheric pressure
  double pressure_viscosity = 0.0;  // [1/Pa]  Barus coefficient
};

/// The race on whose land the cage is centred.
enum class Race { inner, outer };

/// Cage of a roller bearing: a ring with one rectangular pocket for each roller.
struct Cage {
  double inner_diameter = 0.0;  // [m]
  double outer_diameter = 0.0;  // [m]
  double width = 0.0;           // [m]
  double density = 0.0;         // [kg/m^3]
  Race guidance = Race::outer;
};

/// Stiffness of one roller-to-race line contact.
enum class ContactLaw {
  palmgren,  // 8.06e4 l^(8/9) for one contact [N, mm]
  iso16281,  // 35948 l^(8/9) for both contacts in series [N, mm]
};

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

/// Which inertial loads of the carrier frame act on the bodies in it.
struct InertiaSwitches {
  bool own_orbit = true;            // r theta'^2 of the rollers about the bearing axis
  bool coriolis = true;             // 2 Omega r theta', 2 Omega r', 2 Omega x'
  bool carrier_centrifugal = true;  // Omega^2 r and Omega^2 r_c
  bool euler = true;                // all terms in dOmega/dt
};

/// How the frame of the bearing moves: at rest for a bearing in a housing.
struct CarrierMotion {
  double speed = 0.0;         // [rad/s]    Omega
  double acceleration = 0.0;  // [rad/s^2]  dOmega/dt
  double orbit_radius = 0.0;  // [m]        r_c, from the sun axis to the pin axis
};

}  // namespace orbearing::bearing
