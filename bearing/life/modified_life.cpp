#include "bearing/life/modified_life.hpp"

#include <cmath>

#include "bearing/life/life_modification.hpp"
#include "bearing/life/roller_capacity.hpp"

namespace orbearing::bearing::rating {

namespace {

constexpr double kSlopeOfLines = weibull_slope(RollingElement::roller);

// (3); exponent 4 of lives over loads, and 8/9 from damages to lives.
double load_of_damage(double capacity, double damage) {
  return capacity * std::pow(damage, 2.0 / 9.0);
}

}  // namespace

std::optional<ModifiedLife> modified_life(const Bearing& bearing, double reduction_factor,
                                          const Ratings& ratings, const OilCondition& oil,
                                          const motion::RaceDamageView& inner,
                                          const motion::RaceDamageView& outer) {
  return modified_life(bearing, reduction_factor, ratings, oil,
                       motion::means_of(bearing.motions, inner, outer));
}

std::optional<ModifiedLife> modified_life(const Bearing& bearing, double reduction_factor,
                                          const Ratings& ratings, const OilCondition& oil,
                                          const life::LaminaMeans& means) {
  if (!(oil.viscosity_ratio >= kLeastViscosityRatio)) return std::nullopt;
  const ContactCapacities own{contact_capacity(bearing, Race::inner, reduction_factor),
                              contact_capacity(bearing, Race::outer, reduction_factor)};
  const auto damage_of = [&](const ContactCapacities& capacities) {
    const auto laminae = static_cast<int>(means.inner.size());
    return life::lamina_damage(life::lamina_rating(capacities, laminae, bearing.motions), means);
  };
  const ByLamina plain = damage_of(own), standard = damage_of(ratings.contacts);
  const auto laminae = static_cast<double>(plain.inner.size());
  const double capacity = ratings.dynamic_capacity / roller_set(bearing).reduction_factor;
  double modified_inner = 0.0, modified_outer = 0.0;
  for (Eigen::Index k = 0; k < plain.inner.size(); ++k) {
    if (plain.inner[k] + plain.outer[k] == 0.0) continue;
    const double load = load_of_damage(capacity, laminae * (standard.inner[k] + standard.outer[k]));
    const double factor =
        life_modification_factor(RollingElement::roller, oil.viscosity_ratio,
                                 oil.contamination_factor * ratings.fatigue_load_limit / load);
    modified_inner += plain.inner[k] * std::pow(factor, -kSlopeOfLines);
    modified_outer += plain.outer[k] * std::pow(factor, -kSlopeOfLines);
  }
  const double all = plain.inner.sum() + plain.outer.sum(), modified = modified_inner + modified_outer;
  return ModifiedLife{
      .life = {life::life_of_damage(modified_inner), life::life_of_damage(modified_outer),
               life::life_of_damage(modified)},
      .load = load_of_damage(capacity, standard.inner.sum() + standard.outer.sum()),
      .factor = modified > 0.0 ? std::pow(modified / all, -1.0 / kSlopeOfLines) : kLargestLifeModification};
}

}  // namespace orbearing::bearing::rating
