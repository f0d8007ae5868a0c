// Load and motion of a bearing: the only thing that a sweep changes.
#pragma once

#include <Eigen/Core>

#include "bearing/elastic_race.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing {

/// What a sweep changes: the load and the motion of the bearing.
struct OperatingPoint {
  CarrierMotion carrier;
  double inner_speed = 0.0;                             // [rad/s]  race of the pin, relative to the carrier
  double outer_speed = 0.0;                             // [rad/s]  race of the bore, relative to the carrier
  Eigen::Vector2d bore_load = Eigen::Vector2d::Zero();  // [N]   on the outer ring from outside the bearing
  /// Inclination [rad] of the bore's axis relative to the pin's: it runs along (x, y, 1). Felt by laminae
  /// only.
  Eigen::Vector2d bore_tilt = Eigen::Vector2d::Zero();
  ElasticRace outer_race{};  // how the outer race bends
};

/// Speed [rad/s] of the race that turns relative to the load, in whose revolutions lives count: of the inner
/// one where both do.
inline double rotating_speed(const Bearing& bearing, const OperatingPoint& point) {
  return bearing.motions.inner == RaceMotion::rotating ? point.inner_speed : point.outer_speed;
}

}  // namespace orbearing::bearing
