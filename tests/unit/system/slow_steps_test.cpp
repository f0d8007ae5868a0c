// Bounds of steps of slow motion, and the part that a motion without steps names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "coupling/system/bearing_steps.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::system::slow_steps_test {
namespace {

using bearing::Bearing;
using bearing::motion::BearingModel;
using bearing::vectorised::VectorBearing;

constexpr double kSlow = 8.0;

BearingModel reducer_model(bool caged) {
  Bearing bearing = test::reducer_bearing();
  if (!caged) bearing.cage = {};
  return bearing_model(bearing, test::reducer_point(6000.0), test::reducer_parameters());
}

// Allowed error of a group of rollers, slow over fast.
double ratio(const BearingModel& model, int group) {
  const VectorBearing bearing(model);
  const Eigen::VectorXd allowed = allowed_errors(model, 2e-10);
  const auto first = static_cast<std::size_t>(group * bearing.layout().lanes());
  return steps_of_order(2, bearing, allowed, kSlow).allowed[first] /
         steps_of_order(2, bearing, allowed, 1.0).allowed[first];
}

TEST(SlowSteps, AreLongerWithSmallerErrors) {
  const BearingModel model = reducer_model(true);
  const VectorBearing bearing(model);
  const Eigen::VectorXd allowed = allowed_errors(model, 2e-10);
  EXPECT_DOUBLE_EQ(steps_of_order(2, bearing, allowed, kSlow).longest,
                   kSlow * steps_of_order(2, bearing, allowed, 1.0).longest);
  for (int group = 0; group < 5; ++group) EXPECT_NEAR(ratio(model, group), 1.0 / kSlow, 1e-12) << group;
}

TEST(SlowSteps, OfFullComplementsKeepTheErrorsOfRadialSpeeds) {
  const BearingModel model = reducer_model(false);
  for (int group = 0; group < 5; ++group)
    EXPECT_NEAR(ratio(model, group), group == 2 ? 1.0 : 1.0 / kSlow, 1e-12) << group;
}

TEST(Slowness, IsTheSameOfABearingThatOthersDrive) {
  const BearingModel model = reducer_model(true);
  EXPECT_DOUBLE_EQ(slowness(model), slowness(model, model.kinematic_cage_speed));
  EXPECT_DOUBLE_EQ(slowness(model, 0.01 * model.kinematic_cage_speed),
                   slowness(model, -0.01 * model.kinematic_cage_speed));
  EXPECT_GT(slowness(model, 0.01 * model.kinematic_cage_speed), 1.0);
}

TEST(Slowness, OfMoreThanTwoIsSlowMotion) {
  const auto model_at = [](double rpm) {
    return bearing_model(test::reducer_bearing(), test::reducer_point(rpm), test::reducer_parameters());
  };
  const double slow = slowness(model_at(10.0));  // falls as the speed rises
  EXPECT_FALSE(is_slow(model_at(10.0 * slow / 1.99)));
  EXPECT_TRUE(is_slow(model_at(10.0 * slow / 2.01)));
}

TEST(FastestVibration, IsThatOfTheLightestPartOnTheStiffestSpring) {
  using testing::HasSubstr;
  BearingModel model = reducer_model(true);
  model.pin_mass = 1e-9;
  EXPECT_THAT(fastest_vibration(model), HasSubstr("the inner ring or pin (1e-09 kg) on support.stiffness"));
  model.cage.mass = 1e-15;
  EXPECT_THAT(fastest_vibration(model), HasSubstr("the cage (1e-15 kg) on bearing.cage.pocket_stiffness"));
}

// Both races hold a roller.
TEST(FastestVibration, OfARollerIsThatBetweenItsRaces) {
  BearingModel model = reducer_model(true);
  model.roller.mass = 1e-9;
  model.pocket.stiffness = 1.0;
  const double stiffness = 2.0 * race_load(model.inner, kTypicalApproach, 1.0) / kTypicalApproach;
  std::ostringstream expected;
  expected << "a roller (1e-09 kg) on its races (" << stiffness << " N/m), with a period of "
           << 2.0 * M_PI * std::sqrt(1e-9 / stiffness) << " s; state a larger bearing.roller_diameter";
  EXPECT_THAT(fastest_vibration(model), testing::HasSubstr(expected.str()));
}

}  // namespace
}  // namespace orbearing::system::slow_steps_test
