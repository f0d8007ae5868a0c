#include "bearing/friction/oil_supply.hpp"

#include <cmath>

#include "bearing/friction/published_torque.hpp"
#include "bearing/motion/balls/mixture.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::friction {

namespace {

using mechanics::require;

TorqueFamily family_of(const Bearing& bearing) {
  if (bearing.has_rollers())
    return bearing.has_cage() ? TorqueFamily::cylindrical : TorqueFamily::full_complement;
  return bearing.contact_angle() > 0.0 ? TorqueFamily::angular_contact : TorqueFamily::deep_groove;
}

void starve(const Bearing& bearing, const TorqueCondition& at, motion::RaceContactParameters& race) {
  if (race.starvation == motion::Starvation::none) return;
  require(race.starvation == motion::Starvation::skf, "starvation of a bearing in motion",
          static_cast<double>(race.starvation), "none, or SKF's factor");
  const double bore = bearing.inner.seat_diameter, outside = bearing.outer.seat_diameter;
  require(bore > 0.0 && outside > bore, "outside diameter of the bearing [m]", outside,
          "more than its bore for starvation, both stated");
  race.rolling_share = starvation_factor(bore, outside, type_constant(family_of(bearing)), at);
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
  starve(bearing, {.speed = speed, .viscosity = given.lubricant.viscosity / given.drag.oil_density},
         supplied.race);
  return supplied;
}

motion::DynamicsParameters supplied(const Bearing& bearing, const motion::DynamicsParameters& given,
                                    double speed) {
  motion::DynamicsParameters supplied = given;
  starve(bearing, {.speed = speed, .viscosity = given.lubricant.viscosity / given.drag.oil_density},
         supplied.race);
  return supplied;
}

}  // namespace orbearing::bearing::friction
