#include "app/results/continuation_paths.hpp"

#include <algorithm>

namespace orbearing::app {

std::vector<std::vector<std::size_t>> continuation_paths(const std::vector<SweepPoint>& points,
                                                         Direction direction) {
  std::vector<std::vector<std::size_t>> paths;
  for (std::size_t point = 0; point < points.size(); ++point) {
    const auto same = std::find_if(paths.begin(), paths.end(), [&](const std::vector<std::size_t>& path) {
      return points[path.front()].axis_values == points[point].axis_values;
    });
    if (same == paths.end())
      paths.push_back({point});
    else
      same->push_back(point);
  }
  for (std::vector<std::size_t>& path : paths)
    std::stable_sort(path.begin(), path.end(), [&](std::size_t one, std::size_t other) {
      const double step = points[other].input_speed - points[one].input_speed;
      return direction == Direction::up ? step > 0.0 : step < 0.0;
    });
  return paths;
}

}  // namespace orbearing::app
