// Oil between a roller and a flat pocket bar: rigid surfaces, constant viscosity, flooded, no side leakage.
//
//   gap over x (along the bar): h = g + x^2 / (2 R);   V = -dg/dt closing;   u = half the sum of both surface
//   speeds relative to the contact, V and u from the same Reynolds equation:
//
//     d/dx (h^3 dp/dx) = 12 eta (u dh/dx - V)   ->   p = eta (6 V R - 4 u x) / h^2
//
// with the pressure cut where it would fall below zero (half-Sommerfeld), so that the film never pulls. All
// integrals over the film have closed forms. Entrainment alone is the contact of [Martin1916], whose other
// outlet condition gives 4.896 in place of 4; squeeze alone carries 3 sqrt(2) pi eta V l (R/g)^(3/2), as in
// [Hamrock2004].
#pragma once

#include <algorithm>
#include <cmath>

namespace orbearing::bearing::motion {

/// What the film of a line contact gives.
struct LineFilm {
  double load = 0.0;   // [N]      pushes the surfaces apart, >= 0
  double shear = 0.0;  // [N s/m]  integral of eta l / h over the pressurised film: resistance to sliding; to
                       //          entrainment it is twice this on each surface
};

/// Film of a cylinder of `radius` and `length` on a plane [m] with `viscosity` [Pa s] at the least gap `gap`
/// [m] > 0, entrainment `entrainment` >= 0 and closing speed `closing` [m/s]:
///   s = sqrt(2 R / g),  k = 3/4 s V,  psi = atan2(u, -k),  load = 2 eta l s^2 (u + k psi),
///   shear = eta l s psi.
inline LineFilm line_film(double viscosity, double length, double radius, double gap, double entrainment,
                          double closing) {
  const double s = std::sqrt(2.0 * radius / gap);
  const double k = 0.75 * s * closing;
  const double psi = std::atan2(entrainment, -k);
  return {std::max(0.0, 2.0 * viscosity * length * s * s * (entrainment + k * psi)),
          viscosity * length * s * psi};
}

/// Power lost in the film [W], >= 0, at surface speeds whose difference is `sliding` and half sum
/// `entrainment` [m/s].
inline double line_film_power(const LineFilm& film, double entrainment, double closing, double sliding) {
  return film.load * closing + film.shear * (sliding * sliding + 4.0 * entrainment * entrainment);
}

}  // namespace orbearing::bearing::motion
