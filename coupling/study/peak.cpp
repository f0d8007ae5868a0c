#include "coupling/study/peak.hpp"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

namespace orbearing::study {

namespace {

constexpr int kBits = std::numeric_limits<double>::digits / 2;
// An extremum nearer to an end of the bracket than Brent's method resolves stands at that end.
constexpr double kEndZone = 1e-4;

Extremum extremum(const std::function<double(double)>& of_speed, double low, double high, double sign) {
  const double from = std::log(low);
  const double to = std::log(high);
  const auto objective = [&](double log_speed) { return sign * std::log(of_speed(std::exp(log_speed))); };
  const auto [place, value] = boost::math::tools::brent_find_minima(objective, from, to, kBits);
  const double margin = kEndZone * (to - from);
  return {std::exp(place), std::exp(sign * value), place - from > margin && to - place > margin};
}

}  // namespace

Extremum largest(const std::function<double(double)>& of_speed, double low, double high) {
  return extremum(of_speed, low, high, -1.0);
}

Extremum smallest(const std::function<double(double)>& of_speed, double low, double high) {
  return extremum(of_speed, low, high, 1.0);
}

double life_at(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry, double speed) {
  PlanetaryDrivetrain at_speed = drivetrain;
  at_speed.drive.speed = speed;
  return evaluate(at_speed, geometry).life_hours;
}

}  // namespace orbearing::study
