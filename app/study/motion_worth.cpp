#include "app/study/motion_worth.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/errors.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/worth.hpp"
#include "coupling/study/parallel.hpp"

namespace orbearing::app {

namespace {

MotionCurve motion_curve(const ResolvedCase& resolved, const Alternative& alternative,
                         const std::vector<double>& speeds, study::Fidelity fidelity, int jobs,
                         const EvaluateMotion& evaluate) {
  const ResolvedCase changed = with_settings(resolved, alternative.settings);
  std::vector<ResolvedCase> at_speeds;
  for (const double rpm : speeds)
    at_speeds.push_back(changed.with("input.speed", fmt::format("{:.17g} rpm", rpm)));
  MotionCurve curve{.alternative = alternative,
                    .life_h = std::vector<double>(speeds.size(), std::numeric_limits<double>::quiet_NaN()),
                    .status = std::vector<std::string>(speeds.size())};
  std::vector<std::size_t> indices(speeds.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  study::compute_points(
      indices, jobs, [&](std::size_t i) { return evaluate(at_speeds[i], fidelity); },
      [&curve](const std::vector<study::ComputedPoint>& points) {
        for (const study::ComputedPoint& point : points) {
          curve.status[point.index] = point.result.status;
          if (point.result.status == "ok") curve.life_h[point.index] = point.result.life_hours;
        }
      },
      [] { return false; });
  return curve;
}

std::string life_cell(double life) {
  return std::isnan(life) ? "failed" : fmt::format("{:.0f}", life);
}

}  // namespace

study::PointResult evaluated_motion(const ResolvedCase& at_speed, study::Fidelity fidelity) {
  return study::evaluate(bearing_sets(at_speed), fidelity);
}

MotionWorth motion_worth(const ResolvedCase& resolved, const MotionPlan& plan, int jobs,
                         const EvaluateMotion& evaluate,
                         const std::function<void(const MotionWorth& so_far)>& done) {
  MotionWorth worth{
      .case_name = resolved.text("name"), .fidelity = plan.fidelity, .speed_rpm = plan.speed_rpm};
  std::vector<Alternative> all{{"", "the case as it stands", {}}};
  all.insert(all.end(), plan.alternatives.begin(), plan.alternatives.end());
  const ResolvedCase fixed = resolved.without_sweep();
  const study::Fidelity fidelity = fidelity_of(plan.fidelity);
  for (const Alternative& alternative : all) {
    worth.curves.push_back(motion_curve(fixed, alternative, plan.speed_rpm, fidelity, jobs, evaluate));
    done(worth);
  }
  return worth;
}

std::size_t best_speed(const MotionCurve& curve) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < curve.life_h.size(); ++i)
    if (std::isnan(curve.life_h[best]) || curve.life_h[i] > curve.life_h[best]) best = i;
  return best;
}

std::string motion_heading(const MotionWorth& worth) {
  std::string text =
      fmt::format("{}: what assumptions are worth in motion ({}), life of one bearing [h]\n{:<46}",
                  worth.case_name, worth.fidelity, "assumption");
  for (const double rpm : worth.speed_rpm) text += fmt::format("{:>10}", fmt::format("{:.0f} rpm", rpm));
  return text + fmt::format("{:>12}{:>12}  {}\n", "best [rpm]", "worth [h]", "reading");
}

std::string motion_line(const MotionWorth& worth) {
  const MotionCurve& curve = worth.curves.back();
  const std::size_t at = best_speed(worth.curves.front());
  std::string text = fmt::format("{:<46}", curve.alternative.assumption);
  for (const double life : curve.life_h) text += fmt::format("{:>10}", life_cell(life));
  const double gain = curve.life_h[at] - worth.curves.front().life_h[at];
  return text + fmt::format("{:>12.0f}{:>12}  {}\n", worth.speed_rpm[best_speed(curve)],
                            std::isnan(gain) ? "-" : fmt::format("{:+.0f}", gain), curve.alternative.reading);
}

nlohmann::ordered_json motion_json(const MotionWorth& worth) {
  const std::size_t at = best_speed(worth.curves.front());
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const MotionCurve& curve : worth.curves) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < worth.speed_rpm.size(); ++i)
      points.push_back({{"speed_rpm", worth.speed_rpm[i]},
                        {"life_h", std::isnan(curve.life_h[i]) ? nlohmann::ordered_json(nullptr)
                                                               : nlohmann::ordered_json(curve.life_h[i])},
                        {"status", curve.status[i]}});
    const double gain = curve.life_h[at] - worth.curves.front().life_h[at];
    list.push_back(
        {{"case", worth.case_name},
         {"fidelity", worth.fidelity},
         {"assumption", curve.alternative.assumption},
         {"reading", curve.alternative.reading},
         {"settings", curve.alternative.settings},
         {"points", points},
         {"best_speed_rpm", worth.speed_rpm[best_speed(curve)]},
         {"worth_h", std::isnan(gain) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(gain)}});
  }
  return list;
}

}  // namespace orbearing::app
