// Growth of the oil's viscosity with the pressure, after Roelands. Written once for plain numbers, packs and
// both with their slopes. No header of a library here.
//
//   ln(eta/eta_0) = (ln eta_0 + 9.67) ((1 + p/p_r)^Z - 1),   Z = alpha p_r/(ln eta_0 + 9.67),  p_r = 0.196
//   GPa
//
// [Roelands1966]: alpha is the slope at no pressure, as it is in Barus' exponent alpha p. Beyond some 0.5 GPa
// Barus is far above it (alpha p = 15 for 8.7 at 1 GPa, 0.02 Pa s), which is why that exponent is held.
#pragma once

#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing {

template <class Number>
struct RoelandsExponent {
  static constexpr double kInversePressure = 5.1e-9;  // [1/Pa]  1/p_r
  static constexpr double kLogReference = 9.67;       // [-]     -ln of 6.31e-5 Pa s

  Number amount{};  // [-]  ln eta_0 + 9.67
  Number power{};   // [-]  Z

  /// `viscosity` [Pa s], `pressure_viscosity` [1/Pa].
  static RoelandsExponent of(double viscosity, double pressure_viscosity) {
    const double amount = mechanics::logarithm(viscosity) + kLogReference;
    return {amount, pressure_viscosity / (kInversePressure * amount)};
  }

  /// ln(eta/eta_0) at `pressure` [Pa] >= 0.
  template <class Pressure>
  auto at(const Pressure& pressure) const {
    using namespace mechanics;
    return amount * (exponential(power * logarithm(1.0 + kInversePressure * pressure)) - 1.0);
  }
};

}  // namespace orbearing::bearing
