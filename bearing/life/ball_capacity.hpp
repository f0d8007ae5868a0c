// Capacities and equivalent load of radial ball bearings, [ISO281], [ISO1281] and [ISO16281].
#pragma once

#include "bearing/life/lundberg_palmgren.hpp"

namespace orbearing::bearing::rating {

// Inputs of a rating per contact.

/// Load [N] that one contact bears for a million revolutions, on either race.
struct ContactCapacities {
  double inner = 0.0;  // [N]
  double outer = 0.0;  // [N]
};

/// Equivalent loads [N] of the contacts of one ball with either race.
struct EquivalentBallLoads {
  double inner = 0.0;  // [N]
  double outer = 0.0;  // [N]
};

/// One race rotates relative to the load, the other is stationary.
inline RaceMotions rotating(Race race) {
  if (race == Race::inner) return {};
  return {.inner = RaceMotion::stationary, .outer = RaceMotion::rotating};
}

/// Data of a radial ball bearing for its ratings.
struct BallSet {
  int rows = 1;                    // [-]
  int balls = 0;                   // [-]    in one row
  double diameter = 0.0;           // [m]    of a ball
  double pitch_diameter = 0.0;     // [m]
  double contact_angle = 0.0;      // [rad]  nominal
  double inner_osculation = 0.52;  // [-]    groove radius over ball diameter
  double outer_osculation = 0.53;  // [-]
  double material_factor = 1.3;    // [-]    b_m: 1.3 for deep-groove and angular-contact bearings
  double reduction_factor = 0.95;  // [-]    for one row; 0.90 for two
};

/// The rating's view of a bearing of balls, of one row.
BallSet ball_set(const Bearing& bearing);

/// D cos(alpha)/d_m [-], with the nominal angle.
double gamma(const BallSet& set);

/// Factor f_c [N, mm] in the closed form of [ISO1281]. The table of [ISO281] is that of both osculations
/// 0.52.
double ball_capacity_factor(double gamma, double inner_osculation = 0.52, double outer_osculation = 0.52,
                            double reduction_factor = 0.95);

/// f_c of a bearing: that of the table for grooves of up to 0.52 inside and 0.53 outside, as [ISO281] allows;
/// that of its own osculations for wider ones.
double ball_capacity_factor(const BallSet& set);

/// Basic dynamic radial load rating C_r [N].
double dynamic_capacity(const BallSet& set);

/// Basic static radial load rating C_0r [N]: Z i cos(alpha)/5 times the ball load under which the more highly
/// loaded race reaches 4200 MPa with E = 207 GPa and nu = 0.3, [ISO76].
double static_capacity(const BallSet& set);

/// Capacities [N] of one ball on either race, of a bearing whose load rating is `dynamic_capacity` [N].
ContactCapacities contact_capacities(const BallSet& set, double dynamic_capacity);

/// Factors of [ISO281] that change with the axial load.
struct AxialFactors {
  double limit = 0.0;  // [-]  e: up to this F_a/F_r the axial load does not count
  double axial = 0.0;  // [-]  Y
};

/// Under the axial load `axial` [N], linear over F_a/(i Z D^2), for nominal angles of 0 and of 15 degrees;
/// beyond the table its end values hold.
AxialFactors axial_factors(const BallSet& set, double axial);

/// Dynamic equivalent radial load P_r [N] of a deep-groove ball bearing (nominal angle 0) under `radial` and
/// `axial` [N].
double deep_groove_equivalent_load(const BallSet& set, double radial, double axial);

// Fatigue of the balls themselves, which the ratings of bearings leave out, Eq. (35) of [Chen2026].

/// Life [rev] of all balls together, in revolutions of one race relative to the other; infinite at no load.
/// `loads`: a ball turns through them, so their mean counts with the power 3.
///
/// A race and a ball of the same steel in one contact differ by the length of their track only. By Lundberg
/// and Palmgren's law, ln 1/S ~ N^e V, a ball bears (d_race/D)^(1/e) times the cycles N of the race, with
/// d_race = d_m (1 -+ gamma) and e = 10/9. In a million revolutions every point of the race is passed Z/2 (1
/// +- gamma) times; a ball turns (1 - gamma^2)/(2 gamma) times in each of them, N_j, and meets each race once
/// in a turn. The track is taken to stay where it is on the ball: one that wanders lasts longer.
double life_of_balls(const Bearing& bearing, const ContactCapacities& capacities,
                     const EquivalentBallLoads& loads);

/// Life of two parts of which neither may fail, by Weibull's product law for point contacts. Any unit.
double life_of_both(double races, double balls);

}  // namespace orbearing::bearing::rating
