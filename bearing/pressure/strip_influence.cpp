#include "bearing/pressure/strip_influence.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "mechanics/constants.hpp"

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

using Eigen::Index;

/// Distances between the edges of two elements: the integral of f'' over both is f(0) + f(1) - f(2) - f(3).
struct StripInfluence::Corners {
  double at[4];  // [m]

  Corners(double begin, double end, double other_begin, double other_end)
      : at{std::abs(end - other_begin), std::abs(begin - other_end), std::abs(begin - other_begin),
           std::abs(end - other_end)} {}

  template <typename Function>
  double difference(Function f) const {
    return (f(at[0]) - f(at[2])) + (f(at[1]) - f(at[3]));
  }
  double nearest() const { return *std::min_element(at, at + 4); }
};

StripInfluence::StripInfluence(const LengthGrid& grid, double mirror_factor) : grid_(grid) {
  const double length = grid.edge(grid.edge.size() - 1) - grid.edge(0);
  sources_.push_back(source(false, 0.0, 1.0));
  if (mirror_factor != 0.0) {
    sources_.push_back(source(true, length, mirror_factor));
    sources_.push_back(source(true, -length, mirror_factor));
  }
  all_ = summed();
}

std::vector<StripInfluence::Pair> StripInfluence::summed() const {
  std::vector<Pair> all(sources_.front().pairs.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].nearest = sources_.front().pairs[k].nearest;
    for (const Source& source : sources_) {
      const Pair& pair = source.pairs[k];
      for (std::size_t term = 0; term < std::size(pair.far); ++term)
        all[k].far[term] += source.factor * pair.far[term];
      all[k].nearest = std::min(all[k].nearest, pair.nearest);
    }
  }
  return all;
}

StripInfluence::Source StripInfluence::source(bool image, double end, double factor) const {
  Source made{image, end, factor, {}};
  for (Index i = 0; i < grid_.middle.size(); ++i) {
    for (Index j = 0; j <= i; ++j) {
      made.pairs.push_back(pair_of(corners(made, i, j)));
    }
  }
  return made;
}

StripInfluence::Corners StripInfluence::corners(const Source& source, Index i, Index j) const {
  const double begin = grid_.edge(j), end = grid_.edge(j + 1);
  return source.image ? Corners(grid_.edge(i), grid_.edge(i + 1), source.end - end, source.end - begin)
                      : Corners(grid_.edge(i), grid_.edge(i + 1), begin, end);
}

StripInfluence::Pair StripInfluence::pair_of(const Corners& corners) {
  Pair pair;
  pair.nearest = corners.nearest();
  if (!(pair.nearest > 0.0)) {
    return pair;  // always near: the far field is never used
  }
  using Far = StripFarField;
  pair.far[0] = corners.difference([](double x) { return x * std::log(x); });
  const auto over = [&](auto power) { return corners.difference([&](double x) { return 1.0 / power(x); }); };
  const auto cube = [](double x) { return x * x * x; };
  pair.far[1] = Far::second * over([](double x) { return x; });
  pair.far[2] = Far::fourth * over(cube);
  pair.far[3] = Far::sixth * over([&](double x) { return x * x * cube(x); });
  pair.far[4] = Far::eighth * over([&](double x) { return x * cube(x) * cube(x); });
  return pair;
}

StripInfluence::Field StripInfluence::far_field(const Pair& pair, double width) {
  const double s = width * width;
  const auto& far = pair.far;
  return {far[0] + s * (far[1] + s * (far[2] + s * (far[3] + s * far[4]))),
          -(far[1] + s * (2.0 * far[2] + s * (3.0 * far[3] + s * 4.0 * far[4])))};
}

StripInfluence::Field StripInfluence::near_field(const Corners& corners, double width) {
  StripKernel kernel[4];
  for (int k = 0; k < 4; ++k) {
    kernel[k] = strip_kernel(corners.at[k] / width);
  }
  const auto& [a, b, c, d] = kernel;
  const double potential = (a.potential - c.potential) + (b.potential - d.potential);
  const double spread = (a.spread - c.spread) + (b.spread - d.spread);
  return {width * potential, spread / (2.0 * width)};
}

void StripInfluence::evaluate(const Eigen::ArrayXd& half_width, StripMatrices& matrices) const {
  const Index elements = grid_.middle.size();
  matrices.influence.resize(elements, elements);
  matrices.widening.resize(elements, elements);
  const Eigen::ArrayXd square = half_width.square();
  std::size_t position = 0;
  for (Index i = 0; i < elements; ++i) {
    for (Index j = 0; j <= i; ++j, ++position) {
      const double width = std::sqrt(0.5 * (square(i) + square(j)));
      const double far = StripFarField::from * width;
      Field sum;
      if (all_[position].nearest > far) {
        sum = far_field(all_[position], width);
      } else {
        for (const Source& source : sources_) {
          const Pair& pair = source.pairs[position];
          const Field field =
              pair.nearest > far ? far_field(pair, width) : near_field(corners(source, i, j), width);
          sum.influence += source.factor * field.influence;
          sum.widening += source.factor * field.widening;
        }
      }
      matrices.influence(j, i) = sum.influence;
      matrices.widening(j, i) = sum.widening;
    }
  }
  for (Eigen::MatrixXd* matrix : {&matrices.influence, &matrices.widening})
    matrix->triangularView<Eigen::StrictlyLower>() = matrix->transpose();
}

}  // namespace orbearing::bearing::half_space
