#include "coupling/system/balls_in_time.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::system {

namespace {

using bearing::balls::BallNumbers;
using bearing::balls::StateLayout;

// Frequency of a ball between its races [rad/s].
double ball_frequency(const BallNumbers& c) {
  const double slope = 1.5 * (c.inner.stiffness + c.outer.stiffness) * std::sqrt(kTypicalApproach);
  return std::sqrt(slope / c.mass);
}

}  // namespace

std::vector<double> ball_allowed_errors(const BallNumbers& c, double length) {
  const StateLayout layout{c.balls, c.spots.count};
  const double frequency = ball_frequency(c);
  std::vector<double> allowed(static_cast<std::size_t>(layout.size()), 0.0);
  const double per_radius = 1.0 / c.pitch_radius;
  const double by_group[StateLayout::kGroups] = {length,
                                                 length * per_radius,
                                                 length,
                                                 kRadialSpeedShare * length * frequency,
                                                 length * frequency * per_radius,
                                                 length * frequency,
                                                 length * frequency / c.radius,
                                                 length * frequency / c.radius,
                                                 length * frequency / c.radius};
  for (int group = 0; group < StateLayout::kGroups; ++group)
    std::fill_n(allowed.begin() + group * layout.lanes(), c.balls, by_group[group]);
  const auto put = [&](int first, int unknowns) {
    for (int i = 0; i < unknowns; ++i) {
      const double position = i < 3 ? length : length * per_radius;
      allowed[static_cast<std::size_t>(first + i)] = position;
      allowed[static_cast<std::size_t>(first + unknowns + i)] = position * frequency;
    }
  };
  put(layout.cage(), bearing::balls::kCageUnknowns);
  put(layout.inner(), bearing::balls::kRingUnknowns);
  put(layout.outer(), bearing::balls::kRingUnknowns);
  return allowed;
}

integration::Rosenbrock2 ball_stepper(const BallNumbers& numbers, double length, const BallSteps& steps) {
  return integration::Rosenbrock2(ball_allowed_errors(numbers, steps.error_factor * length),
                                  steps.longest / ball_frequency(numbers));
}

void require_containment(const BallNumbers& c, const double* x) {
  const StateLayout layout{c.balls};
  for (int j = 0; j < c.balls; ++j)
    if (!(std::abs(x[j] - c.pitch_radius) < c.radius) ||
        !(std::abs(x[2 * layout.lanes() + j]) < 2.0 * c.radius))
      throw std::runtime_error("a ball left the bearing: it is more than its radius off its circle");
  const double* cage = x + layout.cage();
  if (!(std::hypot(cage[0], cage[1]) < c.radius) || !(std::hypot(cage[3], cage[4]) < 0.5))
    throw std::runtime_error("the cage left its position");
}

}  // namespace orbearing::system
