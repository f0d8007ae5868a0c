#include "coupling/analysis/motion_budget.hpp"

#include <algorithm>

#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace {

using mechanics::significant;

// The shortest windows that make sense.
constexpr int kLeastObserved = 3;
constexpr int kLeastMost = 4;

// From the windows as stated to the shortest.
std::vector<MotionWindows> ladder(const MotionWindows& stated) {
  std::vector<MotionWindows> steps;
  for (const double error : {stated.length_error, std::max(kLargestLengthError, stated.length_error)}) {
    if (!steps.empty() && error == stated.length_error) break;
    MotionWindows now = stated;
    now.length_error = error;
    if (error != stated.length_error) steps.push_back(now);
    while (now.observed > kLeastObserved) {
      --now.observed;
      steps.push_back(now);
    }
    while (now.most > kLeastMost) {
      now.most = std::max(kLeastMost, now.most / 2);
      steps.push_back(now);
    }
  }
  return steps;
}

std::string percent(double share) {
  return significant(100.0 * share, 2) + " %";
}

}  // namespace

double MotionEstimate::seconds(const MotionWindows& windows) const {
  double sum = 0.0;
  for (const auto* list : {&points, &added})
    for (const std::vector<MotionWork>& point : *list) sum += seconds_of(point, windows);
  return sum;
}

std::vector<double> MotionEstimate::work(const MotionWindows& windows) const {
  std::vector<double> seconds;
  for (const std::vector<MotionWork>& point : points) seconds.push_back(seconds_of(point, windows));
  return seconds;
}

int MotionEstimate::accuracy() const {
  int worst = kAccuracy;
  for (const auto* list : {&points, &added})
    for (const std::vector<MotionWork>& point : *list) worst = std::max(worst, accuracy_of(point));
  return worst;
}

BudgetedWindows windows_within(double seconds, const MotionEstimate& estimate) {
  const auto fits = [&](const MotionWindows& windows) { return estimate.seconds(windows) <= seconds; };
  if (fits(estimate.stated)) return {estimate.stated};
  const std::vector<MotionWindows> choices = ladder(estimate.stated);
  const auto chosen = std::ranges::find_if(choices, fits);
  if (chosen != choices.end()) return {*chosen};
  return {choices.empty() ? estimate.stated : choices.back(), false};
}

std::string cost_text(const MotionWindows& windows, const MotionWindows& stated) {
  std::string text = "scatter of the life " + percent(scatter_of_life(windows)) + " (" +
                     percent(scatter_of_life(stated)) + " with the windows as stated)";
  if (windows.length_error > stated.length_error)
    text += ", and up to " + mechanics::with_decimals(100.0 * kErrorOfLargeSteps, 0) +
            " % by the larger error of steps";
  return text;
}

std::string time_text(double seconds) {
  if (seconds < 100.0) return significant(seconds, 2) + " s";
  if (seconds < 6000.0) return significant(seconds / 60.0, 2) + " min";
  return significant(seconds / 3600.0, 2) + " h";
}

}  // namespace orbearing::analysis
