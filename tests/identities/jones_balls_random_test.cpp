// Ball bearings drawn at random, RANDOM_BALANCES of them: any valid geometry, rings at up to 15000 rpm, loads
// over five decades, radial, axial, inclined, with moments, with a given tilt, every closure. Each finds its
// equilibrium, or the reason why there is none.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

#include "bearing/equilibrium/row_group.hpp"
#include "bearing/geometry.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::equilibrium::moving_balls_random_test {
namespace {

constexpr double kPi = constants::pi;

struct Drawn {
  Bearing bearing;
  RowMotion motion;
  RingLoad load;
};

class Draws {
 public:
  Drawn next() {
    Drawn drawn{.bearing = bearing(), .motion = motion(), .load = {}};
    const Balls& balls = drawn.bearing.balls();
    const double capacity =
        1e7 * balls.diameter * balls.diameter * balls.count;  // [N]  that of stationary balls
    drawn.load = load(capacity * std::pow(10.0, between(-5.0, -0.3)), drawn.bearing.pitch_diameter);
    return drawn;
  }

 private:
  Bearing bearing() {
    Bearing bearing;
    Balls balls;
    balls.count = std::uniform_int_distribution<int>(4, 40)(engine_);
    balls.diameter = 1e-3 * std::pow(60.0, between(0.0, 1.0));
    balls.contact_angle = between(0.0, 1.0) < 0.2 ? 0.0 : between(0.0, kPi / 3.0);
    bearing.pitch_diameter = std::max(1.5 * balls.diameter,  //
                                      balls.diameter / std::sin(kPi / balls.count) * between(1.01, 2.0));
    bearing.inner.osculation = between(0.505, 0.56);
    bearing.outer.osculation = between(0.505, 0.56);
    bearing.radial_clearance = between(-5e-4, 2e-3) * balls.diameter;
    bearing.elements = balls;
    bearing.first_element = between(0.0, 6.3);
    return bearing;
  }
  // One ring or the other; one in ten times both, against each other at half the speed at most: rings at
  // opposite speeds leave no orbit.
  RowMotion motion() {
    RowMotion motion;
    const double speed = between(0.0, 15000.0) * kPi / 30.0, which = between(0.0, 1.0);
    if (which < 0.6 || which >= 0.9) motion.speeds.inner = speed;
    if (which >= 0.6) motion.speeds.outer = which < 0.9 ? speed : speed * between(-0.5, 1.0);
    motion.inertia.attitude = static_cast<BallAttitude>(std::uniform_int_distribution<int>(0, 3)(engine_));
    return motion;
  }
  RingLoad load(double size, double pitch_diameter) {
    enum Kind { radial, axial, inclined, with_moments, tilted };
    const auto kind = static_cast<Kind>(std::uniform_int_distribution<int>(0, 4)(engine_));
    const double angle = between(0.0, 0.5 * kPi);
    RingLoad load;
    if (kind != axial) load.radial = kind == radial ? size : size * std::cos(angle);
    if (kind != radial) load.axial = kind == axial ? size : size * std::sin(angle);
    if (kind == with_moments) {
      load.moment = size * pitch_diameter * between(-0.5, 0.5);
      load.moment_across = size * pitch_diameter * between(-0.5, 0.5);
    }
    if (kind == tilted) load.tilt = between(-2e-3, 2e-3);
    return load;
  }
  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }
  std::mt19937_64 engine_{20260101};
};

TEST(RandomBalances, AreFoundOrAreNone) {
  const char* stated = std::getenv("RANDOM_BALANCES");
  const int bearings = stated ? std::atoi(stated) : 200;
  Draws draws;
  int found = 0, none = 0;
  for (int i = 0; i < bearings; ++i) {
    const Drawn drawn = draws.next();
    const RingState state = balance_bearing(drawn.bearing, drawn.motion, drawn.load);
    if (state.report.converged) {
      ++found;
      ASSERT_TRUE(state.stiffness.allFinite()) << i;
      ASSERT_TRUE(state.contact_load.allFinite()) << i;
      continue;
    }
    if (state.report.message.find("no static equilibrium within the grooves") != std::string::npos) {
      ++none;
      continue;
    }
    ADD_FAILURE() << i << ": " << drawn.bearing.balls().count << " balls of "
                  << drawn.bearing.balls().diameter << " m at " << drawn.bearing.balls().contact_angle
                  << " rad, inner " << drawn.motion.speeds.inner << ", outer " << drawn.motion.speeds.outer
                  << " rad/s, " << drawn.load.radial << " N, " << drawn.load.axial << " N, "
                  << drawn.load.moment << " N m: " << state.report.message;
  }
  std::cout << found << " in balance, " << none << " pressed beyond the ends of their grooves\n";
  EXPECT_GE(found, 0.8 * bearings);
}

// A group of rows is sought, and refused, as one row is: two bearings in one place bear half each.
TEST(RandomBalances, TwoRowsInOnePositionBearHalfEach) {
  Draws draws;
  int found = 0, none = 0;
  for (int i = 0; i < 60; ++i) {
    const Drawn drawn = draws.next();
    RingLoad twice = drawn.load;
    for (double* one : {&twice.radial, &twice.axial, &twice.moment, &twice.moment_across}) *one *= 2.0;
    const RowOnShaft row{.bearing = drawn.bearing, .motion = drawn.motion};
    const RingState one = balance_bearing(drawn.bearing, drawn.motion, drawn.load);
    const RingState both = balance_rows({row, row}, twice);
    ASSERT_EQ(both.report.converged, one.report.converged) << i << ": " << both.report.message;
    if (!one.report.converged) {
      EXPECT_NE(both.report.message.find("no static equilibrium within the grooves"), std::string::npos) << i;
      ++none;
      continue;
    }
    const Eigen::Index count = one.contact_load.size();
    const double most = std::max(one.contact_load.maxCoeff(), drawn.load.radial + drawn.load.axial);
    for (const Eigen::Index first : {Eigen::Index{0}, count})
      EXPECT_LT((both.contact_load.segment(first, count) - one.contact_load).abs().maxCoeff(), 1e-6 * most)
          << i;
    ++found;
  }
  EXPECT_GT(found, 40);
  EXPECT_GT(none, 2);
}

}  // namespace
}  // namespace orbearing::bearing::equilibrium::moving_balls_random_test
