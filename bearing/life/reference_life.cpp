#include "bearing/life/reference_life.hpp"

#include <algorithm>
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

namespace {

// Shared length of lamina `own` of `count` with lamina `other` of `others` [-], of the whole length.
double overlap(Eigen::Index own, Eigen::Index count, Eigen::Index other, Eigen::Index others) {
  const auto end = [](Eigen::Index k, Eigen::Index n) {
    return static_cast<double>(k) / static_cast<double>(n);
  };
  return std::max(0.0, std::min(end(own + 1, count), end(other + 1, others)) -
                           std::max(end(own, count), end(other, others)));
}

// Means over `count` equal laminae of what is constant over each of those of `values`.
Eigen::ArrayXd means_over(const Eigen::ArrayXd& values, Eigen::Index count) {
  Eigen::ArrayXd means = Eigen::ArrayXd::Zero(count);
  for (Eigen::Index k = 0; k < count; ++k)
    for (Eigen::Index j = k * values.size() / count; j < values.size(); ++j) {
      const double shared = overlap(k, count, j, values.size());
      if (shared == 0.0 && j > k * values.size() / count) break;
      means[k] += shared * static_cast<double>(count) * values[j];
    }
  return means;
}

}  // namespace

Eigen::ArrayXd stress_riser(Eigen::Index laminae, StressRiser riser) {
  if (riser == StressRiser::standard) return stress_riser(laminae);
  if (laminae == kLeastRatedLaminae) return stress_riser(laminae);
  constexpr double e = life::line_contacts.damage_exponent();
  return means_over(stress_riser(kLeastRatedLaminae).pow(e), laminae).pow(1.0 / e);
}

Eigen::ArrayXXd with_stress_riser(const Eigen::Ref<const Eigen::ArrayXXd>& loads, StressRiser riser) {
  return loads.colwise() * stress_riser(loads.rows(), riser);
}

Eigen::ArrayXd on_equal_laminae(const Eigen::ArrayXd& loads, Eigen::Index count) {
  if (loads.size() == count) return loads;
  const double each = static_cast<double>(loads.size()) / static_cast<double>(count);
  return each * means_over(loads, count);
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
