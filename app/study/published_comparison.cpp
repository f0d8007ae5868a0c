#include "app/study/published_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "app/case/case_file.hpp"
#include "app/case/field_table.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

// The value of the axis nearest to the case's own.
Setting nearest(const ResolvedCase& resolved, const SweepAxis& axis) {
  if (!resolved.has(axis.path)) return axis.setting(0);
  const double own = resolved.value(axis.path).number;
  const auto best =
      std::min_element(axis.numbers.begin(), axis.numbers.end(), [&](double one, double other) {
        return std::abs(one - own) < std::abs(other - own);
      });
  return axis.setting(static_cast<std::size_t>(best - axis.numbers.begin()));
}

// They name the case or choose its operating points.
bool chooses_operating_points(const std::string& path) {
  constexpr std::array<std::string_view, 4> others{"name", "source", "input.speed", "life.duration"};
  return std::find(others.begin(), others.end(), path) != others.end() || path.starts_with("spectrum");
}

// Units written otherwise round otherwise.
bool equal_but_for_units(double one, double other) {
  constexpr double round_off = 1e-12;
  return one == other || std::abs(one - other) <= round_off * std::max(std::abs(one), std::abs(other));
}

bool same_input(const Field& field, const FieldValue& one, const FieldValue& other) {
  if (one.given == other.given) return true;
  if (!is_numeric(field) || !std::isfinite(one.number)) return one == other;
  return equal_but_for_units(one.number, other.number);
}

std::string stated_or_not(const ResolvedCase& in, const std::string& path) {
  return in.has(path) ? in.given(path) : "not stated";
}

// The row of the sweep at a speed on the line that is shown; null where there is none.
const ResultRow* row_at(const SweepOutcome& outcome, const Json& columns, double rpm) {
  for (const ResultRow& row : outcome.rows) {
    bool here = row.ok() && equal_but_for_units(value_of(outcome.head, row, "input_speed_rpm"), rpm);
    for (const auto& [column, value] : columns.items())
      here = here && equal_but_for_units(value_of(outcome.head, row, column), value.get<double>());
    if (here) return &row;
  }
  return nullptr;
}

Json our_life(const SweepOutcome& outcome, const SpeedSlice& slice, double rpm) {
  if (const ResultRow* row = row_at(outcome, slice.columns, rpm))
    return {{"ours_h", value_of(outcome.head, *row, "life_h")}, {"ours_by", "point of the sweep"}};
  if (outcome.header.fidelity != "quasi-static") return {{"ours_h", nullptr}, {"ours_by", ""}};
  const study::PointResult point = compute_point(slice.at.without_sweep(), {input_speed(rpm)},
                                                 study::Fidelity::quasi_static);
  const bool known = point.status == "ok";
  return {{"ours_h", known ? Json(point.life_hours) : Json(nullptr)},
          {"ours_by", "computed for this comparison"}};
}

}  // namespace

SpeedSlice speed_slice(const ResolvedCase& resolved) {
  const std::vector<SweepAxis>& axes = resolved.axes();
  const bool speed_swept =
      std::any_of(axes.begin(), axes.end(), [](const SweepAxis& axis) { return axis.path == kSpeedPath; });
  if (!speed_swept || axes.size() < 2) return {resolved, {}, nullptr};
  std::vector<Setting> settings;
  for (const SweepAxis& axis : axes)
    if (axis.path != kSpeedPath) settings.push_back(nearest(resolved, axis));
  SpeedSlice slice{resolved.with(settings), {}, Json::object()};
  for (const Setting& one : settings) {
    slice.settings.push_back(one.path + "=" + one.text);
    slice.columns[axis_column(one.path).column] = axis_value(slice.at, one.path);
  }
  return slice;
}

std::vector<std::string> changed_inputs(const ResolvedCase& resolved, const ResolvedCase& shipped) {
  std::vector<std::string> changed;
  const auto compare = [&](const std::string& path, const Field& field) {
    if (chooses_operating_points(path) || (!resolved.has(path) && !shipped.has(path))) return;
    const bool both = resolved.has(path) && shipped.has(path);
    if (both && same_input(field, resolved.value(path), shipped.value(path))) return;
    changed.push_back(fmt::format("{}: {} (published: {})", path, stated_or_not(resolved, path), stated_or_not(shipped, path)));
  };
  if (resolved.model() != shipped.model()) return {"model"};
  const std::vector<Input> ours = resolved.inputs();
  for (const auto& [path, field] : ours) compare(path, *field);
  for (const auto& [path, field] : shipped.inputs()) {
    const bool ours_too = std::any_of(ours.begin(), ours.end(), [&](const Input& input) { return input.path == path; });
    if (!ours_too) compare(path, *field);
  }
  return changed;
}

PublishedComparison published_comparison(const ResolvedCase& resolved) {
  const std::string file = shipped_expected(resolved.text("name"));
  ExpectedFile expected = read_expected(file);
  PublishedComparison found{.table = {.case_name = resolved.text("name")}};
  if (expected.published.empty()) return found;
  expected.alternatives.clear();
  const ResolvedCase shipped = read_case((std::filesystem::path(file).parent_path() / "case.yaml").string());
  found.changed = changed_inputs(resolved, shipped);
  if (found.changed.empty()) found.table = validation_table_of(shipped, expected);
  return found;
}

Json published_points(const std::vector<ValidationRow>& rows, const SweepOutcome& outcome,
                      const ResolvedCase& resolved) {
  const SpeedSlice slice = speed_slice(resolved);
  Json list = Json::array();
  Json speed;
  for (const ValidationRow& row : rows)
    if (row.reading.empty() && row.published.quantity == "peak_speed_rpm" && row.published.value)
      speed = *row.published.value;
  for (const ValidationRow& row : rows) {
    const PublishedValue& published = row.published;
    if (!row.reading.empty() || published.quantity != "peak_life_h" || !published.value || speed.is_null()) continue;
    list.push_back({{"source", published.source},
                    {"quantity", published.quantity},
                    {"speed_rpm", speed},
                    {"life_h", *published.value}});
    list.back().update(our_life(outcome, slice, speed.get<double>()));
  }
  return list;
}

}  // namespace orbearing::app
