// The inertial loads of the carrier frame against motion in the frame of the ground.
//
//   Y ^        carrier frame x, y turned by psi(t) = Omega t + 1/2 dOmega/dt t^2; pin at x = 0, y = 0
//     |    y\  /x
//     | r_c  \/     A trajectory (x, y)(t) is chosen in the carrier frame, turned to the ground, and
//     +-------> X   differentiated twice by numbers. In the carrier frame: acceleration of the ground =
//                   relative - "added".
//
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "bearing/carrier_frame.hpp"

namespace orbearing::bearing::bearing_carrier_frame_test {
namespace {

// Fourth-order differences with a step of 2e-3 over lengths and times of order 1 and rates below 10:
// truncation 1e-11 x 10^6 / 90 and round-off 1e-15 / 4e-6 stay below this, while the terms are of order 10.
constexpr double kStep = 2e-3;
constexpr double kDifferenceError = 1e-6;
constexpr double kRoundOff = 1e-13;  // sums of products of order 10

using Trajectory = std::function<Eigen::Vector2d(double)>;

constexpr CarrierMotion kMotion{.speed = 1.7, .acceleration = -0.9, .orbit_radius = 2.3};

double speed_at(double time) {
  return kMotion.speed + kMotion.acceleration * time;
}

Eigen::Rotation2Dd carrier_angle(double time) {
  return Eigen::Rotation2Dd(kMotion.speed * time + 0.5 * kMotion.acceleration * time * time);
}

Eigen::Vector2d first_derivative(const Trajectory& x, double t) {
  const double h = kStep;
  return (8.0 * (x(t + h) - x(t - h)) - (x(t + 2.0 * h) - x(t - 2.0 * h))) / (12.0 * h);
}

Eigen::Vector2d second_derivative(const Trajectory& x, double t) {
  const double h = kStep;
  return (16.0 * (x(t + h) + x(t - h)) - (x(t + 2.0 * h) + x(t - 2.0 * h)) - 30.0 * x(t)) / (12.0 * h * h);
}

Eigen::Vector2d relative_path(double t) {
  return {0.4 * std::cos(1.3 * t) + 0.1 * t, 0.3 * std::sin(0.7 * t) - 0.2 * t * t};
}

// Acceleration seen from the ground, in the directions x and y of the carrier frame.
Eigen::Vector2d ground_acceleration(const Trajectory& relative, double time) {
  const Trajectory ground = [&](double t) -> Eigen::Vector2d {
    return carrier_angle(t) * (relative(t) + Eigen::Vector2d(kMotion.orbit_radius, 0.0));
  };
  return carrier_angle(time).inverse() * second_derivative(ground, time);
}

CarrierFrame frame_at(double time) {
  CarrierMotion now = kMotion;
  now.speed = speed_at(time);
  return carrier_frame(now, InertiaSwitches{});
}

TEST(CarrierFrameFromTheGround, CartesianBodies) {
  for (double time = -1.0; time <= 1.0; time += 0.25) {
    const Eigen::Vector2d added =
        inertial_acceleration(frame_at(time), relative_path(time), first_derivative(relative_path, time));
    const Eigen::Vector2d expected =
        second_derivative(relative_path, time) - ground_acceleration(relative_path, time);
    EXPECT_LT((added - expected).norm(), kDifferenceError) << "at time " << time;
  }
}

TEST(CarrierFrameFromTheGround, PolarRoller) {
  // r and theta over time, with their derivatives by hand.
  const auto radius = [](double t) { return 0.5 + 0.1 * t + 0.05 * t * t; };
  const auto angle = [](double t) { return 0.3 - 2.0 * t + 0.4 * t * t; };
  const Trajectory path = [&](double t) -> Eigen::Vector2d {
    return radius(t) * Eigen::Vector2d(std::cos(angle(t)), std::sin(angle(t)));
  };
  for (double time = -1.0; time <= 1.0; time += 0.25) {
    const double r = radius(time), r_speed = 0.1 + 0.1 * time, r_acceleration = 0.1;
    const double theta = angle(time), theta_speed = -2.0 + 0.8 * time, theta_acceleration = 0.8;
    const Eigen::Vector2d ground = ground_acceleration(path, time);
    const double outward = ground.dot(Eigen::Vector2d(std::cos(theta), std::sin(theta)));
    const double around = ground.dot(Eigen::Vector2d(-std::sin(theta), std::cos(theta)));
    EXPECT_NEAR(outward, r_acceleration - radial_inertial_acceleration(frame_at(time), r, theta, theta_speed),
                kDifferenceError);
    EXPECT_NEAR(around,
                r * theta_acceleration + 2.0 * r_speed * theta_speed -
                    tangential_inertial_acceleration(frame_at(time), r, theta, r_speed),
                kDifferenceError);
  }
}

TEST(CarrierFrameFromTheGround, BodyLeftAloneGoesStraight) {
  const Trajectory seen_from_carrier = [](double t) -> Eigen::Vector2d {
    const Eigen::Vector2d straight(1.0 + 0.6 * t, -0.4 + 0.8 * t);
    return carrier_angle(t).inverse() * straight - Eigen::Vector2d(kMotion.orbit_radius, 0.0);
  };
  for (double time = -1.0; time <= 1.0; time += 0.25) {
    const Eigen::Vector2d added = inertial_acceleration(frame_at(time), seen_from_carrier(time),
                                                        first_derivative(seen_from_carrier, time));
    EXPECT_LT((second_derivative(seen_from_carrier, time) - added).norm(), kDifferenceError);
  }
}

TEST(CarrierFrameEnergy, CentrifugalIsTheGradientOfHalfOmegaSquaredRSquared) {
  InertiaSwitches on{.own_orbit = false, .coriolis = false, .carrier_centrifugal = true, .euler = false};
  const CarrierFrame frame = carrier_frame(kMotion, on);
  const auto potential = [](double x, double y) {
    const double outward = x + kMotion.orbit_radius;
    return 0.5 * kMotion.speed * kMotion.speed * (outward * outward + y * y);
  };
  const double h = kStep;  // differences of a quadratic are exact but for round-off
  for (const double x : {-3.0, 0.0, 0.4}) {
    for (const double y : {-0.5, 0.0, 2.0}) {
      const Eigen::Vector2d gradient((potential(x + h, y) - potential(x - h, y)) / (2.0 * h),
                                     (potential(x, y + h) - potential(x, y - h)) / (2.0 * h));
      const Eigen::Vector2d added = inertial_acceleration(frame, {x, y}, {0.9, -1.1});
      EXPECT_LT((added - gradient).norm(), kDifferenceError);
    }
  }
}

TEST(CarrierFrameEnergy, CoriolisDoesNoWork) {
  InertiaSwitches on{.own_orbit = false, .coriolis = true, .carrier_centrifugal = false, .euler = false};
  const Eigen::Vector2d velocity(0.9, -1.1);
  const Eigen::Vector2d added = inertial_acceleration(carrier_frame(kMotion, on), {0.3, 0.2}, velocity);
  EXPECT_GT(added.norm(), 1.0);
  EXPECT_NEAR(added.dot(velocity), 0.0, kRoundOff);
}

TEST(CarrierFrameEnergy, PolarAndCartesianFormsAgree) {
  const CarrierFrame frame = frame_at(0.0);
  const double r = 0.4, r_speed = 0.3, theta_speed = -2.1;
  for (double theta = 0.0; theta < 6.3; theta += 0.3) {
    const Eigen::Vector2d outward(std::cos(theta), std::sin(theta)),
        around(-std::sin(theta), std::cos(theta));
    const Eigen::Vector2d added =
        inertial_acceleration(frame, r * outward, r_speed * outward + r * theta_speed * around);
    EXPECT_NEAR(radial_inertial_acceleration(frame, r, theta, theta_speed),
                added.dot(outward) + r * theta_speed * theta_speed, kRoundOff);
    // The tangential form leaves out 2 r' theta', which belongs to polar coordinates; the rest of Coriolis is
    // here.
    EXPECT_NEAR(tangential_inertial_acceleration(frame, r, theta, r_speed), added.dot(around), kRoundOff);
  }
}

}  // namespace
}  // namespace orbearing::bearing::bearing_carrier_frame_test
