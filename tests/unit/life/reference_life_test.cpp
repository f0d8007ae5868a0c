#include "bearing/life/reference_life.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bearing/contact/line_contact.hpp"
#include "bearing/life/rating_lives.hpp"

namespace orbearing::bearing::rating::reference_life_test {
namespace {

// The printed formula, for any number of laminae.
const StatedRatings kPrintedFormula{.stress_riser = StressRiser::standard};

constexpr double kRoundOff = 1e-12;
constexpr ContactCapacities kCapacities{.inner = 4000.0, .outer = 5000.0};

// With the stress riser.
BearingLife lamina_life(const ContactCapacities& capacities, const Eigen::ArrayXXd& inner,
                        const Eigen::ArrayXXd& outer, const RaceMotions& motions) {
  return life::lamina_life(life::lamina_rating(capacities, stress_riser(inner.rows()), motions), inner,
                           outer);
}

// Sum over the laminae of equal loads: the same for any number by position, by the formula it is not.
TEST(StressRiser, ByPositionHasTheSameDamageForEqualLoadsWithAnyNumber) {
  constexpr double e = life::line_contacts.damage_exponent();
  const double of_thirty = stress_riser(30).pow(e).mean();
  for (const int laminae : {30, 31, 40, 45, 60, 100, 200, 1000})
    EXPECT_NEAR(stress_riser(laminae, StressRiser::position).pow(e).mean(), of_thirty, kRoundOff * of_thirty)
        << laminae;
  EXPECT_GT(stress_riser(100, StressRiser::standard).pow(e).mean(), 0.0);
  EXPECT_NE(stress_riser(100, StressRiser::standard).pow(e).mean(), of_thirty);
}

// At the standard's least number both are its printed formula: 2.328 at the ends (by hand: 1 -
// 0.01/ln(0.9925)).
TEST(StressRiser, ByPositionIsTheFormulaForThirtyLaminae) {
  EXPECT_TRUE((stress_riser(30, StressRiser::position) == stress_riser(30)).all());
  EXPECT_NEAR(stress_riser(30, StressRiser::position)[0], 1.0 - 0.01 / std::log(1.985 * 29.0 / 58.0),
              kRoundOff);
  const Eigen::ArrayXd sixty = stress_riser(60, StressRiser::position);
  for (int k = 0; k < 60; ++k) EXPECT_NEAR(sixty[k], stress_riser(30)[k / 2], kRoundOff);
}

TEST(EqualLaminae, CarryWhatLiesOverThem) {
  const Eigen::ArrayXd loads = (Eigen::ArrayXd(3) << 3.0, 6.0, 9.0).finished();
  const Eigen::ArrayXd two = on_equal_laminae(loads, 2), six = on_equal_laminae(loads, 6);
  EXPECT_NEAR(two[0], 3.0 + 0.5 * 6.0, kRoundOff);
  EXPECT_NEAR(two[1], 0.5 * 6.0 + 9.0, kRoundOff);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(six[k], 0.5 * loads[k / 2], kRoundOff);
  EXPECT_NEAR(on_equal_laminae(loads, 7).sum(), loads.sum(), 10 * kRoundOff);
}

TEST(StressRiser, LargestAtTheEndsOneInTheMiddleOfAnOddNumber) {
  const Eigen::ArrayXd even = stress_riser(40), odd = stress_riser(41);
  EXPECT_NEAR(even[0], 1.0 - 0.01 / std::log(1.985 * 39.0 / 78.0), kRoundOff);
  EXPECT_EQ(even[0], even[39]);
  EXPECT_EQ(odd[20], 1.0);
  EXPECT_NEAR(odd[19], 1.0 - 0.01 / std::log(1.985 * 2.0 / 80.0), kRoundOff);
  EXPECT_EQ(stress_riser(1)[0], 1.0);
  EXPECT_GT(even[0], 2.0);
  EXPECT_TRUE((even.segment(1, 38) < even[0]).all());
}

TEST(EquivalentLaminaLoads, PowersByMotion) {
  Eigen::ArrayXXd loads = Eigen::ArrayXXd::Zero(2, 16);
  loads(0, 3) = 100.0;
  EXPECT_NEAR(equivalent_lamina_loads(loads, RaceMotion::rotating)[0], 50.0, 50.0 * kRoundOff);
  EXPECT_NEAR(equivalent_lamina_loads(loads, RaceMotion::stationary)[0], 100.0 * std::pow(16.0, -1.0 / 4.5),
              100.0 * kRoundOff);
  EXPECT_EQ(equivalent_lamina_loads(loads, RaceMotion::rotating)[1], 0.0);
}

// One lamina, evenly loaded: L = ((q/Q_i)^4.5 + (q/Q_o)^4.5)^(-8/9) million revolutions.
TEST(ReferenceLife, OneLaminaByHand) {
  const Eigen::ArrayXXd loads = Eigen::ArrayXXd::Constant(1, 12, 500.0);
  const BearingLife life = lamina_life(kCapacities, loads, loads, rotating(Race::inner));
  EXPECT_NEAR(life.inner, 1e6 * 4096.0, 1e6 * 4096.0 * kRoundOff);
  EXPECT_NEAR(life.outer, 1e10, 1e10 * kRoundOff);
  const double both = 1e6 * std::pow(std::pow(8.0, -4.5) + std::pow(10.0, -4.5), -8.0 / 9.0);
  EXPECT_NEAR(life.bearing, both, both * kRoundOff);
}

TEST(ReferenceLife, HalfTheLoadLivesSixteenTimesAndNoneForever) {
  const Eigen::ArrayXXd loads = Eigen::ArrayXXd::Random(40, 15).abs() * 30.0;
  const RaceMotions motions = rotating(Race::outer);
  const double life = lamina_life(kCapacities, loads, loads, motions).bearing;
  EXPECT_NEAR(lamina_life(kCapacities, 0.5 * loads, 0.5 * loads, motions).bearing / life, 16.0,
              16.0 * kRoundOff);
  EXPECT_EQ(lamina_life(kCapacities, 0.0 * loads, 0.0 * loads, motions).bearing,
            std::numeric_limits<double>::infinity());
}

// Equal capacities: swapping the motion of the races is swapping their loads. A name plays no part.
TEST(ReferenceLife, GoesByMotionAndNotByName) {
  const ContactCapacities alike{4000.0, 4000.0};
  const Eigen::ArrayXXd a = Eigen::ArrayXXd::Random(8, 15).abs(), b = Eigen::ArrayXXd::Random(8, 15).abs();
  const BearingLife one = lamina_life(alike, a, b, rotating(Race::inner));
  const BearingLife other = lamina_life(alike, b, a, rotating(Race::outer));
  EXPECT_NEAR(one.bearing / other.bearing, 1.0, kRoundOff);
  EXPECT_NE(one.bearing, lamina_life(alike, a, b, rotating(Race::outer)).bearing);
}

// The bearing states which race rotates: 3 and 10/3 of balls, 4 and 4.5 of rollers change races, nothing
// else.
TEST(ReferenceLife, FollowsTheBearingsTurningRace) {
  Bearing of_balls{.elements = Balls{.count = 7, .diameter = 11.5e-3}, .pitch_diameter = 43.5e-3};
  Bearing of_rollers{
      .elements = CylindricalRollers{.count = 15, .diameter = 5.24e-3, .length = 5.7e-3, .laminae = 1},
      .pitch_diameter = 36e-3};
  const Eigen::ArrayXd inner = Eigen::ArrayXd::LinSpaced(7, 0.0, 900.0);
  const Eigen::ArrayXd outer = Eigen::ArrayXd::LinSpaced(7, 200.0, 1100.0);
  const auto mean = [](const Eigen::ArrayXd& loads, double exponent) {
    return std::pow(loads.pow(exponent).mean(), 1.0 / exponent);
  };
  const auto life_of = [](double capacity, double load, double exponent) {
    return 1e6 * std::pow(capacity / load, exponent);
  };
  for (const Race race : {Race::inner, Race::outer}) {
    const bool inner_turns = race == Race::inner;
    of_balls.motions = of_rollers.motions = rotating(race);
    const ContactCapacities balls = ratings_of(of_balls).contacts, rollers = ratings_of(of_rollers).contacts;
    const ElementLoads on_inner{inner, inner.transpose()}, on_outer{outer, outer.transpose()};
    const BearingLife ball_life =
        rating_lives(bearing_rating(of_balls, kPrintedFormula), {}, on_inner, on_outer).reference;
    const double rotating_ball = 3.0, stationary_ball = 10.0 / 3.0;
    const double expected_inner =
        life_of(balls.inner, mean(inner, inner_turns ? rotating_ball : stationary_ball), 3.0);
    const double expected_outer =
        life_of(balls.outer, mean(outer, inner_turns ? stationary_ball : rotating_ball), 3.0);
    EXPECT_NEAR(ball_life.inner / expected_inner, 1.0, kRoundOff);
    EXPECT_NEAR(ball_life.outer / expected_outer, 1.0, kRoundOff);
    const BearingLife roller_life =
        rating_lives(bearing_rating(of_rollers, kPrintedFormula), {}, on_inner, on_outer).reference;
    EXPECT_NEAR(roller_life.inner / life_of(rollers.inner, mean(inner, inner_turns ? 4.0 : 4.5), 4.0), 1.0,
                kRoundOff);
    EXPECT_NEAR(roller_life.outer / life_of(rollers.outer, mean(outer, inner_turns ? 4.5 : 4.0), 4.0), 1.0,
                kRoundOff);
  }
}

// An even load on a straight roller presses after Hertz: the pressures give the loads back.
TEST(LoadsOfPressures, HertzOfALineContactGivesTheLoadBack) {
  const RollerSet set{.rollers = 15, .diameter = 5.24e-3, .length = 5.7e-3, .pitch_diameter = 36e-3};
  const Material steel{.youngs_modulus = 210e9, .poisson_ratio = 0.3};
  constexpr double load = 600.0;
  for (const Race race : {Race::inner, Race::outer}) {
    const double side = race == Race::inner ? -1.0 : 1.0;
    const double radius = 0.5 * set.diameter * (1.0 + side * gamma(set));  // 1/R = 2/(D (1 -+ gamma))
    const double pressure = hertz_pressure(load, radius, set.length, steel);
    const Eigen::ArrayXXd loads =
        loads_of_pressures(Eigen::ArrayXXd::Constant(40, 1, pressure), set, race, steel);
    EXPECT_NEAR(loads.sum(), load, load * kRoundOff);
    // and in N and mm (p/271)^2 D (1 -+ gamma) l/n
    const double published =
        std::pow(1e-6 * pressure / 271.0, 2.0) * 5.24 * (1.0 + side * gamma(set)) * 5.7 / 40.0;
    constexpr double three_digits = 3e-3;
    EXPECT_NEAR(loads(0, 0) / published, 1.0, three_digits);
  }
}

TEST(BallReferenceLife, OneLoadByHand) {
  const Eigen::ArrayXd loads = Eigen::ArrayXd::Constant(9, 500.0);
  const BearingLife life = ball_reference_life(kCapacities, equivalent_ball_load(loads, RaceMotion::rotating),
                                               equivalent_ball_load(loads, RaceMotion::stationary));
  EXPECT_NEAR(life.inner, 512e6, 512e6 * kRoundOff);
  EXPECT_NEAR(life.outer, 1e9, 1e9 * kRoundOff);
  EXPECT_NEAR(life.bearing, 1e6 * std::pow(std::pow(512.0, -10.0 / 9.0) + std::pow(1e3, -10.0 / 9.0), -0.9),
              1e9 * kRoundOff);
  Eigen::ArrayXd single = Eigen::ArrayXd::Zero(8);
  single[2] = 100.0;
  EXPECT_NEAR(equivalent_ball_load(single, RaceMotion::rotating), 50.0, 50.0 * kRoundOff);
}

}  // namespace
}  // namespace orbearing::bearing::rating::reference_life_test
