// Shear stress of an oil film under pressure, at a point of a contact: each law once, for plain numbers,
// packs and both with their slopes. A law gives friction: stress over pressure. No header of a library here:
// files compiled for special instruction sets include it.
#pragma once

#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing {

/// How the oil between a ball and its race is sheared.
enum class ShearLaw {
  coulomb,         // friction coefficient, rounded at rest over a sliding speed
  limiting_shear,  // Newtonian film up to a stress in proportion to the pressure [BairWiner1979]
  ree_eyring,      // Ree-Eyring film up to the same limit [JohnsonTevaarwerk1977] [BairWiner1979]
};

/// Inputs of the laws.
struct ShearParameters {
  ShearLaw law = ShearLaw::ree_eyring;
  double friction = 0.05;           // [-]    Coulomb's coefficient
  double sliding_scale = 0.1;       // [m/s]  over which it builds up
  double limiting_friction = 0.06;  // [-]    limiting stress over pressure
  double eyring_stress = 5e6;       // [Pa]   at which the oil begins to thin by shear
  double viscosity = 0.0;           // [Pa s]
  double pressure_viscosity = 0.0;  // [1/Pa]
  double largest_exponent = 8.0;    // [-]    alpha p is held here: beyond it oil does not follow Barus
};

/// The oil at a point of the contact.
template <class Number>
struct PressedOil {
  Number pressure;   // [Pa]
  Number viscosity;  // [Pa s]  there
  Number per_film;   // [1/m]   inverse of the film
};

/// Viscosity [Pa s] at `pressure` [Pa] after Barus, held beyond the largest exponent.
template <class Number>
Number pressed_viscosity(const ShearParameters& p, const Number& pressure) {
  using mechanics::exponential, mechanics::smaller;
  return p.viscosity * exponential(smaller(p.pressure_viscosity * pressure, Number{} + p.largest_exponent));
}

/// mu s / sqrt(s^2 + s_0^2).
struct CoulombShear {
  template <class Number, class Speed>
  static auto friction(const ShearParameters& p, const PressedOil<Number>&, const Speed& sliding) {
    return p.friction * mechanics::rounded_sign(sliding, p.sliding_scale);
  }
};

/// L (1 - exp(-eta s / (h L p))): the stress eta s / h, led to its limit L p.
struct LimitedNewtonianShear {
  template <class Number, class Speed>
  static auto friction(const ShearParameters& p, const PressedOil<Number>& oil, const Speed& sliding) {
    const Number per_speed = oil.viscosity * oil.per_film / (p.limiting_friction * oil.pressure);
    return p.limiting_friction * mechanics::saturated(sliding * per_speed);
  }
};

/// t = t_0 arsinh(eta s / (h t_0)), led to its limit: L (1 - exp(-t / (L p))).
struct LimitedEyringShear {
  template <class Number, class Speed>
  static auto friction(const ShearParameters& p, const PressedOil<Number>& oil, const Speed& sliding) {
    using mechanics::logarithm, mechanics::root;
    const auto x = sliding * Number(oil.viscosity * oil.per_film * (1.0 / p.eyring_stress));
    const auto thinned = logarithm(x + root(x * x + 1.0));  // arsinh of x >= 0
    const Number per_stress = p.eyring_stress / (p.limiting_friction * oil.pressure);
    return p.limiting_friction * mechanics::saturated(thinned * per_stress);
  }
};

/// Gives `take` the law asked for.
template <class Take>
auto with_shear_law(ShearLaw law, const Take& take) {
  if (law == ShearLaw::coulomb) return take(CoulombShear{});
  if (law == ShearLaw::limiting_shear) return take(LimitedNewtonianShear{});
  return take(LimitedEyringShear{});
}

}  // namespace orbearing::bearing
