#include "gearset/planet_angles.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "gearset/stepped_planet.hpp"
#include "gearset/warning.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

using constants::degree;
using constants::two_pi;

constexpr double kWritten = 0.005 * degree;  // [rad]  by which a stated angle may be rounded
const std::string kPositions = "gearset.planet_angles";

// From one angle at which teeth fit to the next, Eq. (23).
double fitting_step(const PlanetarySet& set) {
  return two_pi / willis_teeth(set).positions();
}

// The angle itself for a set without teeth, which fits at any angle.
double nearest_fitting(const PlanetarySet& set, double angle) {
  if (set.sun_teeth + set.ring_teeth == 0) return angle;
  return std::round(angle / fitting_step(set)) * fitting_step(set);
}

std::string degrees(double angle) {
  return decimal(angle / degree, 4) + " deg";
}

}  // namespace

std::vector<double> even_angles(int planets) {
  std::vector<double> angles;
  for (int n = 0; n < planets; ++n) angles.push_back(two_pi * n / planets);
  return angles;
}

std::vector<double> angles_of_planets(const PlanetarySet& set) {
  if (set.planet_angles.empty()) return even_angles(set.planets);
  std::vector<double> angles;
  for (const double angle : set.planet_angles) angles.push_back(nearest_fitting(set, angle));
  return angles;
}

std::string nearest_to_even(const PlanetarySet& set) {
  std::string text;
  double before = -1.0;
  for (const double angle : even_angles(set.planets)) {
    const double fitting = nearest_fitting(set, angle);
    if (fitting - before < 0.5 * fitting_step(set) || fitting > two_pi - 0.5 * fitting_step(set)) return "";
    text += (text.empty() ? "[" : ", ") + degrees(fitting);
    before = fitting;
  }
  return text + "]";
}

bool is_unequally_spaced(const PlanetarySet& set) {
  if (set.planet_angles.empty()) return false;
  const std::vector<double> even = even_angles(set.planets), angles = angles_of_planets(set);
  return !std::equal(even.begin(), even.end(), angles.begin(), angles.end(),
                     [](double a, double b) { return std::abs(a - b) < kWritten; });
}

Warnings position_problems(const PlanetarySet& set) {
  const std::vector<double>& angles = set.planet_angles;
  if (angles.empty()) return {};
  const auto problem = [](const std::string& found, const std::string& required) -> Warnings {
    return {{kPositions, "found " + found + "; " + required}};
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
                     "ascending angles below 360 deg are required");
  Warnings problems;
  for (const double angle : angles) {
    const double fitting = nearest_fitting(set, angle);
    if (std::abs(angle - fitting) <= kWritten) continue;
    const double other = fitting + std::copysign(fitting_step(set), angle - fitting);
    problems.push_back(
        {kPositions, "found " + degrees(angle) +
                         ", where teeth do not fit; whole steps of 360 deg/(sun + ring teeth) are "
                         "required: " +
                         degrees(std::min(fitting, other)) + " or " + degrees(std::max(fitting, other))});
  }
  return problems;
}

double least_step(const std::vector<double>& angles) {
  double least = two_pi;
  for (std::size_t n = 0; n < angles.size(); ++n) {
    const bool last = n + 1 == angles.size();
    least = std::min(least, last ? angles.front() + two_pi - angles[n] : angles[n + 1] - angles[n]);
  }
  return least;
}

}  // namespace orbearing::gearset
