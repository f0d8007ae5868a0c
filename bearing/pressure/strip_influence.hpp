// Influence of line loads on one another: strips with semi-elliptic pressure across, of any width.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "bearing/pressure/length_grid.hpp"

namespace orbearing::bearing::half_space {

/// What changes with the widths b of the strips. Pairs of unlike widths act as two of the width
/// sqrt((b_i^2 + b_j^2)/2): the mean of (y - y')^2 is then exact, and the matrix symmetric.
struct StripMatrices {
  Eigen::MatrixXd
      influence;  // [m]    W_ij: integral of 1/r over both elements, mean over their pressures across
  Eigen::MatrixXd widening;  // [1/m]  -dW_ij/d(B)/(2 B), B the common width: what drives the widths apart
};

/// The part that depends on the grid alone; made once, used for all loads, tilts and profiles.
class StripInfluence {
 public:
  /// `mirror_factor` [-] of the pressure mirrored at both ends.
  StripInfluence(const LengthGrid& grid, double mirror_factor);

  /// Fills `matrices` for strips of `half_width` [m] > 0.
  void evaluate(const Eigen::ArrayXd& half_width, StripMatrices& matrices) const;

 private:
  /// Coefficients of the far field of one pair in powers of B^2, and how near the elements are.
  struct Pair {
    double far[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
    double nearest = 0.0;  // [m]
  };
  /// The loads themselves, or their mirror images beyond one end.
  struct Source {
    bool image = false;
    double end = 0.0;         // [m]  an image of x lies at end - x
    double factor = 1.0;      // [-]
    std::vector<Pair> pairs;  // (i, j <= i), row by row
  };
  struct Field {
    double influence = 0.0, widening = 0.0;
  };
  struct Corners;

  Corners corners(const Source& source, Eigen::Index i, Eigen::Index j) const;
  Source source(bool image, double end, double factor) const;
  std::vector<Pair> summed() const;
  static Pair pair_of(const Corners& corners);
  static Field far_field(const Pair& pair, double width);
  static Field near_field(const Corners& corners, double width);

  LengthGrid grid_;
  std::vector<Source> sources_;
  std::vector<Pair> all_;  // over all sources, each with its factor; as near as the nearest
};

}  // namespace orbearing::bearing::half_space
