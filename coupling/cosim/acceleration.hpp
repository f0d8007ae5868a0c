// What to expect next of the end of a window, once a pass has given the output of the last expectation.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <deque>
#include <vector>

namespace orbearing::cosim {

/// State of an iteration: IQN-ILS, least squares over all outputs of this window and the last ones
/// [Degroote2009]. Eqs. (9) and (10) of README.md.
class QuasiNewton {
 public:
  /// @param windows before the present one whose differences it goes on using
  explicit QuasiNewton(int windows) : windows_(static_cast<std::size_t>(std::max(0, windows))) {}

  /// A new window begins.
  void begin();
  /// The next expectation, from the last and the output that it gave.
  /// @param weight one over the size of a typical value: makes values of different units comparable; may
  /// change from call to call
  Eigen::VectorXd next(const Eigen::VectorXd& expected, const Eigen::VectorXd& output,
                       const Eigen::VectorXd& weight);

 private:
  struct Column {
    Eigen::VectorXd residual;  // difference of two residuals
    Eigen::VectorXd output;    // and of their outputs
  };

  Eigen::VectorXd correction(const Eigen::VectorXd& residual, const Eigen::VectorXd& weight) const;

  std::size_t windows_;
  std::deque<std::vector<Column>> columns_ = {{}};  // windows, the newest first
  Eigen::VectorXd residual_;
  Eigen::VectorXd output_;
};

}  // namespace orbearing::cosim
