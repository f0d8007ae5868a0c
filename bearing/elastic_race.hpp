// An outer race that is not rigid: the ring and the body around it bend between rollers and teeth.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace orbearing::bearing {

/// Displacement of the outer race along its radius, w(phi) = sum over orders n of cosine_n cos(n phi) +
/// sine_n sin(n phi), outward positive. Waves of order 1 are displacements of the ring and stay zero: the
/// ring stands where the mean of its race stands.
struct ElasticRace {
  /// [m/N]  (orders 0, 1, ...)  c_n: a radial force of a roller of this bearing at phi' displaces the race at
  /// phi by c_n cos(n (phi - phi')), beyond what the contact law itself gives. Empty: rigid.
  Eigen::ArrayXd compliance;
  Eigen::ArrayXd cosine;  // [m]  (orders)  by whatever else presses on ring and body: the teeth of a planet
  Eigen::ArrayXd sine;    // [m]
  /// [kg]  (orders)  twice the kinetic energy of a wave whose largest radial speed is 1 m/s, over its square.
  /// Felt in motion alone, where it is required.
  Eigen::ArrayXd mass = {};

  bool is_rigid() const { return compliance.size() == 0; }
};

}  // namespace orbearing::bearing
