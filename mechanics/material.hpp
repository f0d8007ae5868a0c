// The material of gears, rings and rolling elements.
#pragma once

namespace orbearing::mechanics {

/// Isotropic; steel unless stated.
struct Material {
  double youngs_modulus = 206e9;  // [Pa]
  double poisson_ratio = 0.3;     // [-]
  double density = 7850.0;        // [kg/m^3]

  double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poisson_ratio)); }  // [Pa]
  /// E/(1 - nu^2) [Pa]: what resists in contacts and thin plates, where strain across is held back.
  double plane_strain_modulus() const { return youngs_modulus / (1.0 - poisson_ratio * poisson_ratio); }
};

}  // namespace orbearing::mechanics
