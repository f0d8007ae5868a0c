// The mean reaction of a driven bearing over the two stages of a step.
#include <gtest/gtest.h>

#include "coupling/system/driven_system.hpp"

namespace orbearing::system::stage_reactions_test {
namespace {

using bearing::motion::BoreReaction;

BoreReaction reaction(double x, double y, double moment) {
  return {Eigen::Vector2d(x, y), moment};
}

// What the stage adds is its reduced reaction without that of the bore's own acceleration; by hand.
TEST(StageReactions, AreTheMeanOfBothStages) {
  StageReactions stages;
  stages.begin(reaction(100.0, 200.0, 300.0));
  bearing::vectorised::PortMatrix port;
  const double values[3][3] = {{2.0, 3.0, 5.0}, {7.0, 11.0, 13.0}, {17.0, 19.0, 23.0}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) port.a[i][j] = values[i][j];
  stages.solved({10.0, 20.0, 30.0}, {1.0, 10.0, 100.0}, port);
  // 10 - 2 - 30 - 500, 20 - 7 - 110 - 1300, 30 - 17 - 190 - 2300
  const double first[3] = {100.0 - 522.0, 200.0 - 1397.0, 300.0 - 2477.0};
  stages.evaluated(reaction(1000.0, 2000.0, 3000.0));
  stages.solved({1.0, 2.0, 3.0}, {0.0, 0.0, 0.0}, port);
  const double second[3] = {1001.0, 2002.0, 3003.0};
  const BoreReaction mean = stages.mean();
  EXPECT_DOUBLE_EQ(mean.force.x(), 0.5 * (first[0] + second[0]));
  EXPECT_DOUBLE_EQ(mean.force.y(), 0.5 * (first[1] + second[1]));
  EXPECT_DOUBLE_EQ(mean.moment, 0.5 * (first[2] + second[2]));
  stages.begin(reaction(1.0, 2.0, 3.0));  // another attempt forgets the former one
  EXPECT_EQ(stages.mean().moment, 0.0);
}

}  // namespace
}  // namespace orbearing::system::stage_reactions_test
