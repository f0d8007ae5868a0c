// Load and motion of a bearing: the only thing that a sweep changes.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "bearing/parameters.hpp"

namespace orbearing::bearing {

// An outer race that is not rigid: the ring and the body around it bend between rollers and teeth.

/// Displacement of the outer race along its radius, w(phi) = sum over orders n of cosine_n cos(n phi) +
/// sine_n sin(n phi), outward positive. Waves of order 1 are displacements of the ring and stay zero: the
/// ring has the mean position of its race.
struct ElasticRace {
  /// [m/N]  (orders 0, 1, ...)  c_n: a radial force of a roller of this bearing at phi' displaces the race at
  /// phi by c_n cos(n (phi - phi')), beyond what the contact law itself gives. Empty: rigid.
  Eigen::ArrayXd compliance;
  Eigen::ArrayXd cosine;  // [m]  (orders)  by whatever else presses on ring and body: the teeth of a planet
  Eigen::ArrayXd sine;    // [m]
  /// [kg]  (orders)  twice the kinetic energy of a wave whose largest radial speed is 1 m/s, over its square.
  /// Used in motion only, where it is required.
  Eigen::ArrayXd mass = {};

  bool is_rigid() const { return compliance.size() == 0; }
};

/// Operating point, which a sweep changes: the load and the motion of the bearing.
struct OperatingPoint {
  CarrierMotion carrier;
  double inner_speed = 0.0;                             // [rad/s]  race of the pin, relative to the carrier
  double outer_speed = 0.0;                             // [rad/s]  race of the bore, relative to the carrier
  Eigen::Vector2d bore_load = Eigen::Vector2d::Zero();  // [N]   on the outer ring from outside the bearing
  /// Inclination [rad] of the bore's axis relative to the pin's: it runs along (x, y, 1). Affects laminae
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
