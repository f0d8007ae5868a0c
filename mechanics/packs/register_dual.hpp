// A plain number with its slopes by up to eight variables, side by side in a register.
#pragma once

#include "mechanics/packs/pack.hpp"
#include "mechanics/sparse_dual.hpp"

namespace orbearing::mechanics::ORBEARING_PACKS {

/// Eight numbers, in as many registers as they take: a vector wider than a register goes through memory.
#if ORBEARING_REGISTER_LANES == 8
using SlopeVector = Register;
#elif ORBEARING_REGISTER_LANES == 4
using SlopeVector = Pack;
#else
using SlopeVector = Two<Pack>;
#endif
inline constexpr int kSlopes = 8;
static_assert(sizeof(SlopeVector) == kSlopes * sizeof(double));

/// All slopes go as one: those that vanish cost nothing here.
using RegisterDual = SparseDual<1u, double, SlopeVector>;

/// The variable number `index` itself, below kSlopes.
inline RegisterDual register_variable(double number, int index) {
  RegisterDual x{number, {SlopeVector{}}};
  reinterpret_cast<double*>(x.slope)[index] = 1.0;
  return x;
}
/// Slope by the variable number `index`.
inline double slope_by(const RegisterDual& x, int index) {
  return reinterpret_cast<const double*>(x.slope)[index];
}

}  // namespace orbearing::mechanics::ORBEARING_PACKS
