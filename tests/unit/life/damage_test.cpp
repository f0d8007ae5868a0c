// Loads counted passage by passage: prescribed motions whose numbers of passages have a closed form.
#include "bearing/life/damage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "bearing/life/ball_capacity.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"
#include "tests/whole_contact_life.hpp"

namespace orbearing::bearing::motion::damage_test {
namespace {

constexpr double kRoundOff = 1e-11;  // of sums over 1e5 steps
constexpr double kLambda = 0.83;
constexpr double kBoreSpeed = -700.0;  // [rad/s]
constexpr Eigen::Index kBins = 72;

BearingGeometry geometry() {
  return geometry_of(test::reducer_bearing());
}
double rolling_speed() {
  return race_speeds(geometry(), 0.0, kBoreSpeed).cage;
}

double load_at(Eigen::Index bin) {
  return 1000.0 * std::max(0.0, std::cos(2.0 * M_PI * static_cast<double>(bin) / kBins) - 0.2);
}
Eigen::ArrayXd loads() {
  return Eigen::ArrayXd::NullaryExpr(kBins, [](Eigen::Index bin) { return load_at(bin); });
}

// Two revolutions of one roller that goes at `speed(angle)` [rad/s]: even steps in angle, each of the time
// that it takes.
DamageSums damage_at(const std::function<double(double)>& speed) {
  constexpr Eigen::Index kSteps = 500;  // for each bin
  constexpr double kStep = 2.0 * M_PI / (kBins * kSteps);
  DamageSums sums(kBins);
  for (Eigen::Index i = 0; i < 2 * kBins * kSteps; ++i) {
    const double angle = (static_cast<double>(i) + 0.5) * kStep;
    const double orbital = speed(angle);
    const double load = load_at(bin_of(angle, kBins));
    sums.add(kStep / std::abs(orbital), 1,
             {&angle, &orbital, &load, &load, race_speeds(geometry(), 0.0, kBoreSpeed)});
  }
  return sums;
}

TEST(Position, BinsAreCentredOnTheirAngles) {
  constexpr double kBin = 2.0 * M_PI / kBins;
  for (const double turn : {0.0, 2.0 * M_PI, -6.0 * M_PI}) {
    EXPECT_EQ(bin_of(turn, kBins), 0);
    EXPECT_EQ(bin_of(turn + 0.49 * kBin, kBins), 0);
    EXPECT_EQ(bin_of(turn + 0.51 * kBin, kBins), 1);
    EXPECT_EQ(bin_of(turn - 0.49 * kBin, kBins), 0);
    EXPECT_EQ(bin_of(turn - 0.51 * kBin, kBins), kBins - 1);
  }
}

// Whole turns are subtracted without the library's floor(): the same bins to the last one.
TEST(Position, IsThatOfFloor) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> angles(-400.0, 400.0);
  for (int i = 0; i < 200'000; ++i) {
    const double angle = i % 2 == 0 ? angles(random) : 2.0 * M_PI * std::round(angles(random)) / kBins;
    const double turns = angle / (2.0 * M_PI) + 0.5 / static_cast<double>(kBins);
    const auto bin = static_cast<Eigen::Index>((turns - std::floor(turns)) * static_cast<double>(kBins));
    EXPECT_EQ(bin_of(angle, kBins), std::min(bin, kBins - 1)) << angle;
  }
}

// Values that two sums share are computed once. Sums of other bins get theirs all the same.
TEST(Damage, CountsForTwoSumsAsForEach) {
  const std::vector<double> angle{0.1, 2.0, -3.0}, speed{-300.0, -310.0, -320.0}, inner{900.0, 10.0, 0.0},
      outer{950.0, 0.0, 30.0};
  const RollerLoads loads{angle.data(), speed.data(), inner.data(), outer.data(),
                          race_speeds(geometry(), 0.0, kBoreSpeed)};
  for (const Eigen::Index bins : {kBins, Eigen::Index{36}}) {
    DamageSums one(kBins), other(bins), alone(kBins), other_alone(bins);
    for (const double time : {1e-6, 3e-6}) {
      one.add(time, 3, loads, &other);
      alone.add(time, 3, loads);
      other_alone.add(time, 3, loads);
    }
    const auto equal = [](const RacePassages& a, const RacePassages& b) {
      return (a.way == b.way).all() && (a.load == b.load).all() && (a.power == b.power).all() &&
             a.rolling == b.rolling;
    };
    EXPECT_GT(one.outer.power.sum(), 0.0);
    EXPECT_TRUE(equal(one.inner, alone.inner) && equal(one.outer, alone.outer));
    EXPECT_TRUE(equal(other.inner, other_alone.inner) && equal(other.outer, other_alone.outer));
  }
}

TEST(Damage, OfPureRollingIsThatOfTheLoadsByPosition) {
  const Bearing bearing = test::reducer_bearing();
  const DamageSums sums = damage_at([](double) { return rolling_speed(); });
  const BearingLife expected = whole_contact_life(bearing, kLambda, loads(), loads());
  const BearingLife life = sums.life(bearing, kLambda);
  EXPECT_NEAR(life.inner, expected.inner, kRoundOff * expected.inner);
  EXPECT_NEAR(life.outer, expected.outer, kRoundOff * expected.outer);
  EXPECT_NEAR(life.bearing, expected.bearing, kRoundOff * expected.bearing);
  EXPECT_LT((sums.inner.mean_load() - loads()).abs().maxCoeff(), 1000.0 * kRoundOff);
}

// A cage ahead by a hundredth: a hundredth more rollers pass the pin; so many fewer pass the bore, which
// rotates the same way and faster.
TEST(Damage, GoesWithTheSpeedOfTheCage) {
  const Bearing bearing = test::reducer_bearing();
  const DamageSums sums = damage_at([](double) { return 1.01 * rolling_speed(); });
  const BearingLife rolling = whole_contact_life(bearing, kLambda, loads(), loads());
  const BearingLife life = sums.life(bearing, kLambda);
  EXPECT_NEAR(life.inner, rolling.inner / 1.01, kRoundOff * rolling.inner);
  const double passed = (kBoreSpeed - 1.01 * rolling_speed()) / (kBoreSpeed - rolling_speed());
  EXPECT_NEAR(life.outer, rolling.outer / passed, kRoundOff * rolling.outer);
}

// Rollers that are slower where they are loaded are closer there. As many pass each bin of the pin as any
// other; of the bore, more pass where they are slow. With speed = c (1 - e cos(angle)) a revolution takes 2
// pi / (c sqrt(1 - e^2)).
TEST(Damage, CountsRollersThatStandCloser) {
  constexpr double kUneven = 0.05;
  const double c = 1.02 * rolling_speed();
  const auto speed = [=](double angle) { return c * (1.0 - kUneven * std::cos(angle)); };
  const DamageSums sums = damage_at(speed);
  const double mean_speed = c * std::sqrt(1.0 - kUneven * kUneven);  // over time
  const double of_pin = mean_speed / rolling_speed();
  const Eigen::ArrayXd pin = sums.inner.passages();
  EXPECT_NEAR(pin.minCoeff(), of_pin, kRoundOff + 1e-8);  // midpoints of the steps
  EXPECT_NEAR(pin.maxCoeff(), of_pin, kRoundOff + 1e-8);
  const Eigen::ArrayXd fourth = loads().pow(4.0);
  EXPECT_LT((sums.inner.damage() - of_pin * fourth).abs().maxCoeff(), 1e-8 * fourth.maxCoeff());
  const Eigen::ArrayXd bore = sums.outer.passages();
  for (const Eigen::Index bin : {0, 9, 18, 36}) {
    const double at = speed(2.0 * M_PI * static_cast<double>(bin) / kBins);
    const double expected = (kBoreSpeed / at - 1.0) * mean_speed / (kBoreSpeed - rolling_speed());
    EXPECT_NEAR(bore[bin], expected, 1e-4 * expected) << "mean over a bin for its middle";
  }
  const double all = (kBoreSpeed - mean_speed) / (kBoreSpeed - rolling_speed());
  EXPECT_NEAR(bore.mean(), all, 1e-8);
}

// A bearing of `n` laminae whose rollers are stationary at their bins for equal times, under a load that the
// damping has doubled.
DamageSums lamina_damage(const LaminaRaces& races, Eigen::Index n, double end_displacement) {
  DamageSums sums(kBins, n);
  const RaceSpeeds speeds = race_speeds(geometry(), 0.0, kBoreSpeed);
  for (Eigen::Index bin = 0; bin < kBins; ++bin) {
    const double angle = 2.0 * M_PI * static_cast<double>(bin) / kBins, orbital = rolling_speed();
    const double inner = 1e-9 * load_at(bin), outer = 0.9 * inner;  // [m]
    const double inner_load = 2.0 * races.inner().evaluate(inner, -end_displacement).load;
    const double outer_end_displacement =
        races.bore_end_displacement().dot(Vector2(std::cos(angle), std::sin(angle)));
    const double outer_load =
        2.0 * races.outer().evaluate(outer, end_displacement - outer_end_displacement).load;
    sums.add(1.0, 1,
             {&angle, &orbital, &inner_load, &outer_load, speeds, &races, &inner, &outer, &end_displacement});
  }
  return sums;
}

laminae::LaminaContact contact(double crown, int n) {
  constexpr double kLength = 5.7e-3;  // [m]
  const std::vector<double> drops =
      laminae::lamina_drops(profile::CircularCrown{kLength, crown}, profile::Straight{}, kLength, n);
  return {LineContact(1.2e10), kLength, drops};
}

// Laminae with equal loads have the life of the whole contact, whatever their number.
TEST(LaminaDamage, OfEvenLoadsIsThatOfTheWholeContact) {
  Bearing bearing = test::reducer_bearing();
  for (const int n : {1, 7, 40}) {
    bearing.rollers().laminae = n;
    const LaminaRaces races(contact(0.0, n), contact(0.0, n), Vector2::Zero());
    EXPECT_TRUE(races.even());
    EXPECT_EQ(uneven_laminae(&races), 0);
    const BearingLife cut = lamina_damage(races, n, 0.0).life(bearing, kLambda);
    const BearingLife whole = lamina_damage(races, 0, 0.0).life(bearing, kLambda);
    EXPECT_NEAR(cut.inner, whole.inner, kRoundOff * whole.inner);
    EXPECT_NEAR(cut.outer, whole.outer, kRoundOff * whole.outer);
    EXPECT_NEAR(cut.bearing, whole.bearing, kRoundOff * whole.bearing);
  }
}

// Against the sums written out: stationary pin 4.5, rotating bore 4, q_c = Q_c n^(-7/9), and the damping on
// all laminae equally.
TEST(LaminaDamage, OfCrownedTiltedRollersIsTheSumOverLaminae) {
  constexpr int kLaminae = 12;
  Bearing bearing = test::reducer_bearing();
  bearing.rollers().laminae = kLaminae;
  const Vector2 tilt(0.4e-3, -0.3e-3);
  const LaminaRaces races(contact(0.6e-6, kLaminae), contact(0.6e-6, kLaminae), tilt);
  EXPECT_EQ(uneven_laminae(&races), kLaminae);
  constexpr double kEndDisplacement = 0.2e-6;  // [m]
  Eigen::ArrayXd inner = Eigen::ArrayXd::Zero(kLaminae), outer = inner, pin = inner, bore = inner;
  double largest = 0.0;
  for (Eigen::Index bin = 0; bin < kBins; ++bin) {
    const double angle = 2.0 * M_PI * static_cast<double>(bin) / kBins;
    const double outer_end_displacement =
        0.5 * 5.7e-3 * (tilt.x() * std::cos(angle) + tilt.y() * std::sin(angle));
    const double approach = 1e-9 * load_at(bin);
    const Eigen::ArrayXd on_inner = 2.0 * races.inner().loads(approach, -kEndDisplacement);
    const Eigen::ArrayXd on_outer =
        2.0 * races.outer().loads(0.9 * approach, kEndDisplacement - outer_end_displacement);
    inner += on_inner.pow(4.5) / kBins;
    outer += on_outer.pow(4.0) / kBins;
    pin += on_inner.pow(4.0) / kBins;
    bore += on_outer.pow(4.5) / kBins;
    largest = std::max(largest, on_inner.maxCoeff());
  }
  const double share = std::pow(kLaminae, -7.0 / 9.0);
  const double inner_capacity = share * contact_capacity(bearing, Race::inner, kLambda);
  const double outer_capacity = share * contact_capacity(bearing, Race::outer, kLambda);
  const double on_pin = (inner / std::pow(inner_capacity, 4.5)).sum();
  const double on_bore = (outer.pow(4.5 / 4.0) / std::pow(outer_capacity, 4.5)).sum();
  const DamageSums sums = lamina_damage(races, kLaminae, kEndDisplacement);
  const BearingLife life = sums.life(bearing, kLambda);
  EXPECT_NEAR(life.inner, 1e6 * std::pow(on_pin, -8.0 / 9.0), kRoundOff * life.inner);
  EXPECT_NEAR(life.outer, 1e6 * std::pow(on_bore, -8.0 / 9.0), kRoundOff * life.outer);
  EXPECT_NEAR(sums.inner.lamina_largest, largest, kRoundOff * largest);
  EXPECT_NE(life.inner, lamina_damage(races, 0, kEndDisplacement).life(bearing, kLambda).inner);
  // If the pin rotates under a load that is stationary relative to the bore, the exponents change races;
  // nothing else does.
  bearing.motions = rating::rotating(Race::inner);
  const BearingLife swapped = sums.life(bearing, kLambda);
  const double rotating_pin = (pin.pow(4.5 / 4.0) / std::pow(inner_capacity, 4.5)).sum();
  const double stationary_bore = (bore / std::pow(outer_capacity, 4.5)).sum();
  EXPECT_NEAR(swapped.inner, 1e6 * std::pow(rotating_pin, -8.0 / 9.0), kRoundOff * swapped.inner);
  EXPECT_NEAR(swapped.outer, 1e6 * std::pow(stationary_bore, -8.0 / 9.0), kRoundOff * swapped.outer);
}

TEST(Damage, NeedsLoadsAndSpeed) {
  const Bearing bearing = test::reducer_bearing();
  EXPECT_TRUE(std::isinf(DamageSums(kBins).life(bearing, kLambda).bearing));
  DamageSums stationary(kBins);
  const double angle = 0.0, orbital = 0.0, load = 100.0;
  stationary.add(1.0, 1, {&angle, &orbital, &load, &load, {}});
  EXPECT_TRUE(std::isinf(stationary.life(bearing, kLambda).bearing));
}

}  // namespace
}  // namespace orbearing::bearing::motion::damage_test
