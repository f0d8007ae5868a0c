// Sinking of an elastic half-space under pressures on a regular grid, by fast Fourier transform.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace orbearing::bearing::film {

/// Integral of 1/r over the rectangle of sides `width` and `height` whose centre lies `x` and `y` away.
/// [Love1929]
double rectangle_potential(double x, double y, double width, double height);

/// Field on (nodes along x) times (nodes along y): column-major, so that x runs fastest.
using Field = Eigen::ArrayXXd;

/// Potential of pressures that are constant around each node: sum over nodes of P times the integral of 1/r.
/// Nodes on the edge are taken to carry nothing. Exact for such pressures, of second order for smooth ones.
class HalfSpacePotential {
 public:
  /// `cells_x` and `cells_y` between nodes, powers of two of at least 4.
  HalfSpacePotential(Eigen::Index cells_x, Eigen::Index cells_y, double step_x, double step_y);

  void operator()(const Field& pressure, Field& potential) const;

  /// Influence of a node on one `x` and `y` steps away, less than the number of cells.
  double influence(Eigen::Index x, Eigen::Index y) const { return near_(std::abs(x), std::abs(y)); }

 private:
  static constexpr Eigen::Index kBatch = 16;  // of transforms side by side
  struct Batch {
    std::vector<double> re, im;
  };

  void transform(Batch& batch, Batch& spare, Eigen::Index length, bool back) const;

  Eigen::Index nx_, ny_;  // cells
  Field near_;
  Field spectrum_;  // of the kernel: (nx + 1) by (ny + 1), the rest by symmetry
  std::vector<double> cosine_, sine_;
  mutable Field re_, im_;  // of the field: (nx + 1) by 2 ny
  mutable Batch batch_, spare_;
};

}  // namespace orbearing::bearing::film
