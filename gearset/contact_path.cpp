#include "gearset/contact_path.hpp"

#include <algorithm>
#include <cmath>

#include "gearset/involute.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset {

namespace {

struct Reach {
  double foot;  // [m] tangent length where the involute begins
  double tip;   // [m] tangent length where it ends
};

Reach reach(const ExternalTooth& tooth) {
  return {tangent_length(tooth.base_radius, tooth.form_radius),
          tangent_length(tooth.base_radius, tooth.tip_radius)};
}

}  // namespace

ContactPath external_contact_path(const ExternalTooth& first, const ExternalTooth& second,
                                  double centre_distance) {
  const double tangent = tangent_length(first.base_radius + second.base_radius, centre_distance);
  const Reach a = reach(first);
  const Reach b = reach(second);
  return {std::max(b.foot, tangent - a.tip), std::min(b.tip, tangent - a.foot)};
}

ContactPath internal_contact_path(const RingTooth& ring, const ExternalTooth& planet,
                                  double centre_distance) {
  const double tangent = tangent_length(ring.base_radius - planet.base_radius, centre_distance);
  const double ring_tip = tangent_length(ring.base_radius, std::max(ring.tip_radius, ring.base_radius));
  const double ring_root = tangent_length(ring.base_radius, ring.root_radius);
  const Reach b = reach(planet);
  return {std::max(b.foot, ring_tip - tangent), std::min(b.tip, ring_root - tangent)};
}

double contact_ratio(const ContactPath& path, const ExternalTooth& tooth) {
  return path.length() / (2.0 * constants::pi * tooth.base_radius / tooth.teeth);
}

}  // namespace orbearing::gearset
