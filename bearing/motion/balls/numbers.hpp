// All constants of a ball bearing in motion as plain numbers. No header of a library here, since files
// compiled for special instruction sets include it.
#pragma once

#include "bearing/contact/ellipse_traction.hpp"
#include "bearing/contact/land_law.hpp"
#include "bearing/contact/point_film.hpp"
#include "bearing/contact/point_rolling.hpp"
#include "bearing/contact/squeeze_film.hpp"
#include "bearing/contact/scratch_law.hpp"

namespace orbearing::bearing::balls {

/// Lanes to which the arrays over balls are padded, whatever the instruction set.
inline constexpr int kPadding = 16;

/// Scratches across a race, all alike.
struct ScratchNumbers {
  static constexpr int kMost = 32;

  int count = 0;
  double angle[kMost]{};      // [rad]  of their middles when the motion begins
  double track_radius = 0.0;  // [m]    of the race where balls run
  ScratchLaw law;
};

/// Round scratches on balls, all alike. How each is turned is part of the state.
struct SpotNumbers {
  static constexpr int kMost = 4;

  int count = 0;
  int ball[kMost]{};      // that has it, from 0
  double angle[kMost]{};  // [rad]  from the contact with the outer race, in the plane of rolling, at the start
  ScratchLaw on_inner;
  ScratchLaw on_outer;
};

/// One grooved race with its contact.
struct GrooveNumbers {
  double centre_radius = 0.0;  // [m]        of the circle on which the groove's centre lies, in the ring's axes
  double centre_axial = 0.0;   // [m]        along the ring's axis from its centre
  double play = 0.0;           // [m]        groove radius less ball radius: contact begins at this distance
  double stiffness = 0.0;      // [N/m^1.5]
  double damping = 0.0;        // [s/m]      share by which the load grows per speed of approach
  double across = 0.0;         // [m/N^(1/3)]   half axis of the ellipse across the direction of rolling
  double along = 0.0;          // [m/N^(1/3)]   along it
  double pressure = 0.0;       // [Pa/N^(1/3)]  largest pressure
  double curvature = 0.0;      // [1/m]      of the surface of contact across
  double rolling_radius = 0.0; // [m]        equivalent radius along: R_x
  double rolling_factor = 0.0; // [N m]      couple against rolling at 1 m/s and 1 N, of the first power law; 0: none
  PointRolling rolling;
  double inlet_heating = 0.0;  // [s^2/m^2]  beta eta/k, contact/inlet_heating.hpp; 0: isothermal
  PointFilmLaw central_film;
  PointFilmLaw least_film;
  PointSqueezeFilm squeeze;  // none: oil does not resist the approach
  ScratchNumbers scratch;
};

/// Pockets of the cage: cylinders along its radii, drawn out by a straight part along the pitch circle.
struct PocketNumbers {
  double play = 0.0;           // [m]       pocket radius less ball radius
  double half_straight = 0.0;  // [m]       half the length of the straight part
  double stiffness = 0.0;      // [N/m^1.5]
  double damping = 0.0;        // [s/m]
  double friction = 0.0;       // [-]
  double sliding_scale = 0.0;  // [m/s]
  RigidPointFilm film;         // x along the cage's radius, y round the pocket
};

/// A ring or the cage as a rigid body.
struct BodyNumbers {
  double mass = 0.0;     // [kg]      0: held, its position is given
  double across = 0.0;   // [kg m^2]  about a diameter
  double polar = 0.0;    // [kg m^2]  about its axis
};

/// Cage on the lands of one ring, half its width at either side.
struct LandNumbers {
  bool present = false;
  bool on_outer = true;
  double offset = 0.0;  // [m]  of each land from the middle plane
  LandLaw law;          // of one land
};

/// Moments that drive the oil-air mixture round the bearing and that resist it (mixture.hpp).
struct MixtureNumbers {
  bool carried = false;       // else it rests in the housing, the upper bound of drag
  int count = 0;              // of balls
  double slenderness = 0.0;   // [-]
  double pitch_radius = 0.0;  // [m]
  double inner_radius = 0.0;  // [m]  of the walls
  double outer_radius = 0.0;  // [m]
  double width = 0.0;         // [m]
  double density = 0.0;       // [kg/m^3]
  double viscosity = 0.0;     // [m^2/s]          kinematic
  double flow = 0.0;          // [kg/s]           oil that comes in and goes out
  double balls = 0.0;         // [N m s^2/rad^2]  drag of all balls about the axis, the mixture at rest
  double cage = 0.0;          // [N m s^2/rad^2]
  double share = 0.0;         // [-]  its speed over that of the cage at pure rolling
};

/// Drag of the oil on a body: forces -coefficient speed |speed|, speeds in the axes of the housing. In a
/// mixture that rotates at a fixed share of the cage's speed, the coefficients are reduced accordingly.
struct DragNumbers {
  double translation = 0.0;    // [N s^2/m^2]       of a ball
  double churning = 0.0;       // [N m s^2/rad^2]   of a ball
  double cage_churning = 0.0;  // [N m s^2/rad^2]
  MixtureNumbers mixture;
};

struct BallNumbers {
  int balls = 0;
  double radius = 0.0;   // [m]
  double mass = 0.0;     // [kg]
  double inertia = 0.0;  // [kg m^2]
  double pitch_radius = 0.0;       // [m]
  double entrainment_scale = 0.0;  // [m/s]  rounds entrainment at zero
  GrooveNumbers inner;
  GrooveNumbers outer;
  ShearParameters shear;
  EllipsePoints points;
  PocketNumbers pocket;
  LandNumbers land;
  DragNumbers drag;
  double oil_flow = 0.0;  // [m^3/s]  through the bearing
  SpotNumbers spots;
  BodyNumbers inner_ring;
  BodyNumbers outer_ring;
  BodyNumbers cage;
};

}  // namespace orbearing::bearing::balls
