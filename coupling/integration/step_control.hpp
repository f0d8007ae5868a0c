// How long the next step of a stepper of order 2 is, from the error of the last.
#pragma once

#include <algorithm>
#include <cmath>

namespace orbearing::integration {

/// Step lengths h (0.85^2 / error)^1/2, with three bounds that spare refusals where contacts open and close: a
/// step grows by a quarter at most, not at all right after a refusal (the obstacle is still ahead), and never
/// beyond the longest one. `error` [-] is the largest share of the allowed error.
class StepControl {
 public:
  explicit StepControl(double longest_step) : longest_step_(longest_step) {}

  /// The step to try after one of `h` was accepted [same unit].
  double after_acceptance(double h, double error) {
    const double most = refused_ ? 1.0 : kMostGrowth;
    refused_ = false;
    return std::min(longest_step_, h * std::min(most, share(error)));
  }
  /// The step to try after one of `h` was refused; an error that is not finite cuts it as far as one may.
  double after_refusal(double h, double error) {
    refused_ = true;
    return h * share(error);
  }

  /// Share of a step with `error` that would just pass, not less than a fifth.
  static double share(double error) {
    return std::isfinite(error) ? std::max(kLeastShare, kSafety / std::sqrt(std::max(error, 1e-4))) : kLeastShare;
  }

 private:
  static constexpr double kSafety = 0.85;
  static constexpr double kLeastShare = 0.2;
  static constexpr double kMostGrowth = 1.25;

  double longest_step_;
  bool refused_ = false;  // the last attempt was
};

}  // namespace orbearing::integration
