// Friction at pure rolling, against the laws written out and against the bearing in motion.
#include "bearing/friction/rolling_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bearing/equilibrium/row_group.hpp"
#include "bearing/geometry.hpp"
#include "bearing/motion/balls/ball_bearing.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::friction::rolling_friction_test {
namespace {

using equilibrium::RingSpeeds;

constexpr Lubricant kOil{.viscosity = 0.01, .pressure_viscosity = 1.5e-8};

// Resistance of one contact by the groups of Moes, contact/friction.hpp, without the rounding of small loads.
double resistance(double modulus, double radius, double length, double speed, double load) {
  const double u = kOil.viscosity * speed / (modulus * radius), w = load / (modulus * radius * length);
  const double m = w / std::sqrt(2.0 * u), l = kOil.pressure_viscosity * modulus * std::pow(2.0 * u, 0.25);
  const double a = 1.4705 * std::sqrt(m), b = 2.2818 * std::pow(m, -0.04543) * std::pow(l, -0.0923);
  return modulus * radius * length * std::pow(2.0 * u, 0.75) /
         std::cbrt(std::pow(a, -3.0) + std::pow(b, -3.0));
}

TEST(RollerFriction, IsTwiceResistanceTimesRollingSpeedAtEachContact) {
  const Bearing bearing = example_bearings::planet_bearing();
  const BearingGeometry g = geometry_of(bearing);
  const double shaft = 600.0, cage = 0.5 * shaft * (1.0 - g.slenderness);
  const double rolling = (shaft - cage) * g.inner_radius, modulus = bearing.material.plane_strain_modulus();
  Eigen::ArrayXd loads = Eigen::ArrayXd::Zero(15);
  loads[0] = 800.0;
  loads[1] = 300.0;
  const double thrown = g.element_mass * g.pitch_radius * cage * cage;
  double by_hand = 0.0;
  for (const double load : loads) {
    if (load > 0.0)
      by_hand +=
          2.0 * rolling * resistance(modulus, equivalent_radius(g, Race::inner), 5.7e-3, rolling, load);
    by_hand += 2.0 * rolling * std::sqrt((load + thrown) / (load + thrown + 1.0)) *
               resistance(modulus, equivalent_radius(g, Race::outer), 5.7e-3, rolling, load + thrown);
  }
  constexpr double rounding = 2e-3;  // loads and speeds at zero are rounded over 1 N and 0.01 m/s
  const RollingFriction loss = roller_friction(bearing, loads, {shaft, 0.0}, kOil);
  EXPECT_NEAR(loss.rolling, by_hand, rounding * by_hand);
  // Thirteen of fifteen rollers have only their centrifugal load on the outer race.
  const double idle = 2.0 * rolling * std::sqrt(thrown / (thrown + 1.0)) *
                      resistance(modulus, equivalent_radius(g, Race::outer), 5.7e-3, rolling, thrown);
  EXPECT_NEAR(loss.idle, 13.0 * idle, rounding * by_hand);
}

TEST(RollerFriction, DependsOnTheRelativeSpeedAloneButForInertiaAndDrag) {
  const Bearing bearing = example_bearings::planet_bearing();
  const Eigen::ArrayXd loads = Eigen::ArrayXd::Constant(15, 500.0);
  const double forward = roller_friction(bearing, loads, {100.0, 0.0}, kOil).rolling;
  EXPECT_DOUBLE_EQ(roller_friction(bearing, loads, {-100.0, 0.0}, kOil).rolling, forward);
  EXPECT_NEAR(roller_friction(bearing, loads, {0.0, -100.0}, kOil).rolling, forward, 1e-3 * forward);
  EXPECT_EQ(roller_friction(bearing, loads, {100.0, 0.0}, {}).rolling, 0.0);
}

// Half the speed: an eighth of the drag but for the walls, whose friction falls with the Reynolds number.
TEST(RollerFriction, DragGrowsAboutWithTheCubeOfTheSpeed) {
  const Bearing bearing = example_bearings::planet_bearing();
  const Eigen::ArrayXd loads = Eigen::ArrayXd::Constant(15, 500.0);
  const double fast = roller_friction(bearing, loads, {600.0, 0.0}, kOil).drag;
  const double slow = roller_friction(bearing, loads, {300.0, 0.0}, kOil).drag;
  EXPECT_GT(slow, fast / 8.0);
  EXPECT_LT(slow, fast / 4.0);
}

Bearing ball_bearing() {
  Bearing bearing;
  bearing.elements = Balls{.count = 9, .diameter = 7.94e-3};
  bearing.pitch_diameter = 38.5e-3;
  bearing.inner = {.seat_diameter = 25e-3, .osculation = 0.52};
  bearing.outer = {.seat_diameter = 52e-3, .osculation = 0.53};
  bearing.width = 15e-3;
  bearing.cage = {.inner_diameter = 35.3e-3, .outer_diameter = 42.5e-3, .width = 11.4e-3, .density = 1310.0};
  return bearing;
}

struct Balanced {
  equilibrium::RingState state;
  RollingFriction loss;
};
Balanced balanced(const Bearing& bearing, const equilibrium::RingLoad& load, const RingSpeeds& speeds,
                  const Lubricant& oil = kOil) {
  const equilibrium::RingState state = equilibrium::balance_bearing(bearing, {.speeds = speeds}, load);
  EXPECT_TRUE(state.report.converged);
  return {state, ball_friction(bearing, state, load, speeds, oil)};
}

// At a low speed balls have no inertia to speak of: the start of the motion in time has the same loads, and
// rolls.
TEST(BallFriction, IsThatOfTheMotionInTimeAtPureRolling) {
  const Bearing bearing = ball_bearing();
  const equilibrium::RingLoad load{.radial = 200.0, .axial = 2000.0};
  const RingSpeeds speeds{20.0, 0.0};
  balls::MotionParameters given;
  given.lubricant = kOil;
  given.race.traction = TractionLaw::ree_eyring;
  given.ellipse.rolling = balls::BallRolling::reynolds;
  balls::BallDuty duty;
  duty.inner = balls::RingDrive::steady(speeds.inner);
  duty.on_inner = {{load.radial, 0.0, load.axial}};
  const balls::BallBearing in_motion(balls::ball_numbers(bearing, given), duty);
  const balls::BallPowerLoss loss =
      in_motion.snapshot(0.0, balls::start_state(bearing, in_motion, 0.0).data()).loss;
  const RollingFriction ours = balanced(bearing, load, speeds).loss;
  EXPECT_NEAR(ours.rolling, loss.rolling, 0.01 * loss.rolling);
  EXPECT_DOUBLE_EQ(ours.drag, loss.churning);
  // The ellipse as a whole is free to slide here, and rolls in its middle there.
  const double over_ellipses = ours.differential_slip + ours.spin;
  EXPECT_GT(ours.spin, 0.0);
  EXPECT_GT(over_ellipses, 0.5 * (loss.sliding + loss.differential + loss.spin));
  EXPECT_LT(over_ellipses, 1.001 * (loss.sliding + loss.differential + loss.spin));
}

TEST(BallFriction, DoesNotSpinUnderARadialLoad) {
  const RollingFriction loss = balanced(ball_bearing(), {.radial = 1000.0}, {300.0, 0.0}).loss;
  EXPECT_NEAR(loss.spin, 0.0, 1e-12);
  EXPECT_GT(loss.differential_slip, 0.0);
}

// Couple ~ (eta u)^0.5 of rigid bodies to (eta u)^0.66 or so of elastic ones.
TEST(BallFriction, RollingGrowsWithViscosityAsItsLaw) {
  Lubricant thick = kOil;
  thick.viscosity *= 2.0;
  const equilibrium::RingLoad load{.radial = 500.0};
  const double thin = balanced(ball_bearing(), load, {500.0, 0.0}).loss.rolling;
  const double growth = balanced(ball_bearing(), load, {500.0, 0.0}, thick).loss.rolling / thin;
  EXPECT_GT(growth, std::pow(2.0, 0.5));
  EXPECT_LT(growth, std::pow(2.0, 0.75));
}

}  // namespace
}  // namespace orbearing::bearing::friction::rolling_friction_test
