#include "app/study/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/study/drivetrain_case.hpp"
#include "app/study/planetary_case.hpp"

namespace orbearing::app {

namespace {

// Observation for a single bearing: the relative speed of its rings.
void add_single_speed(const ResolvedCase& in, std::vector<Observation>& found) {
  if (!in.has("operation.shaft_speed") || !in.has("bearing.pitch_diameter")) return;
  const double outer = in.has("operation.outer_speed") ? in.quantity("operation.outer_speed") : 0.0;
  found.push_back(analysis::observed_speed(in.quantity("operation.shaft_speed") - outer,
                                           in.quantity("bearing.pitch_diameter")));
}

// All that is judged.
void collect(const nlohmann::ordered_json& value, const std::string& key, std::vector<Observation>& found) {
  if (value.is_number() && analysis::range_of(key) != nullptr) found.push_back({key, value.get<double>()});
  if (!value.is_structured()) return;
  for (const auto& [inner, one] : value.items()) collect(one, value.is_object() ? inner : key, found);
}

}  // namespace

std::vector<Observation> observations(const nlohmann::ordered_json& object) {
  std::vector<Observation> found;
  collect(object, "", found);
  return found;
}

std::vector<Observation> observations(const ResolvedCase& at_point) {
  std::vector<Observation> found;
  if (at_point.model() != planetary_drivetrain)
    add_single_speed(at_point, found);
  else if (at_point.shape().several || at_point.shape().bearing)
    found = analysis::observations(bearing_sets(at_point));
  else if (at_point.shape().teeth)
    found = analysis::observations_of_gears(drivetrain_without_gear_set(at_point));
  return found;
}

std::vector<std::string> rim_warnings(const ResolvedCase& at_point) {
  if (at_point.model() != planetary_drivetrain || !(at_point.shape().several || at_point.shape().bearing))
    return {};
  return analysis::thin_rim_warnings(bearing_sets(at_point));
}

study::PointResult judged(study::PointResult result, const std::vector<study::NamedSet>& sets) {
  if (result.status != "ok") return result;
  static const TableHead head = table_head({});
  const ResultRow row = result_row(result, {});
  std::vector<Observation> observed = analysis::observations(sets);
  for (const analysis::PlausibleRange& range : analysis::plausible_ranges())
    for (const std::string& key : range.of.keys) observed.push_back({key, value_of(head, row, key)});
  result.status = judge(observed).status;
  return result;
}

std::vector<std::string> rare_values(const TableHead& head, const std::vector<const ResultRow*>& rows) {
  std::vector<std::string> warnings;
  for (const analysis::PlausibleRange& range : analysis::plausible_ranges()) {
    for (const bool low : {true, false}) {
      std::size_t count = 0;
      std::string text, first;
      for (const ResultRow* row : rows) {
        const auto rare = [&](const std::string& key) {
          const double value = value_of(head, *row, key);
          return low ? value < range.rare_low.value : value > range.rare_high.value;
        };
        const auto key = std::find_if(range.of.keys.begin(), range.of.keys.end(), rare);
        if (key == range.of.keys.end() || count++ > 0) continue;
        text = analysis::rare_text(range, value_of(head, *row, *key));
        first = fmt::format("{:g} rpm", value_of(head, *row, "input_speed_rpm"));
      }
      if (count > 0)
        warnings.push_back(fmt::format("{}: {} of {} points, first at {}", text, count, rows.size(), first));
    }
  }
  return warnings;
}

}  // namespace orbearing::app
