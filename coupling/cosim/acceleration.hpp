// What to expect next of the end of a window, once a pass has answered the last expectation.
#pragma once

#include <Eigen/Core>
#include <memory>

namespace orbearing::cosim {

enum class Acceleration {
  fixed_point,   // the answer itself
  aitken,        // a share of it, from the last two answers [KuettlerWall2008]
  quasi_newton,  // IQN-ILS: least squares over all answers of this window and the last ones [Degroote2009]
};

/// State of an iteration.
class Accelerator {
 public:
  virtual ~Accelerator() = default;
  /// A new window begins.
  virtual void begin() = 0;
  /// The next expectation, from the last and what it was answered by.
  /// @param weight one over the size of a typical value: makes values of different units comparable; may
  /// change from call to call
  virtual Eigen::VectorXd next(const Eigen::VectorXd& expected, const Eigen::VectorXd& answer,
                               const Eigen::VectorXd& weight) = 0;
};

/// @param windows whose differences quasi_newton goes on using
std::unique_ptr<Accelerator> make_accelerator(Acceleration kind, int windows);

}  // namespace orbearing::cosim
