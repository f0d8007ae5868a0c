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
#include "bearing/contact/heated_film.hpp"
#include "bearing/contact/lamina_races.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/motion/cage_and_oil.hpp"
#include "bearing/motion/layout.hpp"
#include "bearing/motion/parameters.hpp"
#include "bearing/motion/vectorised/constants.hpp"
#include "bearing/operating_point.hpp"
#include "bearing/plane.hpp"

namespace orbearing::bearing::motion {

// Speeds that change in time: a run-up in which all speeds keep their ratios. Angles integrate in closed
// form, so that the state needs no more variables.
//
//   s = 1 + ramp t,   speed = s * speed(0),   angle = speed(0) * (t + ramp t^2 / 2),   W' = ramp W(0)
//

/// All speeds at `time` [s] over those at t = 0: s.
inline double speed_ratio(const Driving& driving, double time) {
  return 1.0 + driving.ramp * time;
}

/// Forces of the meshes at `time` [s] over those at t = 0: they pass constant power.
inline double mesh_ratio(const Driving& driving, double time) {
  return 1.0 / speed_ratio(driving, time);
}

/// Time [s] in which the speeds of t = 0 would give the angles turned by `time` [s].
inline double equivalent_time(const Driving& driving, double time) {
  return time + 0.5 * driving.ramp * time * time;
}

// From the parameters to the laws of one race, and those laws for plain numbers for use outside of the
// motion.

/// One race with its laws, fixed for a run.
struct RaceModel : vectorised::RaceLaws {
  std::vector<RaceHarmonic> form;  // none: round
  std::vector<RaceScratch> scratches = {};
};

/// Speeds over which friction and films are rounded, at most `sliding_share` of the speed at pure rolling: a
/// slow bearing would otherwise slip by them. Without rotation they stay: who drives a bearing at speeds that
/// are not known here limits them before.
RaceContactParameters with_limited_scales(const BearingGeometry& geometry, const OperatingPoint& point,
                                          RaceContactParameters given);

/// Laws of `race`. `point` gives the film that is subtracted if the source's printed approach is selected.
RaceModel race_model(const Bearing& bearing, const BearingGeometry& geometry, const OperatingPoint& point,
                     Race race, const DynamicsParameters& parameters);

/// |rolling| [m/s], rounded at zero over `scale` [m/s] so that film and resistance have a slope there.
double entrainment_speed(double rolling, double scale);

/// Load [N] of a straight contact at the approach [m] of its rigid bodies and the entrainment speed [m/s] >
/// 0, without damping: the elastic contact in series with its film, where that adds to the approach.
double race_load(const vectorised::RaceLaws& race, double approach, double entrainment);
/// Energy stored in a straight contact [J] at its elastic approach [m]: the work of the load from first touch
/// at constant entrainment speed.
double race_energy(const vectorised::RaceLaws& race, double elastic_approach, double entrainment);
/// d(energy)/d(entrainment speed) [J s/m] at constant approach of the rigid bodies: what a change of the film
/// does as work.
double race_energy_slope(const vectorised::RaceLaws& race, double elastic_approach, double entrainment);

// The waves of an elastic outer race as bodies of the motion, equation (16) of bearing/motion/README.md.

/// `race` without the waves of a higher order than those that move.
ElasticRace moving_waves(ElasticRace race, const RimParameters& parameters);

/// In the order of equilibrium/elastic_waves.hpp; none for a rigid race. Throws std::invalid_argument, with
/// what was found and what is required, where a wave has no mass.
std::vector<vectorised::RimWave> rim_waves(const ElasticRace& race, const RimParameters& parameters);

// Spring and damper between the pin ring and the carrier.

/// Support of the pin ring, alike in all directions.
struct PinSupport {
  double stiffness = 0.0;  // [N/m]
  double damping = 0.0;    // [N s/m]

  /// Force on the pin ring [N] at its displacement [m] and velocity [m/s].
  Vector2 force(const Vector2& position, const Vector2& velocity) const {
    return -stiffness * position - damping * velocity;
  }
  /// Stored energy [J].
  double energy(const Vector2& position) const { return 0.5 * stiffness * position.squaredNorm(); }
  /// Dissipated power [W].
  double power(const Vector2& velocity) const { return damping * velocity.squaredNorm(); }
};

/// Mass and inertia of one body.
struct BodyInertia {
  double mass = 0.0;     // [kg]
  double inertia = 0.0;  // [kg m^2]  about its axis
};

/// Parts of the load on the bore by their change in a run-up; all at t = 0.
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
  Gravity gravity;
  BodyInertia roller;
  BodyInertia cage;
  double bore_mass = 0.0;  // [kg]
  double pin_mass = 0.0;   // [kg]
  RaceModel inner;
  RaceModel outer;
  std::optional<LaminaRaces> laminae;    // none: line contacts of straight rollers
  std::vector<vectorised::RimWave> rim;  // none: rigid
  FilmContact inner_film;
  FilmContact outer_film;
  FilmHeating film_heating;
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

/// The laminae of `model`; null where its contacts are not cut. Valid as long as the model stays at its
/// address.
inline const LaminaRaces* cut_races(const BearingModel& model) {
  return model.laminae ? &*model.laminae : nullptr;
}

/// Gravity [m/s^2] in the frame of a carrier that has turned by `angle` [rad] since the start.
Vector2 gravity_at(const BearingModel& model, double angle);
/// The carrier's angle [rad] since the start at `time` [s].
inline double carrier_angle(const BearingModel& model, double time) {
  return model.point.carrier.speed * equivalent_time(model.driving, time);
}

/// Weight of the planet [N] on the bore at `time` [s].
Vector2 weight_on_bore(const BearingModel& model, double time);

/// External load on the bore [N] at `time` [s], excitation and the planet's weight included; in a run-up
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
