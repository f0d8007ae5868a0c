// Newton's method for the least of a convex energy of two lengths, with a search along each step.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace orbearing::bearing::laminae {

/// Slope of the energy and its slope. Both unknowns are lengths, so that both slopes are forces.
struct EnergySlope {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();      // [N]    -d(energy)/d(unknowns)
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  // [N/m]
  double scale = 0.0;                                   // [N]    largest of the forces that balance
};

struct NewtonLimits {
  double reach = 0.0;      // [m]  longest step
  double tolerance = 0.0;  // [-]  of the force that remains, as a share of the largest force at hand
  double round_off = 0.0;  // [m]  shortest step that changes anything
  int iterations = 200;
};

struct NewtonReport {
  int iterations = 0;
  bool settled = false;  // ended within tolerance or at round-off
};

/// Lengths that forces cause on a stiffness that may be singular: a direction without stiffness is given a
/// little of the other's, so that forces along it ask for far too long a step, and no force for none.
inline Eigen::Vector2d lengths_under(const Eigen::Vector2d& force, const Eigen::Matrix2d& stiffness) {
  const int first = stiffness(0, 0) >= stiffness(1, 1) ? 0 : 1, second = 1 - first;
  const double pivot = stiffness(first, first) + 1e-30;
  const double factor = stiffness(0, 1) / pivot;
  const double rest = std::fmax(stiffness(second, second) - factor * stiffness(0, 1), 1e-12 * pivot);
  Eigen::Vector2d lengths;
  lengths[second] = (force[second] - factor * force[first]) / rest;
  lengths[first] = force[first] / pivot - factor * lengths[second];
  return lengths;
}

inline Eigen::Vector2d newton_step(const EnergySlope& now, double reach) {
  const Eigen::Vector2d step = lengths_under(now.force, now.stiffness);
  const double length = step.norm();
  return length > reach ? Eigen::Vector2d(step * (reach / length)) : step;
}

/// Follows `slope_at(unknowns)` to where the force vanishes; on return `now` is the slope at `at`. Along a
/// step the force that drives it falls, for the energy is convex: a step that ends with more than a third of
/// it pointing back is shortened to where the secant puts its zero.
template <class Function>
NewtonReport least_energy(Function&& slope_at, const NewtonLimits& limits, Eigen::Vector2d& at,
                          EnergySlope& now) {
  constexpr int kMostShortenings = 40;
  NewtonReport report;
  now = slope_at(at);
  for (; report.iterations < limits.iterations; ++report.iterations) {
    report.settled = now.force.norm() <= limits.tolerance * now.scale;
    if (report.settled) break;
    const Eigen::Vector2d step = newton_step(now, limits.reach);
    report.settled = step.norm() <= limits.round_off;
    if (report.settled) break;
    const Eigen::Vector2d from = at;
    const double drive = now.force.dot(step);
    double fraction = 1.0;
    for (int i = 0; i < kMostShortenings; ++i) {
      at = from + fraction * step;
      now = slope_at(at);
      const double left = now.force.dot(step);
      if (left >= -0.3 * drive) break;
      fraction *= std::fmax(0.1, drive / (drive - left));
    }
  }
  return report;
}

}  // namespace orbearing::bearing::laminae
