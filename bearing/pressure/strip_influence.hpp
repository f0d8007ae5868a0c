// Influence of line loads on one another: strips with semi-elliptic pressure across, of any width.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "bearing/pressure/contact.hpp"

namespace orbearing::bearing::half_space {

// Two strips that carry semi-elliptic pressure across: mean displacement of one under the other.
//
// Let p = 2q/(pi b) sqrt(1 - y^2/b^2) on both and s = (y - y')/b. With <> the mean over both pressures, that
// of 1/r between cross-sections at a distance x is m(x/b)/b, m(xi) = <1/sqrt(xi^2 + s^2)>. Elements of finite
// length need its second antiderivative.

/// Functions of xi = |x|/b.
struct StripKernel {
  double potential = 0.0;  // [-]  <xi arsinh(xi/s) - sqrt(xi^2 + s^2)>: second derivative is m
  double spread = 0.0;     // [-]  <sqrt(xi^2 + s^2)>: minus d[b potential(x/b)]/db
};

/// From a table for small distances (absolute error below 1e-9), from its expansion beyond. `distance` >= 0
/// [-].
StripKernel strip_kernel(double distance);

/// The same by quadrature, which the table is made from.
StripKernel strip_kernel_by_quadrature(double distance);

/// Beyond this distance [-] between cross-sections the expansion holds to 1e-9.
inline constexpr double kStripKernelFar = 10.0;

/// Far field between elements that do not touch, where terms linear in x cancel:
/// b potential = x ln x + b^2 second/x + b^4 fourth/x^3 + b^6 sixth/x^5 + b^8 eighth/x^7.
struct StripFarField {
  static constexpr double second = -1.0 / 8.0;
  static constexpr double fourth = 5.0 / 256.0;
  static constexpr double sixth = -35.0 / 3072.0;
  static constexpr double eighth = 735.0 / 65536.0;
  static constexpr double from = 6.0;  // [-]  |x|/b, from where the influence errs by less than 1e-7
};

/// Matrices that depend on the widths b of the strips. Pairs of unequal widths act as two of the width
/// sqrt((b_i^2 + b_j^2)/2): the mean of (y - y')^2 is then exact, and the matrix symmetric.
struct StripMatrices {
  Eigen::MatrixXd
      influence;  // [m]    W_ij: integral of 1/r over both elements, mean over their pressures across
  Eigen::MatrixXd widening;  // [1/m]  -dW_ij/d(B)/(2 B), B the common width: what drives the widths apart
};

/// The part that depends on the grid only; made once, used for all loads, tilts and profiles.
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
