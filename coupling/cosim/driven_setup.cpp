#include "coupling/cosim/driven_setup.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "mechanics/checks.hpp"

namespace orbearing::cosim {

namespace {

using mechanics::require;

void check_numbers(const DrivenBearingSetup& setup) {
  require(std::isfinite(setup.orbit_radius) && setup.orbit_radius >= 0.0, "orbit radius [m]",
          setup.orbit_radius, "0 or more");
  require(std::isfinite(setup.first_roller), "place of the first roller [rad]", setup.first_roller,
          "a finite number");
  require(std::isfinite(setup.lambda) && setup.lambda > 0.0, "lambda of the life [-]", setup.lambda,
          "more than 0");
  require(std::isfinite(setup.allowed_length_error) && setup.allowed_length_error > 0.0,
          "allowed length error [m]", setup.allowed_length_error, "more than 0");
  require(setup.places >= 1, "places on the races", static_cast<double>(setup.places), "at least 1");
  const double tilt = setup.bore_tilt.norm();
  require(std::isfinite(tilt), "tilt of the bore [rad]", tilt, "a finite number");
  require(tilt == 0.0 || setup.bearing.laminae > 0, "tilt of the bore [rad]", tilt,
          "0 without laminae, which alone feel it");
  require(setup.most_steps >= 1, "largest number of steps", static_cast<double>(setup.most_steps),
          "at least 1");
}

void check_effects(const bearing::dynamics::DynamicsParameters& dynamics) {
  require(dynamics.driving.growth == 0.0, "growth of the speeds [1/s]", dynamics.driving.growth,
          "0, since the speeds are inputs");
  require(dynamics.ripple.harmonics.empty(), "harmonics of a mesh ripple",
          static_cast<double>(dynamics.ripple.harmonics.size()), "none, since the motion is an input");
  const bool printed =
      dynamics.race.film_in_approach && dynamics.race.film_approach == bearing::FilmApproach::as_printed;
  require(!printed, "film in the approach as printed", 1.0,
          "a film that is added, since the printed one asks for the load beforehand");
}

bool finite(const Course& course) {
  return std::all_of(course.coefficient.begin(), course.coefficient.end(),
                     [](double c) { return std::isfinite(c); });
}

}  // namespace

bearing::dynamics::BoreMotion BoreCourse::at(double since) const {
  bearing::dynamics::BoreMotion motion;
  motion.position = {x.at(since), y.at(since)};
  motion.velocity = {v_x.at(since), v_y.at(since)};
  motion.acceleration = {v_x.slope(since), v_y.slope(since)};
  motion.speed = speed.at(since);
  motion.carrier_speed = carrier_speed.at(since);
  motion.carrier_acceleration = carrier_acceleration.at(since);
  return motion;
}

void require_finite(const BoreCourse& inputs) {
  const std::pair<const char*, const Course*> all[] = {
      {"x [m]", &inputs.x},
      {"y [m]", &inputs.y},
      {"v_x [m/s]", &inputs.v_x},
      {"v_y [m/s]", &inputs.v_y},
      {"speed [rad/s]", &inputs.speed},
      {"carrier speed [rad/s]", &inputs.carrier_speed},
      {"carrier acceleration [rad/s^2]", &inputs.carrier_acceleration}};
  for (const auto& [name, course] : all)
    if (!finite(*course))
      throw std::runtime_error(std::string("driven bearing: the input ") + name +
                               " is not finite; required: finite numbers");
}

void require_finite(const bearing::dynamics::BoreMotion& motion) {
  const bool holds = motion.position.allFinite() && motion.velocity.allFinite() &&
                     motion.acceleration.allFinite() && std::isfinite(motion.speed) &&
                     std::isfinite(motion.carrier_speed) && std::isfinite(motion.carrier_acceleration);
  if (!holds)
    throw std::runtime_error(
        "driven bearing: the motion of bore and carrier is not finite; required: finite numbers");
}

void require_length(const Window& window) {
  if (std::isfinite(window.begin) && std::isfinite(window.end) && window.length() > 0.0) return;
  std::ostringstream text;
  text << "driven bearing: found a window from " << window.begin << " s to " << window.end
       << " s; required: an end after the beginning";
  throw std::runtime_error(text.str());
}

bearing::dynamics::BearingModel driven_model(const DrivenBearingSetup& setup) {
  check_numbers(setup);
  check_effects(setup.dynamics);
  bearing::OperatingPoint point;
  point.carrier.orbit_radius = setup.orbit_radius;
  point.bore_tilt = setup.bore_tilt;
  return bearing_model(setup.bearing, point, setup.dynamics);
}

}  // namespace orbearing::cosim
