// All that passes between a roller and a race: load, traction and rolling resistance, balanced on both
// bodies.
#pragma once

#include "bearing/dynamics/contact_damping.hpp"
#include "bearing/dynamics/contact_motion.hpp"
#include "bearing/dynamics/race_load.hpp"
#include "bearing/dynamics/traction.hpp"

namespace orbearing::bearing::dynamics {

/// One race with its laws, fixed for a run.
struct RaceModel {
  RaceSide side;
  double roller_radius = 0.0;      // [m]
  double damping = 0.0;            // [s/m]
  double entrainment_scale = 0.0;  // [m/s]
  bool with_rolling_resistance = false;
  RaceLoadLaw load;
  TractionCurve traction;
  RollingResistance rolling;
};

/// Forces in one race contact.
struct RaceForces {
  Wrench on_roller;
  Wrench on_race;
  double load = 0.0;            // [N]    with damping
  double sliding = 0.0;         // [m/s]
  double entrainment = 0.0;     // [m/s]  > 0
  double damping_power = 0.0;   // [W]    dissipated, as are all powers
  double traction_power = 0.0;  // [W]
  double rolling_power = 0.0;   // [W]
};

/// |rolling| [m/s], rounded at zero over `scale` [m/s] so that film and resistance have a slope there.
inline double entrainment_speed(double rolling, double scale) {
  return std::sqrt(rolling * rolling + scale * scale);
}

/// Forces between a roller and the race of `model`. The tangential force of the rolling resistance on the
/// roller makes the moments of both surfaces balance; it is what the tilted oil pressure leaves after the
/// drag at the inlet.
inline RaceForces race_forces(const RaceModel& model, const BodyMotion& roller, const BodyMotion& race) {
  const ContactMotion motion = contact_motion(roller, model.roller_radius, race, model.side);
  RaceForces forces;
  forces.sliding = motion.sliding;
  forces.entrainment = entrainment_speed(motion.rolling, model.entrainment_scale);
  const double elastic_load = model.load.load(motion.approach, forces.entrainment);
  if (elastic_load <= 0.0) return forces;
  const DampedLoad normal = damped_load(elastic_load, model.damping, motion.approach_speed);
  const double traction = model.traction.force(normal.load, motion.sliding, forces.entrainment);
  const double inlet = model.with_rolling_resistance
                           ? model.rolling.force(normal.load, motion.rolling, forces.entrainment)
                           : 0.0;
  const double pressure_tilt = inlet * (motion.race_arm + motion.roller_arm) / motion.distance;

  forces.load = normal.load;
  forces.on_roller.force =
      -model.side.side * normal.load * motion.normal + (traction + pressure_tilt) * motion.tangent;
  forces.on_roller.moment = (traction - inlet) * motion.roller_arm;
  forces.on_race.force = -forces.on_roller.force;
  forces.on_race.moment = -(traction + inlet) * motion.race_arm;
  forces.damping_power = normal.power;
  forces.traction_power = traction * motion.sliding;
  forces.rolling_power = 2.0 * inlet * motion.rolling;
  return forces;
}

/// Energy stored in the contact [J].
inline double race_energy(const RaceModel& model, const BodyMotion& roller, const BodyMotion& race) {
  const ContactMotion motion = contact_motion(roller, model.roller_radius, race, model.side);
  return model.load.energy(motion.approach, entrainment_speed(motion.rolling, model.entrainment_scale));
}

}  // namespace orbearing::bearing::dynamics
