#include "app/study/speed_slice.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

// The value of the axis nearest to the case's own, as written.
std::string nearest(const ResolvedCase& resolved, const SweepAxis& axis) {
  if (!resolved.has(axis.path)) return axis.values.front();
  const double own = axis_value(resolved, axis.path);
  const auto distance = [&](const std::string& value) {
    return std::abs(axis_value(resolved.with(axis.path, value), axis.path) - own);
  };
  return *std::min_element(
      axis.values.begin(), axis.values.end(),
      [&](const std::string& one, const std::string& other) { return distance(one) < distance(other); });
}

}  // namespace

SpeedSlice speed_slice(const ResolvedCase& resolved) {
  const std::vector<SweepAxis>& axes = resolved.axes();
  const bool speed_swept =
      std::any_of(axes.begin(), axes.end(), [](const SweepAxis& axis) { return axis.path == kSpeedPath; });
  if (!speed_swept || axes.size() < 2) return {resolved, nullptr};
  std::vector<Setting> settings;
  for (const SweepAxis& axis : axes)
    if (axis.path != kSpeedPath) settings.emplace_back(axis.path, nearest(resolved, axis));
  SpeedSlice slice{resolved.with(settings), nlohmann::ordered_json::object()};
  for (const auto& [path, value] : settings)
    slice.columns[axis_column(path).column] = axis_value(slice.at, path);
  return slice;
}

}  // namespace orbearing::app
