// Friction over the ellipse of a point contact: sliding, rolling and spin of both bodies at each point of a
// quadrature, after Eqs. (7) to (13) of [Chen2026]. Written once for plain numbers and packs. No header of a
// library here: files compiled for special instruction sets include it.
//
//   n: from the ball to the race; along: the direction of rolling; across: n x along, the ellipse's long axis
//
//        across ^    .-'''''-.
//               |  .'    b    '.        along, across, n are right-handed. The surface of contact is curved
//               | (      +--a---)       across: at X it lies X^2/(2 R_d) nearer to the ball's centre than
//               |  '.         .'        in the middle, so that the ball cannot roll on all of it (Heathcote).
//               +----'-.....-'---> along
//
#pragma once

#include "bearing/contact/pressed_oil.hpp"
#include "bearing/contact/traction_law.hpp"

namespace orbearing::bearing {

// Shear stress of an oil film under pressure, at a point of a contact: each law once, for plain numbers,
// packs and both with their slopes. A law gives friction: stress over pressure. No header of a library here:
// files compiled for special instruction sets include it.

/// Inputs of the laws.
struct ShearParameters {
  TractionLaw law = TractionLaw::ree_eyring;
  double friction = 0.05;           // [-]    Coulomb's coefficient
  double sliding_scale = 0.1;       // [m/s]  over which it builds up
  double limiting_friction = 0.06;  // [-]    limiting stress over pressure
  double eyring_stress = 5e6;       // [Pa]   at which the oil begins to thin by shear
  double viscosity = 0.0;           // [Pa s]
  double pressure_viscosity = 0.0;  // [1/Pa]
  double largest_exponent = 8.0;    // [-]    alpha p is held here: beyond it oil does not follow Barus
  bool by_roelands = false;         // else Barus
  RoelandsExponent<double> roelands{};

  /// Of balls::MotionParameters.
  template <class Motion>
  static ShearParameters of(const Motion& given) {
    constexpr double kLeastViscosity = 1e-5;  // [Pa s]  where there is no oil
    const auto& race = given.race;
    const double viscosity = given.lubricant.viscosity,
                 pressure_viscosity = given.lubricant.pressure_viscosity;
    using Pressed = decltype(Motion::race.pressure_law);
    return {.law = race.traction,
            .friction = race.friction,
            .sliding_scale = race.sliding_scale,
            .limiting_friction = race.limiting_friction,
            .eyring_stress = given.ellipse.eyring_stress,
            .viscosity = viscosity,
            .pressure_viscosity = pressure_viscosity,
            .largest_exponent = race.largest_barus_exponent,
            .by_roelands = race.pressure_law == Pressed::roelands && viscosity > 0.0,
            .roelands = RoelandsExponent<double>::of(
                viscosity > kLeastViscosity ? viscosity : kLeastViscosity, pressure_viscosity)};
  }
};

/// The oil at a point of the contact.
template <class Number>
struct PressedOil {
  Number pressure;   // [Pa]
  Number viscosity;  // [Pa s]  there
  Number per_film;   // [1/m]   inverse of the film
};

/// Viscosity [Pa s] at `pressure` [Pa] after Barus, held beyond the largest exponent, or Roelands.
template <class Number>
Number pressed_viscosity(const ShearParameters& p, const Number& pressure) {
  using mechanics::exponential, mechanics::smaller;
  if (p.by_roelands) return p.viscosity * exponential(Number(p.roelands.at(pressure)));
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

/// Gives `take` the selected law.
template <class Take>
auto with_shear_law(TractionLaw law, const Take& take) {
  switch (law) {
    case TractionLaw::regularised_coulomb:
      return take(CoulombShear{});
    case TractionLaw::limiting_shear:
      return take(LimitedNewtonianShear{});
    case TractionLaw::ree_eyring:
      return take(LimitedEyringShear{});
  }
  __builtin_trap();  // no law has another value
}

/// Points of the ellipse at which friction is taken.
struct EllipsePoints {
  static constexpr int kMost = 256;

  int count = 0;
  double across[kMost];    // [-]  of the half axis across: X/a
  double along[kMost];     // [-]  of the half axis along: Y/b
  double share[kMost];     // [-]  of the load; their sum is 1
  double pressure[kMost];  // [-]  of the largest
};

/// `slices` across the direction of rolling (Gauss and Legendre), each of `rows` points along it (Gauss and
/// Chebyshev); with one row spin turns about the middle line only. Throws std::invalid_argument for less
/// than one of either, or more than kMost points.
EllipsePoints ellipse_points(int slices, int rows);

/// One loaded ellipse.
template <class Number>
struct LoadedEllipse {
  Number load;       // [N]   > 0
  Number across;     // [m]   half axis across the direction of rolling: a
  Number along;      // [m]   half axis along it: b
  Number pressure;   // [Pa]  the largest
  Number per_film;   // [1/m]
  double curvature;  // [1/m]  of the surface of contact across: 1/R_d
  double ball;       // [m]    diameter
};

/// Motion of the race relative to the ball in the middle of the contact.
template <class Number>
struct Sliding {
  Number along, across;  // [m/s]
  Number turn_along;     // [rad/s]  about the direction of rolling
  Number turn_across;    // [rad/s]  rolling
  Number spin;           // [rad/s]  about the normal
};

/// Friction on the ball; the opposite acts on the race at the same point.
template <class Number>
struct Traction {
  Number along{}, across{};                    // [N]
  Number turn_along{}, turn_across{}, spin{};  // [N m]
};

/// Slopes of force along and across, moments of rolling and spin (rows) by sliding along and across, rolling
/// and spin (columns); symmetric but for the load's own slope.
template <class Number>
struct TractionSlopes {
  Number by[4][4]{};
};

/// Calls `take(force, sliding)` for the friction at every point and its position.
template <bool kSlopes, class Law, class Number>
void add_traction(const Law&, const ShearParameters& shear, const EllipsePoints& points,
                  const LoadedEllipse<Number>& ellipse, const Sliding<Number>& motion, Traction<Number>& sum,
                  TractionSlopes<Number>& slopes) {
  using mechanics::inverse_root, mechanics::root;
  constexpr double kRest = 1e-7;  // [m/s]  rounds sliding at rest; far below any creep
  // The ball's surface at the rim of the ellipse is where it was before it was pressed, Eq. (11).
  const Number lift = ellipse.across * ellipse.across * (0.5 * ellipse.curvature - 1.0 / ellipse.ball);
  for (int i = 0; i < points.count; ++i) {
    const Number x = points.across[i] * ellipse.across, y = points.along[i] * ellipse.along;
    const Number height = lift - (0.5 * ellipse.curvature) * (x * x);
    const Number along = motion.along + motion.turn_across * height - motion.spin * x;
    const Number across = motion.across + motion.spin * y - motion.turn_along * height;
    const Number square = along * along + across * across + kRest * kRest;
    const Number per_sliding = inverse_root(square), sliding = square * per_sliding;
    const Number pressure = points.pressure[i] * ellipse.pressure;
    const PressedOil<Number> oil{pressure, pressed_viscosity(shear, pressure), ellipse.per_film};
    const Number load = points.share[i] * ellipse.load;
    const auto friction = [&] {
      if constexpr (kSlopes)
        return Law::friction(shear, oil, mechanics::variable<0>(sliding));
      else
        return Law::friction(shear, oil, sliding);
    }();
    const Number per_speed = load * mechanics::value_of(friction) * per_sliding;  // [N s/m]
    const Number f = per_speed * along, t = per_speed * across;
    sum.along += f;
    sum.across += t;
    sum.turn_along -= height * t;
    sum.turn_across += height * f;
    sum.spin += y * t - x * f;
    if constexpr (kSlopes) {
      const Number bend =
          (load * friction.template by<0>() - per_speed) * per_sliding * per_sliding;  // of the vector's law
      const Number k11 = per_speed + bend * along * along, k12 = bend * along * across,
                   k22 = per_speed + bend * across * across;
      const Number spin1 = y * k12 - x * k11, spin2 = y * k22 - x * k12;
      auto& s = slopes.by;
      s[0][0] += k11;
      s[0][1] += k12;
      s[0][2] += height * k11;
      s[0][3] += spin1;
      s[1][1] += k22;
      s[1][2] += height * k12;
      s[1][3] += spin2;
      s[2][2] += height * height * k11;
      s[2][3] += height * spin1;
      s[3][3] += y * spin2 - x * spin1;
    }
  }
  if constexpr (kSlopes)
    for (int i = 1; i < 4; ++i)
      for (int k = 0; k < i; ++k) slopes.by[i][k] = slopes.by[k][i];
}

}  // namespace orbearing::bearing
