#include "tests/reference/rectangle_influence.hpp"

#include <numbers>
#include <cmath>

#include "tests/reference/rectangle_kernel.hpp"

namespace orbearing::bearing::half_space {

namespace {

using Eigen::Index;

/// Influence of element j on element i at 0, 1, 2, ... rows from one another, mirrors at both ends included.
Eigen::VectorXd by_distance(const LengthGrid& grid, const RowGrid& rows, double mirror_factor, Index i,
                            Index j) {
  const double length = grid.edge(grid.edge.size() - 1) - grid.edge(0);
  RectanglePair pair{0.0, 0.0, grid.size(j), grid.size(i), rows.spacing};
  Eigen::VectorXd influence(2 * rows.rows - 1);
  for (Index d = 0; d < influence.size(); ++d) {
    pair.across = static_cast<double>(d) * rows.spacing;
    const auto at = [&](double along) {
      pair.along = along;
      return mutual_integral(pair);
    };
    influence(d) = at(grid.middle(i) - grid.middle(j));
    if (mirror_factor != 0.0) {
      const double sum = grid.middle(i) + grid.middle(j);
      influence(d) += mirror_factor * (at(sum - length) + at(sum + length));
    }
  }
  return influence;
}

/// cos(2 pi row wave/period).
Eigen::MatrixXd cosines(Index rows, Index waves, Index period) {
  Eigen::MatrixXd cosine(rows, waves);
  for (Index row = 0; row < rows; ++row) {
    for (Index wave = 0; wave < waves; ++wave) {
      const auto turn = static_cast<double>(row * wave % period) / static_cast<double>(period);
      cosine(row, wave) = std::cos(2.0 * std::numbers::pi * turn);
    }
  }
  return cosine;
}

/// Each row but the first, and each wave but the first and the last, counts twice.
Eigen::VectorXd counts(Index size, bool last_once) {
  Eigen::VectorXd count = Eigen::VectorXd::Constant(size, 2.0);
  count(0) = 1.0;
  if (last_once) {
    count(size - 1) = 1.0;
  }
  return count;
}

}  // namespace

RectangleInfluence::RectangleInfluence(const LengthGrid& grid, const RowGrid& rows, double mirror_factor)
    : own_(grid.middle.size()) {
  const Index elements = grid.middle.size();
  const Index period = 4 * rows.rows - 2, waves = period / 2 + 1, distances = 2 * rows.rows - 1;
  const Eigen::MatrixXd cosine = cosines(distances, waves, period);
  const Eigen::VectorXd count = counts(distances, false);
  forward_ = count.head(rows.rows).asDiagonal() * cosine.topRows(rows.rows);
  backward_ = (counts(waves, true).asDiagonal() * cosine.topRows(rows.rows).transpose()) /
              static_cast<double>(period);
  of_wave_.assign(static_cast<std::size_t>(waves), Eigen::MatrixXd(elements, elements));
  for (Index i = 0; i < elements; ++i) {
    for (Index j = 0; j <= i; ++j) {
      const Eigen::VectorXd influence = by_distance(grid, rows, mirror_factor, i, j);
      const Eigen::VectorXd transformed = cosine.transpose() * count.cwiseProduct(influence);
      for (Index wave = 0; wave < waves; ++wave) {
        auto& matrix = of_wave_[static_cast<std::size_t>(wave)];
        matrix(i, j) = matrix(j, i) = transformed(wave);
      }
      if (i == j) {
        own_(i) = influence(0);
      }
    }
  }
}

Eigen::ArrayXXd RectangleInfluence::apply(const Eigen::ArrayXXd& pressure) const {
  Eigen::MatrixXd spectrum = pressure.matrix() * forward_;
  for (Index wave = 0; wave < spectrum.cols(); ++wave) {
    spectrum.col(wave) = (of_wave_[static_cast<std::size_t>(wave)] * spectrum.col(wave)).eval();
  }
  return (spectrum * backward_).array();
}

}  // namespace orbearing::bearing::half_space
