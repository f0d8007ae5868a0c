// Churning of oil that rotates with the cage, by its balance of angular momentum.
#include "bearing/motion/balls/mixture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "bearing/geometry.hpp"
#include "bearing/motion/balls/ball_bearing.hpp"
#include "tests/random_balls.hpp"

namespace orbearing::bearing::balls::mixture_test {
namespace {

constexpr double kPi = 3.14159265358979324;

// Balls and cage in a jet of oil at 64,000 rpm.
MixtureNumbers jet() {
  return {.carried = true,
          .count = 16,
          .slenderness = 0.14,
          .pitch_radius = 23e-3,
          .inner_radius = 20e-3,
          .outer_radius = 26e-3,
          .width = 14e-3,
          .density = 46.0,
          .viscosity = 4e-6,
          .flow = 0.015,
          .balls = 16 * 1.8e-4 * std::pow(23e-3, 3.0),
          .cage = 4e-9};
}

constexpr double kShaft = 6700.0;  // [rad/s]

double drag_of_balls_and_cage(const MixtureNumbers& m, double mixture) {
  const double ahead = kinematic_cage_speed(m.slenderness, kShaft, 0.0) - mixture;
  return (m.balls + m.cage) * ahead * std::abs(ahead);
}

TEST(Mixture, AngularMomentumIsBalanced) {
  const MixtureNumbers m = jet();
  const double speed = mixture_speed(m, kShaft, 0.0);
  const double dragged = drag_of_balls_and_cage(m, speed) + wall_torque(m, m.inner_radius, kShaft - speed);
  const double held =
      -wall_torque(m, m.outer_radius, -speed) + m.flow * m.pitch_radius * m.pitch_radius * speed;
  EXPECT_NEAR(held, dragged, 1e-9 * dragged);
  EXPECT_GT(speed, 0.0);
  EXPECT_LT(speed, kShaft);
}

// Limits: nothing holds it back, so it rotates with the cage and nothing is churned.
TEST(Mixture, WithoutWallsAndFlowItGoesWithTheCage) {
  MixtureNumbers m = jet();
  m.width = m.flow = 0.0;
  EXPECT_NEAR(mixture_speed(m, kShaft, 0.0), kinematic_cage_speed(m.slenderness, kShaft, 0.0), 1e-5 * kShaft);
  const DragNumbers drag = carried_drag(
      {.translation = 1.8e-4, .churning = 0.0, .cage_churning = 4e-9, .mixture = m}, kShaft, 0.0);
  EXPECT_LT(drag.translation, 1e-9 * 1.8e-4);
  EXPECT_LT(drag.cage_churning, 1e-9 * 4e-9);
}

// The flow must be accelerated to the cage's speed: m' r^2 w, where balls hardly slip in the mixture.
TEST(Mixture, WithoutWallsALittleFlowTakesItsMomentumFromTheCage) {
  MixtureNumbers m = jet();
  m.width = 0.0;
  m.flow = 1e-9;
  const double cage = kinematic_cage_speed(m.slenderness, kShaft, 0.0), speed = mixture_speed(m, kShaft, 0.0);
  const double torque = m.flow * m.pitch_radius * m.pitch_radius * cage;
  EXPECT_NEAR(drag_of_balls_and_cage(m, speed), torque, 1e-3 * torque);
  EXPECT_NEAR(speed, cage, 1e-3 * cage);
}

// A stationary wall without bound, about a shaft too thin to stir, or a flow without bound, stops it: the
// upper bound of drag.
TEST(Mixture, BeforeEndlessWallsOrInEndlessFlowItRests) {
  MixtureNumbers walls = jet(), flow = jet();
  walls.width = 1e9;
  walls.inner_radius = 1e-5;
  flow.flow = 1e6;
  for (const MixtureNumbers& m : {walls, flow}) {
    EXPECT_LT(mixture_speed(m, kShaft, 0.0), 1e-4 * kShaft);
    const DragNumbers drag = carried_drag({.mixture = m}, kShaft, 0.0);
    EXPECT_NEAR(drag.translation, 1.8e-4, 1e-3 * 1.8e-4);
    EXPECT_NEAR(drag.cage_churning, 4e-9, 1e-3 * 4e-9);
  }
}

// Nothing but two cylinders close to each other: the published torque of one that turns in the other, in all
// four regimes.
TEST(Mixture, BetweenBareCylindersTheTorqueIsThatOfBilgenAndBoulos) {
  MixtureNumbers m = jet();
  m.balls = m.cage = m.flow = 0.0;
  m.outer_radius = m.inner_radius * 1.0001;
  const double gap = m.outer_radius - m.inner_radius, r = m.inner_radius;
  for (const auto& [reynolds, factor, power] :
       {std::tuple{20.0, 10.0, -1.0}, {200.0, 2.0, -0.6}, {2e3, 1.03, -0.5}, {2e5, 0.065, -0.2}}) {
    const double speed = reynolds * m.viscosity / (r * gap);
    const double mixture = mixture_speed(m, speed, 0.0);
    EXPECT_NEAR(mixture, 0.5 * speed, 1e-3 * speed);
    const double coefficient = factor * std::pow(reynolds, power) * std::pow(gap / r, 0.3);
    const double expected = coefficient * 0.5 * kPi * m.density * speed * speed * std::pow(r, 4.0) * m.width;
    EXPECT_NEAR(wall_torque(m, r, speed - mixture), expected, 1e-3 * expected) << reynolds;
  }
}

// Whatever turns: drives put in at least what oil carries off as its energy of motion.
TEST(Mixture, NeverGivesPower) {
  RandomBalls random(3);
  for (int draw = 0; draw < 2000; ++draw) {
    MixtureNumbers m = jet();
    m.balls *= random.between(0.0, 2.0);
    m.flow *= random.between(0.0, 2.0);
    m.width *= random.between(0.0, 2.0);
    const double inner = random.between(-5e3, 5e3), outer = random.between(-5e3, 5e3);
    const double speed = mixture_speed(m, inner, outer), cage = kinematic_cage_speed(m.slenderness, inner, outer);
    const double ahead = cage - speed;
    const double power = (m.balls + m.cage) * ahead * std::abs(ahead) * cage +
                         wall_torque(m, m.inner_radius, inner - speed) * inner +
                         wall_torque(m, m.outer_radius, outer - speed) * outer;
    const double carried_off = 0.5 * m.flow * std::pow(m.pitch_radius * speed, 2.0);
    EXPECT_GE(power, carried_off - 1e-9 * std::abs(power)) << draw;
  }
}

// In motion: the heat is the power of balls, cage and the rotating ring, and the stationary mixture is the
// bound of the first two.
TEST(Mixture, HeatInMotionIsThatOfTheBalance) {
  RandomBalls random(5);
  for (int draw = 0; draw < 40; ++draw) {
    DrawnBalls drawn = random.next();
    drawn.duty.outer = {};
    drawn.duty.inner = RingDrive::steady(2000.0);
    drawn.parameters.drag.oil_share = 0.05;
    drawn.parameters.mixture.flow = random.between(0.0, 2e-5);
    const auto churned = [&](OilMotion motion) {
      drawn.parameters.mixture.motion = motion;
      const BallBearing model(ball_numbers(drawn.bearing, drawn.parameters), drawn.duty);
      const std::vector<double> x = start_state(drawn.bearing, model, 0.0);
      const BallSnapshot now = model.snapshot(0.0, x.data());
      struct {
        double heat, torque, walls;
      } out{now.loss.churning, now.inner_torque,
            wall_torques(model.numbers().drag.mixture, 2000.0, 0.0).inner};
      return out;
    };
    const auto resting = churned(OilMotion::at_rest), carried = churned(OilMotion::carried);
    EXPECT_EQ(resting.walls, 0.0);
    EXPECT_GT(carried.walls, 0.0);
    EXPECT_LT(carried.heat - 2000.0 * carried.walls, resting.heat);
    EXPECT_NEAR(carried.torque - resting.torque, carried.walls, 1e-6 * std::abs(resting.torque) + 1e-9);
  }
}

// Slow rotation in a stationary cylinder a gap t = s R away is Couette's flow, whose torque 4 pi mu w b R^2
// (R + t)^2 / (t (2 R + t)) makes 8 (1 + s)^2 / (2 + s) of friction times Reynolds number. The fit of the
// measurements, ~ s^0.3, cuts it at s = 0.066.
TEST(CylinderFriction, IsCouettesWhereTheFlowIsLaminar) {
  constexpr double kFit = 0.09;  // of the fit between these gaps, largest at s = 0.1
  for (const double s : {0.05, 0.066, 0.08, 0.1}) {
    const double couette = 8.0 * (1.0 + s) * (1.0 + s) / (2.0 + s);
    for (const double reynolds : {1e-3, 1.0, 40.0})
      EXPECT_NEAR(reynolds * cylinder_friction(reynolds) * std::pow(s, 0.3), couette, kFit * couette);
  }
}

// The same numbers made into a bearing twice are those made once.
TEST(Mixture, SlowsTheDragOnce) {
  RandomBalls random(7);
  DrawnBalls drawn = random.next();
  drawn.duty.inner = RingDrive::steady(2000.0);
  drawn.duty.outer = {};
  const BallBearing once(ball_numbers(drawn.bearing, drawn.parameters), drawn.duty),
      twice(once.numbers(), drawn.duty);
  EXPECT_GT(once.numbers().drag.translation, 0.0);
  EXPECT_EQ(once.numbers().drag.translation, twice.numbers().drag.translation);
  EXPECT_EQ(once.numbers().drag.cage_churning, twice.numbers().drag.cage_churning);
}

}  // namespace
}  // namespace orbearing::bearing::balls::mixture_test
