#include "coupling/cosim/acceleration.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace orbearing::cosim {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

class FixedPoint : public Accelerator {
 public:
  void begin() override {}
  VectorXd next(const VectorXd&, const VectorXd& answer, const VectorXd&) override { return answer; }
};

// Eq. (9) of coupling/cosim/README.md.
class Aitken : public Accelerator {
 public:
  void begin() override { residual_.resize(0); }

  VectorXd next(const VectorXd& expected, const VectorXd& answer, const VectorXd& weight) override {
    const VectorXd residual = answer - expected;
    if (residual_.size() == residual.size()) {
      const VectorXd change = weight.cwiseProduct(residual - residual_);
      const double square = change.squaredNorm();
      if (square > 0.0)
        share_ = std::clamp(-share_ * weight.cwiseProduct(residual_).dot(change) / square, -kLargestShare,
                            kLargestShare);
    } else {
      share_ = 1.0;
    }
    residual_ = residual;
    return expected + share_ * residual;
  }

 private:
  static constexpr double kLargestShare = 4.0;  // two residuals that nearly agree say little

  VectorXd residual_;
  double share_ = 1.0;
};

// Eqs. (10) and (11).
class QuasiNewton : public Accelerator {
 public:
  explicit QuasiNewton(int windows) : windows_(static_cast<std::size_t>(std::max(0, windows))) {}

  void begin() override {
    columns_.push_front({});
    if (columns_.size() > windows_ + 1) columns_.pop_back();
    residual_.resize(0);
  }

  VectorXd next(const VectorXd& expected, const VectorXd& answer, const VectorXd& weight) override {
    const VectorXd residual = answer - expected;
    if (residual_.size() == residual.size())
      columns_.front().insert(columns_.front().begin(), {residual - residual_, answer - answer_});
    residual_ = residual;
    answer_ = answer;
    return answer + correction(residual, weight);
  }

 private:
  struct Column {
    VectorXd residual;  // difference of two residuals
    VectorXd answer;    // and of their answers
  };
  using Columns = std::vector<Column>;

  // The newest first, no more than unknowns.
  VectorXd correction(const VectorXd& residual, const VectorXd& weight) const {
    const Index n = residual.size();
    Eigen::MatrixXd differences(n, n), answers(n, n);
    Index count = 0;
    for (const Columns& window : columns_)
      for (const Column& column : window) {
        const VectorXd difference = weight.cwiseProduct(column.residual);
        const double size = difference.norm();
        if (count == n || !(size > 0.0)) continue;
        differences.col(count) = difference / size;
        answers.col(count++) = column.answer / size;
      }
    if (count == 0) return VectorXd::Zero(n);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors;
    factors.setThreshold(kLeastPivot);
    factors.compute(differences.leftCols(count));
    return -answers.leftCols(count) * factors.solve(weight.cwiseProduct(residual));
  }

  static constexpr double kLeastPivot = 1e-6;  // differences that are nearly dependent are left out

  std::size_t windows_;
  std::deque<Columns> columns_ = {{}};  // windows, the newest first
  VectorXd residual_;
  VectorXd answer_;
};

}  // namespace

std::unique_ptr<Accelerator> make_accelerator(Acceleration kind, int windows) {
  switch (kind) {
    case Acceleration::aitken:
      return std::make_unique<Aitken>();
    case Acceleration::quasi_newton:
      return std::make_unique<QuasiNewton>(windows);
    case Acceleration::fixed_point:
      break;
  }
  return std::make_unique<FixedPoint>();
}

}  // namespace orbearing::cosim
