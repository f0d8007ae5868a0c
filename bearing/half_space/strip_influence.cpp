#include "bearing/half_space/strip_influence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bearing/half_space/strip_kernel.hpp"

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

namespace {

/// Row by row, the lower triangle.
std::size_t place(Index i, Index j) {
  return static_cast<std::size_t>(i * (i + 1) / 2 + j);
}

}  // namespace

StripInfluence::StripInfluence(const LengthGrid& grid, double mirror_factor)
    : grid_(grid), mirror_factor_(mirror_factor), length_(grid.edge(grid.edge.size() - 1) - grid.edge(0)) {
  const Index elements = grid_.middle.size();
  direct_.resize(place(elements, 0));
  mirrored_.resize(mirror_factor_ != 0.0 ? direct_.size() : 0);
  for (Index i = 0; i < elements; ++i) {
    for (Index j = 0; j <= i; ++j) {
      direct_[place(i, j)].nearest = std::numeric_limits<double>::infinity();
      add(direct_[place(i, j)], direct(i, j), 1.0);
      if (!mirrored_.empty()) {
        Pair& image = mirrored_[place(i, j)];
        image.nearest = std::numeric_limits<double>::infinity();
        add(image, mirrored(i, j, length_), mirror_factor_);
        add(image, mirrored(i, j, -length_), mirror_factor_);
      }
    }
  }
}

StripInfluence::Corners StripInfluence::direct(Index i, Index j) const {
  return {grid_.edge(i), grid_.edge(i + 1), grid_.edge(j), grid_.edge(j + 1)};
}

StripInfluence::Corners StripInfluence::mirrored(Index i, Index j, double end) const {
  return {grid_.edge(i), grid_.edge(i + 1), end - grid_.edge(j + 1), end - grid_.edge(j)};
}

void StripInfluence::add(Pair& pair, const Corners& corners, double factor) {
  pair.nearest = std::min(pair.nearest, corners.nearest());
  if (!(corners.nearest() > 0.0)) {
    return;  // always near: the far field is never asked for
  }
  using Far = StripFarField;
  pair.far[0] += factor * corners.difference([](double x) { return x * std::log(x); });
  pair.far[1] += factor * Far::second * corners.difference([](double x) { return 1.0 / x; });
  pair.far[2] += factor * Far::fourth * corners.difference([](double x) { return 1.0 / (x * x * x); });
  pair.far[3] += factor * Far::sixth * corners.difference([](double x) { return 1.0 / (x * x * x * x * x); });
}

StripInfluence::Field StripInfluence::far_field(const Pair& pair, double width) {
  const double s = width * width;
  return {pair.far[0] + s * (pair.far[1] + s * (pair.far[2] + s * pair.far[3])),
          -(pair.far[1] + s * (2.0 * pair.far[2] + s * 3.0 * pair.far[3]))};
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

StripInfluence::Field StripInfluence::field(Index i, Index j, double width) const {
  const Pair& pair = direct_[place(i, j)];
  const double far = kStripKernelFar * width;
  Field sum = pair.nearest > far ? far_field(pair, width) : near_field(direct(i, j), width);
  if (!mirrored_.empty()) {
    const Pair& image = mirrored_[place(i, j)];
    if (image.nearest > far) {
      const Field ends = far_field(image, width);
      sum.influence += ends.influence;
      sum.widening += ends.widening;
    } else {
      for (const double end : {length_, -length_}) {
        const Field one = near_field(mirrored(i, j, end), width);
        sum.influence += mirror_factor_ * one.influence;
        sum.widening += mirror_factor_ * one.widening;
      }
    }
  }
  return sum;
}

void StripInfluence::evaluate(const Eigen::ArrayXd& half_width, StripMatrices& matrices) const {
  const Index elements = grid_.middle.size();
  matrices.influence.resize(elements, elements);
  matrices.widening.resize(elements, elements);
  const Eigen::ArrayXd square = half_width.square();
  for (Index i = 0; i < elements; ++i) {
    for (Index j = 0; j <= i; ++j) {
      const Field pair = field(i, j, std::sqrt(0.5 * (square(i) + square(j))));
      matrices.influence(i, j) = matrices.influence(j, i) = pair.influence;
      matrices.widening(i, j) = matrices.widening(j, i) = pair.widening;
    }
  }
}

}  // namespace orbearing::bearing::half_space
