// Central and least film of an oiled point contact over load and entrainment speed, written once for plain
// numbers, packs and both with their slopes. No header of a library here: files compiled for special
// instruction sets include it.
#pragma once

#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing {

/// Data of an oiled elliptical contact that determine its film, besides load and speed.
struct OiledPoint {
  double viscosity = 0.0;           // [Pa s]  at the inlet
  double pressure_viscosity = 0.0;  // [1/Pa]
  double rolling_radius = 0.0;      // [m]   equivalent radius in the direction of rolling: R_x
  double axis_ratio = 1.0;          // [-]   of the ellipse, across over along the direction of rolling: k
  double modulus = 0.0;             // [Pa]  E/(1 - nu^2) of two like bodies: E'
};

/// h = R_x C U^a G^b W^-c (1 - d exp(-e k)) of fully flooded point contacts [HamrockDowson1977], with U = eta
/// u/(E' R_x), G = alpha E', W = Q/(E' R_x^2) and u half the sum of the surface speeds.
struct PointFilmLaw {
  double speed = 0.0;       // [-]  exponent a
  double load = 0.0;        // [-]  exponent c
  double log_factor = 0.0;  // [ln m]  at 1 m/s and 1 N

  /// In the middle of the contact.
  static PointFilmLaw central(const OiledPoint& contact) {
    return of(contact, 2.69, 0.67, 0.53, 0.067, 0.61, 0.73);
  }
  /// Least film, at the sides.
  static PointFilmLaw least(const OiledPoint& contact) {
    return of(contact, 3.63, 0.68, 0.49, 0.073, 1.0, 0.68);
  }

  /// ln(film / m) from the logarithms of the load in newtons and of the speed in metres per second.
  template <class LogLoad, class LogSpeed>
  auto log_film(const LogLoad& log_load, const LogSpeed& log_speed) const {
    return speed * log_speed - load * log_load + log_factor;
  }

 private:
  static PointFilmLaw of(const OiledPoint& c, double factor, double speed, double material, double load,
                         double side_leakage, double slenderness) {
    using mechanics::exponential, mechanics::logarithm;
    constexpr double kNone = -400.0;  // no film, and still a number
    if (c.viscosity <= 0.0) return {speed, load, kNone};
    const double leakage = 1.0 - side_leakage * exponential(-slenderness * c.axis_ratio);
    return {speed, load,
            logarithm(c.rolling_radius * factor * leakage) +
                speed * logarithm(c.viscosity / (c.modulus * c.rolling_radius)) +
                material * logarithm(c.pressure_viscosity * c.modulus) +
                load * logarithm(c.modulus * c.rolling_radius * c.rolling_radius)};
  }
};

}  // namespace orbearing::bearing
