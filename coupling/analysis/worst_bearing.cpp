#include "coupling/analysis/worst_bearing.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::analysis {

namespace {

template <class Results>
auto shortest_lived(const Results& results) {
  return std::ranges::min_element(results, {}, [](const auto& one) { return one.life_hours; });
}

double shortest_hours(const PointResult& point) {
  if (point.coupled) return std::ranges::min(point.coupled->bearing_life_hours);
  if (!point.seats.empty()) return shortest_lived(point.seats)->life_hours;
  return point.planets.empty() ? UnlikeBearings::kAlike : shortest_lived(point.planets)->life_hours;
}

}  // namespace

UnlikeBearings unlike_bearings(const PointResult& point) {
  UnlikeBearings unlike{.shortest_hours = shortest_hours(point)};
  for (const auto hours : bearing::rating::kRatedHours) {
    double& least = unlike.shortest_rated.*hours;
    for (const SeatResult& seat : point.seats) least = std::fmin(least, seat.rated_hours.*hours);
    for (const PlanetResult& planet : point.planets) least = std::fmin(least, planet.rated_hours.*hours);
  }
  if (!point.planets.empty())
    unlike.planet = static_cast<double>(shortest_lived(point.planets) - point.planets.begin() + 1);
  for (const PlanetResult& planet : point.planets)
    unlike.load_share = std::fmax(unlike.load_share, planet.load_share);
  return unlike;
}

double worst_governing_hours(const PointResult& point) {
  const bearing::rating::Life life = governing_life(point);
  double worst = UnlikeBearings::kAlike;
  if (point.carrier)
    for (const BearingOverRevolution& one : point.carrier->bearings)
      worst = std::fmin(worst, bearing::rating::hours_of(life, one.life_hours, one.rated_hours));
  if (std::isfinite(worst)) return worst;
  const UnlikeBearings unlike = unlike_bearings(point);
  worst = bearing::rating::hours_of(life, unlike.shortest_hours, unlike.shortest_rated);
  return std::isfinite(worst) ? worst : governing_hours(point);
}

}  // namespace orbearing::analysis
