// The planet bearing as a multibody system: all force laws with their constants, derived once for a run.
//
//        y (sense of carrier rotation)            bodies: rollers (r, theta, spin), cage (x, y, angle),
//        ^                                        bore (x, y; turns at a given speed), pin ring (x, y; on its
//   sun  |                                        support; turns at a given speed, zero in a planet bearing)
//    +---+-----> x (outward)                      origin on the undeformed pin axis, frame turning with the
//    carrier
//
#pragma once

#include <vector>

#include "bearing/carrier_frame.hpp"
#include "bearing/dynamics/cage_guidance.hpp"
#include "bearing/dynamics/cage_pocket.hpp"
#include "bearing/dynamics/layout.hpp"
#include "bearing/dynamics/oil_drag.hpp"
#include "bearing/dynamics/parameters.hpp"
#include "bearing/dynamics/pin_support.hpp"
#include "bearing/dynamics/race_forces.hpp"
#include "bearing/quasi_static.hpp"

namespace orbearing::bearing::dynamics {

/// Mass and inertia of one body.
struct BodyInertia {
  double mass = 0.0;     // [kg]
  double inertia = 0.0;  // [kg m^2]  about its axis
};

/// All constants of a run.
struct BearingModel {
  StateLayout layout;
  RollerBearingGeometry geometry;
  OperatingPoint point;
  CarrierFrame frame;
  BodyInertia roller;
  BodyInertia cage;
  double bore_mass = 0.0;  // [kg]
  double pin_mass = 0.0;   // [kg]
  RaceModel inner;
  RaceModel outer;
  FilmContact inner_film;
  FilmContact outer_film;
  PocketModel pocket;
  std::vector<Vector2> pocket_direction;  // [-]  of each pocket at cage angle zero
  GuidanceModel guidance;
  Race guiding_race = Race::outer;
  PinSupport support;
  QuadraticDrag orbit_drag;  // of a roller's orbital motion
  QuadraticDrag spin_drag;   // churning by a roller
  QuadraticDrag cage_drag;   // churning by the cage
  MeshRipple ripple;
};

/// Model of `bearing` at `point`. The load on the bore holds the planet's inertial load where the bore is
/// centred and at rest, as in the quasi-static model; what displacement and velocity add to it is in the
/// equations. Speed and acceleration of the carrier stay as they are during a run. Throws
/// std::invalid_argument, with what was found and what is required, where a mass, a clearance or a stiffness
/// leaves the equations without meaning.
BearingModel bearing_model(const CylindricalRollerBearing& bearing, const OperatingPoint& point,
                           const DynamicsParameters& parameters);

/// External load on the bore [N] at `time` [s], ripple included.
Vector2 bore_load(const BearingModel& model, double time);
/// Its slope by time [N/s].
Vector2 bore_load_slope(const BearingModel& model, double time);

}  // namespace orbearing::bearing::dynamics
