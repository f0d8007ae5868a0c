#include "bearing/life/lamina_life.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/life/lundberg_palmgren.hpp"

namespace orbearing::bearing::life {

namespace {

using Loads = LaminaLoads;

static_assert(line_contacts.load_exponent == 4.0 && line_contacts.damage_exponent() == 4.5,
              "means of a rotating race are of squares of squares, of a stationary one times a root");

Eigen::ArrayXd weights(const Eigen::ArrayXd& riser, double capacity) {
  return (riser / rating::lamina_capacity(capacity, static_cast<int>(riser.size())))
      .pow(line_contacts.damage_exponent());
}

// Mean over the positions of the load's power: (2) without its root.
Eigen::ArrayXd mean_power(const Loads& loads, RaceMotion motion) {
  if (motion == RaceMotion::rotating) return loads.square().square().rowwise().mean();
  return (loads.square().square() * loads.sqrt()).rowwise().mean();
}

// Rollers that stay level load both halves alike.
bool are_aligned(const Eigen::Ref<const Eigen::ArrayXXd>& powers) {
  const Eigen::Index half = powers.rows() / 2;
  return (powers.topRows(half) == powers.bottomRows(half).colwise().reverse()).all();
}

// The same by (3).
Eigen::ArrayXd mean_of_fourth_powers(const Eigen::Ref<const Eigen::ArrayXXd>& powers, RaceMotion motion) {
  // The roots of one half are those of the other; sums cost no more than to find that out.
  const Eigen::Index laminae = powers.rows();
  const bool by_half = motion == RaceMotion::stationary && are_aligned(powers);
  const Eigen::Index unlike = by_half ? (laminae + 1) / 2 : laminae;
  // Column by column: Eigen takes the roots of a row one at a time.
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(unlike);
  for (Eigen::Index position = 0; position < powers.cols(); ++position) {
    const auto at = powers.col(position).head(unlike);
    if ((at == 0.0).all()) continue;  // not touched there
    if (motion == RaceMotion::rotating)
      sum += at;
    else
      sum += at * at.sqrt().sqrt().sqrt();
  }
  Eigen::ArrayXd mean(laminae);
  mean << sum, sum.head(laminae - unlike).reverse();
  return mean / static_cast<double>(powers.cols());
}

Eigen::ArrayXd by_lamina(const Eigen::ArrayXd& weight, const Eigen::ArrayXd& mean, RaceMotion motion) {
  if (mean.size() != weight.size()) {  // one mean for all
    const double share = std::pow(static_cast<double>(weight.size()), -line_contacts.mean_exponent(motion));
    return by_lamina(weight, Eigen::ArrayXd::Constant(weight.size(), share * mean[0]), motion);
  }
  if (motion == RaceMotion::rotating) return weight * mean.pow(line_contacts.weibull_slope);
  return weight * mean;
}

}  // namespace

LaminaRating lamina_rating(const rating::ContactCapacities& capacities, int laminae,
                           const RaceMotions& motions) {
  return lamina_rating(capacities, Eigen::ArrayXd::Ones(laminae), motions);
}

LaminaRating lamina_rating(const rating::ContactCapacities& capacities, const Eigen::ArrayXd& riser,
                           const RaceMotions& motions) {
  return {weights(riser, capacities.inner), weights(riser, capacities.outer), motions};
}

LaminaRating lamina_rating(const Bearing& bearing, double reduction_factor) {
  return lamina_rating({contact_capacity(bearing, Race::inner, reduction_factor),
                        contact_capacity(bearing, Race::outer, reduction_factor)},
                       std::max(bearing.rollers().laminae, 1), bearing.motions);
}

BearingLife lamina_life(const LaminaRating& rating, const Loads& inner, const Loads& outer) {
  return life_of_means(rating, means_of_loads(rating.motions, inner, outer));
}

LaminaMeans lamina_means(const RaceMotions& motions, const Eigen::Ref<const Eigen::ArrayXXd>& inner,
                         const Eigen::Ref<const Eigen::ArrayXXd>& outer) {
  return {mean_of_fourth_powers(inner, motions.inner), mean_of_fourth_powers(outer, motions.outer)};
}

LaminaMeans means_of_loads(const RaceMotions& motions, const Loads& inner, const Loads& outer) {
  return {mean_power(inner, motions.inner), mean_power(outer, motions.outer)};
}

BearingLife life_of_means(const LaminaRating& rating, const LaminaMeans& means) {
  const rating::ByLamina damage = lamina_damage(rating, means);
  return line_contacts.lives(damage.inner.sum(), damage.outer.sum());
}

rating::ByLamina lamina_damage(const LaminaRating& rating, const LaminaMeans& means) {
  return {by_lamina(rating.inner_weight, means.inner, rating.motions.inner),
          by_lamina(rating.outer_weight, means.outer, rating.motions.outer)};
}

}  // namespace orbearing::bearing::life
