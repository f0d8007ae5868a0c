#include "gearset/mesh/tooth_load.hpp"

#include <cmath>

namespace orbearing::gearset {

namespace {

ToothLoad load(double base_radius, double tangent_length, double force_angle, double helix_angle) {
  const double contact = std::hypot(base_radius, tangent_length);
  const double axis = base_radius / std::cos(force_angle);
  // Eq. (18): at right angles to the teeth they are thinner and the force is less steep.
  const double position = contact * std::cos(std::atan2(tangent_length, base_radius) - force_angle);
  return {.contact_radius = contact,
          .force_angle = force_angle,
          .axis_radius = axis + std::pow(std::sin(helix_angle), 2) * (position - axis)};
}

}  // namespace

// On the base circle the force is square to the radius through the foot of the flank, which lies half the
// tooth's base thickness from its axis; from there the force turns with the angle of roll.
ToothLoad tooth_load(const ExternalTooth& tooth, double tangent_length) {
  const double roll = tangent_length / tooth.base_radius;
  return load(tooth.base_radius, tangent_length, roll - base_half_angle(tooth), tooth.helix_angle);
}

ToothLoad tooth_load(const RingTooth& tooth, double tangent_length) {
  const double roll = tangent_length / tooth.base_radius;
  return load(tooth.base_radius, tangent_length, roll + base_half_angle(tooth), tooth.helix_angle);
}

}  // namespace orbearing::gearset
