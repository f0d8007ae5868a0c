#include "bearing/life/reference_life.hpp"

#include <cmath>

#include "bearing/life/lundberg_palmgren.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::rating {

Eigen::ArrayXd stress_riser(Eigen::Index laminae) {
  Eigen::ArrayXd riser = Eigen::ArrayXd::Ones(laminae);
  const double n = static_cast<double>(laminae);
  for (Eigen::Index k = 1; k <= laminae; ++k) {
    const double position =
        std::abs(2.0 * static_cast<double>(k) - n - 1.0);  // 0 only in the middle of an odd n
    if (position > 0.0) riser[k - 1] = 1.0 - 0.01 / std::log(1.985 * position / (2.0 * n - 2.0));
  }
  return riser;
}

Eigen::ArrayXXd with_stress_riser(const Eigen::Ref<const Eigen::ArrayXXd>& loads) {
  return loads.colwise() * stress_riser(loads.rows());
}

Eigen::ArrayXXd loads_of_pressures(const Eigen::Ref<const Eigen::ArrayXXd>& pressure, const RollerSet& set,
                                   Race race, const Material& material) {
  const double side = race == Race::inner ? -gamma(set) : gamma(set);
  const double modulus = material.plane_strain_modulus();
  const double lamina = set.length / static_cast<double>(pressure.rows());  // [m]
  return pressure.square() * constants::pi * set.diameter * (1.0 + side) * lamina / modulus;
}

Eigen::ArrayXd equivalent_lamina_loads(const Eigen::Ref<const Eigen::ArrayXXd>& loads, RaceMotion motion) {
  Eigen::ArrayXd equivalent(loads.rows());
  for (Eigen::Index k = 0; k < loads.rows(); ++k)
    equivalent[k] = life::line_contacts.equivalent_load(loads.row(k).transpose(), motion);
  return equivalent;
}

double equivalent_ball_load(const Eigen::Ref<const Eigen::ArrayXd>& loads, RaceMotion motion) {
  return life::point_contacts.equivalent_load(loads, motion);
}

BearingLife ball_reference_life(const ContactCapacities& capacities, double inner_load, double outer_load) {
  return life::point_contacts.lives(life::point_contacts.damage(inner_load, capacities.inner),
                                    life::point_contacts.damage(outer_load, capacities.outer));
}

}  // namespace orbearing::bearing::rating
