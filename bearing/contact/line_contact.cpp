#include "bearing/contact/line_contact.hpp"

#include <cmath>

#include "bearing/units.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing {

LineContact::LineContact(double stiffness)
    : stiffness_(stiffness), inverse_power_(std::pow(stiffness, -LineLaw::kApproachExponent)) {}

double LineContact::load(double approach) const {
  return approach > 0.0 ? stiffness_ * std::pow(approach, kExponent) : 0.0;
}

double LineContact::approach(double load) const {
  return inverse_power_ * std::pow(load, LineLaw::kApproachExponent);
}

double LineContact::compliance(double load) const {
  return LineLaw::kApproachExponent * inverse_power_ * std::pow(load, LineLaw::kApproachExponent - 1.0);
}

double LineContact::stiffness(double approach) const {
  return approach > 0.0 ? LineLaw::slope(stiffness_) * std::pow(approach, kExponent - 1.0) : 0.0;
}

double LineContact::energy(double approach) const {
  return approach > 0.0 ? LineLaw::energy(load(approach), approach) : 0.0;
}

LineContact LineContact::through_lever(double ratio) const {
  return LineContact(stiffness_ * std::pow(ratio, kExponent + 1.0));
}

double hertz_pressure(double load, double equivalent_radius, double length, const Material& material) {
  const double reduced_modulus = material.plane_strain_modulus();
  return std::sqrt(load * reduced_modulus / (constants::two_pi * equivalent_radius * length));
}

LineContact roller_race_contact(ContactLaw law, double length) {
  const double length_factor = std::pow(kMillimetres * length, 8.0 / 9.0);
  const double one_contact =
      law == ContactLaw::palmgren ? 8.06e4 : 35948.0 * std::pow(2.0, LineLaw::kExponent);
  return LineContact(one_contact * length_factor * std::pow(kMillimetres, LineLaw::kExponent));
}

LineContact both_in_series(const LineContact& one) {
  return LineContact(one.constant() * std::pow(2.0, -LineLaw::kExponent));
}

}  // namespace orbearing::bearing
