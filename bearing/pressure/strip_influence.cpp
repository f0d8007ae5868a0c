#include "bearing/pressure/strip_influence.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/pressure/strip_kernel.hpp"

namespace orbearing::bearing::half_space {

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
    return pair;  // always near: the far field is never asked for
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
