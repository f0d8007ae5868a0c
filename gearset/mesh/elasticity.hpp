// The material of a pair of gears.
#pragma once

namespace orbearing::gearset {

/// Isotropic, the same for both gears.
struct Elasticity {
  double youngs_modulus = 206e9;  // [Pa]
  double poisson_ratio = 0.3;     // [-]

  double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poisson_ratio)); }  // [Pa]
};

}  // namespace orbearing::gearset
