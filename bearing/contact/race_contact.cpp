#include "bearing/contact/race_contact.hpp"

#include <cmath>

namespace orbearing::bearing {

RollerContacts rolling_contacts(const Bearing& bearing, const BearingGeometry& geometry, double inner_speed,
                                double outer_speed, const std::optional<Lubricant>& lubricant) {
  const LineContact elastic = roller_race_contact(bearing.contact_law, bearing.rollers().length);
  if (!lubricant) return {{elastic, Film()}, {elastic, Film()}};
  const double cage_speed = kinematic_cage_speed(geometry, inner_speed, outer_speed);
  return {{elastic, Film(film_contact(bearing, geometry, Race::inner, *lubricant),
                         std::abs((inner_speed - cage_speed) * geometry.inner_radius))},
          {elastic, Film(film_contact(bearing, geometry, Race::outer, *lubricant),
                         std::abs((outer_speed - cage_speed) * geometry.outer_radius))}};
}

}  // namespace orbearing::bearing
