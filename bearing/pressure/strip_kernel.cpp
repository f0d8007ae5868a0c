#include "bearing/pressure/strip_kernel.hpp"
#include "mechanics/constants.hpp"

#include <array>
#include <numbers>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <utility>
#include <vector>

namespace orbearing::bearing::half_space {

namespace {

using constants::half_pi;
using std::numbers::ln2;

/// Density of s = |t - t'| on [0, 2] for two semi-ellipses on [-1, 1]: with t + t' = 2 c sin(phi), c = 1 -
/// s/2.
double density(double s) {
  const double c = 1.0 - 0.5 * s, d = 1.0 + 0.5 * s;
  const double integral = boost::math::quadrature::gauss<double, 40>::integrate(
      [&](double phi) {
        const double sine = c * std::sin(phi), cosine = std::cos(phi);
        return cosine * cosine * std::sqrt(d * d - sine * sine);
      },
      0.0, half_pi);
  return 4.0 * c * c * integral / (half_pi * half_pi);
}

/// Places s with their weights; they crowd at s = 0, where the functions bend when xi is small.
struct Mean {
  std::vector<std::pair<double, double>> positions;

  Mean() {
    using Rule = boost::math::quadrature::gauss<double, 30>;
    constexpr int panels = 8;
    for (int panel = 0; panel < panels; ++panel) {
      for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
        for (const double side : {-1.0, 1.0}) {
          add((panel + 0.5 + 0.5 * side * Rule::abscissa()[k]) / panels, 0.5 * Rule::weights()[k] / panels);
        }
      }
    }
  }

  void add(double v, double weight) {
    const double s = 2.0 * v * v * v;
    positions.emplace_back(s, 6.0 * v * v * weight * density(s));
  }
};

StripKernel expansion(double xi) {
  using Far = StripFarField;
  const double e = 1.0 / (xi * xi);
  const double logarithm = xi * (std::log(xi) + 2.0 * ln2 - 0.75);
  const double near = (Far::second + e * (Far::fourth + e * (Far::sixth + e * Far::eighth))) / xi;
  const double spread = (0.25 + e * (-5.0 / 64.0 + e * (35.0 / 512.0 - e * 735.0 / 8192.0))) / xi;
  return {logarithm + near, xi + spread};
}

/// Slope of both functions: <arsinh(xi/s)> and <xi/sqrt(xi^2 + s^2)>. The first is d(potential)/d(xi).
StripKernel slope(const Mean& mean, double xi) {
  StripKernel sum;
  for (const auto& [s, weight] : mean.positions) {
    sum.potential += weight * std::asinh(xi / s);
    sum.spread += weight * xi / std::hypot(xi, s);
  }
  return sum;
}

const Mean& mean_over_sections() {
  static const Mean mean;
  return mean;
}

/// Cubic Hermite interpolation over u = sqrt(xi), in which xi^2 ln(xi) is smooth enough.
class Table {
 public:
  Table() {
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const double u = static_cast<double>(k) * kStep;
      const StripKernel value = strip_kernel_by_quadrature(u * u),
                        per_xi = slope(mean_over_sections(), u * u);
      const double chain = 2.0 * u * kStep;
      nodes_[k] = {value.potential, chain * per_xi.potential, value.spread, chain * per_xi.spread};
    }
  }

  StripKernel at(double xi) const {
    const double position = std::sqrt(xi) / kStep;
    const auto cell = static_cast<std::size_t>(position);
    const double t = position - static_cast<double>(cell), r = 1.0 - t;
    const double value0 = (1.0 + 2.0 * t) * r * r, slope0 = t * r * r;
    const double value1 = t * t * (3.0 - 2.0 * t), slope1 = -t * t * r;
    const auto &a = nodes_[cell], &b = nodes_[cell + 1];
    return {value0 * a[0] + slope0 * a[1] + value1 * b[0] + slope1 * b[1],
            value0 * a[2] + slope0 * a[3] + value1 * b[2] + slope1 * b[3]};
  }

 private:
  static constexpr double kStep = 1.0 / 256.0;
  static constexpr std::size_t kNodes = 812;  // sqrt(kStripKernelFar)/kStep and two more
  std::array<std::array<double, 4>, kNodes> nodes_;
};

}  // namespace

StripKernel strip_kernel_by_quadrature(double distance) {
  StripKernel sum;
  for (const auto& [s, weight] : mean_over_sections().positions) {
    const double root = std::hypot(distance, s);
    sum.spread += weight * root;
    sum.potential += weight * (distance * std::asinh(distance / s) - root);
  }
  return sum;
}

StripKernel strip_kernel(double distance) {
  static const Table table;
  return distance < kStripKernelFar ? table.at(distance) : expansion(distance);
}

}  // namespace orbearing::bearing::half_space
