#include "bearing/pin_beam.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing {

namespace {

// Under unit force or moment at one position. Moments m and shear forces v are linear between supports and
// that position:
//   (1)  displacement_i by load_j = integral m_i m_j/(E I) dz + integral v_i v_j kappa/(G A) dz
// A flexpin passes all loads of its sleeve at its free end: by a force in the middle it moves by L^3/(12 E I)
// and does not incline.
//   (2)  1/kappa = 6 (1 + nu) (1 + r^2)^2/((7 + 6 nu) (1 + r^2)^2 + (20 + 12 nu) r^2),  r: bore over diameter
//   [Cowper1966]
struct UnitLoad {
  double position = 0.0;  // [m]  from the left support
  bool moment = false;
};

double pin_moment(const PinBeam& pin, const UnitLoad& load, double z) {
  const double a = load.position, span = pin.span;
  if (pin.ends == PinEnds::flexpin) return load.moment ? 1.0 : a - z;  // all of it passes the free end
  if (pin.ends == PinEnds::one) return z >= a ? 0.0 : load.moment ? 1.0 : a - z;
  if (load.moment) return z < a ? -z / span : 1.0 - z / span;
  return z < a ? (1.0 - a / span) * z : a * (1.0 - z / span);
}

double pin_shear(const PinBeam& pin, const UnitLoad& load, double z) {
  const double a = load.position, span = pin.span;
  if (pin.ends == PinEnds::flexpin) return load.moment ? 0.0 : 1.0;
  if (pin.ends == PinEnds::one) return z >= a || load.moment ? 0.0 : 1.0;
  if (load.moment) return -1.0 / span;
  return z < a ? 1.0 - a / span : -a / span;
}

struct PinSection {
  double bending = 0.0;  // [N m^2]  E I
  double shear = 0.0;    // [N]      G A/kappa
};

PinSection pin_section_of(const PinBeam& pin) {
  using constants::pi;
  const double nu = pin.material.poisson_ratio, m = pin.bore / pin.diameter;
  const double area = 0.25 * pi * (pin.diameter * pin.diameter - pin.bore * pin.bore);
  const double second = pi / 64.0 * (std::pow(pin.diameter, 4) - std::pow(pin.bore, 4));
  const double solid = 6.0 * (1.0 + nu) * std::pow(1.0 + m * m, 2);
  const double coefficient =
      solid / ((7.0 + 6.0 * nu) * std::pow(1.0 + m * m, 2) + (20.0 + 12.0 * nu) * m * m);
  return {pin.material.youngs_modulus * second, coefficient * pin.material.shear_modulus() * area};
}

// Integral of products of linear pieces: Simpson's rule is exact.
template <class Integrand>
double piecewise_integral(const std::vector<double>& breaks, Integrand&& of) {
  double sum = 0.0;
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double a = breaks[i - 1], b = breaks[i], inside = 1e-9 * (b - a);  // jumps are at the ends
    sum += (b - a) / 6.0 * (of(a + inside) + 4.0 * of(0.5 * (a + b)) + of(b - inside));
  }
  return sum;
}

}  // namespace

Eigen::MatrixXd pin_compliance(const PinBeam& pin, const std::vector<double>& positions) {
  mechanics::require_positive(pin.span, "span of the pin [m]");
  std::vector<UnitLoad> loads;
  std::vector<double> breaks{0.0, pin.span};
  for (const bool moment : {false, true})
    for (const double position : positions) {
      mechanics::require(pin.ends == PinEnds::flexpin || std::abs(position) < 0.5 * pin.span,
                         "position of a bearing on its pin [m]", position, "between the supports of the pin");
      loads.push_back({position + 0.5 * pin.span, moment});
      // In a flexpin moments and shear forces have no break but its ends.
      if (pin.ends != PinEnds::flexpin) breaks.push_back(loads.back().position);
    }
  std::sort(breaks.begin(), breaks.end());
  const PinSection section = pin_section_of(pin);
  const auto count = static_cast<Eigen::Index>(loads.size());
  Eigen::MatrixXd compliance(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j) {
      const UnitLoad &one = loads[static_cast<std::size_t>(i)], &other = loads[static_cast<std::size_t>(j)];
      compliance(i, j) = piecewise_integral(breaks, [&](double z) {
        return pin_moment(pin, one, z) * pin_moment(pin, other, z) / section.bending +
               pin_shear(pin, one, z) * pin_shear(pin, other, z) / section.shear;
      });
    }
  return compliance;
}

}  // namespace orbearing::bearing
