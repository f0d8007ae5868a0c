#include "bearing/friction/replenishment.hpp"

#include <cmath>

#include "bearing/motion/balls/mixture.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::friction {

namespace {

using constants::pi, constants::two_pi;

// Oil [m/s] that comes to the wall of a race with the mixture's momentum.
double arrival_on_race(const balls::MixtureNumbers& mixture, double radius, double difference, double share) {
  if (difference == 0.0) return 0.0;
  const double stress =
      std::abs(balls::wall_torque(mixture, radius, difference)) / (two_pi * radius * radius * mixture.width);
  return share * stress / (mixture.density * std::abs(radius * difference));
}

// The same of a roller that spins in it.
double arrival_on_roller(const balls::DragNumbers& drag, const CylindricalRollers& rollers, double spin,
                         double share) {
  const double radius = 0.5 * rollers.diameter;
  const double stress = drag.churning * spin * spin / (two_pi * radius * radius * rollers.length);
  return share * stress / (drag.mixture.density * radius * spin);
}

}  // namespace

double inlet_length(double equivalent_radius, double roller_length, double returned) {
  return std::cbrt(returned * equivalent_radius * roller_length / (2.0 * kEndFlow));
}

double returned_oil(const Bearing& bearing, const BearingGeometry& geometry, Race race,
                    const equilibrium::RingSpeeds& speeds, const balls::DragNumbers& drag, double share) {
  const bool inner = race == Race::inner;
  const double cage = kinematic_cage_speed(geometry, speeds.inner, speeds.outer);
  const double spin = std::abs(kinematic_roller_spin(geometry, speeds.inner, speeds.outer));
  const double of_race = inner ? speeds.inner : speeds.outer, passing = std::abs(of_race - cage);
  if (passing == 0.0 || spin == 0.0 || !(drag.mixture.density > 0.0)) return 0.0;
  const CylindricalRollers& rollers = bearing.rollers();
  const double radius = inner ? geometry.inner_radius : geometry.outer_radius;
  return arrival_on_race(drag.mixture, radius, of_race - drag.mixture.share * cage, share) * two_pi /
             (rollers.count * passing) +
         arrival_on_roller(drag, rollers, spin, share) * pi / spin;
}

}  // namespace orbearing::bearing::friction
