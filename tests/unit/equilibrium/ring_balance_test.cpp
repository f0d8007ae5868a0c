// Forces of static bearings have an energy; equilibria exist for any load.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/equilibrium/rollers.hpp"
#include "mechanics/constants.hpp"
#include "tests/messages.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::equilibrium::ring_balance_test {
namespace {

constexpr double kMicrometre = 1e-6;

Bearing rollers() {
  Bearing in;
  in.rollers() = {.count = 11,
                  .diameter = 5.24e-3,
                  .length = 5.7e-3,
                  .laminae = 12,
                  .profile = profile::CircularCrown{5.7e-3, 4e-6}};
  in.pitch_diameter = 36e-3;
  in.radial_clearance = 8e-6;
  return in;
}

Bearing balls(double contact_angle, double clearance) {
  return {.elements = Balls{.count = 8, .diameter = 11.5e-3, .contact_angle = contact_angle},
          .pitch_diameter = 43.5e-3,
          .radial_clearance = clearance};
}

// The stiffness is the slope of the forces, by central differences, whose error is that of step^2 beside the
// curvature of the contacts' laws; and it is symmetric, so that the forces have an energy.
template <class Row>
void expect_slopes(const Row& row, const RingPosition& position) {
  constexpr double step = 1e-3 * kMicrometre;
  constexpr double truncation = 1e-5, round_off = 1e-14;
  const RingImbalance now = row_forces(row, position);
  EXPECT_LT((now.stiffness - now.stiffness.transpose()).norm(), round_off * now.stiffness.norm());
  for (int i = 0; i < 5; ++i) {
    const RingPosition change = RingPosition::Unit(i) * step;
    const RingPosition slope =
        (row_forces(row, position - change).force - row_forces(row, position + change).force) / (2.0 * step);
    EXPECT_LT((slope - now.stiffness.col(i)).norm(), truncation * now.stiffness.norm());
  }
}

TEST(StaticRollers, ForcesHaveAnEnergy) {
  const RingPosition position = (RingPosition() << 15.0, -4.0, 2.0, 3.0, 2.0).finished() * kMicrometre;
  Bearing bearing = rollers();
  bearing.first_element = 0.2;
  expect_slopes(RollerRow(bearing), position);
}

TEST(StaticBalls, ForcesHaveAnEnergy) {
  Bearing bearing = balls(0.3, 0.0);
  bearing.first_element = 0.2;
  const RingPosition position = (RingPosition() << 12.0, -5.0, 30.0, 14.0, -9.0).finished() * kMicrometre;
  expect_slopes(BallRow(bearing), position);
}

// The groove centres of the inner ring lie on a circle of R_i = d_m/2 + (r_i - D/2) cos(a), so a tilt moves
// them along z by R_i psi cos(phi). With that arm, the displacement and the loads that are reported, the
// moment is the slope of the potential U(psi) - F_r u(psi) - F_a w(psi), whose slopes by u and w vanish.
TEST(StaticBalls, MomentIsTheSlopeOfTheEnergyByTheTiltAtTheGrooveCircle) {
  for (const double nominal : {0.0, 0.5}) {
    const Bearing bearing = balls(nominal, nominal > 0.0 ? 0.0 : 10e-6);
    const double diameter = bearing.balls().diameter, cosine = std::cos(nominal);
    const double distance = (bearing.inner.osculation + bearing.outer.osculation - 1.0) * diameter;
    const double arm = 0.5 * bearing.pitch_diameter + (bearing.inner.osculation - 0.5) * diameter * cosine;
    const RingLoad load{.radial = 800.0, .axial = 1500.0};
    const auto potential = [&](double tilt) {
      RingLoad held = load;
      held.tilt = tilt;
      const RingState state = balance_ring(BallRow(bearing), held);
      EXPECT_TRUE(state.report.converged);
      double energy = -load.radial * state.radial - load.axial * state.axial;
      for (Eigen::Index j = 0; j < state.contact_load.size(); ++j) {
        const double angle = constants::two_pi * static_cast<double>(j) / 8.0;
        const double radial = distance * cosine - 0.5 * bearing.radial_clearance +
                              state.radial * std::cos(angle) + state.lateral * std::sin(angle);
        const double axial = distance * std::sin(nominal) + state.axial + arm * tilt * std::cos(angle) +
                             arm * state.lateral_tilt * std::sin(angle);
        const double approach = std::hypot(radial, axial) - distance;
        energy += 0.4 * state.contact_load[j] * std::max(approach, 0.0);  // U = 2/5 Q delta
      }
      return energy;
    };
    constexpr double tilt = -0.8e-3, step = 2e-5;
    RingLoad held = load;
    held.tilt = tilt;
    const double moment = balance_ring(BallRow(bearing), held).moment;
    ASSERT_GT(std::abs(moment), 0.1);
    const double slope = (potential(tilt + step) - potential(tilt - step)) / (2.0 * step);
    EXPECT_NEAR(slope / moment, 1.0, 1e-3) << nominal;  // d_m/2 would be off by 1 % of the ball's part
  }
}

// One lamina, no clearance: c_L (u cos phi)^(10/9) on the loaded half, summed by hand for four rollers of
// which one alone is loaded (two are at a right angle).
TEST(StaticRollers, FourRollersByHand) {
  Bearing in = rollers();
  in.rollers().count = 4;
  in.radial_clearance = 20e-6;
  in.contact_law = ContactLaw::iso16281;
  in.rollers().profile = profile::Straight{};
  in.rollers().laminae = 1;
  const RingState state = balance_ring(RollerRow(in), {.radial = 1000.0});
  const double approach = 1e-3 * std::pow(1000.0 / (35948.0 * std::pow(5.7, 8.0 / 9.0)), 0.9);
  EXPECT_NEAR(state.radial, 10e-6 + approach, 1e-12);
  EXPECT_NEAR(state.contact_load[0], 1000.0, 1e-8);
  EXPECT_NEAR(state.contact_load[1] + state.contact_load[2] + state.contact_load[3], 0.0, 1e-8);
}

TEST(StaticRollers, GivenTiltNeedsTheMomentThatGivesIt) {
  const RingState held = balance_ring(RollerRow(rollers()), {.radial = 2000.0, .tilt = 1e-3});
  ASSERT_TRUE(held.report.converged);
  EXPECT_GT(held.moment, 0.0);
  const RingState free = balance_ring(RollerRow(rollers()), {.radial = 2000.0, .moment = held.moment});
  ASSERT_TRUE(free.report.converged);
  EXPECT_NEAR(free.tilt, 1e-3, 1e-10);
  EXPECT_NEAR(free.radial, held.radial, 1e-13);
  // laminae at negative x carry more on the loaded side
  EXPECT_GT(held.lamina_load(0, 0), held.lamina_load(11, 0));
  const RingState mirrored = balance_ring(RollerRow(rollers()), {.radial = 2000.0, .tilt = -1e-3});
  EXPECT_NEAR(mirrored.lamina_load(11, 0), held.lamina_load(0, 0), 1e-8);
}

TEST(StaticBalls, GivenTiltNeedsTheMomentThatGivesIt) {
  const RingState held =
      balance_ring(BallRow(balls(0.0, 10e-6)), {.radial = 2000.0, .axial = 700.0, .tilt = 5e-4});
  ASSERT_TRUE(held.report.converged);
  const RingState free =
      balance_ring(BallRow(balls(0.0, 10e-6)), {.radial = 2000.0, .axial = 700.0, .moment = held.moment});
  ASSERT_TRUE(free.report.converged);
  EXPECT_NEAR(free.tilt, 5e-4, 1e-9);
  EXPECT_NEAR(free.axial, held.axial, 1e-11);
}

// Straight rollers without tilt share a load like the uncut ones of the planet bearing, for either law.
TEST(StaticRollers, AreTheQuasiStaticBearingWhereNothingTilts) {
  for (const ContactLaw law : {ContactLaw::palmgren, ContactLaw::iso16281}) {
    Bearing in = rollers();
    in.rollers().profile = profile::Straight{};
    in.contact_law = law;
    const RingState cut = balance_ring(RollerRow(in), {.radial = 1500.0});
    in.rollers().laminae = 0;
    const QuasiStaticState uncut =
        quasi_static_state(in, bearing::example_bearings::static_load(-1500.0), {}, 0.0);
    EXPECT_LT((cut.contact_load - uncut.outer_load).abs().maxCoeff(), 1e-8);
  }
}

// A relief on a race acts once, that of the rollers twice: once at either race.
TEST(StaticRollers, ProfilesOfRollersAndRacesAddUp) {
  Bearing on_rollers = rollers(), on_races = rollers();
  on_races.rollers().profile = profile::Straight{};
  on_races.inner.profile = on_races.outer.profile = on_rollers.rollers().profile;
  const RingState one = balance_ring(RollerRow(on_rollers), {.radial = 2000.0, .tilt = 5e-4});
  const RingState other = balance_ring(RollerRow(on_races), {.radial = 2000.0, .tilt = 5e-4});
  EXPECT_LT((one.lamina_load - other.lamina_load).abs().maxCoeff(), 1e-9);
}

// A sin a is the closed form of a ring under axial load alone: Z Q sin a = F with Q = c (A (cos a0/cos a -
// 1))^1.5.
TEST(StaticBalls, AxialLoadAlone) {
  for (const double nominal : {0.0, 0.26, 0.7}) {
    const Bearing bearing = balls(nominal, nominal > 0.0 ? 0.0 : 15e-6);
    const BallRow row(bearing);
    const RingState state = balance_ring(row, {.axial = 1500.0});
    ASSERT_TRUE(state.report.converged);
    const double angle = state.contact_angle[0];
    const double approach = row.radial_distance() / std::cos(angle) - row.groove_distance();
    EXPECT_NEAR(8.0 * row.constant() * std::pow(approach, 1.5) * std::sin(angle), 1500.0, 1e-6);
    EXPECT_NEAR(state.axial, row.radial_distance() * std::tan(angle) - row.axial_distance(), 1e-12);
    EXPECT_NEAR(state.contact_load.maxCoeff(), state.contact_load.minCoeff(), 1e-6);
  }
}

TEST(StaticBalls, LoadsOfAnySizeAndDirectionBalance) {
  std::mt19937 random(20250611);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    Bearing bearing = balls(i % 3 == 0 ? 0.8 * unit(random) : 0.0, 60e-6 * unit(random) - 15e-6);
    bearing.balls().count = 3 + i % 20;
    RingLoad load{.radial = unit(random) < 0.2 ? 0.0 : std::pow(10.0, 5.0 * unit(random) - 1.0),
                  .axial = unit(random) < 0.2 ? 0.0 : std::pow(10.0, 5.0 * unit(random) - 1.0)};
    if (unit(random) < 0.3) load.moment = 0.02 * (load.radial + load.axial) * (unit(random) - 0.5);
    if (unit(random) < 0.2) load.tilt = 2e-3 * (unit(random) - 0.5);
    const RingState state = balance_ring(BallRow(bearing), load);
    EXPECT_TRUE(state.report.converged) << state.report.residual << " after " << state.report.iterations;
  }
}

TEST(StaticRollers, LoadsOfAnySizeAndTiltBalance) {
  std::mt19937 random(20250612);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Bearing in = rollers();
    in.rollers().laminae = 1 + i % 60;
    in.rollers().count = 3 + i % 25;
    in.radial_clearance = 100e-6 * unit(random) - 20e-6;
    if (i % 4 == 0) in.rollers().profile = profile::Iso16281{5.7e-3, 5.24e-3};
    RingLoad load{.radial = std::pow(10.0, 6.0 * unit(random) - 1.0)};
    // a single lamina has no arm to hold a moment
    if (in.rollers().laminae > 1 && unit(random) < 0.3)
      load.moment = 0.01 * load.radial * (unit(random) - 0.5);
    if (unit(random) < 0.3) load.tilt = 10e-3 * (unit(random) - 0.5);
    const RingState state = balance_ring(RollerRow(in), load);
    EXPECT_TRUE(state.report.converged) << state.report.residual << " after " << state.report.iterations;
  }
}

TEST(StaticRollers, MomentOnASingleLaminaFindsNoBalanceAndSaysSo) {
  Bearing in = rollers();
  in.rollers().laminae = 1;
  const RingState state = balance_ring(RollerRow(in), {.radial = 1000.0, .moment = 1.0});
  EXPECT_FALSE(state.report.converged);
  EXPECT_SAID("single lamina", state.report.message);
}

// Turning the row by a pitch changes nothing; turning the moment with the plane it acts in turns the tilts.
TEST(StaticBalls, AFullPitchOfTheFirstElementChangesNothing) {
  const RingLoad load{.radial = 2000.0, .axial = 700.0, .moment = 3.0, .moment_across = -5.0};
  Bearing turned = balls(0.26, 0.0);
  turned.first_element = 2.0 * constants::two_pi / turned.balls().count;
  const RingState one = balance_ring(BallRow(balls(0.26, 0.0)), load);
  const RingState other = balance_ring(BallRow(turned), load);
  ASSERT_TRUE(one.report.converged && other.report.converged);
  EXPECT_NEAR(one.radial, other.radial, 1e-12);
  EXPECT_NEAR(one.lateral_tilt, other.lateral_tilt, 1e-12);
  EXPECT_NEAR(one.contact_load[2], other.contact_load[0], 1e-6);
}

// Eight balls are equal in both planes, so without a radial load the tilts under both moments are equal.
TEST(StaticBalls, AMomentAcrossTiltsAcross) {
  const RingState along = balance_ring(BallRow(balls(0.0, 0.0)), {.axial = 900.0, .moment = 4.0});
  const RingState across = balance_ring(BallRow(balls(0.0, 0.0)), {.axial = 900.0, .moment_across = 4.0});
  ASSERT_TRUE(along.report.converged && across.report.converged);
  EXPECT_GT(along.tilt, 0.0);
  EXPECT_NEAR(across.lateral_tilt, along.tilt, 1e-12);
  EXPECT_NEAR(across.tilt, 0.0, 1e-12);
}

// The plane of the radial load is a mirror: a moment across it that changes its sign changes sides.
TEST(StaticRollers, AMomentAcrossTheRadialLoadIsMirrored) {
  const RingLoad load{.radial = 2000.0, .moment_across = 0.5};
  const RingState one = balance_ring(RollerRow(rollers()), load);
  const RingState other = balance_ring(RollerRow(rollers()), {.radial = 2000.0, .moment_across = -0.5});
  ASSERT_TRUE(one.report.converged && other.report.converged);
  EXPECT_GT(one.lateral_tilt, 0.0);
  EXPECT_NEAR(one.lateral_tilt, -other.lateral_tilt, 1e-12);
  EXPECT_NEAR(one.radial, other.radial, 1e-12);
  for (Eigen::Index j = 1; j < 11; ++j)
    EXPECT_LT((one.lamina_load.col(j) - other.lamina_load.col(11 - j)).abs().maxCoeff(), 1e-6);
}

TEST(StaticBalls, NoLoadInInterferenceBalances) {
  const RingState state = balance_ring(BallRow(balls(0.0, -15e-6)), {});
  EXPECT_TRUE(state.report.converged);
  EXPECT_GT(state.contact_load.minCoeff(), 0.0);
}

TEST(StaticBearings, WhatCannotBeIsRefused) {
  Bearing none = rollers();
  none.rollers().laminae = 0;
  EXPECT_REFUSED(std::invalid_argument, "ring_balance 1", balance_ring(RollerRow(none), {.radial = 1.0}));
  Bearing tight = balls(0.0, 0.0);
  tight.inner.osculation = 0.5;
  EXPECT_REFUSED(std::invalid_argument, "ring_balance 2", balance_ring(BallRow(tight), {.radial = 1.0}));
  EXPECT_REFUSED(std::invalid_argument, "ring_balance 3",
                 balance_ring(BallRow(balls(0.0, 2e-3)), {.radial = 1.0}));
}

}  // namespace
}  // namespace orbearing::bearing::equilibrium::ring_balance_test
