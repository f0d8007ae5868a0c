// Lower and upper quartile of a sample.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace orbearing::bench {

struct Quartiles {
  double lower = 0.0, median = 0.0, upper = 0.0;
};

/// By linear interpolation between the ordered values, of which there is at least one.
inline Quartiles quartiles(std::vector<double> values) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double position = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (position - static_cast<double>(below)) * (values[above] - values[below]);
  };
  return {at(0.25), at(0.5), at(0.75)};
}

inline double median(const std::vector<double>& values) {
  return quartiles(values).median;
}

}  // namespace orbearing::bench
