#include "app/study/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "app/errors.hpp"
#include "app/results/json_number.hpp"
#include "app/results/result_row.hpp"
#include "app/study/fidelity.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

double speed_of_largest(const LifeCurve& curve, const std::vector<double>& values) {
  return curve
      .speed_rpm[static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin())];
}

double speed_of_smallest(const LifeCurve& curve, const std::vector<double>& values) {
  return curve
      .speed_rpm[static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin())];
}

double rises_then_falls(const LifeCurve& curve) {
  const auto peak = std::max_element(curve.life_h.begin(), curve.life_h.end());
  const bool inside = peak != curve.life_h.begin() && peak != curve.life_h.end() - 1;
  const bool one_peak = std::is_sorted(curve.life_h.begin(), peak) &&
                        std::is_sorted(peak, curve.life_h.end(), std::greater<>());
  return inside && one_peak ? 1.0 : 0.0;
}

std::string life_cell(double life) {
  return std::isnan(life) ? "failed" : fmt::format("{:.0f}", life);
}

// At the best speed of the case as it stands [h]; NaN where either failed.
double gain_at_best(const ChangeResult& reference, const ChangeResult& result) {
  const std::size_t at = best_point(reference);
  return life_of(result.points[at]) - life_of(reference.points[at]);
}

}  // namespace

LifeCurve life_curve(const ChangeResult& result) {
  LifeCurve curve;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const study::PointResult& point = result.points[i];
    if (!is_computed(point.status)) continue;  // the sweep tells why
    curve.speed_rpm.push_back(in_table_unit(result.speed[i], 1.0 / kRadiansPerSecond));
    curve.life_h.push_back(point.life_hours);
    curve.roller_load_rms.push_back(point.outer.load_rms);
  }
  if (curve.speed_rpm.empty()) throw ComputationFailed("no point of the sweep has a life");
  return curve;
}

LifeCurve life_curve(const ResolvedCase& resolved) {
  return life_curve(results_of(resolved, with_reference({}), {}).front());
}

double property(const LifeCurve& curve, const std::string& quantity) {
  static const std::map<std::string, std::function<double(const LifeCurve&)>> known{
      {"peak_speed_rpm", [](const LifeCurve& c) { return speed_of_largest(c, c.life_h); }},
      {"peak_life_h", [](const LifeCurve& c) { return *std::max_element(c.life_h.begin(), c.life_h.end()); }},
      {"least_load_speed_rpm", [](const LifeCurve& c) { return speed_of_smallest(c, c.roller_load_rms); }},
      {"shortest_life_speed_rpm", [](const LifeCurve& c) { return speed_of_smallest(c, c.life_h); }},
      {"life_rises_then_falls", rises_then_falls},
  };
  const auto found = known.find(quantity);
  return found == known.end() ? std::numeric_limits<double>::quiet_NaN() : found->second(curve);
}

std::vector<Sensitivity> sensitivities(const std::vector<ChangeResult>& results) {
  const double stated = property(life_curve(results.front()), "peak_life_h");
  std::vector<Sensitivity> all;
  for (std::size_t i = 1; i < results.size(); ++i) {
    Sensitivity one{.change = results[i].change, .curve = life_curve(results[i])};
    one.peak_speed_rpm = property(one.curve, "peak_speed_rpm");
    one.peak_life_h = property(one.curve, "peak_life_h");
    one.difference_h = one.peak_life_h - stated;
    all.push_back(std::move(one));
  }
  return all;
}

void put_derivatives(const ResolvedCase& resolved, double peak_rpm, int jobs, std::vector<Sensitivity>& all) {
  DerivativeOptions options{.jobs = jobs};
  for (const Sensitivity& one : all) options.paths.push_back(one.change.group);
  if (options.paths.empty()) return;
  const ResolvedCase at_peak =
      resolved.without_sweep().with({input_speed(peak_rpm)});
  const ScalarResult life = scalar_result(at_peak);
  const Derivatives found = derivatives(at_peak, life, value_here(at_peak, life), options);
  for (Sensitivity& one : all)
    for (const Derivative& derivative : found.inputs)
      if (derivative.path == one.change.group) one.derivative = derivative;
}

ChangeStudy study_of(const ResolvedCase& resolved, const MotionPlan& plan, int jobs) {
  ChangeStudy study{.fidelity = fidelity_of(plan.fidelity), .jobs = jobs};
  for (const double rpm : plan.speed_rpm)
    study.speed.push_back(resolved.with({input_speed(rpm)}).quantity(kSpeedPath));
  return study;
}

std::string motion_heading(const std::string& case_name, const MotionPlan& plan) {
  std::string text =
      fmt::format("{}: what assumptions are worth in motion ({}), life of one bearing [h]\n{:<46}", case_name,
                  plan.fidelity, "assumption");
  for (const double rpm : plan.speed_rpm) text += fmt::format("{:>10}", fmt::format("{:.0f} rpm", rpm));
  return text + fmt::format("{:>12}{:>12}  {}\n", "best [rpm]", "worth [h]", "reading");
}

std::string motion_line(const MotionPlan& plan, const ChangeResult& reference, const ChangeResult& result) {
  std::string text = fmt::format("{:<46}", result.change.group);
  for (const study::PointResult& point : result.points)
    text += fmt::format("{:>10}", life_cell(life_of(point)));
  const double difference = gain_at_best(reference, result);
  return text + fmt::format("{:>12.0f}{:>12}  {}\n", plan.speed_rpm[best_point(result)],
                            std::isnan(difference) ? "-" : fmt::format("{:+.0f}", difference),
                            result.change.name);
}

nlohmann::ordered_json motion_json(const std::string& case_name, const MotionPlan& plan,
                                   const std::vector<ChangeResult>& results) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ChangeResult& result : results) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < result.points.size(); ++i)
      points.push_back({{"speed_rpm", plan.speed_rpm[i]},
                        {"life_h", number_or_null(life_of(result.points[i]))},
                        {"status", result.points[i].status}});
    list.push_back({{"case", case_name},
                    {"fidelity", plan.fidelity},
                    {"assumption", result.change.group},
                    {"reading", result.change.name},
                    {"settings", result.change.settings},
                    {"points", points},
                    {"best_speed_rpm", plan.speed_rpm[best_point(result)]},
                    {"worth_h", number_or_null(gain_at_best(results.front(), result))}});
  }
  return list;
}

}  // namespace orbearing::app
