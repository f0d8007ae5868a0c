#include "coupling/cosim/acceleration.hpp"

#include <Eigen/QR>

namespace orbearing::cosim {

using Eigen::VectorXd;

void QuasiNewton::begin() {
  columns_.push_front({});
  if (columns_.size() > windows_ + 1) columns_.pop_back();
  residual_.resize(0);
}

VectorXd QuasiNewton::next(const VectorXd& expected, const VectorXd& output, const VectorXd& weight) {
  const VectorXd residual = output - expected;
  if (residual_.size() == residual.size())
    columns_.front().insert(columns_.front().begin(), {residual - residual_, output - output_});
  residual_ = residual;
  output_ = output;
  return output + correction(residual, weight);
}

// The newest differences first, no more than unknowns.
VectorXd QuasiNewton::correction(const VectorXd& residual, const VectorXd& weight) const {
  constexpr double kLeastPivot = 1e-6;  // differences that are nearly dependent are left out
  const Eigen::Index n = residual.size();
  Eigen::MatrixXd differences(n, n), outputs(n, n);
  Eigen::Index count = 0;
  for (const std::vector<Column>& window : columns_)
    for (const Column& column : window) {
      const VectorXd difference = weight.cwiseProduct(column.residual);
      const double size = difference.norm();
      if (count == n || !(size > 0.0)) continue;
      differences.col(count) = difference / size;
      outputs.col(count++) = column.output / size;
    }
  if (count == 0) return VectorXd::Zero(n);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors;
  factors.setThreshold(kLeastPivot);
  factors.compute(differences.leftCols(count));
  return -outputs.leftCols(count) * factors.solve(weight.cwiseProduct(residual));
}

}  // namespace orbearing::cosim
