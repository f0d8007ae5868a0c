#include "app/study/speed_slice.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/study/sweep_study.hpp"

namespace orbearing::app {

namespace {

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

}  // namespace

SpeedSlice speed_slice(const ResolvedCase& resolved) {
  const std::vector<SweepAxis>& axes = resolved.axes();
  const bool speed_swept =
      std::any_of(axes.begin(), axes.end(), [](const SweepAxis& axis) { return axis.path == kSpeedPath; });
  if (!speed_swept || axes.size() < 2) return {resolved, nullptr};
  std::vector<Setting> settings;
  for (const SweepAxis& axis : axes)
    if (axis.path != kSpeedPath) settings.push_back(nearest(resolved, axis));
  SpeedSlice slice{resolved.with(settings), nlohmann::ordered_json::object()};
  for (const Setting& one : settings)
    slice.columns[axis_column(one.path).column] = axis_value(slice.at, one.path);
  return slice;
}

}  // namespace orbearing::app
