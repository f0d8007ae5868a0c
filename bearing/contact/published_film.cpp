#include "bearing/contact/published_film.hpp"

#include "bearing/contact/race_contact.hpp"

namespace orbearing::bearing {

namespace {
constexpr double kLargestOverMean = 4.08;  // [-]  Q_max Z / F of many rollers without clearance [Harris2006]
}

PublishedFilm published_film(const Bearing& bearing, const BearingGeometry& geometry,
                             const Lubricant& lubricant, double inner_speed, double outer_speed,
                             double load) {
  const double largest = kLargestOverMean * load / bearing.rollers().count;
  const RollerContacts contacts = rolling_contacts(bearing, geometry, inner_speed, outer_speed, lubricant);
  return {contacts.inner.film().least(largest), contacts.outer.film().least(largest)};
}

}  // namespace orbearing::bearing
