#include "gearset/planet_places.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <string>

#include "gearset/message.hpp"

namespace orbearing::gearset {

namespace {

using boost::math::double_constants::degree;
using boost::math::double_constants::two_pi;

constexpr double kWritten = 0.005 * degree;  // [rad]  by which a stated angle may be rounded
const std::string kPlaces = "gearset.planet_angles";

// From one place where teeth fit to the next, Eq. (23).
double place_step(const PlanetarySet& set) {
  return two_pi / (set.sun_teeth + set.ring_teeth);
}

// Of a set without teeth, any.
double nearest_place(const PlanetarySet& set, double angle) {
  if (set.sun_teeth + set.ring_teeth == 0) return angle;
  return std::round(angle / place_step(set)) * place_step(set);
}

std::string degrees(double angle) {
  return decimal(angle / degree, 4) + " deg";
}

}  // namespace

std::vector<double> even_places(int planets) {
  std::vector<double> places;
  for (int n = 0; n < planets; ++n) places.push_back(two_pi * n / planets);
  return places;
}

std::vector<double> planet_places(const PlanetarySet& set) {
  if (set.planet_angles.empty()) return even_places(set.planets);
  std::vector<double> places;
  for (const double angle : set.planet_angles) places.push_back(nearest_place(set, angle));
  return places;
}

bool stands_unevenly(const PlanetarySet& set) {
  if (set.planet_angles.empty()) return false;
  const std::vector<double> even = even_places(set.planets), places = planet_places(set);
  return !std::equal(even.begin(), even.end(), places.begin(), places.end(),
                     [](double a, double b) { return std::abs(a - b) < kWritten; });
}

Warnings place_problems(const PlanetarySet& set) {
  const std::vector<double>& angles = set.planet_angles;
  if (angles.empty()) return {};
  const auto problem = [](const std::string& found, const std::string& required) -> Warnings {
    return {{kPlaces, "found " + found + "; " + required}};
  };
  if (angles.size() != static_cast<std::size_t>(set.planets))
    return problem(std::to_string(angles.size()) + " angles",
                   "one for each of the " + std::to_string(set.planets) + " planets is required");
  if (angles.front() != 0.0)
    return problem(degrees(angles.front()) + " for the first planet",
                   "0 deg is required, from which the others count");
  for (std::size_t n = 1; n < angles.size(); ++n)
    if (!(angles[n] > angles[n - 1] && angles[n] < two_pi))
      return problem(degrees(angles[n]) + " behind " + degrees(angles[n - 1]),
                     "angles that grow, below 360 deg, are required");
  Warnings problems;
  for (const double angle : angles) {
    const double place = nearest_place(set, angle);
    if (std::abs(angle - place) <= kWritten) continue;
    const double other = place + std::copysign(place_step(set), angle - place);
    problems.push_back(
        {kPlaces, "found " + degrees(angle) +
                      ", where teeth do not fit; whole steps of 360 deg/(sun + ring teeth) are "
                      "required: " +
                      degrees(std::min(place, other)) + " or " + degrees(std::max(place, other))});
  }
  return problems;
}

double least_step(const std::vector<double>& places) {
  double least = two_pi;
  for (std::size_t n = 0; n < places.size(); ++n) {
    const bool last = n + 1 == places.size();
    least = std::min(least, last ? places.front() + two_pi - places[n] : places[n + 1] - places[n]);
  }
  return least;
}

}  // namespace orbearing::gearset
