#include "app/study/worth.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>

#include "app/errors.hpp"
#include "app/results/result_row.hpp"
#include "app/study/planetary_case.hpp"
#include "app/units.hpp"
#include "coupling/study/operating_point.hpp"

namespace orbearing::app {

namespace {

std::vector<double> speeds_of_sweep(const ResolvedCase& resolved) {
  for (const SweepAxis& axis : resolved.axes()) {
    if (axis.path != "input.speed") continue;
    std::vector<double> speeds;
    for (const std::string& value : axis.values)
      speeds.push_back(resolved.with(axis.path, value).quantity(axis.path));
    return speeds;
  }
  return {resolved.quantity("input.speed")};
}

Setting split_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw BadInput("expected.yaml: settings: found " + text + "; required: path=value");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

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

}  // namespace

ResolvedCase with_settings(const ResolvedCase& resolved, const std::vector<std::string>& settings) {
  std::vector<Setting> split;
  for (const std::string& text : settings) split.push_back(split_setting(text));
  return resolved.with(split);
}

LifeCurve life_curve(const ResolvedCase& resolved) {
  const std::vector<study::NamedSet> sets = bearing_sets(resolved);
  LifeCurve curve;
  for (const double speed : speeds_of_sweep(resolved)) {
    try {
      const study::PointResult point = study::evaluate(study::at_speed(sets, speed));
      curve.speed_rpm.push_back(in_table_unit(speed, 1.0 / kRadiansPerSecond));
      curve.life_h.push_back(point.life_hours);
      curve.roller_load_rms.push_back(point.outer.load_rms);
    } catch (const std::runtime_error&) {
      continue;  // the sweep tells why
    }
  }
  if (curve.speed_rpm.empty()) throw ComputationFailed("no point of the sweep has a life");
  return curve;
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

std::vector<Worth> worth_of(const ResolvedCase& resolved, const LifeCurve& base,
                            const std::vector<Alternative>& alternatives) {
  std::vector<Worth> all;
  for (const Alternative& alternative : alternatives) {
    Worth worth{.alternative = alternative,
                .curve = life_curve(with_settings(resolved, alternative.settings))};
    worth.peak_speed_rpm = property(worth.curve, "peak_speed_rpm");
    worth.peak_life_h = property(worth.curve, "peak_life_h");
    worth.worth_h = worth.peak_life_h - property(base, "peak_life_h");
    all.push_back(std::move(worth));
  }
  return all;
}

}  // namespace orbearing::app
