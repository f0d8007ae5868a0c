// A small dense matrix with its factors, without pivoting: for 1 - g J of a body of some tens of freedoms,
// which is close to its positive diagonal. A quarter of the time of Eigen's PartialPivLU at 21 freedoms.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace orbearing::mechanics {

class DenseLu {
 public:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// Replaces `matrix` by its factors and keeps them; false where a pivot vanishes.
  bool factor(const Matrix& matrix) {
    a_ = matrix;
    const Eigen::Index n = a_.rows();
    for (Eigen::Index p = 0; p < n; ++p) {
      const double* pivot = row(p);
      const double inverse = 1.0 / pivot[p];
      if (!std::isfinite(inverse)) return false;
      row(p)[p] = inverse;
      for (Eigen::Index i = p + 1; i < n; ++i) {
        double* below = row(i);
        const double share = below[p] * inverse;
        if (share == 0.0) continue;
        below[p] = share;
        for (Eigen::Index k = p + 1; k < n; ++k) below[k] -= share * pivot[k];
      }
    }
    return true;
  }

  /// `b` becomes the solution.
  void solve(Eigen::Ref<Eigen::VectorXd> b) const {
    const Eigen::Index n = a_.rows();
    for (Eigen::Index i = 1; i < n; ++i) b[i] -= a_.row(i).head(i).dot(b.head(i));
    for (Eigen::Index i = n - 1; i >= 0; --i) {
      const Eigen::Index behind = n - 1 - i;
      b[i] = (b[i] - a_.row(i).tail(behind).dot(b.tail(behind))) * a_(i, i);
    }
  }

 private:
  double* row(Eigen::Index i) { return a_.data() + i * a_.cols(); }
  Matrix a_;
};

}  // namespace orbearing::mechanics
