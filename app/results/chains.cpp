#include "app/results/chains.hpp"

#include <algorithm>

namespace orbearing::app {

std::vector<std::vector<std::size_t>> chains_of(const std::vector<SweepPoint>& points, Direction direction) {
  std::vector<std::vector<std::size_t>> chains;
  for (std::size_t point = 0; point < points.size(); ++point) {
    const auto same = std::find_if(chains.begin(), chains.end(), [&](const std::vector<std::size_t>& chain) {
      return points[chain.front()].axis_values == points[point].axis_values;
    });
    if (same == chains.end())
      chains.push_back({point});
    else
      same->push_back(point);
  }
  for (std::vector<std::size_t>& chain : chains)
    std::stable_sort(chain.begin(), chain.end(), [&](std::size_t one, std::size_t other) {
      const double step = points[other].input_speed - points[one].input_speed;
      return direction == Direction::up ? step > 0.0 : step < 0.0;
    });
  return chains;
}

}  // namespace orbearing::app
