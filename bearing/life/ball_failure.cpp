#include "bearing/life/ball_failure.hpp"

#include <cmath>

#include "bearing/geometry.hpp"
#include "bearing/life/lundberg_palmgren.hpp"

namespace orbearing::bearing::rating {

namespace {

// Revolutions of the bearing that one of its contacts leaves a ball. `side`: -1 inner, +1 outer race.
double life_by(double capacity, double load, double gamma, double balls, double pitch_over_ball, double side) {
  if (!(load > 0.0)) return kInfinity;
  const double passed = 0.5 * balls * (1.0 - side * gamma);         // of a point of the race in a revolution
  const double turned = 0.5 * (1.0 - gamma * gamma) / gamma;        // of the ball in it
  const double longer = pitch_over_ball * (1.0 + side * gamma);     // track of the race over that of the ball
  return kMillionRevolutions * std::pow(capacity / load, life::point_contacts.load_exponent) * passed /
         turned * std::pow(longer, 1.0 / life::point_contacts.weibull_slope);
}

}  // namespace

double life_of_balls(const Bearing& bearing, const ContactCapacities& capacities, const BallContactLoads& loads) {
  const Balls& balls = bearing.balls();
  const double gamma = geometry_of(bearing).slenderness, ratio = bearing.pitch_diameter / balls.diameter;
  const double count = balls.count;
  const double inner = life_by(capacities.inner, loads.inner, gamma, count, ratio, -1.0);
  const double outer = life_by(capacities.outer, loads.outer, gamma, count, ratio, 1.0);
  return life_of_both(inner, outer) * std::pow(count, -1.0 / life::point_contacts.weibull_slope);
}

double life_of_both(double races, double balls) {
  return system_life(Eigen::Array2d(races, balls), life::point_contacts.weibull_slope);
}

}  // namespace orbearing::bearing::rating
