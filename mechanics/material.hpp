// The material of gears, rings and rolling elements.
#pragma once

#include "mechanics/described.hpp"

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

/// Elastic constants, for bodies without mass.
struct Elasticity {
  double youngs_modulus = Material{}.youngs_modulus;  // [Pa]
  double poisson_ratio = Material{}.poisson_ratio;    // [-]

  Material material() const { return {.youngs_modulus = youngs_modulus, .poisson_ratio = poisson_ratio}; }
};

inline constexpr std::string_view steel = "rolling bearing steel";

inline auto youngs_modulus_row(double& member) {
  using namespace described;
  return input(member, "material.youngs_modulus", "Young's modulus of gears, rings and rollers",
               {.dimension = dimension::stress, .range = {1.0, 1000.0}, .reason = steel});
}
inline auto poisson_ratio_row(double& member) {
  using namespace described;
  return input(member, "material.poisson_ratio", "Poisson's ratio of gears, rings and rollers",
               {.range = {.least = 0.0, .most = 0.5, .most_allowed = false}, .reason = steel});
}

inline auto density_row(double& member) {
  using namespace described;
  return input(member, "material.density", "density of gears, rings and rollers",
               {.dimension = dimension::density, .range = {100.0, 25000.0}, .reason = steel});
}

template <class Visitor>
void describe(Visitor& visit, Elasticity& m) {
  described::members(visit, m, youngs_modulus_row(m.youngs_modulus), poisson_ratio_row(m.poisson_ratio));
}

template <class Visitor>
void describe(Visitor& visit, Material& m) {
  using namespace described;
  members(visit, m, youngs_modulus_row(m.youngs_modulus), poisson_ratio_row(m.poisson_ratio),
          density_row(m.density));
}

}  // namespace orbearing::mechanics
