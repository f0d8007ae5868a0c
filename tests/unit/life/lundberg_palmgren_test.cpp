#include "bearing/life/lundberg_palmgren.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bearing/life/ball_capacity.hpp"
#include "tests/unit/bearing/example_bearings.hpp"
#include "tests/whole_contact_life.hpp"

namespace orbearing::bearing::lundberg_palmgren_test {
namespace {

constexpr double kRoundOff = 1e-12;   // a few powers in double precision, relative
constexpr double kHandDigits = 1e-5;  // the hand values carry six digits
constexpr double kLambda = 0.83;

// D = l = 1 mm and 16 rollers leave 552 lambda / 2 (1 -+ 0.1)^(29/27) / (1 +- 0.1)^(1/4) 0.1^(2/9).
Bearing simple_bearing() {
  Bearing bearing;
  bearing.rollers().count = 16;
  bearing.rollers().diameter = 1e-3;
  bearing.rollers().length = 1e-3;
  bearing.pitch_diameter = 10e-3;
  return bearing;
}

double race_life(double capacity, double equivalent_load) {
  return life::line_contacts.life(life::line_contacts.damage(equivalent_load, capacity));
}

TEST(ContactCapacity, ByHand) {
  EXPECT_NEAR(contact_capacity(simple_bearing(), Race::inner, kLambda), 119.749, 119.749 * kHandDigits);
  EXPECT_NEAR(contact_capacity(simple_bearing(), Race::outer, kLambda), 156.194, 156.194 * kHandDigits);
}

TEST(ContactCapacity, GrowsWithSizeLengthAndFewerRollers) {
  const Bearing small = simple_bearing();
  const auto ratio = [&](const Bearing& other) {
    return contact_capacity(other, Race::inner, 1.0) / contact_capacity(small, Race::inner, 1.0);
  };
  Bearing other = small;
  other.rollers().diameter *= 2.0;
  other.pitch_diameter *= 2.0;
  EXPECT_NEAR(ratio(other), std::pow(2.0, 29.0 / 27.0), kRoundOff);
  other = small;
  other.rollers().length *= 2.0;
  EXPECT_NEAR(ratio(other), std::pow(2.0, 7.0 / 9.0), kRoundOff);
  other = small;
  other.rollers().count = 1;
  EXPECT_NEAR(ratio(other), 2.0, kRoundOff);
}

TEST(EquivalentLoad, FourthPowerTurningAndPowerFourAndAHalfStanding) {
  Eigen::ArrayXd loads = Eigen::ArrayXd::Zero(16);
  loads[3] = 100.0;
  EXPECT_NEAR(life::line_contacts.equivalent_load(loads, RaceMotion::rotating), 50.0, 50.0 * kRoundOff);
  const double stationary = 100.0 * std::pow(16.0, -1.0 / 4.5);
  EXPECT_NEAR(life::line_contacts.equivalent_load(loads, RaceMotion::stationary), stationary,
              stationary * kRoundOff);
}

TEST(EquivalentLoad, OfEqualLoadsIsTheLoadAndOfNoneIsZero) {
  for (const RaceMotion motion : {RaceMotion::rotating, RaceMotion::stationary}) {
    EXPECT_NEAR(life::line_contacts.equivalent_load(Eigen::ArrayXd::Constant(7, 80.0), motion), 80.0,
                80.0 * kRoundOff);
    EXPECT_EQ(life::line_contacts.equivalent_load(Eigen::ArrayXd::Zero(7), motion), 0.0);
    EXPECT_EQ(life::line_contacts.equivalent_load(Eigen::ArrayXd(), motion), 0.0);
  }
}

TEST(EquivalentLoad, NeitherOverflowsNorUnderflows) {
  for (const double scale : {1e-100, 1e100}) {
    const double equivalent =
        life::line_contacts.equivalent_load(Eigen::ArrayXd::Constant(3, scale), RaceMotion::stationary);
    EXPECT_NEAR(equivalent / scale, 1.0, kRoundOff);
  }
}

TEST(RaceLife, IsAMillionRevolutionsAtTheCapacity) {
  EXPECT_NEAR(race_life(500.0, 500.0), 1e6, 1e6 * kRoundOff);
  EXPECT_NEAR(race_life(500.0, 250.0), 16e6, 16e6 * kRoundOff);
  EXPECT_EQ(race_life(500.0, 0.0), std::numeric_limits<double>::infinity());
}

// The exponents are those of Lundberg and Palmgren, 3 and 10/3 of points, 4 and 9/2 of lines.
TEST(FatigueLaw, HasTheExponentsOfPointsAndLines) {
  EXPECT_EQ(life::point_contacts.mean_exponent(RaceMotion::rotating), 3.0);
  EXPECT_DOUBLE_EQ(life::point_contacts.mean_exponent(RaceMotion::stationary), 10.0 / 3.0);
  EXPECT_EQ(life::line_contacts.mean_exponent(RaceMotion::rotating), 4.0);
  EXPECT_EQ(life::line_contacts.mean_exponent(RaceMotion::stationary), 4.5);
  const double life = life::point_contacts.life(life::point_contacts.damage(250.0, 500.0));
  EXPECT_NEAR(life, 8e6, 8e6 * kRoundOff);
}

TEST(CombinedLife, OfEqualRacesAndOfOneUnloadedRace) {
  const double expected = 100.0 * std::pow(2.0, -8.0 / 9.0);
  EXPECT_NEAR(combined_life(100.0, 100.0), expected, expected * kRoundOff);
  EXPECT_NEAR(combined_life(100.0, std::numeric_limits<double>::infinity()), 100.0, 100.0 * kRoundOff);
}

TEST(SystemLife, OfEightEqualBearings) {
  const double expected = 40000.0 * 0.157490131236859;  // 8^(-8/9) = 2^(-8/3)
  EXPECT_NEAR(system_life(40000.0, 8), expected, expected * kRoundOff);
  EXPECT_EQ(system_life(40000.0, 1), 40000.0);
}

TEST(BearingLife, TakesEachRacesOwnLoadsCapacityAndMotion) {
  const Bearing bearing = simple_bearing();
  const Eigen::ArrayXd inner = Eigen::ArrayXd::LinSpaced(16, 0.0, 30.0);
  const Eigen::ArrayXd outer = Eigen::ArrayXd::LinSpaced(16, 5.0, 35.0);
  const BearingLife life = whole_contact_life(bearing, kLambda, inner, outer);
  const double inner_life = race_life(contact_capacity(bearing, Race::inner, kLambda),
                                      life::line_contacts.equivalent_load(inner, RaceMotion::stationary));
  const double outer_life = race_life(contact_capacity(bearing, Race::outer, kLambda),
                                      life::line_contacts.equivalent_load(outer, RaceMotion::rotating));
  EXPECT_NEAR(life.inner, inner_life, inner_life * kRoundOff);
  EXPECT_NEAR(life.outer, outer_life, outer_life * kRoundOff);
  const double both = combined_life(inner_life, outer_life);
  EXPECT_NEAR(life.bearing, both, both * kRoundOff);
}

// A load that is fixed to a housing while the shaft rotates: the exponents of both means are interchanged, 4
// and 4.5, and the capacities stay.
TEST(BearingLife, SwapsNothingButTheExponentsWhereTheOtherRaceTurns) {
  Bearing bearing = simple_bearing();
  bearing.motions = rating::rotating(Race::inner);
  const Eigen::ArrayXd inner = Eigen::ArrayXd::LinSpaced(16, 0.0, 30.0);
  const Eigen::ArrayXd outer = Eigen::ArrayXd::LinSpaced(16, 5.0, 35.0);
  const BearingLife life = whole_contact_life(bearing, kLambda, inner, outer);
  const double inner_mean = std::pow(inner.pow(4.0).mean(), 1.0 / 4.0);
  const double outer_mean = std::pow(outer.pow(4.5).mean(), 1.0 / 4.5);
  const double inner_life = 1e6 * std::pow(contact_capacity(bearing, Race::inner, kLambda) / inner_mean, 4.0);
  const double outer_life = 1e6 * std::pow(contact_capacity(bearing, Race::outer, kLambda) / outer_mean, 4.0);
  EXPECT_NEAR(life.inner, inner_life, inner_life * kRoundOff);
  EXPECT_NEAR(life.outer, outer_life, outer_life * kRoundOff);
  EXPECT_NE(life.bearing, whole_contact_life(simple_bearing(), kLambda, inner, outer).bearing);
}

TEST(Hours, OfAMillionRevolutionsAtAThousandPerMinute) {
  const double speed = example_bearings::rpm(1000.0);
  EXPECT_NEAR(hours(1e6, speed), 1e6 / 60000.0, 1e-11);
  EXPECT_EQ(hours(1e6, -speed), hours(1e6, speed));
  EXPECT_EQ(hours(1e6, 0.0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace orbearing::bearing::lundberg_palmgren_test
