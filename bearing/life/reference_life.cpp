#include "bearing/life/reference_life.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "bearing/life/basic_life.hpp"
#include "bearing/units.hpp"

namespace orbearing::bearing::rating {

namespace {

constexpr double kLaminaExponent = 9.0 / 2.0;
constexpr double kRollerSlope = weibull_slope(RollingElement::roller);
constexpr double kBallExponent = 10.0 / 3.0;
constexpr double kBallSlope = weibull_slope(RollingElement::ball);

double roller_exponent(RaceMotion motion) {
  return motion == RaceMotion::turning ? 4.0 : 4.5;
}

// Mean of powers, scaled by the largest load so that no power over- or underflows.
double power_mean(const Eigen::Ref<const Eigen::ArrayXd>& loads, double exponent) {
  const double largest = loads.size() > 0 ? loads.maxCoeff() : 0.0;
  if (largest <= 0.0) return 0.0;
  return largest * std::pow((loads / largest).max(0.0).pow(exponent).mean(), 1.0 / exponent);
}

// sum (q/q_c)^(9/2), the part of one race in L^(-9/8).
double race_damage(double capacity, const Eigen::ArrayXd& equivalent) {
  const double lamina = lamina_capacity(capacity, static_cast<int>(equivalent.size()));
  return (equivalent / lamina).pow(kLaminaExponent).sum();
}

double life_of(double damage, double slope) {
  return damage > 0.0 ? kMillionRevolutions * std::pow(damage, -1.0 / slope) : kInfinity;
}

BearingLife life_of_races(double inner, double outer, double slope) {
  return {life_of(inner, slope), life_of(outer, slope), life_of(inner + outer, slope)};
}

double ball_damage(double capacity, double equivalent) {
  return std::pow(equivalent / capacity, kBallExponent);
}

}  // namespace

Eigen::ArrayXd stress_riser(Eigen::Index laminae) {
  Eigen::ArrayXd riser = Eigen::ArrayXd::Ones(laminae);
  const double n = static_cast<double>(laminae);
  for (Eigen::Index k = 1; k <= laminae; ++k) {
    const double place =
        std::abs(2.0 * static_cast<double>(k) - n - 1.0);  // 0 only in the middle of an odd n
    if (place > 0.0) riser[k - 1] = 1.0 - 0.01 / std::log(1.985 * place / (2.0 * n - 2.0));
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
  return pressure.square() * boost::math::double_constants::pi * set.diameter * (1.0 + side) * lamina /
         modulus;
}

Eigen::ArrayXd equivalent_lamina_loads(const Eigen::Ref<const Eigen::ArrayXXd>& loads, RaceMotion motion) {
  Eigen::ArrayXd equivalent(loads.rows());
  for (Eigen::Index k = 0; k < loads.rows(); ++k)
    equivalent[k] = power_mean(loads.row(k).transpose(), roller_exponent(motion));
  return equivalent;
}

BearingLife lamina_reference_life(const ContactCapacities& capacities, const ByLamina& loads) {
  return life_of_races(race_damage(capacities.inner, loads.inner), race_damage(capacities.outer, loads.outer),
                       kRollerSlope);
}

BearingLife lamina_reference_life(const ContactCapacities& capacities,
                                  const Eigen::Ref<const Eigen::ArrayXXd>& inner_loads,
                                  const Eigen::Ref<const Eigen::ArrayXXd>& outer_loads,
                                  const RaceMotions& motions) {
  return lamina_reference_life(capacities,
                               {equivalent_lamina_loads(with_stress_riser(inner_loads), motions.inner),
                                equivalent_lamina_loads(with_stress_riser(outer_loads), motions.outer)});
}

namespace {

double ball_mean_exponent(RaceMotion motion) {
  return motion == RaceMotion::turning ? 3.0 : kBallExponent;
}

}  // namespace

double equivalent_ball_load(const Eigen::Ref<const Eigen::ArrayXd>& loads, RaceMotion motion) {
  return power_mean(loads, ball_mean_exponent(motion));
}

BearingLife ball_reference_life(const ContactCapacities& capacities, double inner_load, double outer_load) {
  return life_of_races(ball_damage(capacities.inner, inner_load), ball_damage(capacities.outer, outer_load),
                       kBallSlope);
}

BearingLife ball_reference_life(const ContactCapacities& capacities,
                                const Eigen::Ref<const Eigen::ArrayXd>& inner_loads,
                                const Eigen::Ref<const Eigen::ArrayXd>& outer_loads,
                                const RaceMotions& motions) {
  return ball_reference_life(capacities, equivalent_ball_load(inner_loads, motions.inner),
                             equivalent_ball_load(outer_loads, motions.outer));
}

}  // namespace orbearing::bearing::rating
