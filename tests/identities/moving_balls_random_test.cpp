// Ten thousand ball bearings drawn at random, either ring turning at up to 15000 rpm: a balance for each,
// whose forces close.
#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <random>

#include "bearing/equilibrium/static_bearing.hpp"
#include "bearing/geometry.hpp"

namespace orbearing::bearing::equilibrium::moving_balls_random_test {
namespace {

constexpr double kPi = boost::math::double_constants::pi;

struct Drawn {
  Bearing bearing;
  RowMotion motion;
  RingLoad load;
};

class Draws {
 public:
  // Angular-contact bearings are loaded along the axis too, and no bearing with less than its balls press on
  // the outer race by their own mass: beneath, rings leave their balls.
  Drawn next() {
    Drawn drawn;
    Bearing& bearing = drawn.bearing;
    Balls balls;
    balls.count = std::uniform_int_distribution<int>(6, 30)(engine_);
    balls.diameter = between(3e-3, 40e-3);
    balls.contact_angle = between(0.0, kPi / 4.0);
    bearing.pitch_diameter = balls.diameter / std::sin(kPi / balls.count) * between(1.02, 1.4);
    bearing.inner.osculation = between(0.51, 0.55);
    bearing.outer.osculation = between(0.51, 0.55);
    bearing.radial_clearance = between(-2e-4, 1e-3) * balls.diameter;
    bearing.elements = balls;
    bearing.first_element = between(0.0, 6.0);
    const double speed = between(0.0, 15000.0) * kPi / 30.0;
    (between(0.0, 1.0) < 0.7 ? drawn.motion.speeds.inner : drawn.motion.speeds.outer) = speed;
    const double orbit = 0.55 * speed;
    const double thrown =
        balls.count * geometry_of(bearing).element_mass * 0.5 * bearing.pitch_diameter * orbit * orbit;
    const double capacity =
        1e7 * balls.diameter * balls.diameter * balls.count;  // [N]  that of balls at rest
    const double load = std::max(thrown, capacity * std::pow(10.0, between(-3.0, -0.3)));
    const double least = std::atan(1.2 * std::tan(balls.contact_angle));
    const double angle = between(least, 0.5 * kPi);
    drawn.load = {.radial = load * std::cos(angle), .axial = load * std::sin(angle)};
    if (between(0.0, 1.0) < 0.3)
      drawn.load.moment = 0.05 * load * bearing.pitch_diameter * between(-1.0, 1.0);
    return drawn;
  }

 private:
  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }
  std::mt19937_64 engine_{20260101};
};

TEST(MovingBallsRandom, EachFindsItsBalance) {
  constexpr int kBearings = 10000;
  Draws draws;
  int failed = 0;
  for (int i = 0; i < kBearings; ++i) {
    const Drawn drawn = draws.next();
    const RingState state = balance_moving(drawn.bearing, drawn.motion, drawn.load);
    if (!state.report.converged) {
      ++failed;
      ADD_FAILURE() << i << ": " << drawn.bearing.balls().count << " balls of "
                    << drawn.bearing.balls().diameter << " m at " << drawn.bearing.balls().contact_angle
                    << " rad, inner " << drawn.motion.speeds.inner << ", outer " << drawn.motion.speeds.outer
                    << " rad/s, " << drawn.load.radial << " N, " << drawn.load.axial << " N, "
                    << drawn.load.moment << " N m: " << state.report.message;
      continue;
    }
    ASSERT_TRUE(state.stiffness.allFinite()) << i;
    ASSERT_TRUE(state.contact_load.allFinite()) << i;
  }
  EXPECT_EQ(failed, 0);
}

}  // namespace
}  // namespace orbearing::bearing::equilibrium::moving_balls_random_test
