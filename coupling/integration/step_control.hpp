// How long the next step of a linearly implicit stepper is, from the error of the last.
#pragma once

#include <algorithm>
#include <cmath>

namespace orbearing::integration {

/// Step lengths 0.85 h / error^(1/p) for a stepper of order p, with three bounds that spare refusals where
/// contacts open and close: a step grows by a quarter at most, not at all right after a refusal (the obstacle
/// is still ahead), and never beyond the longest one. `error` [-] is the largest share of the allowed error.
class StepControl {
 public:
  explicit StepControl(double longest_step, int order = 2) : longest_step_(longest_step), order_(order) {}

  /// The step to try after one of `h` was accepted [same unit].
  double after_acceptance(double h, double error) {
    const double most = refused_ ? 1.0 : kMostGrowth;
    refused_ = false;
    return std::min(longest_step_, h * std::min(most, share(error, order_)));
  }
  /// The step to try after one of `h` was refused; an error that is not finite cuts it as far as one may.
  double after_refusal(double h, double error) {
    refused_ = true;
    return h * share(error, order_);
  }

  /// Share of a step of a stepper of `order` 2 or 3 with `error` that would just pass, not less than a fifth.
  static double share(double error, int order = 2) {
    if (!std::isfinite(error)) return kLeastShare;
    const double least = std::max(error, 1e-4);
    return std::max(kLeastShare, kSafety / (order == 2 ? std::sqrt(least) : std::cbrt(least)));
  }

 private:
  static constexpr double kSafety = 0.85;
  static constexpr double kLeastShare = 0.2;
  static constexpr double kMostGrowth = 1.25;

  double longest_step_;
  int order_;
  bool refused_ = false;  // the last attempt was
};

}  // namespace orbearing::integration
