#include "bearing/friction/published_torque.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/constants.hpp"

namespace orbearing::bearing::friction {

namespace {

constexpr double kMillimetres = 1e3;        // [mm/m]
constexpr double kSquareMillimetres = 1e6;  // [mm^2/m^2]
constexpr double kNewtonMillimetre = 1e-3;  // [N m]
constexpr double kRpm = 60.0 / constants::two_pi;

// Input of the formulas: mm, mm^2/s, rpm.
struct Printed {
  double mean_diameter, speed, viscosity;

  Printed(double mean, const TorqueCondition& at)
      : mean_diameter(kMillimetres * mean),
        speed(kRpm * std::abs(at.speed)),
        viscosity(kSquareMillimetres * at.viscosity) {}
};

// P_1 of balls: at least the radial load.
double load_of_balls(double axial_factor, const TorqueCondition& at) {
  return std::max(axial_factor * at.axial - 0.1 * at.radial, at.radial);
}

// P_0/C_0 of balls: X_0 = 0.6, Y_0 = 0.5 of deep grooves [ISO76]; of angular contacts the factors of P_1
// serve.
double static_load_ratio(const BearingSize& size, const TorqueCondition& at) {
  return std::max(0.6 * at.radial + 0.5 * at.axial, at.radial) / size.static_capacity;
}

// Constants of Eqs. (3) and (4) of one series.
struct SkfConstants {
  double r1, r2, r3, s1, s2, s3;
  double full_film;  // [-]  mu_EHL, mineral oil
};

// Tables 3, 3a and 3c of [SKF6000], pages 92 and 93.
SkfConstants skf_constants(const BearingSize& size) {
  constexpr double balls = 0.05, rollers = 0.02;
  const int series = size.diameter_series;
  switch (size.family) {
    case TorqueFamily::deep_groove:
      if (series == 0) return {4.1e-7, 1.7, 0.0, 3.73e-3, 14.6, 0.0, balls};
      if (series == 2) return {3.9e-7, 1.7, 0.0, 3.23e-3, 36.5, 0.0, balls};
      if (series == 3) return {3.7e-7, 1.7, 0.0, 2.84e-3, 92.8, 0.0, balls};
      return {3.6e-7, 1.7, 0.0, 2.43e-3, 198.0, 0.0, balls};
    case TorqueFamily::angular_contact:
      return {5.03e-7, 1.97, 1.90e-12, 1.30e-2, 0.68, 1.91e-12, balls};
    case TorqueFamily::full_complement:
      return {2.13e-6, 0.0, 0.0, 0.16, 0.0015, 0.0, rollers};
    case TorqueFamily::cylindrical:
      break;
  }
  const double first = series == 0   ? (size.wide ? 1.23e-6 : 1.12e-6)
                       : series == 4 ? 1.00e-6
                       : !size.wide  ? 1.09e-6
                       : series == 2 ? 1.40e-6
                                     : 1.48e-6;
  return {first, 0.0, 0.0, series == 0 && !size.wide ? 0.17 : 0.16, 0.0015, 0.0, rollers};
}

// G_rr and G_sl.
struct SkfVariables {
  double rolling, sliding;
};

SkfVariables deep_groove(const SkfConstants& c, double d, double capacity, const TorqueCondition& at) {
  if (at.axial == 0.0)
    return {c.r1 * std::pow(d, 1.96) * std::pow(at.radial, 0.54),
            c.s1 * std::pow(d, -0.26) * std::pow(at.radial, 5.0 / 3.0)};
  const double angle = constants::degree * 24.6 * std::pow(at.axial / capacity, 0.24), sine = std::sin(angle);
  return {c.r1 * std::pow(d, 1.96) * std::pow(at.radial + c.r2 / sine * at.axial, 0.54),
          c.s1 * std::pow(d, -0.145) *
              std::cbrt(std::pow(at.radial, 5.0) + c.s2 * std::pow(d, 1.5) / sine * std::pow(at.axial, 4.0))};
}

SkfVariables angular_contact(const SkfConstants& c, double d, double speed, const TorqueCondition& at) {
  const double square = std::pow(d, 4.0) * speed * speed;
  return {c.r1 * std::pow(d, 1.97) * std::pow(at.radial + c.r3 * square + c.r2 * at.axial, 0.54),
          c.s1 * std::pow(d, 0.26) *
              (std::pow(at.radial + c.s3 * square, 4.0 / 3.0) + c.s2 * std::pow(at.axial, 4.0 / 3.0))};
}

SkfVariables variables_of(const BearingSize& size, const SkfConstants& c, const Printed& p,
                          const TorqueCondition& at) {
  if (size.family == TorqueFamily::deep_groove)
    return deep_groove(c, p.mean_diameter, size.static_capacity, at);
  if (size.family == TorqueFamily::angular_contact) return angular_contact(c, p.mean_diameter, p.speed, at);
  return {c.r1 * std::pow(p.mean_diameter, 2.41) * std::pow(at.radial, 0.31),
          c.s1 * std::pow(p.mean_diameter, 0.9) * at.axial + c.s2 * p.mean_diameter * at.radial};
}

}  // namespace

TorqueFactors palmgren_factors(const BearingSize& size, const TorqueCondition& at) {
  const int series = size.diameter_series;
  switch (size.family) {
    case TorqueFamily::deep_groove:
      return {series == 0   ? 1.7
              : series == 2 ? 2.0
                            : 2.3,
              0.0009 * std::sqrt(static_load_ratio(size, at)), load_of_balls(3.3, at)};
    case TorqueFamily::angular_contact:
      return {series <= 2 ? 2.0 : 3.0, 0.001 * std::cbrt(static_load_ratio(size, at)),
              load_of_balls(1.0, at)};
    case TorqueFamily::full_complement:
      return {5.0, 0.00055, at.radial};
    case TorqueFamily::cylindrical:
      break;
  }
  if (size.wide) return {series == 0 ? 2.5 : series == 2 ? 3.0 : 4.0, 0.0004, at.radial};
  return {2.0, series == 0 ? 0.0002 : series == 2 ? 0.0003 : series == 3 ? 0.00035 : 0.0004, at.radial};
}

TorqueFactors gear_unit_factors(const BearingSize& size, const TorqueCondition& at) {
  switch (size.family) {
    case TorqueFamily::deep_groove:
      return {2.0, 0.0009 * std::pow(static_load_ratio(size, at), 0.55), load_of_balls(3.3, at)};
    case TorqueFamily::angular_contact:
      return {3.3, 0.001 * std::cbrt(static_load_ratio(size, at)), load_of_balls(1.0, at)};
    case TorqueFamily::full_complement:
      return {5.0, 0.00055, at.radial};
    case TorqueFamily::cylindrical:
      break;
  }
  return {3.0, 0.0003, at.radial};
}

TorqueParts torque_parts(const TorqueFactors& factors, double mean_diameter, const TorqueCondition& at) {
  constexpr double slow = 2000.0;  // [mm^2/s rpm]
  const Printed p(mean_diameter, at);
  const double product = p.viscosity * p.speed, cube = std::pow(p.mean_diameter, 3.0);
  const double growth = product < slow ? 160.0 : std::pow(product, 2.0 / 3.0);
  return {kNewtonMillimetre * 1e-7 * factors.load_free * growth * cube,
          factors.load_dependent * factors.load * mean_diameter};
}

double inlet_heating_factor(double mean_diameter, const TorqueCondition& at) {
  const Printed p(mean_diameter, at);
  return 1.0 / (1.0 + 1.84e-9 * std::pow(p.speed * p.mean_diameter, 1.28) * std::pow(p.viscosity, 0.64));
}

// Table 5 of [SKF6000], page 98.
double type_constant(TorqueFamily family) {
  switch (family) {
    case TorqueFamily::deep_groove:
      return 3.1;
    case TorqueFamily::angular_contact:
      return 4.4;
    case TorqueFamily::full_complement:
      return 6.2;
    case TorqueFamily::cylindrical:
      break;
  }
  return 5.1;
}

double starvation_factor(double bore, double outside, double constant, const TorqueCondition& at) {
  constexpr double low_bath = 3e-8;
  const Printed p(0.5 * (bore + outside), at);
  return std::exp(-low_bath * p.viscosity * p.speed * 2.0 * p.mean_diameter *
                  std::sqrt(constant / (2.0 * kMillimetres * (outside - bore))));
}

SkfTorque skf_torque(const BearingSize& size, const TorqueCondition& at) {
  constexpr double boundary = 0.15;  // mu_bl
  const SkfConstants c = skf_constants(size);
  const Printed p(size.mean_diameter(), at);
  const double product = p.viscosity * p.speed;
  const SkfVariables g = variables_of(size, c, p, at);
  SkfTorque torque{.inlet_heating = inlet_heating_factor(size.mean_diameter(), at),
                   .starvation = starvation_factor(size.bore, size.outside, type_constant(size.family), at),
                   .boundary_share = std::exp(-2.6e-8 * std::pow(product, 1.4) * p.mean_diameter)};
  torque.rolling =
      kNewtonMillimetre * torque.inlet_heating * torque.starvation * g.rolling * std::pow(product, 0.6);
  torque.sliding = kNewtonMillimetre * g.sliding *
                   (torque.boundary_share * boundary + (1.0 - torque.boundary_share) * c.full_film);
  return torque;
}

}  // namespace orbearing::bearing::friction
