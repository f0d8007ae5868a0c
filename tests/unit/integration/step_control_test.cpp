#include "coupling/integration/step_control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace orbearing::integration::step_control_test {
namespace {

constexpr double kStep = 1e-6;  // [s]

TEST(StepControl, AStepOfOrderTwoJustPasses) {
  // Error h^2 and a target of 0.85^2.
  StepControl control(1.0);
  EXPECT_DOUBLE_EQ(control.after_refusal(kStep, 4.0), 0.85 / 2.0 * kStep);
  EXPECT_DOUBLE_EQ(control.after_acceptance(kStep, 0.81), 0.85 / 0.9 * kStep);
}

TEST(StepControl, AStepOfOrderThreeJustPasses) {
  StepControl control(1.0, 3);
  EXPECT_DOUBLE_EQ(control.after_refusal(kStep, 8.0), 0.85 / 2.0 * kStep);
  EXPECT_DOUBLE_EQ(control.after_acceptance(kStep, 0.729), 0.85 / 0.9 * kStep);
}

TEST(StepControl, StepsDoNotGrowAfterARefusal) {
  StepControl control(1.0);
  control.after_refusal(kStep, 2.0);
  EXPECT_DOUBLE_EQ(control.after_acceptance(kStep, 1e-3), kStep) << "the first after it";
  EXPECT_DOUBLE_EQ(control.after_acceptance(kStep, 1e-3), 1.25 * kStep) << "the second";
}

TEST(StepControl, AStepThatOnlyJustPassedShrinksAfterARefusalToo) {
  StepControl control(1.0);
  control.after_refusal(kStep, 2.0);
  EXPECT_DOUBLE_EQ(control.after_acceptance(kStep, 1.0), 0.85 * kStep);
}

TEST(StepControl, GrowthIsAQuarterAtMostAndEndsAtTheLongestStep) {
  StepControl control(1.1 * kStep);
  EXPECT_DOUBLE_EQ(control.after_acceptance(kStep, 0.0), 1.1 * kStep);
  EXPECT_DOUBLE_EQ(control.after_acceptance(0.5 * kStep, 0.0), 0.625 * kStep);
}

// 0.85 before^(0.2/p) / error^(0.6/p).
TEST(StepControl, ByTwoErrorsARisingOneTellsOfTheNext) {
  StepControl control(1.0, 3, StepRule::two_errors);
  control.after_acceptance(kStep, 0.5);
  EXPECT_DOUBLE_EQ(control.after_acceptance(kStep, 0.5), 0.85 / std::pow(0.5, 0.4 / 3.0) * kStep) << "steady";
  StepControl rising(1.0, 3, StepRule::two_errors);
  rising.after_acceptance(kStep, 0.05);
  EXPECT_DOUBLE_EQ(rising.after_acceptance(kStep, 0.5),
                   0.85 * std::pow(0.05, 0.2 / 3.0) / std::pow(0.5, 0.2) * kStep);
}

TEST(StepControl, ByTwoErrorsGrowthIsAHalfAtMostAndNoneAfterARefusal) {
  StepControl control(1.0, 3, StepRule::two_errors);
  EXPECT_DOUBLE_EQ(control.after_acceptance(kStep, 0.0), 1.5 * kStep);
  EXPECT_DOUBLE_EQ(control.after_refusal(kStep, 8.0), 0.85 / 2.0 * kStep);
  EXPECT_DOUBLE_EQ(control.after_acceptance(kStep, 0.0), kStep);
}

TEST(StepControl, AStepOfOrderFourJustPasses) {
  StepControl control(1.0, 4);
  EXPECT_DOUBLE_EQ(control.after_refusal(kStep, 16.0), 0.85 / 2.0 * kStep);
  EXPECT_DOUBLE_EQ(control.after_acceptance(kStep, 0.6561), 0.85 / 0.9 * kStep);
}

// A step that a jump of the mesh stiffness cuts short has an error far below, which is no measure for the
// next.
TEST(StepControl, ByTwoErrorsAStepCutShortIsPassedOver) {
  StepControl control(1.0, 4, StepRule::two_errors);
  const double asked = control.after_acceptance(kStep, 0.5);
  control.after_acceptance(0.2 * asked, 1e-3);
  EXPECT_DOUBLE_EQ(control.after_acceptance(asked, 0.5), 0.85 / std::pow(0.5, 0.4 / 4.0) * asked) << "steady";
}

TEST(StepControl, WithoutAnErrorToGoByAStepIsCutToAFifth) {
  StepControl control(1.0);
  EXPECT_DOUBLE_EQ(control.after_refusal(kStep, std::numeric_limits<double>::infinity()), 0.2 * kStep);
  EXPECT_DOUBLE_EQ(control.after_refusal(kStep, std::nan("")), 0.2 * kStep);
  EXPECT_DOUBLE_EQ(control.after_refusal(kStep, 1e6), 0.2 * kStep);
}

}  // namespace
}  // namespace orbearing::integration::step_control_test
