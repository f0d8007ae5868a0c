#include "bearing/equilibrium/lamina_bearing.hpp"

#include <algorithm>

#include "bearing/plane.hpp"

namespace orbearing::bearing::laminae {

namespace {

LaminaContact contact_of(const Bearing& bearing, Race race) {
  const double length = bearing.rollers().length;
  return {roller_race_contact(bearing.contact_law, length), length, lamina_drops(bearing, race)};
}

}  // namespace

std::vector<double> lamina_drops(const Bearing& bearing, Race race) {
  const CylindricalRollers& rollers = bearing.rollers();
  if (rollers.laminae == 0) return {0.0};
  const profile::Profile& other = bearing.ring(race).profile;
  profile::require_sound(rollers.profile);
  profile::require_sound(other);
  return lamina_drops(rollers.profile, other, rollers.length, rollers.laminae);
}

LaminaBearing::LaminaBearing(const Bearing& bearing)
    : bearing_(bearing),
      geometry_(geometry_of(bearing_)),
      inner_(contact_of(bearing_, Race::inner)),
      outer_(contact_of(bearing_, Race::outer)) {}

Eigen::Vector2d force_on_bore(const QuasiStaticState& state) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (Eigen::Index j = 0; j < state.angle.size(); ++j)
    sum += state.outer_load[j] * direction(state.angle[j]);
  return sum;
}

bool are_settled(const std::vector<RollerState>& rollers) {
  return std::all_of(rollers.begin(), rollers.end(),
                     [](const RollerState& roller) { return roller.settled; });
}

double largest_drop(const LaminaBearing& bearing) {
  return std::max(bearing.contact(Race::inner).greatest_drop(), bearing.contact(Race::outer).greatest_drop());
}

}  // namespace orbearing::bearing::laminae
