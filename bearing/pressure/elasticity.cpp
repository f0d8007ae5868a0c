#include "bearing/pressure/elasticity.hpp"

#include <stdexcept>

#include "mechanics/checks.hpp"

namespace orbearing::bearing::half_space {

namespace {

double compliance(const Material& material) {
  return 1.0 / material.plane_strain_modulus();
}

void require_sound(const Material& material, const char* modulus) {
  mechanics::require_positive(material.youngs_modulus, modulus);
  mechanics::require(material.poisson_ratio >= 0.0 && material.poisson_ratio <= 0.5,
                     "Poisson's ratio of a half-space [-]", material.poisson_ratio, "0 to 0.5");
}

}  // namespace

double contact_modulus(const HalfSpaceContact& contact) {
  return 1.0 / (compliance(contact.roller) + compliance(contact.race));
}

double mirror_factor(EndSurface ends, double poisson_ratio) {
  switch (ends) {
    case EndSurface::continuing:
      return 0.0;
    case EndSurface::mirrored:
      return 1.0;
    case EndSurface::corrected:
      return 1.29 - (0.08 - 0.5 * poisson_ratio) / (1.0 - poisson_ratio);
  }
  throw std::logic_error("half-space contact: unknown kind of end");
}

double mirror_factor(const HalfSpaceContact& contact) {
  const double roller = compliance(contact.roller), race = compliance(contact.race);
  return (roller * mirror_factor(contact.roller_ends, contact.roller.poisson_ratio) +
          race * mirror_factor(contact.race_ends, contact.race.poisson_ratio)) /
         (roller + race);
}

void require_sound(const HalfSpaceContact& contact) {
  mechanics::require_positive(contact.length, "length of a half-space contact [m]");
  mechanics::require_positive(contact.equivalent_radius, "equivalent radius of a half-space contact [m]");
  require_sound(contact.roller, "Young's modulus of the roller [Pa]");
  require_sound(contact.race, "Young's modulus of the race [Pa]");
}

}  // namespace orbearing::bearing::half_space
