#include "tests/reference/inclined_springs.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace orbearing::reference {

namespace {

double dot(const Space& a, const Space& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Space cross(const Space& a, const Space& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double contact(const InclinedSpring& spring, double depth) {
  return depth > 0.0 ? spring.stiffness * std::pow(depth, spring.exponent) : 0.0;
}

struct Pair {
  double inner, outer;
};

// The element sinks by s into the inner race along its normal, a rib holds it along that race.
Pair loads_of(const InclinedSpring& spring, double approach) {
  const double between = dot(spring.inner_normal, spring.outer_normal);
  const double radius = std::hypot(spring.at[0], spring.at[1]);
  const double radial =
      (spring.inner_normal[0] * spring.at[0] + spring.inner_normal[1] * spring.at[1]) / radius;
  const auto pair_at = [&](double s) {
    return Pair{contact(spring, s), contact(spring, approach - between * s)};
  };
  const auto excess = [&](double s) {
    const Pair both = pair_at(s);
    return both.inner - between * both.outer + spring.outward_inertia * radial;
  };
  double low = -0.1, high = 0.1;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? high : low) = middle;
  }
  return pair_at(0.5 * (low + high));
}

double approach_of(const InclinedSpring& spring, const std::array<double, 5>& place) {
  const Space turned = cross({place[3], place[4], 0.0}, spring.at);
  const Space moved{place[0] + turned[0], place[1] + turned[1], place[2] + turned[2]};
  return spring.mounted - dot(spring.outer_normal, moved);
}

using Five = std::array<double, 5>;

// Forces and moments on the planet.
Five left_over(const std::vector<InclinedSpring>& springs, const Space& force,
               const std::array<double, 2>& moment, const Five& place) {
  Five sum{force[0], force[1], force[2], moment[0], moment[1]};
  for (const InclinedSpring& spring : springs) {
    const double load = loads_of(spring, approach_of(spring, place)).outer;
    const Space push{load * spring.outer_normal[0], load * spring.outer_normal[1],
                     load * spring.outer_normal[2]};
    const Space turn = cross(spring.at, push);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += push[i];
    sum[3] += turn[0];
    sum[4] += turn[1];
  }
  return sum;
}

double size_of(const Five& all, std::size_t count) {
  double size = 0.0;
  for (std::size_t i = 0; i < count; ++i) size = std::max(size, std::abs(all[i]) * (i < 3 ? 1.0 : 10.0));
  return size;
}

// Elimination with pivots.
Five solved(std::array<Five, 5> matrix, Five right, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < count; ++i)
      if (std::abs(matrix[i][k]) > std::abs(matrix[pivot][k])) pivot = i;
    std::swap(matrix[k], matrix[pivot]);
    std::swap(right[k], right[pivot]);
    for (std::size_t i = k + 1; i < count; ++i) {
      const double factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k; j < count; ++j) matrix[i][j] -= factor * matrix[k][j];
      right[i] -= factor * right[k];
    }
  }
  Five result{};
  for (std::size_t k = count; k-- > 0;) {
    result[k] = right[k];
    for (std::size_t j = k + 1; j < count; ++j) result[k] -= matrix[k][j] * result[j];
    result[k] /= matrix[k][k];
  }
  return result;
}

}  // namespace

SpringLoads springs_in_balance(const std::vector<InclinedSpring>& springs, const Space& force,
                               const std::array<double, 2>& moment, bool tilts) {
  const std::size_t count = tilts ? 5 : 3;
  SpringLoads found;
  Five& place = found.place;
  const double size = std::hypot(force[0], force[1]);
  for (std::size_t i = 0; i < 2; ++i) place[i] = size > 0.0 ? 30e-6 * force[i] / size : 0.0;
  Five left = left_over(springs, force, moment, place);
  for (int step = 0; step < 200 && size_of(left, count) > 1e-9 * (1.0 + size); ++step) {
    std::array<Five, 5> slopes{};
    for (std::size_t j = 0; j < count; ++j) {
      const double change = 1e-9 * (j < 3 ? 1.0 : 10.0);
      Five ahead = place, behind = place;
      ahead[j] += change;
      behind[j] -= change;
      const Five more = left_over(springs, force, moment, ahead),
                 less = left_over(springs, force, moment, behind);
      for (std::size_t i = 0; i < count; ++i) slopes[i][j] = (less[i] - more[i]) / (2.0 * change);
    }
    const Five full = solved(slopes, left, count);
    const double before = size_of(left, count);
    Five best = place;
    for (double part = 1.0; part > 1e-4; part *= 0.5) {
      Five next = place;
      for (std::size_t i = 0; i < count; ++i) next[i] += part * full[i];
      const Five then = left_over(springs, force, moment, next);
      if (size_of(then, count) >= before) continue;
      best = next;
      left = then;
      break;
    }
    if (best == place) break;
    place = best;
  }
  for (const InclinedSpring& spring : springs) {
    const Pair both = loads_of(spring, approach_of(spring, place));
    found.inner.push_back(both.inner);
    found.outer.push_back(both.outer);
  }
  found.residual = size_of(left, count);
  return found;
}

}  // namespace orbearing::reference
