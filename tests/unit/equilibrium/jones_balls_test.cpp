// Balls at speed: bearing 218 of [Harris2006], slopes against differences, limits, and the moment that a
// rotating ball requires.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "bearing/equilibrium/row_group.hpp"
#include "bearing/geometry.hpp"
#include "mechanics/constants.hpp"
#include "tests/messages.hpp"

namespace orbearing::bearing::equilibrium::moving_balls_test {
namespace {

constexpr double kDegree = constants::degree;
constexpr double kRpm = constants::pi / 30.0;

Bearing bearing_218() {
  return {.inner = {.osculation = 0.5232},
          .outer = {.osculation = 0.5232},
          .elements = Balls{.count = 16, .diameter = 22.23e-3, .contact_angle = 40.0 * kDegree},
          .pitch_diameter = 125.26e-3,
          .material = {.youngs_modulus = 207e9, .poisson_ratio = 0.3, .density = 7800.0}};
}

RowMotion rotating(double rpm, BallAttitude attitude = BallAttitude::minimum_friction,
                   GyroscopicMoment moment = GyroscopicMoment::balanced) {
  return {.speeds = {.inner = rpm * kRpm}, .inertia = {.attitude = attitude, .gyroscopic_moment = moment}};
}

constexpr BallAttitude attitudes[] = {BallAttitude::minimum_friction, BallAttitude::hybrid,
                                      BallAttitude::race_control, BallAttitude::outer_race_control};

// Computed by a separate program from the printed equations.
TEST(JonesBalls, Bearing218AsPrinted) {
  const RingState state = balance_bearing(
      bearing_218(),
      rotating(10000.0, BallAttitude::outer_race_control, GyroscopicMoment::literature_variant),
      {.axial = 17800.0});
  ASSERT_TRUE(state.report.converged) << state.report.message;
  constexpr double kDigits = 1e-6;  // of the other program's solution
  EXPECT_NEAR(state.contact_angle[0] / kDegree / 45.40239358170123, 1.0, kDigits);
  EXPECT_NEAR(state.outer_angle[0] / kDegree / 37.4083522674167, 1.0, kDigits);
  EXPECT_NEAR(state.contact_load[0] / 1562.3784802371226, 1.0, kDigits);
  EXPECT_NEAR(state.outer_load[0] / 2020.7041249210247, 1.0, kDigits);
  EXPECT_NEAR(1e3 * state.axial / 0.03356346023339357, 1.0, kDigits);
}

// The races' moment on a ball is the rate of its angular momentum, here by differences in an inertial frame.
TEST(JonesBalls, TheMomentIsTheRateOfAngularMomentum) {
  const Bearing bearing = bearing_218();
  const BearingGeometry geometry = geometry_of(bearing);
  for (const RingSpeeds speeds :
       {RingSpeeds{1000.0, 0.0}, RingSpeeds{0.0, 700.0}, RingSpeeds{900.0, -500.0}}) {
    JonesRow row(bearing, {.speeds = speeds});
    RingState state = balance_ring(row, {.axial = 17800.0});
    ASSERT_TRUE(state.report.converged);
    const JonesBall& ball = row.balls().front();
    // x outward at the start, z along the axis, y where the ball goes.
    const auto momentum = [&](double time) {
      const Eigen::Vector3d spin(ball.motion.radial_spin, 0.0, ball.motion.axial_spin + ball.motion.orbit);
      const Eigen::AngleAxisd orbit(ball.motion.orbit * time, Eigen::Vector3d::UnitZ());
      return Eigen::Vector3d(geometry.element_inertia * (orbit * spin));
    };
    constexpr double step = 1e-6;  // [s]
    const Eigen::Vector3d rate = (momentum(step) - momentum(-step)) / (2.0 * step);
    const double radius = geometry.element_radius;
    const auto force = [](const ContactNormal<double>& normal, double along) {
      return Eigen::Vector3d(-along * normal.sine, 0.0, along * normal.cosine);
    };
    const auto arm = [&](const ContactNormal<double>& normal) {
      return Eigen::Vector3d(radius * normal.cosine, 0.0, radius * normal.sine);
    };
    const Eigen::Vector3d moment = arm(ball.outer).cross(force(ball.outer, ball.outer_traction)) -
                                   arm(ball.inner).cross(force(ball.inner, ball.inner_traction));
    EXPECT_NEAR((moment - rate).norm() / rate.norm(), 0.0, 1e-6);
  }
}

// Both centres of contact roll: ball and race have one speed there.
TEST(JonesBalls, BallsRollOnBothRaces) {
  const ContactNormal<double> inner{std::cos(0.8), std::sin(0.8)}, outer{std::cos(0.6), std::sin(0.6)};
  const RingSpeeds speeds{900.0, -200.0};
  constexpr double ball = 0.01, pitch = 0.06;
  for (const SpinWeights<double> weights : {SpinWeights<double>{0.0, 1.0}, {1.0, 0.0}, {2.0, 3.0}}) {
    const BallMotion<double> motion = ball_motion(inner, outer, weights, ball, pitch, speeds);
    const auto surface = [&](const ContactNormal<double>& n, double side) {
      return side * ball * (motion.axial_spin * n.cosine - motion.radial_spin * n.sine);
    };
    EXPECT_NEAR(surface(outer, 1.0), (speeds.outer - motion.orbit) * (pitch + ball * outer.cosine), 1e-12);
    EXPECT_NEAR(surface(inner, -1.0), (speeds.inner - motion.orbit) * (pitch - ball * inner.cosine), 1e-12);
    EXPECT_NEAR(motion.outer_spin,
                motion.radial_spin * outer.cosine + motion.axial_spin * outer.sine -
                    (speeds.outer - motion.orbit) * outer.sine,
                1e-9);
    EXPECT_NEAR(motion.inner_spin,
                motion.radial_spin * inner.cosine + motion.axial_spin * inner.sine -
                    (speeds.inner - motion.orbit) * inner.sine,
                1e-9);
    if (weights.inner == 0.0) {
      EXPECT_NEAR(motion.outer_spin, 0.0, 1e-12);
    }
    if (weights.outer == 0.0) {
      EXPECT_NEAR(motion.inner_spin, 0.0, 1e-12);
    }
  }
}

// Each entry of the stiffness against differences of the forces, all closures, with unloaded balls among
// them.
TEST(JonesBalls, StiffnessIsTheSlopeOfTheForces) {
  const Bearing bearing = bearing_218();
  for (const BallAttitude attitude : attitudes)
    for (const auto& load :
         {RingLoad{.radial = 9000.0, .axial = 17800.0, .moment = 60.0, .moment_across = 30.0},
          RingLoad{.radial = 15000.0, .axial = 9000.0}}) {
      const RowMotion motion = rotating(9000.0, attitude);
      const RingState state = balance_bearing(bearing, motion, load);
      ASSERT_TRUE(state.report.converged);
      JonesRow row(bearing, motion);
      const RingPosition position = position_of(state, row.lever());
      RingState unused;
      row.put_loads(position, unused);
      row.choose_control();
      const RingImbalance here = row_forces(row, position);
      constexpr double step = 2e-9;  // [m]
      for (int i = 0; i < 5; ++i) {
        const RingPosition aside = step * RingPosition::Unit(i);
        const RingPosition slope =
            (row_forces(row, position - aside).force - row_forces(row, position + aside).force) /
            (2.0 * step);
        EXPECT_NEAR((slope - here.stiffness.col(i)).norm() / here.stiffness.norm(), 0.0, 1e-6) << i;
      }
    }
}

// At nearly zero speed the moving row, through all of its own equations, is the static row.
TEST(JonesBalls, AtRestItIsTheStaticRow) {
  const Bearing bearing = bearing_218();
  const RingLoad load{.radial = 4000.0, .axial = 17800.0, .moment = 50.0};
  const RingState still = balance_ring(BallRow(bearing), load);
  for (const BallAttitude attitude : attitudes) {
    const RingState state = balance_bearing(bearing, rotating(1e-4, attitude), load);
    ASSERT_TRUE(state.report.converged);
    EXPECT_NEAR(state.axial / still.axial, 1.0, 1e-12);
    EXPECT_NEAR(state.radial / still.radial, 1.0, 1e-12);
    EXPECT_LT((state.contact_load - still.contact_load).matrix().norm() / still.contact_load.matrix().norm(),
              1e-12);
    EXPECT_LT((state.stiffness - still.stiffness).norm() / still.stiffness.norm(), 1e-9);
    EXPECT_LT((state.stiffness - state.stiffness.transpose()).norm() / state.stiffness.norm(), 1e-10);
  }
  EXPECT_EQ(balance_bearing(bearing, rotating(0.0), load).axial, still.axial);
}

// Centrifugal force alone leaves an energy: stiffness is symmetric at all speeds but for what the orbit owes
// to the contact angles; with it frozen, exactly.
TEST(JonesBalls, WithoutMassSpeedsAreNotFelt) {
  const Bearing bearing = bearing_218();
  RowMotion motion = rotating(12000.0);
  motion.inertia.enabled = false;
  const RingState state = balance_bearing(bearing, motion, {.axial = 17800.0});
  EXPECT_EQ(state.axial, balance_ring(BallRow(bearing), {.axial = 17800.0}).axial);
}

// An axial load that the inner ring carries is carried by the outer one, and the balls' forces close.
TEST(JonesBalls, ForcesOfEachBallClose) {
  const Bearing bearing = bearing_218();
  for (const BallAttitude attitude : attitudes) {
    JonesRow row(bearing, rotating(11000.0, attitude));
    const RingState state = balance_ring(row, {.radial = 3000.0, .axial = 17800.0});
    ASSERT_TRUE(state.report.converged);
    for (const JonesBall& ball : row.balls()) {
      const double along = ball.inner_load * ball.inner.sine + ball.inner_traction * ball.inner.cosine -
                           ball.outer_load * ball.outer.sine + ball.outer_traction * ball.outer.cosine;
      const double outward = ball.inner_load * ball.inner.cosine - ball.inner_traction * ball.inner.sine -
                             ball.outer_load * ball.outer.cosine - ball.outer_traction * ball.outer.sine +
                             ball.centrifugal_force;
      EXPECT_NEAR(along / ball.outer_load, 0.0, 1e-9);
      EXPECT_NEAR(outward / ball.outer_load, 0.0, 1e-9);
    }
  }
}

// Forces at the points of contact, with their arms in space, hold the moments on the ring: those of traction
// too.
TEST(JonesBalls, ForcesAtTheContactsHoldTheMoments) {
  const Bearing bearing = bearing_218();
  const RingLoad load{.radial = 3000.0, .axial = 17800.0, .moment = 40.0, .moment_across = -25.0};
  for (const BallAttitude attitude : attitudes) {
    JonesRow row(bearing, rotating(11000.0, attitude));
    ASSERT_TRUE(balance_ring(row, load).report.converged);
    const double groove = 0.5232 * 22.23e-3;  // [m]
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (Eigen::Index j = 0; j < 16; ++j) {
      const JonesBall& ball = row.balls()[static_cast<std::size_t>(j)];
      const auto [cosine, sine] = row.geometry().direction(j);
      const Eigen::Vector3d outward(cosine, sine, 0.0), along = Eigen::Vector3d::UnitZ();
      const Eigen::Vector3d normal = ball.inner.cosine * outward + ball.inner.sine * along;
      const Eigen::Vector3d across = ball.inner.cosine * along - ball.inner.sine * outward;
      const Eigen::Vector3d position = row.lever() * outward - groove * normal;
      moment += position.cross(-ball.inner_load * normal - ball.inner_traction * across);
    }
    EXPECT_NEAR(moment.x(), -load.moment_across, 1e-7);
    EXPECT_NEAR(moment.y(), load.moment, 1e-7);
  }
}

// A bearing rotated about its axis carries an equal, rotated load: one ball pitch further nothing has
// changed.
TEST(JonesBalls, OnePitchFurtherNothingChanges) {
  Bearing bearing = bearing_218();
  const RingLoad load{.radial = 5000.0, .axial = 12000.0, .moment = 20.0};
  const RingState one = balance_bearing(bearing, rotating(8000.0), load);
  bearing.first_element = 2.0 * constants::pi / 16.0;
  const RingState other = balance_bearing(bearing, rotating(8000.0), load);
  EXPECT_NEAR(one.radial / other.radial, 1.0, 1e-9);
  EXPECT_NEAR((one.stiffness - other.stiffness).norm() / one.stiffness.norm(), 0.0, 1e-7);
}

// A ball that a radial load does not reach runs in the outer groove with the kinematic speed of the cage, and
// presses on it by its centrifugal force.
TEST(JonesBalls, ABallThatLeftTheInnerRaceOrbitsWithTheCage) {
  const Bearing bearing = bearing_218();
  const BearingGeometry geometry = geometry_of(bearing);
  const double cage = 0.5 * 8000.0 * kRpm * (1.0 - geometry.element_radius / geometry.pitch_radius);
  const double thrown = geometry.element_mass * geometry.pitch_radius * cage * cage;
  for (const BallAttitude attitude : attitudes) {
    const RingState state = balance_bearing(bearing, rotating(8000.0, attitude),
                                            {.radial = 15000.0, .axial = 6000.0, .tilt = 0.0});
    ASSERT_TRUE(state.report.converged) << state.report.message;
    int unloaded = 0;
    for (Eigen::Index j = 0; j < state.contact_load.size(); ++j) {
      if (state.contact_load[j] > 0.0) continue;
      ++unloaded;
      EXPECT_NEAR(state.outer_load[j] / thrown, 1.0, 1e-6) << j;
      EXPECT_NEAR(state.outer_angle[j], 0.0, 1e-6) << j;
    }
    EXPECT_GE(unloaded, 1);
  }
}

// Newton's method alone, from the stationary bearing, finds no equilibrium of a light load on balls with
// centrifugal loads; the path from the centrifugal force alone leads to one, at which the row's own forces
// close.
TEST(JonesBalls, APathLeadsWhereNewtonStops) {
  const Bearing bearing = bearing_218();
  const RowMotion motion{.speeds = {.outer = 10000.0 * kRpm}};
  const RingLoad load{.radial = 2000.0, .axial = 500.0};
  JonesRow row(bearing, motion);
  const RingPosition at_rest = position_of(balance_ring(BallRow(bearing), load), row.lever());
  EXPECT_FALSE(balance_ring(row, load, at_rest).report.converged && row.settled());
  const RingState state = balance_bearing(bearing, motion, load);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  JonesRow again(bearing, motion);
  const RingImbalance borne = row_forces(again, position_of(state, again.lever()));
  ASSERT_TRUE(again.settled());
  EXPECT_LT((borne.force + outer_load(load, again.lever())).norm(), 1e-6 * borne.scale);
}

// A bearing at 40 degrees whose axial load is far too small for its radial one, with nothing to hold its
// tilt.
TEST(JonesBalls, BallsPressedBeyondTheirGroovesAreNamed) {
  const RingState state =
      balance_bearing(bearing_218(), rotating(10000.0), {.radial = 12000.0, .axial = 2000.0});
  EXPECT_FALSE(state.report.converged);
  EXPECT_SAID("beyond grooves", state.report.message);
}

TEST(JonesBalls, EitherRingMayTurn) {
  const Bearing bearing = bearing_218();
  RowMotion motion;
  motion.speeds.outer = 6000.0 * kRpm;
  const RingState outer = balance_bearing(bearing, motion, {.axial = 17800.0});
  ASSERT_TRUE(outer.report.converged);
  motion.speeds = {.inner = 6000.0 * kRpm};
  const RingState inner = balance_bearing(bearing, motion, {.axial = 17800.0});
  // The outer race is further out, so balls orbit faster where it turns.
  EXPECT_GT(outer.outer_load[0], inner.outer_load[0]);
}

}  // namespace
}  // namespace orbearing::bearing::equilibrium::moving_balls_test
