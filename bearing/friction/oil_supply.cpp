#include "bearing/friction/oil_supply.hpp"

#include <cmath>

#include "bearing/friction/published_torque.hpp"
#include "bearing/motion/balls/mixture.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::friction {

namespace {

using mechanics::require;

// K_Z of Eq. (6), Table 5 of [SKF6000].
double type_constant(const Bearing& bearing) {
  return bearing.contact_angle() > 0.0 ? 4.4 : 3.1;
}

}  // namespace

balls::MotionParameters supplied(const Bearing& bearing, const balls::MotionParameters& given, double speed) {
  balls::MotionParameters supplied = given;
  if (given.drag.on && given.mixture.fill == balls::OilFill::parker) {
    require(given.mixture.flow > 0.0, "flow of oil [m^3/s]", given.mixture.flow,
            "more than 0 for a share of oil by the flow");
    require(speed != 0.0, "speed of the rings against each other [rad/s]", speed,
            "other than 0 for a share of oil by the speed");
    supplied.drag.oil_share = balls::filled_share(given.mixture.flow, bearing.pitch_diameter, speed);
  }
  if (given.mixture.starvation == balls::Starvation::skf) {
    const double bore = bearing.inner.seat_diameter, outside = bearing.outer.seat_diameter;
    require(bore > 0.0 && outside > bore, "outside diameter of the bearing [m]", outside,
            "more than its bore for starvation, both stated");
    supplied.race.rolling_share =
        starvation_factor(bore, outside, type_constant(bearing),
                          {.speed = speed, .viscosity = given.lubricant.viscosity / given.drag.oil_density});
  }
  return supplied;
}

}  // namespace orbearing::bearing::friction
