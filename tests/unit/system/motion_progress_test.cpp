// Progress of a motion, for all observers, and without a change of its numbers.
#include "coupling/system/motion_progress.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "coupling/analysis/multi_stage.hpp"
#include "tests/reducer.hpp"

namespace orbearing::system::motion_progress_test {
namespace {

analysis::PointResult motion_of_reducer() {
  analysis::NamedSet set{"", example::reducer(), {}};
  set.drivetrain.steady_state.integration.method = integration::Method::linearly_implicit;
  set.drivetrain.steady_state.observed_windows = 40;  // some tenths of a second, in which they are told
  set.drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  set.geometry = derive(set.drivetrain);
  return evaluate({set}, analysis::Fidelity::dynamic);
}

TEST(MotionProgress, AllWhoWatchSeeOneMotionToItsEnd) {
  std::vector<MotionProgress> one, other;
  const auto kept_in = [](std::vector<MotionProgress>& list) {
    return [&list](const MotionProgress& now) { list.push_back(now); };
  };
  const analysis::PointResult unseen = motion_of_reducer();
  analysis::PointResult seen;
  {
    const ObservedMotions first(kept_in(one)), second(kept_in(other));
    const RunInTurn turn(2, 8);
    seen = motion_of_reducer();
  }
  EXPECT_EQ(seen.life_hours, unseen.life_hours);
  EXPECT_EQ(seen.dynamic->final_state, unseen.dynamic->final_state);
  ASSERT_GT(one.size(), 1U);
  ASSERT_EQ(other.size(), one.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(other[i].time, one[i].time);
    EXPECT_LE(one[i].time, one[i].expected);
    EXPECT_LE(one[i].expected, one[i].most);
    EXPECT_EQ(one[i].run, 2);
    EXPECT_EQ(one[i].most_runs, 8);
  }
  // Once the means are taken, the end is known.
  EXPECT_NEAR(one.back().expected, unseen.dynamic->series.time.tail(1)[0], 0.01 * one.back().expected);
  const std::size_t told = one.size();
  motion_of_reducer();
  EXPECT_EQ(one.size(), told) << "nobody watches any more";
}

TEST(MotionProgress, ShareIsOfWhatIsExpected) {
  const bearing::motion::Snapshot nothing;
  EXPECT_DOUBLE_EQ((MotionProgress{.time = 0.1, .most = 1.0, .expected = 0.4, .bearing = nothing}.share()),
                   0.25);
  EXPECT_DOUBLE_EQ((MotionProgress{.time = 0.5, .most = 1.0, .expected = 0.4, .bearing = nothing}.share()),
                   1.0);
}

}  // namespace
}  // namespace orbearing::system::motion_progress_test
