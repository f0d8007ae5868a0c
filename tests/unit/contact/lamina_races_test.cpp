// Rollers in motion whose contacts are cut into laminae: limits, and forces against differences of the
// energy.
#include "bearing/contact/lamina_races.hpp"

#include <gtest/gtest.h>

#include "bearing/motion/snapshot.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::lamina_races_test {
namespace {

constexpr double kLength = 20e-3;  // [m]

laminae::LaminaContact contact(double crown, int n) {
  const std::vector<double> drops =
      laminae::lamina_drops(profile::CircularCrown{kLength, crown}, profile::Straight{}, kLength, n);
  return {LineContact(1.2e10), kLength, drops};
}

TEST(LaminaRaces, StraightRollersHaveTheLoadsOfTheLineContact) {
  Bearing bearing = test::reducer_bearing();
  const OperatingPoint point = test::reducer_point(6000.0);
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.race.film_in_approach = true;
  const BearingModel line = bearing_model(bearing, point, parameters);
  bearing.rollers().laminae = 17;
  const BearingModel cut = bearing_model(bearing, point, parameters);
  test::Random random;
  for (int i = 0; i < 10; ++i) {
    const Eigen::VectorXd x = test::shaken_state(line, bearing, parameters, 5e-6, 0.05, random);
    const Snapshot expected = snapshot(line, x), found = snapshot(cut, x);
    EXPECT_LT((found.inner.load - expected.inner.load).abs().maxCoeff(),
              1e-12 * expected.inner.load.maxCoeff());
    EXPECT_LT((found.outer.load - expected.outer.load).abs().maxCoeff(),
              1e-12 * expected.outer.load.maxCoeff());
  }
}

TEST(LaminaRaces, LoadsAreSlopesOfTheEnergy) {
  const LaminaRaces races(contact(6e-6, 31), contact(3e-6, 31), Vector2(1.5e-3, 0.0));
  const Vector2 outward = Vector2(0.8, 0.6);
  const double h = 1e-10;
  for (const double inner : {-2e-6, 1e-6, 6e-6}) {
    for (const double outer : {-1e-6, 2e-6, 9e-6}) {
      for (const double end_displacement : {-3e-6, 0.0, 4e-6}) {
        const LaminaRaceLoads loads = races.loads({inner, outer, end_displacement}, outward);
        const auto energy = [&](double in, double out, double t) {
          return races.energy({inner + in, outer + out, end_displacement + t}, outward);
        };
        const double scale = 1.0 + loads.inner + loads.outer;
        EXPECT_NEAR((energy(h, 0, 0) - energy(-h, 0, 0)) / (2 * h), loads.inner, 1e-6 * scale);
        EXPECT_NEAR((energy(0, h, 0) - energy(0, -h, 0)) / (2 * h), loads.outer, 1e-6 * scale);
        EXPECT_NEAR((energy(0, 0, h) - energy(0, 0, -h)) / (2 * h), -loads.excess, 1e-6 * scale);
      }
    }
  }
}

// The tilt is a variable of the motion, and where no moment tilts the roller any more both contacts are in
// equilibrium.
TEST(LaminaRaces, NothingTurnsARollerWhereBothContactsBalance) {
  const LaminaRaces races(contact(6e-6, 31), contact(3e-6, 31), Vector2(1.5e-3, 0.0));
  const Vector2 outward = Vector2(0.8, 0.6);
  for (const double inner : {1e-6, 6e-6})
    for (const double outer : {2e-6, 9e-6}) {
      const double end_displacement = races.balanced_end_displacement(inner, outer, outward);
      const LaminaRaceLoads loads = races.loads({inner, outer, end_displacement}, outward);
      EXPECT_LT(std::abs(loads.excess), 1e-12 * (loads.inner + loads.outer));
      EXPECT_GT(races.loads({inner, outer, end_displacement - 1e-7}, outward).excess, 0.0);
      EXPECT_LT(races.loads({inner, outer, end_displacement + 1e-7}, outward).excess, 0.0);
    }
}

TEST(LaminaRaces, ARollerBetweenLikeContactsStandsHalfway) {
  const LaminaRaces races(contact(5e-6, 24), contact(5e-6, 24), Vector2(1e-3, 0.0));
  const double bore_end_displacement = 1e-3 * kLength / 2;
  EXPECT_NEAR(races.balanced_end_displacement(8e-6, 8e-6, Vector2(1.0, 0.0)), 0.5 * bore_end_displacement,
              1e-9 * bore_end_displacement);
  EXPECT_NEAR(races.balanced_end_displacement(8e-6, 8e-6, Vector2(-1.0, 0.0)), -0.5 * bore_end_displacement,
              1e-9 * bore_end_displacement);
  EXPECT_NEAR(races.balanced_end_displacement(8e-6, 8e-6, Vector2(0.0, 1.0)), 0.0,
              1e-9 * bore_end_displacement);
  EXPECT_FALSE(races.upright());
  EXPECT_TRUE(LaminaRaces(contact(5e-6, 24), contact(1e-6, 24), Vector2::Zero()).upright());
}

TEST(LaminaRaces, ARollerInOneContactFollowsThatRace) {
  const LaminaRaces races(contact(5e-6, 24), contact(5e-6, 24), Vector2(1e-3, 0.0));
  const double bore_end_displacement = 1e-3 * kLength / 2;
  EXPECT_NEAR(races.balanced_end_displacement(-30e-6, 8e-6, Vector2(1.0, 0.0)), bore_end_displacement,
              1e-9 * bore_end_displacement);
  EXPECT_NEAR(races.balanced_end_displacement(8e-6, -30e-6, Vector2(1.0, 0.0)), 0.0,
              1e-9 * bore_end_displacement);
}

}  // namespace
}  // namespace orbearing::bearing::motion::lamina_races_test
