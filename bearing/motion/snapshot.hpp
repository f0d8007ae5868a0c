// Observed values of the bearing at one instant: loads, slip, film, energy and losses.
#pragma once

#include <Eigen/Core>

#include "bearing/life/damage.hpp"
#include "bearing/motion/bore_motion.hpp"
#include "bearing/motion/model.hpp"

namespace orbearing::bearing::motion {

/// One race at one instant. Arrays are over rollers.
struct RaceSnapshot {
  Eigen::ArrayXd load;         // [N]
  Eigen::ArrayXd sliding;      // [m/s]  surface of the race less that of the roller
  Eigen::ArrayXd entrainment;  // [m/s]
  Eigen::ArrayXd least_film;   // [m]    zero without oil
};

/// Energy by where it is stored [J]. The centrifugal potential of the turning frame counts as stored.
struct StoredEnergy {
  double kinetic = 0.0;      // in the carrier frame, prescribed rotations excluded; waves of an elastic rim
  double centrifugal = 0.0;  // negative outward
  double races = 0.0;        // elastic contacts and films
  double pockets = 0.0;
  double neighbours = 0.0;  // rollers that touch one another
  double guidance = 0.0;
  double support = 0.0;
  double rim = 0.0;  // waves of an elastic race, beyond what the teeth hold

  double total() const {
    return kinetic + centrifugal + races + pockets + neighbours + guidance + support + rim;
  }
};

/// Power lost by cause [W], each >= 0.
struct PowerLoss {
  double race_damping = 0.0;  // of contacts, tilting rollers and an elastic rim
  double inner_traction = 0.0;
  double outer_traction = 0.0;
  double rolling = 0.0;
  double drag = 0.0;        // rollers and cage in the oil-air mixture
  double pockets = 0.0;     // damping, friction, film
  double neighbours = 0.0;  // of rollers that touch one another: damping, friction
  double guidance = 0.0;    // film, touch-down
  double support = 0.0;

  double total() const {
    return race_damping + inner_traction + outer_traction + rolling + drag + pockets + neighbours + guidance +
           support;
  }
};

/// Power that enters from outside [W].
struct PowerInput {
  double bore_load = 0.0;         // external load times velocity of the bore
  double rotations = 0.0;         // what keeps bore and pin at their speeds
  double euler = 0.0;             // inertial loads of a carrier that speeds up
  double changing_film = 0.0;     // work of the films as their speed changes
  double out_of_roundness = 0.0;  // of what holds a form or a tilt while race or rollers turn through it
  double changing_frame = 0.0;    // of the centrifugal field as the carrier's speed changes
  double teeth = 0.0;             // of their forces on an elastic rim, as they change
  double weight = 0.0;            // of rollers, cage and pin ring; that of the planet is part of bore_load

  double total() const {
    return bore_load + rotations + euler + changing_film + out_of_roundness + changing_frame + teeth + weight;
  }
};

/// The bearing at one instant.
struct Snapshot {
  RaceSnapshot inner;
  RaceSnapshot outer;
  Eigen::ArrayXd angle;          // [rad]  (rollers)  angle of each roller, from 0 to 2 pi
  Eigen::ArrayXd orbital_speed;  // [rad/s]  (rollers)  relative to the carrier
  Eigen::ArrayXd spin;           // [rad/s]  (rollers)
  bool caged = true;
  Eigen::ArrayXd pocket_load;  // [N]    (rollers)  positive where the roller drives the cage; empty without
  Eigen::ArrayXd neighbour_load;  // [N]    (rollers)  of the neighbour ahead, without a cage; else empty
  double orbit_angle = 0.0;  // [rad]  of the cage, without one the mean over the rollers; grows without bound
  double orbit_speed = 0.0;  // [rad/s]  likewise; relative to the carrier
  Vector2 cage_position = Vector2::Zero();  // [m]
  double cage_eccentricity = 0.0;           // [-]  of the land's clearance
  BoreReaction on_bore;                     // of rollers, film and, where the outer ring guides it, the cage
  BorePort port;
  RaceSpeeds race_speeds;
  /// Approaches of the contacts [m] (rollers), and the laminae; empty and none where contacts are not cut.
  Eigen::ArrayXd inner_approach, outer_approach, end_displacement;
  const LaminaRaces* laminae = nullptr;
  Eigen::VectorXd waves;  // [m]  of an elastic race; none: rigid
  PowerLoss loss;
};

/// Roller loads of the snapshot for the damage of the races; valid as long as `snapshot`.
RollerLoads loads_of(const Snapshot& snapshot);

/// Snapshot of the state `x` at `time` [s], which matters in a run-up and where waves turn with a race.
Snapshot snapshot(const BearingModel& model, const Eigen::Ref<const Eigen::VectorXd>& x, double time = 0.0);

/// As above, into a snapshot that is used again. `tilt_rate` [m/s] (rollers): how fast end displacements
/// changed in the step to `x`, for the power that tilting loses, resistance x rate^2. Null: by the excess in
/// `x`, which is exact at an instant, but after steps that are long against the tilts' own time holds mainly
/// what the steps leave.
void take_snapshot(const BearingModel& model, const Eigen::Ref<const Eigen::VectorXd>& x, Snapshot& into,
                   double time = 0.0, const double* tilt_rate = nullptr);

/// Observed values of a bearing in the state `x` with a prescribed motion of its bore: the bore follows
/// `motion`, whatever its four entries of `x` hold. Loads, speeds and frame with which `model` was made are
/// not used, nor are its excitation and its run-up; the pin ring does not turn.
Snapshot driven_snapshot(const BearingModel& model, const BoreMotion& motion,
                         const Eigen::Ref<const Eigen::VectorXd>& x);

/// Energy of the state `x` at `time` [s].
StoredEnergy stored_energy(const BearingModel& model, const Eigen::Ref<const Eigen::VectorXd>& x,
                           double time = 0.0);

/// Power that enters at `time` [s] in the state `x` whose rate is `dx`.
PowerInput power_input(const BearingModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                       const Eigen::Ref<const Eigen::VectorXd>& dx);

/// As their namesakes, under `motion`. The power of the prescribed bore motion is not included.
StoredEnergy driven_energy(const BearingModel& model, const BoreMotion& motion,
                           const Eigen::Ref<const Eigen::VectorXd>& x);
PowerInput driven_power_input(const BearingModel& model, const BoreMotion& motion,
                              const Eigen::Ref<const Eigen::VectorXd>& x,
                              const Eigen::Ref<const Eigen::VectorXd>& dx);

}  // namespace orbearing::bearing::motion
