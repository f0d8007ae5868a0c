// Films in elliptical contacts that roll and spin: regressions of [Guo2013], Eqs. (10) to (13).
//
// Misprints of the source, mended here: G is the product of pressure-viscosity coefficient and modulus; the
// second constant of Eq. (10) is 1.418e5, since with 1.418e-5 no speed would have an effect.
#pragma once

#include <string>
#include <vector>

#include "bearing/parameters.hpp"
#include "mechanics/described.hpp"
#include "mechanics/numbers.hpp"
#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing::film {

/// Contact data that the regressions use.
struct EllipticalContact {
  double rolling_radius = 0.0;  // [m]   equivalent, in the plane of rolling: R_x
  double ellipticity = 1.0;     // [-]   axis across rolling over that along it
  double modulus = 0.0;         // [Pa]  E/(1 - nu^2) for like bodies
};

/// Contact of a ball on a race at the nominal contact angle.
EllipticalContact ball_contact(const Bearing& bearing, Race race);

/// Load and motion of the contact.
struct ContactMotion {
  double load = 0.0;     // [N]
  double rolling = 0.0;  // [m/s]    mean speed of both surfaces
  double spin = 0.0;     // [rad/s]  of one against the other about the normal
};

template <class Visitor>
void describe(Visitor& visit, ContactMotion& m) {
  using namespace described;
  members(visit, m, input(m.load, "load", "of the contact", {.dimension = dimension::force, .range = positive(1e9)}),
          input(m.rolling, "rolling_speed", "mean of both surfaces",
                {.dimension = dimension::speed, .range = positive(1e4)}),
          input(m.spin, "spin", "of one surface against the other",
                {.dimension = dimension::spin, .range = {-1e6, 1e6}}));
}

struct Films {
  double rigid = 0.0;    // [m]  approach of the bodies without their deformation less film: h_0
  double central = 0.0;  // [m]
  double least = 0.0;    // [m]
  double central_hamrock_dowson = 0.0;  // [m]  Eq. (13), without spin
  double least_hamrock_dowson = 0.0;    // [m]
};

/// Eqs. (10) to (13). A least film that spin makes vanish is 0.
Films spin_films(const EllipticalContact& contact, const Lubricant& oil, const ContactMotion& motion);

/// Inputs outside of the ranges of the regressions; empty where there are none.
std::vector<std::string> outside_of_range(const EllipticalContact& contact, const ContactMotion& motion);

/// Load by approach: Eq. (10) solved for the load.
template <class Number>
struct ApproachLawIn {
  Number constant{};     // [N/m^(1/0.678)]
  Number speed_scale{};  // [s/m]
  Number spin_scale{};   // [s]
};
using ApproachLaw = ApproachLawIn<double>;

inline constexpr double kLoadExponent = 0.678;
inline constexpr double kSpeedFactor = 1.418e5, kSpeedExponent = 0.677;
inline constexpr double kSpinFactor = 1.294e19, kSpinExponent = 2.274;

ApproachLaw approach_law(const EllipticalContact& contact, const Lubricant& oil);

namespace detail {
// |x|^e without slopes at zero, where they would not be finite.
template <class T>
T power_of_size(const T& x, double exponent) {
  using namespace mechanics;
  constexpr double kNothing = 1e-200;
  const T square = x * x;
  if (!(value_of(square) > kNothing)) return T{};
  return exponential((0.5 * exponent) * logarithm(square));
}
}  // namespace detail

/// Share of Eq. (10) by which rolling lessens the approach and spin enlarges it.
template <class T, class Constant>
T motion_share(const ApproachLawIn<Constant>& law, const T& rolling, const T& spin) {
  constexpr double kLeast = 0.1;  // far beyond any speed of the source
  const T rolled = 1.0 - kSpeedFactor * detail::power_of_size(T(law.speed_scale * rolling), kSpeedExponent);
  const T spun = 1.0 + kSpinFactor * detail::power_of_size(T(law.spin_scale * spin), kSpinExponent);
  return (mechanics::value_of(rolled) > kLeast ? rolled : T{} + kLeast) * spun;
}

/// Load [N] at an approach [m] of the bodies, rolling speed [m/s] and spin [rad/s].
template <class T, class Constant>
T load_at(const ApproachLawIn<Constant>& law, const T& approach, const T& rolling, const T& spin) {
  if (!(mechanics::value_of(approach) > 0.0)) return T{};
  return law.constant *
         detail::power_of_size(T(approach / motion_share(law, rolling, spin)), 1.0 / kLoadExponent);
}

}  // namespace orbearing::bearing::film
