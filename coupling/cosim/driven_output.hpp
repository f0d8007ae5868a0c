// What a driven bearing shows, from what can be read off it at an instant.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "coupling/cosim/driven_bearing.hpp"

namespace orbearing::cosim {

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
