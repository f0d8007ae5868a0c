#include "tests/reference/inclined_laminae.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace orbearing::reference {

namespace {

using Vector = std::array<double, 3>;
using Five = std::array<double, 5>;

Vector turned(const Vector& rotation, const Vector& arm) {
  return {rotation[1] * arm[2] - rotation[2] * arm[1], rotation[2] * arm[0] - rotation[0] * arm[2],
          rotation[0] * arm[1] - rotation[1] * arm[0]};
}

Vector point_of(const LaminaRoller& roller, double place) {
  return {roller.at[0] + place * roller.along[0], roller.at[1] + place * roller.along[1],
          roller.at[2] + place * roller.along[2]};
}

double of_contact(const LaminaRoller& roller, double depth) {
  const double share = roller.stiffness / static_cast<double>(roller.places.size());
  return depth > 0.0 ? share * std::pow(depth, roller.exponent) : 0.0;
}

// Zero of a function that grows from below zero at `low` to above zero at `high`.
template <class Function>
double zero(const Function& value, double low, double high) {
  double at_low = value(low), at_high = value(high);
  int kept = 0;
  for (int i = 0; i < 300 && high - low > 1e-21; ++i) {
    double next = high - at_high * (high - low) / (at_high - at_low);
    if (i % 8 == 7 || !(next > low && next < high)) next = 0.5 * (low + high);
    const double here = value(next);
    if (here == 0.0 || next == low || next == high) return next;
    if (here > 0.0) {
      high = next;
      at_high = here;
      if (kept == 1) at_low *= 0.5;
      kept = 1;
    } else {
      low = next;
      at_low = here;
      if (kept == -1) at_high *= 0.5;
      kept = -1;
    }
  }
  return 0.5 * (low + high);
}

struct Settled {
  std::vector<double> inner, outer;
};

Settled settled(const LaminaRoller& roller, const std::vector<double>& approach) {
  const std::size_t count = roller.places.size();
  const auto at = [&](double depth, double tilt) {
    Settled both;
    for (std::size_t k = 0; k < count; ++k) {
      const double in = depth + roller.places[k] * tilt;
      both.inner.push_back(of_contact(roller, in - roller.drops[k]));
      both.outer.push_back(of_contact(
          roller, approach[k] - roller.between * depth - roller.places[k] * tilt - roller.drops[k]));
    }
    return both;
  };
  constexpr double deep = 2e-3, steep = 0.05;
  const auto depth_of = [&](double tilt) {
    return zero(
        [&](double depth) {
          const Settled both = at(depth, tilt);
          double sum = roller.inertia;
          for (std::size_t k = 0; k < count; ++k) sum += both.inner[k] - roller.between * both.outer[k];
          return sum;
        },
        -deep, deep);
  };
  double tilt = 0.0;
  if (count > 1)
    tilt = zero(
        [&](double angle) {
          const Settled both = at(depth_of(angle), angle);
          double sum = 0.0;
          for (std::size_t k = 0; k < count; ++k) sum += roller.places[k] * (both.inner[k] - both.outer[k]);
          return sum;
        },
        -steep, steep);
  return at(depth_of(tilt), tilt);
}

Settled under(const LaminaRoller& roller, const Five& place) {
  std::vector<double> approach;
  for (const double x : roller.places) {
    const Vector turn = turned({place[3], place[4], 0.0}, point_of(roller, x));
    double outward = 0.0;
    for (std::size_t i = 0; i < 3; ++i) outward += roller.outer_normal[i] * (place[i] + turn[i]);
    approach.push_back(roller.mounted - outward);
  }
  return settled(roller, approach);
}

Five left_over(const std::vector<LaminaRoller>& rollers, const Vector& force,
               const std::array<double, 2>& moment, const Five& place) {
  Five sum{force[0], force[1], force[2], moment[0], moment[1]};
  for (const LaminaRoller& roller : rollers) {
    const Settled both = under(roller, place);
    for (std::size_t k = 0; k < roller.places.size(); ++k) {
      Vector push = roller.outer_normal;
      for (double& part : push) part *= both.outer[k];
      const Vector turn = turned(point_of(roller, roller.places[k]), push);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += push[i];
      sum[3] += turn[0];
      sum[4] += turn[1];
    }
  }
  return sum;
}

double size_of(const Five& all) {
  double size = 0.0;
  for (std::size_t i = 0; i < 5; ++i) size = std::max(size, std::abs(all[i]) * (i < 3 ? 1.0 : 10.0));
  return size;
}

Five solved(std::array<Five, 5> matrix, Five right) {
  for (std::size_t k = 0; k < 5; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < 5; ++i)
      if (std::abs(matrix[i][k]) > std::abs(matrix[pivot][k])) pivot = i;
    std::swap(matrix[k], matrix[pivot]);
    std::swap(right[k], right[pivot]);
    for (std::size_t i = k + 1; i < 5; ++i) {
      const double factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k; j < 5; ++j) matrix[i][j] -= factor * matrix[k][j];
      right[i] -= factor * right[k];
    }
  }
  Five result{};
  for (std::size_t k = 5; k-- > 0;) {
    result[k] = right[k];
    for (std::size_t j = k + 1; j < 5; ++j) result[k] -= matrix[k][j] * result[j];
    result[k] /= matrix[k][k];
  }
  return result;
}

}  // namespace

LaminaLoads laminae_in_balance(const std::vector<LaminaRoller>& rollers, const Vector& force,
                               const std::array<double, 2>& moment) {
  LaminaLoads found;
  Five& place = found.place;
  const double size = std::hypot(force[0], force[1]);
  for (std::size_t i = 0; i < 2; ++i) place[i] = size > 0.0 ? 30e-6 * force[i] / size : 0.0;
  Five left = left_over(rollers, force, moment, place);
  for (int step = 0; step < 60 && size_of(left) > 1e-8 * (1.0 + size); ++step) {
    std::array<Five, 5> slopes{};
    for (std::size_t j = 0; j < 5; ++j) {
      const double change = 1e-9 * (j < 3 ? 1.0 : 10.0);
      Five ahead = place;
      ahead[j] += change;
      const Five more = left_over(rollers, force, moment, ahead);
      for (std::size_t i = 0; i < 5; ++i) slopes[i][j] = (left[i] - more[i]) / change;
    }
    const Five full = solved(slopes, left);
    const double before = size_of(left);
    for (double part = 1.0; part > 1e-3; part *= 0.5) {
      Five next = place;
      for (std::size_t i = 0; i < 5; ++i) next[i] += part * full[i];
      const Five then = left_over(rollers, force, moment, next);
      if (size_of(then) >= before && part > 2e-3) continue;
      place = next;
      left = then;
      break;
    }
  }
  for (const LaminaRoller& roller : rollers) {
    Settled both = under(roller, place);
    found.inner.push_back(std::move(both.inner));
    found.outer.push_back(std::move(both.outer));
  }
  found.residual = size_of(left);
  return found;
}

}  // namespace orbearing::reference
