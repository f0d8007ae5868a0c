// The slip of a cage under quasi-static loads against that of the bearing in motion: where the bore rotates
// about a pin, with rolling resistance, which moves rollers along, and without; and where a shaft rotates.
#include <gtest/gtest.h>

#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/motion/drag_slip.hpp"
#include "coupling/system/steady_state.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::drag_slip_motion_test {
namespace {

constexpr double kStated = 0.03;  // [-]  as the result states of itself: docs/slip_and_branches.md

struct Condition {
  const char* name;
  bool shaft_turns = false;
  bool rolling_resistance = true;
  Race guidance = Race::inner;
};

class DragSlipInMotion : public testing::TestWithParam<Condition> {};

TEST_P(DragSlipInMotion, Agrees) {
  Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.drag.oil_share = 0.5;
  parameters.race.squeeze = true;
  parameters.race.rolling_resistance = GetParam().rolling_resistance;
  bearing.cage.guidance = GetParam().guidance;
  parameters.cage.guide_diameter = GetParam().guidance == Race::outer ? 38.88e-3 : 33.1e-3;
  OperatingPoint point;
  point.outer_speed = 1050.0;
  if (GetParam().shaft_turns) point = {.inner_speed = 1400.0};
  point.bore_load = {0.0, 60.0};
  const BearingModel model = bearing_model(bearing, point, parameters);
  const QuasiStaticResult rest = quasi_static_bearing(bearing, point, {});
  const std::optional<double> slip = drag_slip(model, {rest.inner_load, rest.outer_load});
  ASSERT_TRUE(slip.has_value());
  system::SteadyStateOptions options;
  options.allowed_length_error = 2e-9;
  options.observed_windows = 2;
  const system::SteadyStateResult run = system::run_to_steady_state(bearing, point, parameters, options);
  ASSERT_TRUE(run.completed) << run.message;
  EXPECT_NEAR(*slip, run.orbit_slip(), kStated);
  EXPECT_GT(drag_over_traction(model, {rest.inner_load, rest.outer_load}), 1.0) << "lightly loaded";
}

INSTANTIATE_TEST_SUITE_P(Conditions, DragSlipInMotion,
                         testing::Values(Condition{.name = "bore"},
                                         Condition{.name = "bore_without_rolling_resistance",
                                                   .rolling_resistance = false},
                                         Condition{.name = "bore_that_guides", .guidance = Race::outer},
                                         Condition{.name = "shaft", .shaft_turns = true},
                                         Condition{.name = "shaft_without_rolling_resistance",
                                                   .shaft_turns = true,
                                                   .rolling_resistance = false}),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace orbearing::bearing::motion::drag_slip_motion_test
