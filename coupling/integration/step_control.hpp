// Length of the next step of a linearly implicit stepper, from the error of the last.
#pragma once

#include <algorithm>
#include <cmath>

namespace orbearing::integration {

/// Rule for the length of a step: by the error of the last step only, or also by that of the one before,
/// which shows whether errors rise (proportional and integral control). The latter is for motion without
/// impacts, where the error of one step predicts that of the next; steps then may grow faster, and fewer are
/// refused.
enum class StepRule { last_error, two_errors };

/// Step lengths 0.85 h / error^(1/p) for a stepper of order p, or 0.85 h before^(0.2/p) / error^(0.6/p) by
/// two errors, with three bounds that spare refusals where contacts open and close: a step grows by a quarter
/// at most (by two errors by a half), not at all right after a refusal (the obstacle is still ahead), and
/// never beyond the longest one. `error` [-] is the largest share of the allowed error.
class StepControl {
 public:
  explicit StepControl(double longest_step, int order = 2, StepRule rule = StepRule::last_error)
      : longest_step_(longest_step), order_(order), rule_(rule) {}

  /// The step to try after one of `h` was accepted [same unit]. One that was shorter than intended, at the
  /// end of a window, does not show whether errors rise.
  double after_acceptance(double h, double error) {
    const double most = refused_ ? 1.0 : rule_ == StepRule::last_error ? kMostGrowth : kMostGrowthByTwo;
    refused_ = false;
    const bool cut = h < kCut * asked_;
    const double change = rule_ == StepRule::last_error ? share(error, order_) : share_by_two(error, cut);
    const double next = std::min(longest_step_, h * std::min(most, change));
    asked_ = cut ? std::max(asked_, next) : next;
    return next;
  }
  /// The step to try after one of `h` was refused; an error that is not finite cuts it as far as one may.
  double after_refusal(double h, double error) {
    refused_ = true;
    return asked_ = h * share(error, order_);
  }

  /// Goes on as a new one would.
  void forget() {
    refused_ = false;
    log_before_ = 0.0;
    asked_ = 0.0;
  }

  /// Share of a step of a stepper of `order` 2, 3 or 4 with `error` that would just pass, not less than a
  /// fifth.
  static double share(double error, int order = 2) {
    if (!std::isfinite(error)) return kLeastShare;
    const double least = std::max(error, kLeastError);
    const double root = order == 2   ? std::sqrt(least)
                        : order == 3 ? std::cbrt(least)
                                     : std::sqrt(std::sqrt(least));
    return std::max(kLeastShare, kSafety / root);
  }

 private:
  static constexpr double kSafety = 0.85;
  static constexpr double kLeastShare = 0.2;
  static constexpr double kMostGrowth = 1.25;
  static constexpr double kCut = 0.99;         // of the intended step
  static constexpr double kLeastError = 1e-4;  // smaller ones would not let a step grow faster
  // Powers of the last error and of the one before, over the order: of all that were tried those with fewest
  // refusals that cost no time (README.md).
  static constexpr double kLast = 0.6, kBefore = 0.2;
  static constexpr double kMostGrowthByTwo = 1.5;

  double share_by_two(double error, bool cut) {
    const double now = std::log(std::max(error, kLeastError));
    const double exponent = (kBefore * log_before_ - kLast * now) / order_;
    if (!cut) log_before_ = now;
    return std::max(kLeastShare, kSafety * std::exp(exponent));
  }

  double longest_step_;
  int order_;
  StepRule rule_;
  bool refused_ = false;     // the last attempt was
  double log_before_ = 0.0;  // of the error of the last accepted step
  double asked_ = 0.0;       // the step
};

}  // namespace orbearing::integration
