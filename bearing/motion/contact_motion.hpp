// How a roller moves against a race: normal, approach, sliding and rolling from the motion of both bodies.
//
//   inner race (side -1)          outer race (side +1)
//     o ---n--> (roller)            (roller) is inside; n from the race's centre to the roller's
//   race centre                     contact point at  side * roller_radius * n  from the roller's centre
//
#pragma once

#include <cmath>

#include "bearing/plane.hpp"

namespace orbearing::bearing::motion {

/// Which side of the roller a race touches, as seen along n.
struct RaceSide {
  double side = 1.0;    // [-]  -1 inner race, +1 outer race
  double radius = 0.0;  // [m]  of the race
};

/// Relative motion in one race contact. Speeds along the tangent t = z x n.
struct ContactMotion {
  Vector2 normal;               // [-]    from the centre of the race to that of the roller
  Vector2 tangent;              // [-]
  double distance = 0.0;        // [m]    between both centres
  double approach = 0.0;        // [m]    overlap of the rigid bodies, negative for a gap
  double approach_speed = 0.0;  // [m/s]
  double sliding = 0.0;         // [m/s]  surface of the race less that of the roller
  double rolling = 0.0;         // [m/s]  half the sum of both surface speeds relative to the contact
  double race_arm = 0.0;        // [m]    from the centre of the race to the contact point, along n
  double roller_arm = 0.0;      // [m]    from the centre of the roller to the contact point, along n
  double line_speed = 0.0;      // [rad/s]  at which the line of centres turns
};

/// Motion of `roller` of radius `roller_radius` [m] on `race`. Exact rigid-body kinematics: the line of
/// centres turns at its own rate, which at centred rings is the roller's orbital speed.
inline ContactMotion contact_motion(const BodyMotion& roller, double roller_radius, const BodyMotion& race,
                                    const RaceSide& on) {
  ContactMotion motion;
  const Vector2 between = roller.position - race.position;
  const Vector2 relative_velocity = roller.velocity - race.velocity;
  motion.distance = std::sqrt(between.squaredNorm());
  motion.normal = between / motion.distance;
  motion.tangent = across(motion.normal);
  motion.approach = on.side * (motion.distance - on.radius) + roller_radius;
  motion.approach_speed = on.side * relative_velocity.dot(motion.normal);
  motion.roller_arm = on.side * roller_radius;
  motion.race_arm = motion.distance + motion.roller_arm;
  motion.line_speed = relative_velocity.dot(motion.tangent) / motion.distance;
  const double race_surface = (race.speed - motion.line_speed) * motion.race_arm;
  const double roller_surface = (roller.speed - motion.line_speed) * motion.roller_arm;
  motion.sliding = race_surface - roller_surface;
  motion.rolling = 0.5 * (race_surface + roller_surface);
  return motion;
}

}  // namespace orbearing::bearing::motion
