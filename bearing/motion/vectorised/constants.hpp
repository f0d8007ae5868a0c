// All constants of a run as plain numbers: what the vectorised model reads instead of BearingModel. No header
// of a library here, since files compiled for special instruction sets include it.
#pragma once

#include "bearing/contact/friction.hpp"
#include "bearing/contact/land_law.hpp"
#include "bearing/contact/pocket_law.hpp"
#include "bearing/contact/scratch_law.hpp"
#include "bearing/contact/squeeze_film.hpp"
#include "bearing/inertial_frame.hpp"
#include "bearing/race_harmonic.hpp"

namespace orbearing::bearing::vectorised {

/// Lanes to which the arrays over rollers are padded, whatever the instruction set.
inline constexpr int kPadding = 16;

/// Numbers in a row that others keep.
template <class T>
struct Listed {
  const T* first = nullptr;
  int count = 0;

  bool empty() const { return count == 0; }
  const T& operator[](int i) const { return first[i]; }
  const T* begin() const { return first; }
  const T* end() const { return first + count; }
};

/// Numbers of the contacts of one race. For one race Number is double; vectorised laws hold the numbers of
/// both.
template <class Number>
struct RaceNumbers {
  Number side{};               // [-]      -1 inner race, +1 outer race
  Number radius{};             // [m]
  Number speed{};              // [rad/s]  of the race now
  Number stiffness{};          // [N/m^(10/9)]
  Number log_stiffness{};      // its logarithm
  Number damping{};            // [s/m]
  Number entrainment_scale{};  // [m/s]

  FilmLaw<Number> film_law;
  SqueezeFilm<Number> squeeze;
  // Constants of a film that is a power law, in the form that its own search uses.
  Number film_factor{};        // [m^(103/90)]  thinning film times approach^(13/90), at 1 m/s
  Number film_cap{};           // [m]  largest film at 1 m/s
  Number film_cap_approach{};  // [m]  elastic approach where the cap begins, at 1 m/s
};

/// The laws of one race.
struct RaceLaws : RaceNumbers<double> {
  bool film = false;      // adds to the elastic approach
  bool squeezed = false;  // resists the approach
  FrictionLaws<double> friction;
};

/// One race: its laws and its form.
struct RaceConstants : RaceLaws {
  double turned = 0.0;  // [rad]  by the race now
  Listed<RaceHarmonic> form;
  Listed<RaceScratch> scratches;
};

/// Sets the constants of film law and stiffness for the search by powers.
inline void set_film_powers(RaceNumbers<double>& c) {
  using Film = FilmLaw<double>;
  c.film_factor = mechanics::exponential(c.film_law.log_factor - Film::kLoad * c.log_stiffness);
  c.film_cap = mechanics::exponential(c.film_law.log_unloaded(0.0));
  c.film_cap_approach =
      mechanics::exponential(LineLaw::log_approach(c.film_law.log_cap_load, c.log_stiffness));
}

/// The contacts cut into laminae; see contact/lamina_races.hpp.
struct LaminaConstants {
  int count = 0;                         // 0: line contacts of straight rollers
  const double* position = nullptr;      // (count)  -1 to 1
  const double* inner_drop = nullptr;    // (count)  [m]
  const double* outer_drop = nullptr;    // (count)  [m]
  double bore_end_displacement_x = 0.0;  // [m]
  double bore_end_displacement_y = 0.0;  // [m]
  double resistance = 0.0;               // [N s/m]  against tilting
  bool upright = true;                   // symmetric, and no roller ever tilts
};

/// A wave of an elastic outer race as a body of the motion, equation (16) of bearing/motion/README.md.
struct RimWave {
  double stiffness = 0.0;  // [N/m]
  double mass = 0.0;       // [kg]
  double damping = 0.0;    // [N s/m]
  double at_rest = 0.0;    // [m]    without rollers, under the mean forces of the teeth
};

/// The lands that guide the cage.
struct LandConstants {
  bool present = false;
  bool on_bore = true;  // the bore carries them, else the pin
  LandLaw law;
};

/// Rollers that touch one another without a cage, the same for all. Assumption: they meet along their whole
/// length, whatever their profile and tilt, with the line contact of the races, whose law contains no radius.
struct NeighbourConstants {
  double stiffness = 0.0;  // [N/m^(10/9)]
  double damping = 0.0;    // [s/m]
  CoulombFriction<double> friction;
};

/// Constants of a run.
struct Constants {
  int rollers = 0;
  double roller_radius = 0.0;   // [m]
  double roller_mass = 0.0;     // [kg]
  double roller_inertia = 0.0;  // [kg m^2]
  double orbit_drag = 0.0;      // [N s^2/m^2]
  double spin_drag = 0.0;       // [N m s^2/rad^2]
  double cage_drag = 0.0;       // [N m s^2/rad^2]

  CarrierFrame frame;               // now
  PlaneAcceleration gravity{0, 0};  // [m/s^2]  now
  double meshes = 1.0;              // [-]  forces of the teeth on the waves of a rim now, over their means

  RaceConstants inner;
  RaceConstants outer;
  LaminaConstants laminae;
  Listed<RimWave> rim;  // none: rigid

  bool caged = true;
  PocketLaw pocket;               // of a cage
  NeighbourConstants neighbours;  // without one

  int followed = 0;  // rollers whose turning is followed
  Listed<RollerScratch> roller_scratches;

  double cage_mass = 0.0;          // [kg]
  double cage_inertia = 0.0;       // [kg m^2]
  double bore_mass = 0.0;          // [kg]
  double pin_mass = 0.0;           // [kg]
  double support_stiffness = 0.0;  // [N/m]
  double support_damping = 0.0;    // [N s/m]
  LandConstants land;
};

}  // namespace orbearing::bearing::vectorised
