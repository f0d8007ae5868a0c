// One set of lives for every bearing.
#include "bearing/life/rating_lives.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bearing/life/inclined_rating.hpp"
#include "bearing/units.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::rating::rating_lives_test {
namespace {

// The printed formula, for any number of laminae.
const StatedRatings kPrintedFormula{.stress_riser = StressRiser::standard};

constexpr double kRoundOff = 1e-12;
constexpr double kSumsOfPowers = 1e-10;

// Loads of the fifteen rollers of a planet bearing [N]; the inner race is stationary, the outer one rotates.
const Eigen::ArrayXd kInner{{820, 700, 420, 90, 0, 0, 0, 0, 0, 0, 0, 0, 90, 420, 700}};
const Eigen::ArrayXd kOuter{{860, 740, 450, 110, 0, 0, 0, 0, 0, 0, 0, 0, 110, 450, 740}};

ElementLoads of_rollers(const Eigen::ArrayXd& loads, const Eigen::ArrayXd& shares) {
  return {loads, shares.matrix() * loads.matrix().transpose()};
}

Eigen::ArrayXd even_shares(Eigen::Index laminae) {
  return Eigen::ArrayXd::Constant(laminae, 1.0 / static_cast<double>(laminae));
}

RatingCondition under(double load, const std::optional<OilCondition>& oil = std::nullopt, double a_1 = 1.0) {
  return {.dynamic_load = load, .static_load = 1.2 * load, .oil = oil, .reliability_factor = a_1};
}

// Numbers of a second program in N and mm, written from the formulas of bearing/life/README.md.
TEST(RatingLives, OfAPlanetBearingByHand) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.rollers().laminae = 30;
  const BearingRating rating = bearing_rating(bearing, kPrintedFormula);
  const RatingLives lives =
      rating_lives(rating, under(2781.0, OilCondition{5.48, 0.5512989584521938}, 0.64),
                   of_rollers(kInner, even_shares(30)), of_rollers(kOuter, even_shares(30)));
  EXPECT_NEAR(lives.dynamic_capacity / 16928.577203653913, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.static_capacity / 16814.577777777784, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.fatigue_load_limit / 2050.5582655826565, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.basic / 411.8428830133287e6, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.reference.bearing / 629.0529432542367e6, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.life_modification / 3.7725094699250796, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.modified / 994.3559528249787e6, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.modified_reference.bearing / 609.1286394469533e6, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.reference_modification / 1.5130101676532526, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.load_ratio(), 16928.577203653913 / 2781.0, 1e-9);
  EXPECT_NEAR(lives.static_safety(), 16814.577777777784 / (1.2 * 2781.0), 1e-9);
}

// The ends of the rollers carry 0.02 and 0.18 of the load, laminae between them in a straight line.
TEST(RatingLives, OfTiltedRollersByHand) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.rollers().laminae = 10;
  const Eigen::ArrayXd slope = Eigen::ArrayXd::LinSpaced(10, 0.02, 0.18);
  const RatingLives lives =
      rating_lives(bearing_rating(bearing, kPrintedFormula), under(2781.0, OilCondition{0.7, 0.4}),
                   of_rollers(kInner, slope), of_rollers(kOuter, slope));
  EXPECT_NEAR(lives.basic / 411.8428830133287e6, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.reference.bearing / 53.094937392034836e6, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.life_modification / 0.50732850475411, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.modified_reference.bearing / 13.365005624523143e6, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.reference_modification / 0.25171902032467836, 1.0, kSumsOfPowers);
  const double races = combined_life(lives.modified_reference.inner, lives.modified_reference.outer);
  EXPECT_NEAR(races / lives.modified_reference.bearing, 1.0, kSumsOfPowers);
}

// 6305 with C_r by formula; balls: a_ISO at P = C (L10r)^(-1/3), the same on both races.
TEST(RatingLives, OfABallBearingByHand) {
  const Bearing bearing{.elements = Balls{.count = 7, .diameter = 11.5e-3}, .pitch_diameter = 43.5e-3};
  const RatingLives lives =
      rating_lives(bearing_rating(bearing, kPrintedFormula), under(1000.0, OilCondition{2.0, 0.3}, 0.5),
                   EquivalentBallLoads{600.0, 640.0});
  EXPECT_NEAR(lives.dynamic_capacity / 22368.568006981048, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.basic / 11192.176410091e6, 1.0, kSumsOfPowers);
  EXPECT_NEAR(lives.reference.bearing / 2229.9432906156026e6, 1.0, kSumsOfPowers);
  const double limit = 0.3 * lives.fatigue_load_limit;
  EXPECT_NEAR(lives.life_modification, life_modification_factor(RollingElement::ball, 2.0, limit / 1000.0),
              kRoundOff);
  const double load = 22368.568006981048 * std::pow(2229.9432906156026, -1.0 / 3.0);
  EXPECT_NEAR(lives.reference_modification, life_modification_factor(RollingElement::ball, 2.0, limit / load),
              1e-9);
  EXPECT_NEAR(lives.modified, 0.5 * lives.life_modification * lives.basic, lives.modified * kRoundOff);
  EXPECT_NEAR(lives.modified_reference.outer, 0.5 * lives.reference_modification * lives.reference.outer,
              lives.modified_reference.outer * kRoundOff);
}

// Contacts that are not cut carry evenly: as thirty laminae with equal loads, static and over a motion.
TEST(RatingLives, OfWholeContactsAreThoseOfThirtyEqualLaminae) {
  const Bearing whole = example_bearings::planet_bearing();
  Bearing cut = whole;
  cut.rollers().laminae = 30;
  const RatingCondition condition = under(2000.0, OilCondition{1.1, 0.3});
  const RatingLives one =
      rating_lives(bearing_rating(whole, kPrintedFormula), condition, of_rollers(kInner, even_shares(1)),
                   of_rollers(kOuter, even_shares(1)));
  const RatingLives thirty =
      rating_lives(bearing_rating(cut, kPrintedFormula), condition, of_rollers(kInner, even_shares(30)),
                   of_rollers(kOuter, even_shares(30)));
  EXPECT_NEAR(one.reference.inner / thirty.reference.inner, 1.0, kSumsOfPowers);
  EXPECT_NEAR(one.reference.outer / thirty.reference.outer, 1.0, kSumsOfPowers);
  EXPECT_NEAR(one.modified_reference.bearing / thirty.modified_reference.bearing, 1.0, kSumsOfPowers);
  // A cut bearing whose laminae carry equal loads may give the whole loads.
  const RatingLives of_whole =
      rating_lives(bearing_rating(cut, kPrintedFormula), condition, of_rollers(kInner, even_shares(1)),
                   of_rollers(kOuter, even_shares(1)));
  EXPECT_NEAR(of_whole.reference.bearing / thirty.reference.bearing, 1.0, kSumsOfPowers);
}

// Loads that do not vary at any position: the means of a motion are those of the static bearing.
TEST(RatingLives, OfASteadyMotionAreThoseAtRest) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.rollers().laminae = 12;
  const Eigen::ArrayXd slope = Eigen::ArrayXd::LinSpaced(12, 0.5, 1.5) / 12.0;
  const ElementLoads inner = of_rollers(kInner, slope), outer = of_rollers(kOuter, slope);
  const BearingRating rating = bearing_rating(bearing, kPrintedFormula);
  const RatingCondition condition = under(2000.0, OilCondition{1.1, 0.3});
  const RatingLives rest = rating_lives(rating, condition, inner, outer);
  const RatingLives motion = rating_lives(
      rating, condition,
      life::lamina_means(bearing.motions, inner.laminae.square().square(), outer.laminae.square().square()));
  EXPECT_NEAR(motion.reference.bearing / rest.reference.bearing, 1.0, kSumsOfPowers);
  EXPECT_NEAR(motion.modified_reference.bearing / rest.modified_reference.bearing, 1.0, kSumsOfPowers);
}

// L10 is proportional to P^(-10/3), L10r to the load's fourth power: (9/2)(8/9) = 4.
TEST(RatingLives, FallWithTheLoadByTheirExponents) {
  const Bearing bearing = example_bearings::planet_bearing();
  const BearingRating rating = bearing_rating(bearing, kPrintedFormula);
  const auto at = [&](double times) {
    return rating_lives(rating, under(1000.0 * times), of_rollers(times * kInner, even_shares(1)),
                        of_rollers(times * kOuter, even_shares(1)));
  };
  EXPECT_NEAR(at(1.0).basic / at(2.0).basic, std::pow(2.0, 10.0 / 3.0), kSumsOfPowers);
  EXPECT_NEAR(at(1.0).reference.bearing / at(2.0).reference.bearing, 16.0, 1e-8);
  const Bearing balls{.elements = Balls{.count = 7, .diameter = 11.5e-3}, .pitch_diameter = 43.5e-3};
  const auto of_balls = [&](double times) {
    return rating_lives(bearing_rating(balls, kPrintedFormula), under(1000.0 * times),
                        EquivalentBallLoads{600.0 * times, 640.0 * times});
  };
  EXPECT_NEAR(of_balls(1.0).basic / of_balls(2.0).basic, 8.0, 1e-10);
  EXPECT_NEAR(of_balls(1.0).reference.bearing / of_balls(2.0).reference.bearing, 8.0, 1e-8);
}

// The part of a lamina in P_k of (2): with both races equal and no stress riser the load from all laminae is
// 0.323 Z n q, whatever the weights of the races.
TEST(RatingLives, EachLaminaHasItsOwnFactor) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.rollers().laminae = 3;
  const BearingRating rating = bearing_rating(bearing, kPrintedFormula);
  // Only the middle lamina is loaded, where f_k = 1, and equally all round.
  const Eigen::ArrayXd middle{{0.0, 100.0, 0.0}};
  const ElementLoads loads = of_rollers(Eigen::ArrayXd::Ones(15), middle);
  const RatingLives lives = rating_lives(rating, under(1.0, OilCondition{1.0, 0.5}), loads, loads);
  const double expected = life_modification_factor(RollingElement::roller, 1.0,
                                                   0.5 * lives.fatigue_load_limit / (0.323 * 15 * 3 * 100.0));
  EXPECT_NEAR(lives.reference_modification / expected, 1.0, kSumsOfPowers);
}

// For two rows P_k has the factor 2, where their C has 2^(7/9): under the same loads of all laminae the
// bearing bears twice the load of one row, and the share of a lamina in it is half.
TEST(RatingLives, LaminaOfTwoRowsStandsForTheLoadOfBoth) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.rollers().laminae = 3;
  const PlanetRows two{.type = PlanetBearingType::spherical_roller, .contact_angle = 0.2};
  const BearingRating rating = planet_bearing_rating(bearing, two, kPrintedFormula);
  const Eigen::ArrayXd middle{{0.0, 100.0, 0.0}};
  const ElementLoads loads = of_rollers(Eigen::ArrayXd::Ones(15), middle);
  const RatingLives lives = rating_lives(rating, under(1.0, OilCondition{1.0, 0.5}), loads, loads);
  const double load = 0.323 * 2 * 15 * 3 * std::cos(0.2) * 100.0;
  const double expected =
      life_modification_factor(RollingElement::roller, 1.0, 0.5 * lives.fatigue_load_limit / load);
  EXPECT_NEAR(lives.reference_modification / expected, 1.0, kSumsOfPowers);
}

TEST(RatingLives, ReliabilityIsInTheModifiedLivesAlone) {
  const BearingRating rating = bearing_rating(example_bearings::planet_bearing());
  const auto at = [&](double a_1) {
    return rating_lives(rating, under(2000.0, OilCondition{1.0, 0.5}, a_1),
                        of_rollers(kInner, even_shares(1)), of_rollers(kOuter, even_shares(1)));
  };
  const RatingLives ninety = at(1.0), less = at(0.25);
  EXPECT_EQ(less.basic, ninety.basic);
  EXPECT_EQ(less.reference.bearing, ninety.reference.bearing);
  EXPECT_EQ(less.life_modification, ninety.life_modification);
  EXPECT_EQ(less.reference_modification, ninety.reference_modification);
  EXPECT_EQ(less.modified, 0.25 * ninety.modified);
  EXPECT_EQ(less.modified_reference.bearing, 0.25 * ninety.modified_reference.bearing);
}

TEST(RatingLives, WhereTheStandardsGiveNone) {
  const BearingRating rating = bearing_rating(example_bearings::planet_bearing());
  const auto lives = [&](const RatingCondition& condition) {
    return rating_lives(rating, condition, of_rollers(kInner, even_shares(1)),
                        of_rollers(kOuter, even_shares(1)));
  };
  const RatingLives dry = lives(under(2000.0));
  EXPECT_TRUE(std::isnan(dry.modified) && std::isnan(dry.modified_reference.bearing));
  EXPECT_TRUE(std::isnan(dry.life_modification) && std::isnan(dry.reference_modification));
  EXPECT_GT(dry.basic, 0.0);
  const RatingLives starved = lives(under(2000.0, OilCondition{0.099, 0.5}));
  EXPECT_TRUE(std::isnan(starved.modified) && std::isnan(starved.modified_reference.bearing));
  EXPECT_EQ(starved.oil->viscosity_ratio, 0.099);
  const RatingLives without_load = lives({.oil = OilCondition{1.0, 0.5}});
  EXPECT_TRUE(std::isnan(without_load.basic) && std::isnan(without_load.modified));
  EXPECT_TRUE(std::isnan(without_load.static_safety()));
  EXPECT_GT(without_load.modified_reference.bearing, 0.0);
  const RatingLives idle =
      rating_lives(rating, under(0.0, OilCondition{4.0, 1.0}), of_rollers(0.0 * kInner, even_shares(1)),
                   of_rollers(0.0 * kOuter, even_shares(1)));
  EXPECT_EQ(idle.basic, kInfinity);
  EXPECT_EQ(idle.reference.bearing, kInfinity);
  EXPECT_EQ(idle.reference_modification, 50.0);
  EXPECT_EQ(idle.modified_reference.bearing, kInfinity);
}

TEST(RatingLives, GoverningLife) {
  const RatedHours hours{.basic = 1.0, .reference = 2.0, .modified = 3.0, .modified_reference = 4.0};
  for (const bool oil : {false, true}) {
    EXPECT_EQ(hours_of(governing_life(LifeMethod::lundberg_palmgren, oil), 5.0, hours), 5.0);
    EXPECT_EQ(hours_of(governing_life(LifeMethod::iso281, oil), 5.0, hours), oil ? 3.0 : 1.0);
    EXPECT_EQ(hours_of(governing_life(LifeMethod::iso16281, oil), 5.0, hours), oil ? 4.0 : 2.0);
  }
  EXPECT_STREQ(hours_key(governing_life(LifeMethod::iso16281, true)), "L10mrh");
  EXPECT_STREQ(hours_key(governing_life(LifeMethod::iso281, false)), "L10h");
  EXPECT_STREQ(revolutions_key(governing_life(LifeMethod::iso16281, false)), "L10r_Mrev");
  EXPECT_STREQ(revolutions_key(governing_life(LifeMethod::lundberg_palmgren, true)), "life_Mrev");
}

TEST(StaticEquivalentLoad, IsNeverLessThanTheRadialLoad) {
  const Bearing balls{.elements = Balls{.count = 7, .diameter = 11.5e-3}, .pitch_diameter = 43.5e-3};
  EXPECT_EQ(*static_equivalent_load(balls, 1000.0, 500.0), 1000.0);
  EXPECT_NEAR(*static_equivalent_load(balls, 1000.0, 2000.0), 1600.0, 1e-9);
  EXPECT_EQ(*static_equivalent_load(example_bearings::planet_bearing(), 1000.0, 0.0), 1000.0);
  const Bearing angular{.elements = Balls{.count = 7, .diameter = 11.5e-3, .contact_angle = 0.3},
                        .pitch_diameter = 43.5e-3};
  EXPECT_FALSE(static_equivalent_load(angular, 1000.0, 500.0));
  EXPECT_FALSE(equivalent_load(angular, 1000.0, 500.0));
}

}  // namespace
}  // namespace orbearing::bearing::rating::rating_lives_test
