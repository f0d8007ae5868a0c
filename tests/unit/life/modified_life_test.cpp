// Issue 16, Build 5: a_ISO lamina by lamina, on the loads of any fidelity.
#include "bearing/life/modified_life.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/units.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::rating::modified_life_test {
namespace {

constexpr double kLambda = 0.83;
constexpr double kRoundOff = 1e-12;

Eigen::ArrayXd load_zone(Eigen::Index places) {
  return (1400.0 * Eigen::ArrayXd::LinSpaced(places, -3.0, 3.0).cos() - 300.0).cwiseMax(0.0);
}

motion::RaceDamage whole(double share = 1.0) {
  return {.whole = (share * load_zone(24)).pow(4), .laminae = {}};
}

// The same loads, spread over the laminae by `shares` that add up to 1.
motion::RaceDamage cut(const Eigen::ArrayXd& shares) {
  return {.whole = whole().whole,
          .laminae = (shares.matrix() * load_zone(24).matrix().transpose()).array().pow(4)};
}

double plain_life(const Bearing& bearing, const motion::RaceDamage& inner, const motion::RaceDamage& outer) {
  return motion::life_under(bearing, kLambda, inner, outer).bearing;
}

// By hand: P = C_r/0.83 (L10r/1e6)^(-1/4), L10r from loads that lie evenly on every roller.
TEST(ModifiedLife, OfWholeContactsIsThePlainOneTimesAIso) {
  const Bearing bearing = example_bearings::planet_bearing();
  const Ratings ratings = ratings_of(bearing);
  const OilCondition oil{.viscosity_ratio = 0.7, .contamination_factor = 0.4};
  const auto modified = modified_life(bearing, kLambda, ratings, oil, whole(), whole(1.1));
  ASSERT_TRUE(modified);
  const double turning = std::pow(whole(1.1).whole.mean(), 0.25);
  const double standing = std::pow(whole().whole.pow(1.125).mean(), 1.0 / 4.5);
  const double l10r = std::pow(
      std::pow(standing / ratings.contacts.inner, 4.5) + std::pow(turning / ratings.contacts.outer, 4.5),
      -8.0 / 9.0);
  const double load = ratings.dynamic_capacity / 0.83 * std::pow(l10r, -0.25);
  EXPECT_NEAR(modified->load, load, load * 1e-10);
  const double factor = life_modification_factor(
      RollingElement::roller, 0.7, oil.contamination_factor * ratings.fatigue_load_limit / load);
  EXPECT_NEAR(modified->factor, factor, factor * kRoundOff);
  const double plain = plain_life(bearing, whole(), whole(1.1));
  EXPECT_NEAR(modified->life.bearing, factor * plain, factor * plain * 1e-10);
}

// A bearing without clearance at rest: P is the load on it. (Sums over fifteen rollers and rounded constants
// of the standard: some per cent.)
TEST(ModifiedLife, LoadIsThatOnTheBearing) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.radial_clearance = 0.0;
  bearing.motions = {};  // the inner race turns, as in the standard
  for (const double force : {200.0, 1000.0, 5000.0}) {
    const QuasiStaticResult loads =
        quasi_static_bearing(bearing, example_bearings::static_load(force, 0.5), {});
    ASSERT_TRUE(loads.report.converged);
    const auto modified = modified_life(bearing, kLambda, ratings_of(bearing), {1.0, 0.5},
                                        {loads.inner_load.pow(4), {}}, {loads.outer_load.pow(4), {}});
    EXPECT_NEAR(modified->load, force, 0.05 * force);
  }
}

TEST(ModifiedLife, EqualLaminaeChangeNothing) {
  Bearing bearing = example_bearings::planet_bearing();
  const Ratings ratings = ratings_of(bearing);
  const OilCondition oil{.viscosity_ratio = 1.5, .contamination_factor = 0.5};
  const double once = modified_life(bearing, kLambda, ratings, oil, whole(), whole())->factor;
  bearing.rollers().laminae = 30;
  const auto even = cut(Eigen::ArrayXd::Constant(30, 1.0 / 30.0));
  EXPECT_NEAR(modified_life(bearing, kLambda, ratings, oil, even, even)->factor, once, once * 1e-10);
}

// Edges that are loaded more have the smaller a_ISO and the larger share: less than the factor of the mean
// load.
TEST(ModifiedLife, LoadedEdgesLowerIt) {
  Bearing bearing = example_bearings::planet_bearing();
  bearing.rollers().laminae = 10;
  const Ratings ratings = ratings_of(bearing);
  const OilCondition oil{.viscosity_ratio = 2.0, .contamination_factor = 0.6};
  const Eigen::ArrayXd slope = Eigen::ArrayXd::LinSpaced(10, 0.02, 0.18);
  const Eigen::ArrayXd level = Eigen::ArrayXd::Constant(10, 0.1);
  const auto tilted = modified_life(bearing, kLambda, ratings, oil, cut(slope), cut(slope));
  const auto even = modified_life(bearing, kLambda, ratings, oil, cut(level), cut(level));
  EXPECT_LT(tilted->factor, 0.9 * even->factor);
  const double plain = plain_life(bearing, cut(slope), cut(slope));
  EXPECT_NEAR(tilted->life.bearing, tilted->factor * plain, tilted->life.bearing * 1e-9);
  // Races add up to the bearing.
  const double together = combined_life(tilted->life.inner, tilted->life.outer);
  EXPECT_NEAR(tilted->life.bearing, together, together * 1e-10);
}

TEST(ModifiedLife, LimitsOfFilmDirtAndLoad) {
  const Bearing bearing = example_bearings::planet_bearing();
  const Ratings ratings = ratings_of(bearing);
  const auto factor = [&](double kappa, double e_c, double share) {
    return modified_life(bearing, kLambda, ratings, {kappa, e_c}, whole(share), whole(share));
  };
  EXPECT_FALSE(factor(0.099, 0.5, 1.0));                     // where the standard begins
  EXPECT_NEAR(factor(1.0, 0.0, 1.0)->factor, 0.1, 1e-12);    // dirt without end
  EXPECT_NEAR(factor(4.0, 1.0, 1e-3)->factor, 50.0, 1e-12);  // below the fatigue limit
  EXPECT_EQ(factor(4.0, 1.0, 0.0)->factor, 50.0);            // no load
  EXPECT_EQ(factor(4.0, 1.0, 0.0)->life.bearing, kInfinity);
  EXPECT_LT(factor(0.4, 0.5, 1.0)->factor, factor(1.0, 0.5, 1.0)->factor);
  EXPECT_LT(factor(1.0, 0.5, 2.0)->factor, factor(1.0, 0.5, 1.0)->factor);
}

TEST(OilCondition, ByItsFilmAndByItsSpeed) {
  EXPECT_NEAR(viscosity_ratio_of_film(0.4e-6, 0.2e-6), std::pow(2.0, 1.3), kRoundOff);
  const OilCondition by_speed =
      oil_condition({.kinematic_viscosity = 20e-6}, 261.8, 81e-3);  // 2500 rpm: 10 mm^2/s
  EXPECT_NEAR(by_speed.viscosity_ratio, 2.0, 1e-4);
  EXPECT_EQ(
      by_speed.contamination_factor,
      contamination_factor(Lubrication::circulating_oil, Cleanliness::high, by_speed.viscosity_ratio, 81e-3));
  const OilCondition stated =
      oil_condition({.viscosity_ratio = 0.6, .contamination_factor = 0.3}, 0.0, 81e-3);
  EXPECT_EQ(stated.viscosity_ratio, 0.6);
  EXPECT_EQ(stated.contamination_factor, 0.3);
}

}  // namespace
}  // namespace orbearing::bearing::rating::modified_life_test
