#include "bearing/life/rating_lives.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/life/basic_life.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "bearing/life/reference_life.hpp"
#include "bearing/life/roller_capacity.hpp"
#include "bearing/units.hpp"

namespace orbearing::bearing::rating {

namespace {

constexpr double kDamageExponent = life::line_contacts.damage_exponent();

BearingLife scaled_lives(double factor, const BearingLife& life) {
  return {factor * life.inner, factor * life.outer, factor * life.bearing};
}

// (2), with the loads of a lamina by what they do to it. Elements are those of all rows: the i^(7/9) of their
// capacities, and i^(2/9) of the laminae over which the life is summed.
class LaminaLoad {
 public:
  LaminaLoad(const BearingRating& rating, Eigen::Index laminae) {
    const double inner = lamina_capacity(rating.ratings.contacts.inner, static_cast<int>(laminae));
    const double ratio = kOuter * rating.ratings.contacts.inner / rating.ratings.contacts.outer;
    scale_ = 0.323 * rating.elements * static_cast<double>(laminae) * std::cos(rating.contact_angle) * inner *
             std::pow(1.0 + std::pow(ratio, kDamageExponent), -1.0 / kDamageExponent);
  }
  double operator()(double inner_damage, double outer_damage) const {
    return scale_ * std::pow(inner_damage + outer_ * outer_damage, 1.0 / kDamageExponent);
  }

 private:
  static constexpr double kOuter = 1.038;
  double outer_ = std::pow(kOuter, kDamageExponent);
  double scale_ = 0.0;  // [N]
};

double modification(const BearingRating& rating, const OilCondition& oil, double load) {
  const double limit = oil.contamination_factor * rating.ratings.fatigue_load_limit;
  return life_modification_factor(rating.element, oil.viscosity_ratio, load > 0.0 ? limit / load : kInfinity);
}

// Means over the positions by lamina, on the laminae of the rating.
life::LaminaMeans on_rated_laminae(const life::LaminaRating& rating, const life::LaminaMeans& means) {
  const Eigen::Index laminae = rating.inner_weight.size();
  const auto of = [&](const Eigen::ArrayXd& powers, RaceMotion motion) -> Eigen::ArrayXd {
    if (powers.size() == laminae || powers.size() == 1) return powers;
    const double exponent = life::line_contacts.mean_exponent(motion);
    return on_equal_laminae(powers.pow(1.0 / exponent), laminae).pow(exponent);
  };
  return {of(means.inner, rating.motions.inner), of(means.outer, rating.motions.outer)};
}

bool is_modified(const std::optional<OilCondition>& oil) {
  return oil && oil->viscosity_ratio >= kLeastViscosityRatio;
}

// Lives that do not depend on the loads of single elements.
RatingLives lives_by_load(const BearingRating& rating, const RatingCondition& condition) {
  RatingLives lives{.dynamic_capacity = rating.ratings.dynamic_capacity,
                    .static_capacity = rating.ratings.static_capacity,
                    .fatigue_load_limit = rating.ratings.fatigue_load_limit,
                    .dynamic_load = condition.dynamic_load.value_or(kNotRated),
                    .static_load = condition.static_load.value_or(kNotRated),
                    .oil = condition.oil,
                    .reliability_factor = condition.reliability_factor};
  if (!condition.dynamic_load) return lives;
  lives.basic = basic_rating_life(rating.element, lives.dynamic_capacity, lives.dynamic_load);
  if (!is_modified(condition.oil)) return lives;
  lives.life_modification = modification(rating, *condition.oil, lives.dynamic_load);
  lives.modified = condition.reliability_factor * lives.life_modification * lives.basic;
  return lives;
}

}  // namespace

BearingRating bearing_rating(const Bearing& bearing, const StatedRatings& stated) {
  BearingRating rating{.ratings = ratings_of(bearing, stated),
                       .element = rolling_element(bearing),
                       .elements = bearing.element_count(),
                       .contact_angle = bearing.contact_angle(),
                       .motions = bearing.motions,
                       .laminae = {}};
  if (!bearing.has_rollers()) return rating;
  rating.laminae = rated_laminae(rating.ratings.contacts, bearing, stated.stress_riser);
  rating.on_too_few_laminae = has_too_few_laminae(bearing, stated.stress_riser);
  return rating;
}

bool has_too_few_laminae(const Bearing& bearing, StressRiser riser) {
  const CylindricalRollers& rollers = bearing.rollers();
  return riser == StressRiser::position && rollers.laminae > 0 && rollers.laminae < kLeastRatedLaminae &&
         std::holds_alternative<profile::Straight>(rollers.profile);
}

life::LaminaRating rated_laminae(const ContactCapacities& contacts, const Bearing& bearing,
                                 StressRiser riser) {
  const int cut = bearing.rollers().laminae;
  const bool own = riser == StressRiser::standard && cut > 0;
  return life::lamina_rating(contacts, stress_riser(own ? cut : kLeastRatedLaminae), bearing.motions);
}

RatingLives rating_lives(const BearingRating& rating, const RatingCondition& condition,
                         const life::LaminaMeans& means) {
  RatingLives lives = lives_by_load(rating, condition);
  if (rating.on_too_few_laminae) return lives;
  const auto [inner, outer] = life::lamina_damage(rating.laminae, on_rated_laminae(rating.laminae, means));
  lives.reference = life::line_contacts.lives(inner.sum(), outer.sum());
  if (!is_modified(condition.oil)) return lives;
  const LaminaLoad load(rating, inner.size());
  double modified_inner = 0.0, modified_outer = 0.0;
  for (Eigen::Index k = 0; k < inner.size(); ++k) {
    if (inner[k] + outer[k] == 0.0) continue;
    const double factor = std::pow(modification(rating, *condition.oil, load(inner[k], outer[k])),
                                   -life::line_contacts.weibull_slope);
    modified_inner += inner[k] * factor;
    modified_outer += outer[k] * factor;
  }
  lives.modified_reference =
      scaled_lives(condition.reliability_factor, life::line_contacts.lives(modified_inner, modified_outer));
  const double plain = inner.sum() + outer.sum();
  lives.reference_modification = plain > 0.0 ? std::pow((modified_inner + modified_outer) / plain,
                                                        -1.0 / life::line_contacts.weibull_slope)
                                             : modification(rating, *condition.oil, 0.0);
  return lives;
}

RatingLives rating_lives(const BearingRating& rating, const RatingCondition& condition,
                         const EquivalentBallLoads& loads) {
  RatingLives lives = lives_by_load(rating, condition);
  lives.reference = ball_reference_life(rating.ratings.contacts, loads.inner, loads.outer);
  if (!is_modified(condition.oil)) return lives;
  const double load = reference_load(RollingElement::ball, lives.dynamic_capacity, lives.reference.bearing);
  lives.reference_modification = modification(rating, *condition.oil, load);
  lives.modified_reference =
      scaled_lives(condition.reliability_factor * lives.reference_modification, lives.reference);
  return lives;
}

RatingLives rating_lives(const BearingRating& rating, const RatingCondition& condition,
                         const ElementLoads& inner, const ElementLoads& outer) {
  if (rating.element == RollingElement::roller)
    return rating_lives(rating, condition,
                        life::means_of_loads(rating.motions, inner.laminae, outer.laminae));
  return rating_lives(rating, condition,
                      EquivalentBallLoads{equivalent_ball_load(inner.contact, rating.motions.inner),
                                          equivalent_ball_load(outer.contact, rating.motions.outer)});
}

RatedHours rated_hours(const RatingLives& lives, double speed) {
  const auto of = [&](double life) { return std::isnan(life) ? kNotRated : hours(life, speed); };
  return {of(lives.basic), of(lives.reference.bearing), of(lives.modified),
          of(lives.modified_reference.bearing)};
}

RatedHours hours_together(const std::vector<RatedHours>& bearings, double slope) {
  RatedHours together;
  Eigen::ArrayXd lives(static_cast<Eigen::Index>(bearings.size()));
  for (const auto life : kRatedHours) {
    for (Eigen::Index i = 0; i < lives.size(); ++i) lives[i] = bearings[static_cast<std::size_t>(i)].*life;
    if (!lives.isNaN().any()) together.*life = system_life(lives, slope);
  }
  return together;
}

RatedHours hours_of_equal(const RatedHours& one, int count, double slope) {
  RatedHours all = one;
  for (const auto life : kRatedHours) all.*life *= std::pow(count, -1.0 / slope);
  return all;
}

const char* hours_key(Life life) {
  constexpr std::array keys{"L10h", "L10rh", "L10mh", "L10mrh", "life_h"};
  return keys[static_cast<std::size_t>(life)];
}

const char* revolutions_key(Life life) {
  constexpr std::array keys{"L10_Mrev", "L10r_Mrev", "L10m_Mrev", "L10mr_Mrev", "life_Mrev"};
  return keys[static_cast<std::size_t>(life)];
}

double hours_of(Life life, double lundberg_palmgren, const RatedHours& hours) {
  if (life == Life::lundberg_palmgren) return lundberg_palmgren;
  return hours.*kRatedHours[static_cast<std::size_t>(life)];
}

}  // namespace orbearing::bearing::rating
