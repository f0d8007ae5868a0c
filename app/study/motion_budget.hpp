// Processor time of points in motion before they are computed, and windows that keep to a budget of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/check_table.hpp"
#include "app/case/resolved_case.hpp"
#include "app/results/sweep_run.hpp"
#include "coupling/analysis/motion_budget.hpp"

namespace orbearing::app {

using analysis::MotionEstimate;

/// None for quasi-static sweeps. Points around the peak are left out where those of the request are short,
/// unless `all`.
std::optional<MotionEstimate> motion_estimate(const ResolvedCase& resolved, const SweepRequest& request,
                                              bool all);

/// Seconds of a budget as the option states it: "60 s". Throws BadInput.
double budget_option(const std::string& text);

/// The case with the windows that keep to `budget` [s] of processor time, chosen from counts alone and
/// written into it with the reason; empty where the case keeps to it as it is. Throws BadInput where the
/// shortest windows do not.
struct BudgetedCase {
  ResolvedCase resolved;
  analysis::MotionWindows windows;
  std::string chosen;  // in one line: what changed, and what it costs
};
std::optional<BudgetedCase> within_budget(const ResolvedCase& resolved, const MotionEstimate& estimate,
                                          const std::string& budget);

/// Throws BadInput for a quasi-static fidelity, whose points have no windows.
void require_motion_for_budget(const std::string& fidelity);
/// Throws BadInput for an analysis that is no sweep: the case states how long it lasts.
[[noreturn]] void refuse_budget(const ResolvedCase& resolved, bool gears_alone);

/// "estimate: about 2 min (240 s of processor time on 2 threads) for 12 points in motion"; empty below half a
/// minute. `accuracy`: factor within which it is right.
std::string estimate_text(double seconds, std::size_t points, std::size_t added, int threads, int accuracy);

/// Quantities of `check` on the time of a run in motion; none where there is none.
std::vector<Derived> motion_time_quantities(const ResolvedCase& resolved);

}  // namespace orbearing::app
