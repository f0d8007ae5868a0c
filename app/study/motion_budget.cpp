#include "app/study/motion_budget.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "app/case/input_keys.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/units.hpp"
#include "app/errors.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

using analysis::MotionWindows;
using analysis::MotionWork;
using analysis::time_text;

constexpr double kAnnounced = 30.0;  // [s]  estimates below are not shown
constexpr std::size_t kMostEstimated =
    100;  // points; of more, the others take as long as the nearest of them
constexpr std::size_t kMostAddedRounds = 40;
constexpr double kShareOfGrid = 0.2;                  // of all points, at least
constexpr const char* kLargestErrorText = "1e-6 mm";  // analysis::kLargestLengthError

MotionWindows windows_of(const ResolvedCase& in) {
  return machine_of<MotionWindows>(in);
}

// Empty where the case fails: the computation itself reports the failure.
std::vector<MotionWork> work_of(const ResolvedCase& at_point, analysis::Fidelity fidelity) {
  try {
    return analysis::motion_work(bearing_sets(at_point), fidelity);
  } catch (const std::exception&) {
    return {};
  }
}

std::vector<std::vector<MotionWork>> work_of(const ResolvedCase& resolved, analysis::Fidelity fidelity,
                                             const std::vector<SweepPoint>& points) {
  std::vector<std::vector<MotionWork>> all;
  const std::size_t stride = (points.size() + kMostEstimated - 1) / kMostEstimated;
  for (std::size_t i = 0; i < points.size(); ++i)
    all.push_back(i % stride == 0 ? work_of(resolved.with(points[i].settings), fidelity) : all.back());
  return all;
}

// Expected points that refine the peak, from quasi-static lives instead of those in motion.
std::vector<SweepPoint> expected_around_peak(const ResolvedCase& resolved, const SweepRequest& request) {
  std::vector<SweepPoint> added;
  if (!request.refinement || request.header.shard || request.header.grid() > kMostEstimated) return added;
  std::vector<SweepRow> rows;
  const auto take = [&](const SweepPoint& point) {
    analysis::PointResult result;
    try {
      result = compute_point(resolved, point.settings, analysis::Fidelity::quasi_static);
    } catch (const std::exception& error) {
      result.status = error.what();
    }
    result.input_speed = point.input_speed;
    rows.push_back(sweep_row(result, request.header, point.axis_values));
  };
  for (std::size_t i = 0; i < request.header.grid(); ++i) take(request.points[i]);
  for (std::size_t round = 0; round < kMostAddedRounds; ++round) {
    const std::vector<SweepPoint> next = request.refinement->next(rows);
    if (next.empty()) break;
    for (const SweepPoint& point : next) {
      take(point);
      added.push_back(point);
    }
  }
  return added;
}

}  // namespace

std::optional<MotionEstimate> motion_estimate(const ResolvedCase& resolved, const SweepRequest& request,
                                              bool all) {
  const analysis::Fidelity fidelity = fidelity_of(request.header.fidelity);
  if (!in_time(fidelity) || !resolved.has(keys().observed_revolutions)) return std::nullopt;
  MotionEstimate estimate{work_of(resolved, fidelity, request.points), {}, windows_of(resolved)};
  if (all || estimate.seconds(estimate.stated) > kShareOfGrid * kAnnounced)
    estimate.added = work_of(resolved, fidelity, expected_around_peak(resolved, request));
  return estimate;
}

double budget_option(const std::string& text) {
  const Reading<double> time = read_quantity(text, dimension::time);
  if (time.value && *time.value > 0.0) return *time.value;
  throw BadInput("--budget: found '" + text + "'" + (time.value ? "" : ": " + time.fault) +
                 "; required: a processor time above 0 like '60 s' or '5 min'");
}

void require_motion_for_budget(const std::string& fidelity) {
  if (in_time(fidelity_of(fidelity))) return;
  throw BadInput("--budget: found with --fidelity " + fidelity +
                 "; required: dynamic, co-simulated or monolithic, whose windows it chooses");
}

void refuse_budget(const ResolvedCase& resolved, bool gears_alone) {
  throw BadInput(
      "--budget: found with " +
      (gears_alone ? std::string("--gears") : "a case of the model " + resolved.choice("model")) +
      "; required: planet bearings in motion (--fidelity dynamic), whose windows it chooses; the case "
      "states how long this run lasts");
}

namespace {

void require_no_axis(const ResolvedCase& resolved) {
  for (const SweepAxis& axis : resolved.axes())
    for (const std::string& path :
         {keys().observed_revolutions, keys().most_revolutions, keys().length_error})
      if (axis.path == path)
        throw BadInput(fmt::format("--budget: found with a sweep over {}; required: one of both", path));
}

}  // namespace

std::optional<BudgetedCase> within_budget(const ResolvedCase& resolved, const MotionEstimate& estimate,
                                          const std::string& budget) {
  const double seconds = budget_option(budget);
  require_no_axis(resolved);
  const MotionWindows& stated = estimate.stated;
  const double asked = estimate.seconds(stated);
  if (asked <= seconds) return std::nullopt;
  const auto error_text = [&](const MotionWindows& windows) {
    return windows.length_error == stated.length_error ? resolved.given(keys().length_error)
                                                       : kLargestErrorText;
  };
  const auto [chosen, within] = analysis::windows_within(seconds, estimate);
  if (!within)
    throw BadInput(
        fmt::format("--budget: found {}; required: {} of processor time or more by estimate, with the "
                    "shortest windows: {} revolutions for the means, at most {} before them, {} {}",
                    budget, time_text(estimate.seconds(chosen)), chosen.observed, chosen.most,
                    keys().length_error, error_text(chosen)));
  const std::string cost = analysis::cost_text(chosen, stated);
  std::vector<Setting> settings;
  std::string text;
  const auto set = [&](const std::string& path, bool changed, const std::string& before,
                       const std::string& now) {
    if (!changed) return;
    settings.push_back({path, now});
    text += fmt::format("{}{} {} instead of {}", text.empty() ? "" : ", ", path, now, before);
  };
  set(keys().observed_revolutions, chosen.observed != stated.observed, std::to_string(stated.observed),
      std::to_string(chosen.observed));
  set(keys().most_revolutions, chosen.most != stated.most, std::to_string(stated.most),
      std::to_string(chosen.most));
  set(keys().length_error, chosen.length_error != stated.length_error, resolved.given(keys().length_error),
      kLargestErrorText);
  ResolvedCase changed = resolved.with(settings);
  for (const Setting& one : settings)
    changed = changed.assuming(one.path, "chosen by --budget from the number of steps: " + cost);
  return BudgetedCase{std::move(changed), chosen,
                      fmt::format("--budget {}: {} ({} of processor time instead of {}); {}", budget, text,
                                  time_text(estimate.seconds(chosen)), time_text(asked), cost)};
}

std::string estimate_text(double seconds, std::size_t points, std::size_t added, int threads, int accuracy) {
  const double wall = seconds / threads;
  if (wall < kAnnounced) return {};
  return fmt::format(
      "estimate: about {} for {} {} in motion{} ({} of processor time on {} {}), within a factor of {}",
      time_text(wall), points, points == 1 ? "point" : "points",
      added > 0 ? fmt::format(" and some {} around the peak", added) : "", time_text(seconds), threads,
      threads == 1 ? "thread" : "threads", accuracy);
}

std::vector<Derived> motion_time_quantities(const ResolvedCase& resolved) {
  if (resolved.model() != planetary_drivetrain || !resolved.has(keys().observed_revolutions) ||
      !resolved.shape().bearing)
    return {};
  const std::vector<MotionWork> work = work_of(resolved.without_sweep(), analysis::Fidelity::dynamic);
  const double seconds = analysis::seconds_of(work, windows_of(resolved));
  if (!(seconds > 0.0)) return {};
  return {{"simulation.processor_time", seconds, "s",
           fmt::format("estimate of a run with --fidelity dynamic, within a factor of {}",
                       analysis::accuracy_of(work))}};
}

}  // namespace orbearing::app
