// What a driven bearing shows, from what can be read off it at an instant.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <vector>

#include "bearing/geometry.hpp"
#include "bearing/motion/bore_motion.hpp"
#include "bearing/motion/snapshot.hpp"

namespace orbearing::cosim {

/// At the present time.
struct DrivenBearingOutput {
  bearing::dynamics::BoreReaction reaction;
  double cage_speed = 0.0;   // [rad/s]  relative to the carrier
  double cage_slip = 0.0;    // [-]  1 - cage speed / kinematic cage speed; 0 where nothing turns
  double life_used = 0.0;    // [-]  revolutions so far over the life (in revolutions) under the loads so far
  double revolutions = 0.0;  // [-]  of the bore relative to the carrier, since the start; absolute value
  double friction_loss = 0.0;        // [W]
  std::vector<double> inner_load;    // [N]  (rollers)
  std::vector<double> outer_load;    // [N]  (rollers)
  std::vector<double> roller_angle;  // [rad]  (rollers)
};

/// Of `now`, under a bore that turns at `bore_speed` [rad/s] and has turned by `turned` [rad] there and back;
/// `life` [rev] under the loads so far.
inline DrivenBearingOutput driven_output(const bearing::RollerBearingGeometry& geometry, double bore_speed,
                                         const bearing::dynamics::Snapshot& now,
                                         const bearing::dynamics::BoreReaction& reaction, double turned,
                                         double life) {
  constexpr double kLeastSpeed = 1e-9;  // [rad/s]  below it nothing turns
  const double kinematic = kinematic_cage_speed(geometry, 0.0, bore_speed);
  DrivenBearingOutput output;
  output.reaction = reaction;
  output.cage_speed = now.cage_speed;
  output.cage_slip = std::abs(kinematic) > kLeastSpeed ? 1.0 - now.cage_speed / kinematic : 0.0;
  output.revolutions = turned / boost::math::double_constants::two_pi;
  output.life_used = output.revolutions / life;
  output.friction_loss = now.loss.total();
  output.inner_load.assign(now.inner.load.begin(), now.inner.load.end());
  output.outer_load.assign(now.outer.load.begin(), now.outer.load.end());
  output.roller_angle.assign(now.angle.begin(), now.angle.end());
  return output;
}

}  // namespace orbearing::cosim
