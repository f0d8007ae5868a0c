#include "bearing/equilibrium/roller_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::roller_balance_test {
namespace {

constexpr double kSolverRoundOff =
    1e-10;  // Newton ends at round-off of the load; the approach of two may cancel
constexpr double kDifferenceError = 1e-6;  // central difference over solver results, relative

LineContact elastic() {
  return roller_race_contact(ContactLaw::palmgren, 5.7e-3);
}

RaceContact dry() {
  return {elastic(), Film()};
}

RaceContact oiled() {
  const FilmContact contact{.equivalent_radius = 2.3e-3,
                            .length = 5.7e-3,
                            .reduced_modulus = 2.26e11,
                            .lubricant = {.viscosity = 0.01, .pressure_viscosity = 1.5e-8}};
  return {elastic(), Film(contact, 6.0)};
}

TEST(RollerBalance, MasslessRollerSharesTheApproachEvenly) {
  const RollerBalance roller = balance_roller(dry(), dry(), 0.0, 10e-6);
  EXPECT_NEAR(roller.inner_load, elastic().load(5e-6), elastic().load(5e-6) * kSolverRoundOff);
  EXPECT_EQ(roller.inner_load, roller.outer_load);
  EXPECT_NEAR(roller.stiffness, 0.5 * elastic().stiffness(5e-6), roller.stiffness * kSolverRoundOff);
}

TEST(RollerBalance, LoadsDifferByTheInertialLoadAndFillTheApproach) {
  for (const double inertial : {-300.0, -1e-3, 0.0, 1e-3, 300.0}) {
    for (const double approach : {6e-6, 20e-6, 300e-6}) {
      for (const RaceContact& contact : {dry(), oiled()}) {
        const RollerBalance roller = balance_roller(contact, contact, inertial, approach);
        EXPECT_NEAR(roller.outer_load - roller.inner_load, inertial, roller.outer_load * kSolverRoundOff);
        const double filled = contact.approach(roller.inner_load) + contact.approach(roller.outer_load);
        EXPECT_NEAR(filled, approach, approach * kSolverRoundOff);
      }
    }
  }
}

TEST(RollerBalance, UnsqueezedRollerRestsWhereItsInertialLoadPoints) {
  for (const RaceContact& contact : {dry(), oiled()}) {
    const RollerBalance outside = balance_roller(contact, contact, 4.0, -20e-6);
    EXPECT_EQ(outside.outer_load, 4.0);
    EXPECT_EQ(outside.inner_load, 0.0);
    EXPECT_EQ(outside.stiffness, 0.0);
    const RollerBalance inside = balance_roller(contact, contact, -4.0, -20e-6);
    EXPECT_EQ(inside.outer_load, 0.0);
    EXPECT_EQ(inside.inner_load, 4.0);
  }
}

// A roller under centrifugal load on the bore deforms it: the races may come closer by that before the pin is
// loaded.
TEST(RollerBalance, SqueezeBeginsContinuouslyBeyondTheInertialApproach) {
  const double element_depth = elastic().approach(4.0);
  EXPECT_EQ(balance_roller(dry(), dry(), 4.0, 0.999 * element_depth).inner_load, 0.0);
  EXPECT_GT(balance_roller(dry(), dry(), 4.0, 1.001 * element_depth).inner_load, 0.0);
  EXPECT_LT(balance_roller(dry(), dry(), 4.0, 1.001 * element_depth).inner_load, 0.01 * 4.0);
}

TEST(RollerBalance, FilmCarriesBeforeTheSurfacesMeet) {
  const double both_caps = 2.0 * oiled().onset();
  EXPECT_LT(both_caps, 0.0);
  EXPECT_EQ(balance_roller(oiled(), oiled(), 0.0, 1.01 * both_caps).outer_load, 0.0);
  EXPECT_GT(balance_roller(oiled(), oiled(), 0.0, 0.99 * both_caps).outer_load, 0.0);
}

TEST(RollerBalance, StiffnessIsTheSlopeOfTheOuterLoad) {
  for (const double inertial : {-50.0, 0.0, 50.0}) {
    for (const RaceContact& contact : {dry(), oiled()}) {
      const double approach = 25e-6;
      const double step = 1e-4 * approach;
      const auto load = [&](double at) { return balance_roller(contact, contact, inertial, at).outer_load; };
      const double slope = (load(approach + step) - load(approach - step)) / (2.0 * step);
      EXPECT_NEAR(balance_roller(contact, contact, inertial, approach).stiffness, slope,
                  slope * kDifferenceError);
    }
  }
}

}  // namespace
}  // namespace orbearing::bearing::roller_balance_test
