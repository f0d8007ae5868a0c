#include "bearing/life/roller_capacity.hpp"

#include <cmath>

#include "bearing/life/lundberg_palmgren.hpp"
#include "bearing/units.hpp"

namespace orbearing::bearing::rating {

namespace {

constexpr double kWeakerRace = life::line_contacts.damage_exponent();
constexpr double kBothRaces = 1.0 / kWeakerRace;

// Curvatures of the inner race over those of the outer one, as far as them affect fatigue.
double race_ratio(double gamma) {
  return std::pow((1.0 - gamma) / (1.0 + gamma), 143.0 / 108.0);
}

}  // namespace

RollerSet roller_set(const Bearing& bearing) {
  const CylindricalRollers& rollers = bearing.rollers();
  return {.rollers = rollers.count,
          .diameter = rollers.diameter,
          .length = rollers.length,
          .pitch_diameter = bearing.pitch_diameter};
}

double gamma(const RollerSet& set) {
  return set.diameter * std::cos(set.contact_angle) / set.pitch_diameter;
}

double roller_capacity_factor(double gamma, double reduction_factor) {
  const double curvature =
      std::pow(gamma, 2.0 / 9.0) * std::pow(1.0 - gamma, 29.0 / 27.0) / std::pow(1.0 + gamma, 0.25);
  const double races = std::pow(1.0 + std::pow(1.04 * race_ratio(gamma), kWeakerRace), -kBothRaces);
  return 0.377 * 551.13373 * reduction_factor * curvature * races;
}

double dynamic_capacity(const RollerSet& set) {
  const double length = kMillimetres * set.length * set.rows * std::cos(set.contact_angle);  // [mm]
  const double diameter = kMillimetres * set.diameter;                                       // [mm]
  return set.material_factor * roller_capacity_factor(gamma(set), set.reduction_factor) *
         std::pow(length, 7.0 / 9.0) * std::pow(set.rollers, 0.75) * std::pow(diameter, 29.0 / 27.0);
}

double static_capacity(const RollerSet& set) {
  const double area = kMillimetres * kMillimetres * set.length * set.diameter;  // [mm^2]
  return 44.0 * (1.0 - gamma(set)) * set.rows * set.rollers * area * std::cos(set.contact_angle);
}

ContactCapacities contact_capacities(const RollerSet& set, double dynamic_capacity) {
  const double share = dynamic_capacity / (set.reduction_factor * set.rollers * std::cos(set.contact_angle) *
                                           std::pow(set.rows, 7.0 / 9.0));
  const double ratio = std::pow(1.038 * race_ratio(gamma(set)), kWeakerRace);
  return {.inner = share / 0.378 * std::pow(1.0 + ratio, kBothRaces),
          .outer = share / 0.364 * std::pow(1.0 + 1.0 / ratio, kBothRaces)};
}

double lamina_capacity(double contact_capacity, int laminae) {
  return contact_capacity * std::pow(laminae, -7.0 / 9.0);
}

}  // namespace orbearing::bearing::rating
