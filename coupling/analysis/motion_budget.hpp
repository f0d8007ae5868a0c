// Windows of motions that keep to a budget of processor time, chosen before anything is computed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/analysis/motion_work.hpp"

namespace orbearing::analysis {

/// Estimated times of the points of a sweep in motion, and of those that it will add around the peak.
struct MotionEstimate {
  std::vector<std::vector<MotionWork>> points;  // of the request
  std::vector<std::vector<MotionWork>> added;   // around the peak, by the quasi-static life
  MotionWindows stated;

  double seconds(const MotionWindows& windows) const;            // [s]  of processor time, all points
  std::vector<double> work(const MotionWindows& windows) const;  // [s]  (points of the request)
  int accuracy() const;                                          // factor: the worst of all points
};

/// The windows to compute with.
struct BudgetedWindows {
  MotionWindows windows;
  bool within = true;  // false: these are the shortest that make sense, and take longer than the budget
};

/// The longest windows that keep to so many seconds of processor time: the stated ones, then fewer
/// revolutions for the means, then fewer on the way to them; all of it once more with a larger error.
BudgetedWindows windows_within(double seconds, const MotionEstimate& estimate);

/// Largest error of windows that are chosen [m].
inline constexpr double kLargestLengthError = 1e-9;

/// Scatter of the life with windows other than the stated ones, in words.
std::string cost_text(const MotionWindows& windows, const MotionWindows& stated);

/// "2.5 min".
std::string time_text(double seconds);

}  // namespace orbearing::analysis
