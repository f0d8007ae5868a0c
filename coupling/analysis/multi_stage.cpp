#include "coupling/analysis/multi_stage.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/life/lundberg_palmgren.hpp"
#include "coupling/analysis/worst_bearing.hpp"

namespace orbearing::analysis {

namespace {

SetResult summary(const std::string& name, const PointResult& point) {
  return {.set = name,
          .carrier_speed = point.carrier_speed,
          .planet_load = point.planet_load,
          .inner = point.inner,
          .outer = point.outer,
          .life_hours = point.life_hours,
          .rating = point.rating,
          .contact_pressure = point.contact_pressure,
          .rim_over_module = point.rim_over_module,
          .unlike = unlike_bearings(point)};
}

// An unknown life, as with kappa below 0.1, counts as the shortest.
double life(const PointResult& point) {
  const double hours = worst_governing_hours(point);
  return std::isnan(hours) ? 0.0 : hours;
}

PointResult evaluate_named(const NamedSet& set, Fidelity fidelity) {
  try {
    return evaluate(set.drivetrain, set.geometry, fidelity);
  } catch (const std::exception& error) {
    throw std::runtime_error(set.name + ": " + error.what());
  }
}

}  // namespace

PointResult evaluate(const std::vector<NamedSet>& sets, Fidelity fidelity) {
  if (sets.empty()) throw std::invalid_argument("no set has bearings");
  if (sets.size() == 1 && sets.front().name.empty())
    return evaluate(sets.front().drivetrain, sets.front().geometry, fidelity);
  std::vector<PointResult> points;
  for (const NamedSet& set : sets) points.push_back(evaluate_named(set, fidelity));
  const auto shortest =
      std::min_element(points.begin(), points.end(),
                       [](const PointResult& a, const PointResult& b) { return life(a) < life(b); });
  PointResult result = *shortest;
  result.limiting_set = sets[static_cast<std::size_t>(shortest - points.begin())].name;
  std::vector<bearing::rating::RatedHours> rated;
  for (const PointResult& point : points) rated.push_back(point.rating.system_hours);
  result.rating.system_hours = bearing::rating::hours_together(
      rated, bearing::rating::weibull_slope(bearing::rating::RollingElement::roller));
  const auto together = [&](auto life_of) {
    double all = life_of(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) all = bearing::combined_life(all, life_of(points[i]));
    return all;
  };
  result.system_life_hours = together([](const PointResult& point) { return point.system_life_hours; });
  for (std::size_t i = 0; i < points.size(); ++i) result.sets.push_back(summary(sets[i].name, points[i]));
  return result;
}

std::vector<NamedSet> at_speed(std::vector<NamedSet> sets, double speed) {
  for (NamedSet& set : sets) turn_at(speed, set.drivetrain, set.geometry);
  return sets;
}

}  // namespace orbearing::analysis
