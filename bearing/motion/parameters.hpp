// What the motion in time needs beyond the quasi-static bearing. Every default is an assumption, with its
// reason.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/parameters.hpp"

namespace orbearing::bearing::dynamics {

/// How friction in a race contact follows the sliding speed.
enum class TractionLaw {
  regularised_coulomb,  // mu Q s / sqrt(s^2 + s_0^2), Eq. (17) of [Gai2025]
  limiting_shear,       // mu Q (1 - exp(-|s| / s_c)) sign(s), film sheared up to its limiting stress
                        // [BairWiner1979]
};

/// Who carries the load of a race contact.
enum class Lubrication {
  full,   // the film, or the surfaces, alone: one law of friction
  mixed,  // film and asperities share load and friction by the film ratio [OlverSpikes1998]
};

/// What the damping of a race contact acts on.
enum class DampingLaw {
  approach_speed,  // [HuntCrossley1975]
  as_printed,      // Eq. (9) of [Gai2025]: c delta^n without a speed, which is no damping but stiffness; c is
                   // read as damping * 1 m/s of the contact's constant
};

/// Race contacts: damping, friction, and whether the film adds to the elastic approach.
struct RaceContactParameters {
  double damping = 0.1;  // [s/m]  load grows by this share per m/s of approach speed. Assumption: 10 %
                         //        of critical at 1 kN on a small roller, typical of oiled steel
  TractionLaw traction = TractionLaw::regularised_coulomb;
  double friction = 0.05;           // [-]    largest friction. Assumption: mineral oil at moderate pressure
  double sliding_scale = 0.1;       // [m/s]  s_0. Assumption: creep of oiled contacts at full friction
  double limiting_friction = 0.06;  // [-]    limiting shear stress / pressure. Assumption: mineral oil
  double least_sliding_scale =
      0.01;  // [m/s]  added to s_c, so that a film that has gone leaves finite slope. Assumption
  double largest_barus_exponent = 8.0;  // [-]    alpha p is held here: beyond it oil does not follow Barus
  double entrainment_scale = 0.01;      // [m/s]  rounds |u| at zero. Assumption: far below any running speed
  bool film_in_approach = false;        // the film takes part in the approach
  bool rolling_resistance = true;       // shear of the oil at the inlet
  FilmApproach film_approach = FilmApproach::added;
  DampingLaw damping_law = DampingLaw::approach_speed;
  Lubrication lubrication = Lubrication::full;
  double roughness = 0.2e-6;        // [m]  composite rms of roller and race. Assumption: honed races, ground
                                    //      rollers
  double boundary_friction = 0.12;  // [-]  of asperities in contact. Assumption: mineral oil with additives
};

/// Force of the oil between cage and land.
enum class GuidanceFilm {
  short_bearing,  // with squeeze and whirl, [Ocvirk1952]
  as_printed,     // Eqs. (24) and (25) of [Gai2025], which lack both
};

/// Oil between roller and pocket bar before they touch.
enum class PocketFilm {
  none,          // the bar is felt when it is touched
  hydrodynamic,  // rigid-isoviscous line contact with entrainment and squeeze
};

/// Cage speed at which a run starts and from which its slip is counted.
enum class ReferenceSpeed {
  rolling,     // pure rolling on both races
  as_printed,  // Eq. (8) of [Gai2025]: that of a turning inner race, with the speed of the outer
};

/// Cage pockets and the land that guides the cage.
struct CageParameters {
  double pocket_clearance =
      0.1e-3;                     // [m]    along the pitch circle, both sides together. Assumption: the usual
                                  //        play of moulded cages of this size
  double pocket_stiffness = 3e7;  // [N/m]  Assumption: glass-filled polyamide bar
  double pocket_damping = 1.0;    // [s/m]  as damping of the races. Assumption: polymer
  double pocket_friction = 0.05;  // [-]    Assumption: oiled
  PocketFilm pocket_film = PocketFilm::none;
  double pocket_roughness = 0.4e-6;  // [m]    where asperities hold the film. Assumption: the moulded bar,
                                     //        which outweighs the roller
  ReferenceSpeed reference_speed = ReferenceSpeed::rolling;
  double guide_diameter = 0.0;  // [m]    of the land; 0: no guidance
  double land_width = 0.0;      // [m]    of one land; 0: what cage width and roller length leave at each side
  int lands = 2;                // [-]
  GuidanceFilm guidance_film = GuidanceFilm::short_bearing;
  double largest_eccentricity =
      0.98;                           // [-]    of the land's clearance where roughness takes over. Assumption
  double touch_down_stiffness = 1e7;  // [N/m]  Assumption
  double touch_down_damping = 1.0;    // [s/m]  Assumption
  double touch_down_friction = 0.05;  // [-]    Assumption: oiled polymer on steel
};

/// Oil-air mixture around the rollers. Assumption: it rests in the carrier frame, the upper bound of its
/// drag.
struct OilDragParameters {
  bool on = true;
  double oil_density = 850.0;     // [kg/m^3]  Assumption: mineral oil
  double oil_share = 0.05;        // [-]  of the free volume. Assumption: oil mist with jets
  double drag_coefficient = 1.1;  // [-]  cylinder across the flow
  double churning_coefficient =
      0.05;  // [-]  Assumption: disc and drum friction of the Reynolds numbers at hand
};

/// Pin ring on its support in the carrier.
struct SupportParameters {
  double stiffness = 5e8;       // [N/m]  Assumption: short steel pin in both carrier walls
  double damping_ratio = 0.05;  // [-]    of pin ring and bore together on the stiffness. Assumption
};

/// One harmonic of a load: cosine cos(order angle) + sine sin(order angle).
struct LoadHarmonic {
  int order = 1;
  Eigen::Vector2d cosine = Eigen::Vector2d::Zero();  // [N]
  Eigen::Vector2d sine = Eigen::Vector2d::Zero();    // [N]
};

/// What the meshes add to the mean load on the bore as their teeth pass, as a Fourier series.
struct MeshRipple {
  double angular_frequency = 0.0;       // [rad/s]  of tooth engagement
  std::vector<LoadHarmonic> harmonics;  // in rising order
};

/// Run-up or run-down: all speeds are (1 + growth t) times those at t = 0. The meshes pass constant power, so
/// their load falls as the speed rises; inertial loads rise with its square.
struct Driving {
  double growth = 0.0;  // [1/s]  0: steady speeds
};

/// All that the roller dynamics adds to CylindricalRollerBearing.
struct DynamicsParameters {
  RaceContactParameters race;
  CageParameters cage;
  OilDragParameters drag;
  SupportParameters support;
  MeshRipple ripple;
  Driving driving;
  InertiaSwitches inertia;
  Lubricant lubricant{.viscosity = 0.01, .pressure_viscosity = 1.5e-8};  // Assumption: thin oil at 90 deg C
  double bore_mass = 0.0;  // [kg]  planet mass per bearing; 0: that of the outer ring
};

}  // namespace orbearing::bearing::dynamics
