// Windows of motions that keep to a budget of processor time.
#include "coupling/analysis/motion_budget.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace orbearing::analysis::motion_budget_test {
namespace {

// Runs of 10 ms a revolution with steps of 4 us, of which errors allow 2 us.
MotionEstimate estimate() {
  const MotionWork work{.runs = 2.0,
                        .settling = 5.0,
                        .turn = 10e-3,
                        .longest_step = 4e-6,
                        .accurate_step = 2e-6,
                        .step_seconds = 3e-6};
  return {.points = {{work}, {work, work}}, .added = {{work}}, .stated = {}};
}

TEST(MotionBudget, KeepsTheStatedWindowsWhereTheyFit) {
  const BudgetedWindows found = windows_within(estimate().seconds({}), estimate());
  EXPECT_TRUE(found.within);
  EXPECT_EQ(found.windows, MotionWindows{});
}

TEST(MotionBudget, TakesFewerRevolutionsForTheMeansFirst) {
  const BudgetedWindows found = windows_within(0.9 * estimate().seconds({}), estimate());
  EXPECT_TRUE(found.within);
  EXPECT_LT(found.windows.observed, MotionWindows{}.observed);
  EXPECT_EQ(found.windows.most, MotionWindows{}.most);
  EXPECT_EQ(found.windows.length_error, MotionWindows{}.length_error);
  MotionWindows longer = found.windows;
  ++longer.observed;
  const double of_longer = estimate().seconds(longer), of_all = estimate().seconds({});
  EXPECT_GT(of_longer, 0.9 * of_all);
}

TEST(MotionBudget, GivesTheShortestWhereNoneFits) {
  const BudgetedWindows found = windows_within(1e-6, estimate());
  EXPECT_FALSE(found.within);
  EXPECT_EQ(found.windows, (MotionWindows{.observed = 3, .most = 4, .length_error = kLargestLengthError}));
  EXPECT_THAT(cost_text(found.windows, {}), testing::HasSubstr("and up to 2 % by the larger error of steps"));
}

TEST(MotionBudget, TimesHaveTwoDigits) {
  EXPECT_EQ(time_text(12.34), "12 s");
  EXPECT_EQ(time_text(150.0), "2.5 min");
  EXPECT_EQ(time_text(36000.0), "10 h");
}

}  // namespace
}  // namespace orbearing::analysis::motion_budget_test
