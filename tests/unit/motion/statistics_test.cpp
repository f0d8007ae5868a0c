#include "bearing/motion/statistics.hpp"

#include <gtest/gtest.h>

#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::statistics_test {
namespace {

constexpr double kRoundOff = 1e-12;
constexpr Eigen::Index kRollers = 2;
constexpr Eigen::Index kPositions = 8;

Snapshot sample_at(double first_angle, double first_load, double second_load, double cage_angle) {
  Snapshot sample;
  for (RaceSnapshot* race : {&sample.inner, &sample.outer}) {
    race->load = Eigen::Array2d(first_load, second_load);
    race->sliding = Eigen::Array2d(0.1, -0.3);
    race->entrainment = Eigen::Array2d::Ones();
    race->least_film = Eigen::Array2d(2e-7, 1e-7);
  }
  sample.angle = Eigen::Array2d(first_angle, std::fmod(first_angle + M_PI, 2.0 * M_PI));
  sample.orbital_speed = Eigen::Array2d(2.0, 2.0);
  sample.race_speeds = {0.0, 5.0, 2.0};
  sample.spin = Eigen::Array2d(10.0, 20.0);
  sample.pocket_load = Eigen::Array2d::Zero();
  sample.orbit_angle = cage_angle;
  sample.loss.drag = 4.0;
  return sample;
}

// Each loss goes to its own mean, the parts of one instant are not those of another.
TEST(PowerLoss, MeanOfEachPartIsItsOwn) {
  const PowerLoss first{1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0},
      second{3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0, 17.0, 19.0};
  PowerLoss sum = first;
  sum += second;
  const PowerLoss mean = sum / 2.0;
  EXPECT_EQ(mean.race_damping, 2.0);
  EXPECT_EQ(mean.inner_traction, 3.5);
  EXPECT_EQ(mean.outer_traction, 5.5);
  EXPECT_EQ(mean.rolling, 8.5);
  EXPECT_EQ(mean.drag, 13.5);
  EXPECT_EQ(mean.pockets, 22.5);
  EXPECT_EQ(mean.neighbours, 39.5);
  EXPECT_EQ(mean.guidance, 72.5);
  EXPECT_EQ(mean.support, 137.5);
}

TEST(Statistics, MeansOfAHandMadeWindow) {
  StatisticsCollector collector(kRollers, kPositions);
  collector.begin(1.0, sample_at(0.0, 0.0, 0.0, 5.0));
  collector.add(1.5, sample_at(0.0, 3.0, 1.0, 5.5));
  collector.add(2.0, sample_at(0.05, 4.0, 1.0, 7.0));
  const WindowStatistics means = collector.means();
  EXPECT_EQ(means.samples, 2);
  EXPECT_NEAR(means.orbit_speed, 2.0, kRoundOff);
  EXPECT_NEAR(means.mean_spin, 15.0, kRoundOff);
  EXPECT_NEAR(means.loss.total(), 4.0, kRoundOff);
  EXPECT_NEAR(means.inner.roller_rms[0], std::sqrt((3.0 * 3.0 + 4.0 * 4.0) / 2.0), kRoundOff);
  EXPECT_NEAR(means.inner.load_rms, std::sqrt((9.0 + 1.0 + 16.0 + 1.0) / 4.0), kRoundOff);
  EXPECT_NEAR(means.inner.mean_sliding, 0.2, kRoundOff);
  EXPECT_EQ(means.inner.load_max, 4.0);
  EXPECT_EQ(means.inner.least_film, 2e-7) << "of the most loaded roller";
  EXPECT_NEAR(means.outer.mean_load[0], 3.5, kRoundOff);
  EXPECT_NEAR(means.outer.mean_load[kPositions / 2], 1.0, kRoundOff);
  // Two of 2 samples x 2 rollers x 8 bins, 32 in all, fell on the first bin.
  EXPECT_NEAR(means.outer.passages[0], 2.0 * kPositions / 4.0, kRoundOff);
  EXPECT_NEAR(means.outer.damage[0], (81.0 + 256.0) * kPositions / 4.0, 1e3 * kRoundOff);
}

}  // namespace
}  // namespace orbearing::bearing::motion::statistics_test
