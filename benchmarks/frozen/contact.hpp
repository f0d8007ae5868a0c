// Frozen: a roller on a race, as commit d33b5f5 had it: elastic contact in series with the film, damping,
// Coulomb friction, rolling resistance.
#pragma once

#include <algorithm>
#include <cmath>

#include "benchmarks/frozen/plane.hpp"

namespace orbearing::bench::frozen {

/// Hunt and Crossley's damping [N].
inline double damped_load(double elastic_load, double damping, double approach_speed) {
  return elastic_load * std::max(0.0, 1.0 + damping * approach_speed);
}

/// Regularised Coulomb friction [N].
inline double regularised_friction(double friction, double load, double sliding, double scale) {
  return friction * load * sliding / std::sqrt(sliding * sliding + scale * scale);
}

/// Constants of a contact and its oil.
struct OiledLine {
  double stiffness = 0.0;           // [N/m^(10/9)]
  double equivalent_radius = 0.0;   // [m]
  double length = 0.0;              // [m]
  double reduced_modulus = 0.0;     // [Pa]
  double viscosity = 0.0;           // [Pa s]
  double pressure_viscosity = 0.0;  // [1/Pa]
};

/// Load of a race contact from its geometric approach, with a film that follows the entrainment speed.
class RaceLoadLaw {
 public:
  RaceLoadLaw() = default;
  explicit RaceLoadLaw(const OiledLine& line);

  /// Load [N] at geometric approach [m] and entrainment speed [m/s] > 0.
  double load(double approach, double entrainment) const;

 private:
  struct FilmScale {
    double factor;        // [m^(103/90)]
    double cap;           // [m]
    double cap_approach;  // [m]
  };
  FilmScale film_scale(double entrainment) const;
  double elastic_approach(double approach, double entrainment) const;

  double stiffness_ = 0.0;     // [N/m^(10/9)]
  double factor_ = 0.0;        // FilmScale at 1 m/s
  double cap_ = 0.0;           // [m]
  double cap_approach_ = 0.0;  // [m]
};

/// Resistance of the oil at the inlet to rolling.
class RollingResistance {
 public:
  RollingResistance() = default;
  explicit RollingResistance(const OiledLine& line);

  /// Backward force on each surface [N].
  double force(double load, double rolling, double entrainment) const;

 private:
  double factor_ = 0.0;  // [N] at unit speed and load
};

/// One race with its laws.
struct Race {
  double side = 1.0;               // [-]  -1 inner race, +1 outer race
  double radius = 0.0;             // [m]
  double roller_radius = 0.0;      // [m]
  double damping = 0.0;            // [s/m]
  double entrainment_scale = 0.0;  // [m/s]
  double friction = 0.0;           // [-]
  double sliding_scale = 0.0;      // [m/s]
  RaceLoadLaw load;
  RollingResistance rolling;
};

/// Relative motion in one race contact. Speeds along the tangent t = z x n.
struct ContactMotion {
  Vector2 normal;               // [-]    from the centre of the race to that of the roller
  Vector2 tangent;              // [-]
  double distance = 0.0;        // [m]
  double approach = 0.0;        // [m]
  double approach_speed = 0.0;  // [m/s]
  double sliding = 0.0;         // [m/s]
  double rolling = 0.0;         // [m/s]
  double race_arm = 0.0;        // [m]
  double roller_arm = 0.0;      // [m]
};

inline ContactMotion contact_motion(const BodyMotion& roller, const BodyMotion& race, const Race& on) {
  ContactMotion motion;
  const Vector2 between = roller.position - race.position;
  const Vector2 relative_velocity = roller.velocity - race.velocity;
  motion.distance = std::sqrt(between.squaredNorm());
  motion.normal = between / motion.distance;
  motion.tangent = across(motion.normal);
  motion.approach = on.side * (motion.distance - on.radius) + on.roller_radius;
  motion.approach_speed = on.side * relative_velocity.dot(motion.normal);
  motion.roller_arm = on.side * on.roller_radius;
  motion.race_arm = motion.distance + motion.roller_arm;
  const double line_speed = relative_velocity.dot(motion.tangent) / motion.distance;
  const double race_surface = (race.speed - line_speed) * motion.race_arm;
  const double roller_surface = (roller.speed - line_speed) * motion.roller_arm;
  motion.sliding = race_surface - roller_surface;
  motion.rolling = 0.5 * (race_surface + roller_surface);
  return motion;
}

/// Forces in one race contact.
struct RaceForces {
  Wrench on_roller;
  Wrench on_race;
};

inline RaceForces race_forces(const Race& model, const BodyMotion& roller, const BodyMotion& race) {
  const ContactMotion motion = contact_motion(roller, race, model);
  const double entrainment =
      std::sqrt(motion.rolling * motion.rolling + model.entrainment_scale * model.entrainment_scale);
  const double elastic_load = model.load.load(motion.approach, entrainment);
  RaceForces forces;
  if (elastic_load <= 0.0) return forces;
  const double load = damped_load(elastic_load, model.damping, motion.approach_speed);
  const double traction = regularised_friction(model.friction, load, motion.sliding, model.sliding_scale);
  const double inlet = model.rolling.force(load, motion.rolling, entrainment);
  const double tilt = inlet * (motion.race_arm + motion.roller_arm) / motion.distance;
  forces.on_roller.force = -model.side * load * motion.normal + (traction + tilt) * motion.tangent;
  forces.on_roller.moment = (traction - inlet) * motion.roller_arm;
  forces.on_race.force = -forces.on_roller.force;
  forces.on_race.moment = -(traction + inlet) * motion.race_arm;
  return forces;
}

}  // namespace orbearing::bench::frozen
