// Issue 19, Build 6: which waves of a race that bends move, and with what.
#include "bearing/motion/rim.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::rim_test {
namespace {

TEST(MovingWaves, AreThoseUpToTheLargestOrder) {
  const ElasticRace race = test::bending_race();  // orders 0 to 6
  for (const int most : {0, 3, 5, 6, 20}) {
    const ElasticRace moving = moving_waves(race, {.most_order = most});
    const Eigen::Index orders = std::min(most, 6) + 1;
    ASSERT_EQ(moving.compliance.size(), orders) << most;
    ASSERT_EQ(moving.cosine.size(), orders);
    ASSERT_EQ(moving.sine.size(), orders);
    ASSERT_EQ(moving.mass.size(), orders);
    EXPECT_TRUE((moving.compliance == race.compliance.head(orders)).all());
    EXPECT_TRUE((moving.mass == race.mass.head(orders)).all());
  }
}

// A wave rings at sqrt(k/m) and loses a share 2 pi (2 D) of its energy a cycle, D = c/(2 sqrt(k m)).
TEST(RimModel, DampsEachWaveByTheSameRatio) {
  const RimParameters parameters{.most_order = 4, .damping_ratio = 0.03};
  const RimModel rim = rim_model(moving_waves(test::bending_race(), parameters), parameters);
  ASSERT_GT(rim.mass.size(), 4);
  for (Eigen::Index wave = 0; wave < rim.mass.size(); ++wave)
    EXPECT_NEAR(rim.damping[wave] / (2.0 * std::sqrt(rim.stiffness[wave] * rim.mass[wave])), 0.03, 1e-15);
}

}  // namespace
}  // namespace orbearing::bearing::motion::rim_test
