// Waves of a bending race that are in motion.
#include "bearing/motion/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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

}  // namespace
}  // namespace orbearing::bearing::motion::rim_test
