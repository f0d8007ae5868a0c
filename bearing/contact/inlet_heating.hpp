// Shear heats the oil before the contact: it is thinner there and resists rolling less. Written once for
// plain numbers, packs and both with their slopes. No header of a library here.
//
//   share of the isothermal resistance   1/(1 + 0.29 L^0.78),   L = beta eta u^2/k
//
// [GoksemHargreaves1978], as [ZhouHoeprich1991] uses it: line contacts, pure rolling, L to about 10; here of
// points too. beta: relative fall of the viscosity per kelvin, eta: viscosity at the inlet, u: rolling speed,
// k: conductivity of the oil.
#pragma once

#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing {

/// Share [-] of the isothermal rolling resistance, from ln L of the thermal loading L above.
template <class LogLoading>
auto heated_inlet_share(const LogLoading& log_loading) {
  constexpr double kFactor = 0.29, kPower = 0.78;
  using mechanics::exponential;
  return 1.0 / (1.0 + kFactor * exponential(kPower * log_loading));
}

}  // namespace orbearing::bearing
