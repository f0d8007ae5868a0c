// Oil between two rigid bodies that nearly touch along a line: constant viscosity, flooded, no side leakage,
// squeezed and entrained at once. Written once for plain numbers, packs and both with their slopes; no header
// of a library here, since files compiled for special instruction sets include it.
//
//   gap over x (along the motion): h = g + x^2 / (2 R);   V = -dg/dt closing;   u = half the sum of both
//   surface speeds relative to the contact, V and u from the same Reynolds equation:
//
//     d/dx (h^3 dp/dx) = 12 eta (u dh/dx - V)   ->   p = eta (6 V R - 4 u x) / h^2
//
// with the pressure cut where it would fall below zero (half-Sommerfeld), so that the film never pulls. All
// integrals over the film have closed forms: with S = (2 R / g)^(1/2), k = 3/4 S V, psi = atan2(u, -k)
//
//   load = 2 eta l S^2 (u + k psi),   integral of eta l / h over the pressurised film = eta l S psi.
//
// Entrainment alone is the contact of [Martin1916], whose other outlet condition gives 4.896 instead of 4;
// squeeze alone carries 3 sqrt(2) pi eta V l (R/g)^(3/2), as in [Hamrock2004], twice its contribution if
// rolling takes the oil away behind it.
#pragma once

#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing {

/// Forces of the film of a line contact.
template <class Load, class Shear>
struct LineFilm {
  Load load;    // [N]      pushes the surfaces apart, >= 0 but for round-off
  Shear shear;  // [N s/m]  resistance to sliding; to entrainment it is twice this on each surface
};

/// Film of a cylinder on a plane; numbers only, so that those of two contacts can be put side by side. The
/// gap enters as `s` = slenderness(gap).
template <class Number>
struct RigidLineFilm {
  Number viscous{};        // [Pa s m]  2 eta l
  Number root_diameter{};  // [m^0.5]   (2 R)^(1/2)

  static RigidLineFilm of(double viscosity, double length, double radius) {
    return {2.0 * viscosity * length, mechanics::root(2.0 * radius)};
  }

  /// S [-] at the least gap `gap` [m] > 0.
  template <class Gap>
  auto slenderness(const Gap& gap) const {
    using mechanics::inverse_root;
    return root_diameter * inverse_root(gap);
  }
  /// Load [N] of the wedge only, at entrainment `u` [m/s] > 0.
  template <class Slenderness, class Speed>
  auto wedge(const Slenderness& s, const Speed& u) const {
    return viscous * (s * s) * u;
  }
  /// Load [N] that the closing speed `v` [m/s] adds, with the sign of `v`: if the surfaces separate, less
  /// than the load of the wedge.
  template <class Slenderness, class Speed, class Closing>
  auto squeeze(const Slenderness& s, const Speed& u, const Closing& v) const {
    using mechanics::angle_of;
    const auto k = 0.75 * (s * v);
    return viscous * (s * s) * (k * angle_of(u, -k));
  }
  /// Both, and the resistance to sliding.
  template <class Slenderness, class Speed, class Closing>
  auto at(const Slenderness& s, const Speed& u, const Closing& v) const {
    using mechanics::angle_of;
    const auto k = 0.75 * (s * v);
    const auto psi = angle_of(u, -k);
    const auto load = viscous * (s * s) * (u + k * psi);
    const auto shear = 0.5 * (viscous * s) * psi;
    return LineFilm<decltype(viscous * (s * s) * (u + k * psi)), decltype(0.5 * (viscous * s) * psi)>{load,
                                                                                                      shear};
  }
};

}  // namespace orbearing::bearing
