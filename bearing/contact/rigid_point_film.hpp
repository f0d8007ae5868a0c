// Oil between two rigid bodies that nearly touch in a point: constant viscosity, flooded, squeezed and
// entrained at once. Written once for plain numbers and packs; no header of a library here, since files
// compiled for special instruction sets include it.
//
//   gap h = g + x^2 / (2 R_x) + y^2 / (2 R_y),   V = -dg/dt,   u = half the sum of both surface velocities
//   relative to the contact; Reynolds' equation  div(h^3 grad p) = 12 eta (u . grad h - V)  is solved by
//
//     p = (c - a_x x - a_y y) / h^2,   c = 6 eta V / (1/R_x + 1/R_y),   a_x = 12 eta u_x / (3 + 2 R_x / R_y),
//
//   cut where it would fall below zero (half-Sommerfeld), so that the film never pulls. With
//   A^2 = 2 g (R_x a_x^2 + R_y a_y^2) its resultant is  pi sqrt(R_x R_y) / g (c + sqrt(A^2 + c^2)).
//
// Squeeze alone on a sphere before a plane is Taylor's 6 pi eta R^2 V / g; entrainment alone that of
// [Kapitza1955], as in [Hamrock2004].
#pragma once

#include "mechanics/numbers.hpp"

namespace orbearing::bearing {

/// Load of a film and what it does to surfaces that slide, with the slopes that a stage of a step needs.
template <class Number>
struct RigidPointLoad {
  Number load;          // [N]      pushes apart, >= 0
  Number by_gap;        // [N/m]    <= 0
  Number by_closing;    // [N s/m]  >= 0
  Number by_ux, by_uy;  // [N s/m]
  Number shear;         // [N s/m]  of both surfaces against sliding
};

/// What closing adds to the load of the wedge, with slopes.
template <class Number>
struct SqueezedPoint {
  Number load;        // [N]      with the sign of the closing speed
  Number by_gap;      // [N/m]
  Number by_closing;  // [N s/m]  >= 0
};

struct RigidPointFilm {
  double size = 0.0;         // [m]       pi sqrt(R_x R_y); 0: no film
  double squeeze = 0.0;      // [N s/m]   c / V
  double entrained_x = 0.0;  // [N s m^-1.5]  A / (sqrt(g) u_x)
  double entrained_y = 0.0;
  double rolling_x = 0.0;  // [-]       traction on each surface over shear times u_x
  double rolling_y = 0.0;
  double viscosity = 0.0;  // [Pa s]
  double extent = 0.0;     // [m]       gap by which the film ends: that at its edge less that in its middle
  double least_gap = 0.0;  // [m]       where asperities hold it

  bool present() const { return size > 0.0; }

  /// Of radii `rx`, `ry` [m] that reaches as far as `wide_x`, `wide_y` [m] from its middle.
  static RigidPointFilm between(double viscosity, double rx, double ry, double wide_x, double wide_y,
                                double least_gap) {
    constexpr double kPi = 3.14159265358979323846;
    const auto wedge = [&](double along, double across) {
      return 12.0 * viscosity / (3.0 + 2.0 * along / across);
    };
    const auto rolling = [](double along, double across) { return 6.0 / (3.0 + 2.0 * along / across); };
    const double mean = __builtin_sqrt(rx * ry);
    return {.size = kPi * mean,
            .squeeze = 6.0 * viscosity / (1.0 / rx + 1.0 / ry),
            .entrained_x = wedge(rx, ry) * __builtin_sqrt(2.0 * rx),
            .entrained_y = wedge(ry, rx) * __builtin_sqrt(2.0 * ry),
            .rolling_x = rolling(rx, ry),
            .rolling_y = rolling(ry, rx),
            .viscosity = viscosity,
            .extent = wide_x * wide_y / (2.0 * mean),
            .least_gap = least_gap};
  }

  /// Load [N] of the wedge alone at `gap` [m], entrained along x with `ux` [m/s].
  template <class Number>
  Number wedge(const Number& gap, const Number& ux) const {
    using namespace mechanics;
    return (size * entrained_x) * absolute(ux) * inverse_root(gap);
  }
  /// What closing at `closing` [m/s] adds to it: where surfaces part, less than what the wedge carries.
  template <class Number>
  SqueezedPoint<Number> squeezed(const Number& gap, const Number& closing, const Number& ux) const {
    using namespace mechanics;
    constexpr double kAtRest = 1e-30;  // [N^2/m^2]  keeps the slope finite
    const Number c = squeeze * closing, per_gap = size / gap;
    const Number x = entrained_x * ux, carried = x * x;
    const Number alone = root(gap * carried + kAtRest), together = root(gap * carried + c * c + kAtRest);
    const Number load = per_gap * c * (1.0 + c / (together + alone));
    return {load, per_gap * (0.5 * carried) * (1.0 / together - 1.0 / alone) - load / gap,
            (squeeze * per_gap) * (1.0 + c / together)};
  }

  /// At `gap` [m], which the least gap bounds, closing at `closing` and entrained with `ux`, `uy` [m/s].
  /// Shear is that of h from its middle to its edge over the half that carries, and over both where it is
  /// squeezed.
  template <class Number>
  RigidPointLoad<Number> at(const Number& gap, const Number& closing, const Number& ux,
                            const Number& uy) const {
    using namespace mechanics;
    constexpr double kAtRest = 1e-30;  // [N^2/m^2]  keeps the slope finite
    const Number held = Number{} + least_gap;
    const Number g = larger(gap, held);
    const auto free = gap > held;
    const Number c = squeeze * closing;
    const Number x = entrained_x * ux, y = entrained_y * uy;
    const Number wedge = x * x + y * y;
    const Number together = root(g * wedge + c * c + kAtRest);
    const Number per_gap = size / g;
    const Number load = per_gap * (c + together);
    const Number pressed = larger(c, Number{}) / together;
    return {load,
            only(free, per_gap * (0.5 * wedge / together) - load / g),
            (squeeze * per_gap) * (1.0 + c / together),
            (size * entrained_x) * x / together,
            (size * entrained_y) * y / together,
            (size * viscosity) * (1.0 + pressed) * logarithm(1.0 + extent / g)};
  }
};

}  // namespace orbearing::bearing
