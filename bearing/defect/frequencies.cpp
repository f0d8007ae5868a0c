#include "bearing/defect/frequencies.hpp"

#include <cmath>

#include "bearing/geometry.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::defect {

double rolling_speed(const Bearing& bearing, double inner_speed, double outer_speed) {
  const BearingGeometry geometry = geometry_of(bearing);
  const double gamma =
      geometry.slenderness;  // with the cosine of the contact angle, which the ratio of radii is without
  return 0.5 * (outer_speed - inner_speed) * geometry.pitch_radius / geometry.element_radius *
         (1.0 - gamma * gamma);
}

PassingFrequencies passing_frequencies(const Bearing& bearing, double shaft_speed) {
  return passing_frequencies(bearing, shaft_speed, 0.0);
}

PassingFrequencies passing_frequencies(const Bearing& bearing, double inner_speed, double outer_speed) {
  const double hertz = 1.0 / constants::two_pi;  // [Hz per rad/s]
  const BearingGeometry geometry = geometry_of(bearing);
  const double cage = kinematic_cage_speed(geometry, inner_speed, outer_speed);
  const double count = bearing.element_count();
  return {.shaft = std::abs(inner_speed - outer_speed) * hertz,
          .cage = std::abs(cage) * hertz,
          .outer_pass = count * std::abs(outer_speed - cage) * hertz,
          .inner_pass = count * std::abs(inner_speed - cage) * hertz,
          .element_pass = 2.0 * std::abs(rolling_speed(bearing, inner_speed, outer_speed)) * hertz};
}

}  // namespace orbearing::bearing::defect
