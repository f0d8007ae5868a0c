// Issue 14: kinematics of a ball in its pocket, Eqs. (14) to (18) of [Chen2026], and forces on both bodies.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "bearing/motion/balls/pocket_contact.hpp"

namespace orbearing::bearing::balls::pocket_contact_test {
namespace {

constexpr double kBallRadius = 4.76e-3, kPlay = 0.1e-3, kPitch = 18e-3;

BallNumbers numbers(double straight) {
  BallNumbers c;
  c.radius = kBallRadius;
  c.pocket = {.play = kPlay, .half_straight = 0.5 * straight, .stiffness = 1e9, .friction = 0.1, .sliding_scale = 0.01};
  return c;
}

// A ball at angle zero, off the pocket's middle by `ahead` along the pitch circle and `axial`.
PocketTouch<double> touch(const BallNumbers& c, double ahead, double axial) {
  const Ball<double> ball{kPitch, 0.0, 1.0, 0.0, {}, {}, 0.0};
  const Body cage{{0.0, -ahead, -axial}, {0.0, 0.0, 1.0}, {}, {}, 0.0};
  ContactSlopes<double> unused;
  return pocket_touch<false>(c, ball, seen(ball, cage), Triple<double>{1.0, 0.0, 0.0}, unused);
}

TEST(PocketContact, RoundPocketsCountTheDistanceFromTheirMiddle) {
  const BallNumbers c = numbers(0.0);
  EXPECT_NEAR(touch(c, 0.03e-3, 0.04e-3).approach, 0.05e-3 - kPlay, 1e-15);
  EXPECT_NEAR(touch(c, -0.09e-3, 0.12e-3).approach, 0.15e-3 - kPlay, 1e-15);
}

// Eq. (14): the straight part holds the ball axially alone; beyond it, the half circle about its end.
TEST(PocketContact, OblongPocketsCountFromTheNearestPointOfTheirMiddleLine) {
  const BallNumbers c = numbers(0.2e-3);
  EXPECT_NEAR(touch(c, 0.08e-3, 0.12e-3).approach, 0.12e-3 - kPlay, 1e-15);
  EXPECT_NEAR(touch(c, 0.22e-3, 0.05e-3).approach, std::hypot(0.12e-3, 0.05e-3) - kPlay, 1e-15);
  EXPECT_NEAR(touch(c, -0.25e-3, 0.0).approach, 0.15e-3 - kPlay, 1e-15);
}

TEST(PocketContact, PushesTheBallBackAndDrivesTheCage) {
  const PocketTouch<double> ahead = touch(numbers(0.0), 0.15e-3, 0.0);
  EXPECT_NEAR(ahead.load, 1e9 * std::pow(0.05e-3, 1.5), 1e-9 * ahead.load);
  EXPECT_LT(ahead.on_ball.force.y, 0.0);
  EXPECT_GT(ahead.driving, 0.0);
  EXPECT_EQ(touch(numbers(0.0), 0.05e-3, 0.0).load, 0.0);
}

// Eq. (17): the pocket's direction in a tilted cage is that of the shortest turn of its axis.
TEST(PocketContact, DirectionsTurnWithTheAxis) {
  const Eigen::Vector3d axis = Eigen::Vector3d(0.02, -0.03, 1.0).normalized();
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis);
  for (const double angle : {0.0, 0.7, 2.5, -1.9}) {
    const Triple<double> ours =
        pocket_direction<double>({axis.x(), axis.y(), axis.z()}, std::cos(angle), std::sin(angle));
    const Eigen::Vector3d exact = turn * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    EXPECT_NEAR(ours.x, exact.x(), 1e-15);
    EXPECT_NEAR(ours.y, exact.y(), 1e-15);
    EXPECT_NEAR(ours.z, exact.z(), 1e-15);
  }
}

}  // namespace
}  // namespace orbearing::bearing::balls::pocket_contact_test
