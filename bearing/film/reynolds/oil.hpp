// Oil under pressure as Reynolds' equation needs it: viscosity after Roelands, density after Dowson and
// Higginson, shear thinning after Eyring.
#pragma once

#include <cmath>

#include "bearing/contact/pressed_oil.hpp"

namespace orbearing::bearing::film {

/// Properties of the oil of a film.
struct ReynoldsOil {
  double viscosity = 0.0;           // [Pa s]  dynamic, at atmospheric pressure
  double pressure_viscosity = 0.0;  // [1/Pa]  0: the same viscosity at every pressure
  double eyring_stress = 0.0;       // [Pa]    at which shear begins to thin the oil; 0: Newtonian
  bool compressible = true;         // else of the same density at every pressure
};

/// Viscosity over that at rest, density over that at rest, and their slopes by pressure.
struct OilState {
  double viscosity = 1.0;            // [-]
  double viscosity_log_slope = 0.0;  // [1/Pa]
  double density = 1.0;              // [-]
  double density_slope = 0.0;        // [1/Pa]
};

/// Eqs. (7) and (8) of [Guo2013] with pressures in Pa: [Roelands1966], [DowsonHigginson1966].
class OilUnderPressure {
 public:
  explicit OilUnderPressure(const ReynoldsOil& oil)
      : compressible_(oil.compressible),
        log_range_(std::log(oil.viscosity) + kLogReference),
        exponent_(log_range_ > 0.0 ? oil.pressure_viscosity / (kInversePressure * log_range_) : 0.0) {}

  /// At `pressure` [Pa] >= 0.
  OilState at(double pressure) const {
    OilState state;
    if (pressure <= 0.0) {
      state.viscosity_log_slope = exponent_ * log_range_ * kInversePressure;
      state.density_slope = compressible_ ? kDensityRise : 0.0;
      return state;
    }
    if (exponent_ > 0.0) {
      const double base = 1.0 + kInversePressure * pressure;
      const double power = std::exp(exponent_ * std::log(base));
      state.viscosity = std::exp(log_range_ * (power - 1.0));
      state.viscosity_log_slope = log_range_ * exponent_ * kInversePressure * power / base;
    }
    if (compressible_) {
      const double below = 1.0 + kDensityLimit * pressure;
      state.density = 1.0 + kDensityRise * pressure / below;
      state.density_slope = kDensityRise / (below * below);
    }
    return state;
  }

 private:
  static constexpr double kLogReference = RoelandsExponent<double>::kLogReference;
  static constexpr double kInversePressure = RoelandsExponent<double>::kInversePressure;
  static constexpr double kDensityRise = 0.6e-9;   // [1/Pa]
  static constexpr double kDensityLimit = 1.7e-9;  // [1/Pa]

  bool compressible_;
  double log_range_;  // [-]  ln of the viscosity over Roelands' reference
  double exponent_;   // [-]  Z
};

/// Flow factors of the oil along and across its shearing: Newtonian oil has 1 and 1. `shear` [-] is viscosity
/// times sliding speed over film and Eyring's stress. Mean stresses of a film that slides much more than
/// pressure makes it flow, [EhretDowsonTaylor1998].
struct EyringFlow {
  double along = 1.0;
  double across = 1.0;
  double along_power = 0.0;   // d ln(along)/d ln(shear)
  double across_power = 0.0;  // d ln(across)/d ln(shear)
};

inline EyringFlow eyring_flow(double shear) {
  constexpr double kNewtonian = 1e-4;  // below it both differ from 1 by less than 1e-8
  if (shear < kNewtonian) return {};
  const double root = std::sqrt(1.0 + shear * shear), stress = std::asinh(shear);
  return {root, shear / stress, shear * shear / (root * root), 1.0 - shear / (root * stress)};
}

}  // namespace orbearing::bearing::film
