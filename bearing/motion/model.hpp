// The planet bearing as a multibody system: all force laws with their constants, derived once for a run.
//
//        y (sense of carrier rotation)            bodies: rollers (r, theta, spin), cage (x, y, angle),
//        ^                                        bore (x, y; turns at a given speed), pin ring (x, y; on its
//   sun  |                                        support; turns at a given speed, zero in a planet bearing)
//    +---+-----> x (outward)                      origin on the undeformed pin axis, frame turning with the
//    carrier
//
#pragma once

#include <optional>
#include <vector>

#include "bearing/carrier_frame.hpp"
#include "bearing/contact/lamina_races.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/motion/cage_guidance.hpp"
#include "bearing/motion/driving.hpp"
#include "bearing/motion/layout.hpp"
#include "bearing/motion/oil_drag.hpp"
#include "bearing/motion/parameters.hpp"
#include "bearing/motion/pin_support.hpp"
#include "bearing/motion/race_model.hpp"
#include "bearing/motion/rim.hpp"

namespace orbearing::bearing::motion {

/// Mass and inertia of one body.
struct BodyInertia {
  double mass = 0.0;     // [kg]
  double inertia = 0.0;  // [kg m^2]  about its axis
};

/// How the load on the bore changes in a run-up; all at t = 0.
struct BoreLoads {
  Vector2 meshes = Vector2::Zero();       // [N]  falls as the speed rises
  Vector2 centrifugal = Vector2::Zero();  // [N]  of the planet, rises with the square of the speed
  Vector2 euler = Vector2::Zero();        // [N]  of the planet, stays
};

/// All constants of a run. Speeds and frame are those at t = 0; see driving.hpp.
struct BearingModel {
  StateLayout layout;
  BearingGeometry geometry;
  OperatingPoint point;
  CarrierFrame frame;
  InertiaSwitches inertia;  // what the frame was made with
  BodyInertia roller;
  BodyInertia cage;
  double bore_mass = 0.0;  // [kg]
  double pin_mass = 0.0;   // [kg]
  RaceModel inner;
  RaceModel outer;
  std::optional<LaminaRaces> laminae;  // none: line contacts of straight rollers
  std::vector<vectorised::RimWave> rim;  // none: rigid
  FilmContact inner_film;
  FilmContact outer_film;
  PocketLaw pocket;                           // of a cage
  vectorised::NeighbourConstants neighbours;  // without one
  std::vector<RollerScratch> roller_scratches = {};
  std::vector<double> radius_deviation;   // [m]  (rollers)  radius of each roller less the stated one
  std::vector<Vector2> pocket_direction;  // [-]  of each pocket at cage angle zero
  vectorised::LandConstants land;
  PinSupport support;
  QuadraticDrag orbit_drag;  // of a roller's orbital motion
  QuadraticDrag spin_drag;   // churning by a roller
  QuadraticDrag cage_drag;   // churning by the cage
  MeshExcitation excitation;
  Driving driving;
  BoreLoads bore_loads;               // of a run-up
  double kinematic_cage_speed = 0.0;  // [rad/s]  at which the cage starts, and to which its slip refers
};

/// Model of `bearing` at `point`. The load on the bore holds the planet's inertial load where the bore is
/// centred and at rest, as in the quasi-static model; what displacement and velocity add to it is in the
/// equations. Speed and acceleration of the carrier stay as they are during a run, but in a run-up
/// (`parameters.driving`): then the acceleration follows from it and must not be given, and the planet's
/// Euler load is added. Throws std::invalid_argument, with what was found and what is required, where a mass,
/// a clearance or a stiffness leaves the equations without meaning.
BearingModel bearing_model(const Bearing& bearing, const OperatingPoint& point,
                           const DynamicsParameters& parameters);

/// The laminae of `model`; null where its contacts are not cut. Valid as long as the model stays in its
/// place.
inline const LaminaRaces* cut_races(const BearingModel& model) {
  return model.laminae ? &*model.laminae : nullptr;
}

/// External load on the bore [N] at `time` [s], excitation included; in a run-up
///   meshes / s + centrifugal s^2 + euler,   s = 1 + ramp t,
/// the excitation falling and quickening with the meshes.
Vector2 bore_load(const BearingModel& model, double time);
/// Its slope by time [N/s].
Vector2 bore_load_slope(const BearingModel& model, double time);

/// The carrier's frame at `time` [s].
inline CarrierFrame frame_at(const BearingModel& model, double time) {
  const double ratio = speed_ratio(model.driving, time);
  CarrierFrame frame = model.frame;
  frame.coriolis_speed *= ratio;
  frame.centrifugal *= ratio * ratio;
  return frame;
}

}  // namespace orbearing::bearing::motion
