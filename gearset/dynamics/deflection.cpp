#include "gearset/dynamics/deflection.hpp"

#include <cmath>

namespace orbearing::gearset::dynamics {

namespace {

// The back flank is the mirror image of the driving one: the pressure angle and the approach change sign.
struct Line {
  double sign;            // [-]
  double pressure_angle;  // [rad]
};

Line line_of(Flank flank, double pressure_angle) {
  return flank == Flank::driving ? Line{1.0, pressure_angle} : Line{-1.0, -pressure_angle};
}

}  // namespace

DeflectionVector sun_mesh_deflection(double planet_angle, double pressure_angle, Flank flank) {
  const auto [sign, alpha] = line_of(flank, pressure_angle);
  const double psi = planet_angle - alpha;
  return {sign * Eigen::Vector3d(-std::sin(psi), std::cos(psi), 1.0),
          sign * Eigen::Vector3d(-std::sin(alpha), -std::cos(alpha), 1.0)};
}

DeflectionVector ring_mesh_deflection(double planet_angle, double pressure_angle, Flank flank) {
  const auto [sign, alpha] = line_of(flank, pressure_angle);
  const double psi = planet_angle + alpha;
  return {sign * Eigen::Vector3d(-std::sin(psi), std::cos(psi), 1.0),
          sign * Eigen::Vector3d(std::sin(alpha), -std::cos(alpha), -1.0)};
}

DeflectionVector radial_bearing_deflection(double planet_angle) {
  return {{std::cos(planet_angle), std::sin(planet_angle), 0.0}, {-1.0, 0.0, 0.0}};
}

DeflectionVector tangential_bearing_deflection(double planet_angle) {
  return {{-std::sin(planet_angle), std::cos(planet_angle), 1.0}, {0.0, -1.0, 0.0}};
}

DeflectionVector planet_rotation(double carrier_radius, double planet_radius) {
  return {{0.0, 0.0, -1.0 / carrier_radius}, {0.0, 0.0, 1.0 / planet_radius}};
}

}  // namespace orbearing::gearset::dynamics
