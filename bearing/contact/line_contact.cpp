#include "bearing/contact/line_contact.hpp"

#include <cmath>

#include "bearing/contact/line_law.hpp"
#include "bearing/units.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing {

LineContact::LineContact(double stiffness)
    : stiffness_(stiffness), inverse_power_(std::pow(stiffness, -kLineApproachExponent)) {}

double LineContact::load(double approach) const {
  return approach > 0.0 ? stiffness_ * std::pow(approach, kLineExponent) : 0.0;
}

double LineContact::approach(double load) const {
  return inverse_power_ * std::pow(load, kLineApproachExponent);
}

double LineContact::compliance(double load) const {
  return kLineApproachExponent * inverse_power_ * std::pow(load, kLineApproachExponent - 1.0);
}

double LineContact::compliance(double load, double approach) {
  return kLineApproachExponent * approach / load;
}

double LineContact::stiffness(double approach) const {
  return approach > 0.0 ? kLineExponent * stiffness_ * std::pow(approach, kLineExponent - 1.0) : 0.0;
}

double LineContact::energy(double approach) const {
  return load(approach) * (approach > 0.0 ? approach : 0.0) / (kLineExponent + 1.0);
}

double hertz_pressure(double load, double equivalent_radius, double length, const Material& material) {
  const double reduced_modulus = material.plane_strain_modulus();
  return std::sqrt(load * reduced_modulus /
                   (constants::two_pi * equivalent_radius * length));
}

LineContact roller_race_contact(ContactLaw law, double length) {
  const double length_factor = std::pow(kMillimetres * length, 8.0 / 9.0);
  const double one_contact = law == ContactLaw::palmgren ? 8.06e4 : 35948.0 * std::pow(2.0, kLineExponent);
  return LineContact(one_contact * length_factor * std::pow(kMillimetres, kLineExponent));
}

}  // namespace orbearing::bearing
