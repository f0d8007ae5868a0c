// Issue 49, Build 3: slip of lightly loaded rollers by drag against traction.
#include "bearing/motion/drag_slip.hpp"

#include <gtest/gtest.h>

#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::drag_slip_test {
namespace {

constexpr double kHalvings = 1e-12;  // 50 of the whole range, and round-off
constexpr double kTransition = 1e-9;

// A bore that turns about a pin that stands, the cage on a land of the pin or on none.
BearingModel lightly_loaded(double oil_share, bool land = false) {
  Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.drag.oil_share = oil_share;
  parameters.cage.guide_diameter = 0.0;
  if (land) {
    bearing.cage.guidance = Race::inner;
    parameters.cage.guide_diameter = bearing.cage.inner_diameter - 0.4e-3;
  }
  OperatingPoint point = test::reducer_point(6000.0);
  point.carrier = {};
  return bearing_model(bearing, point, parameters);
}

double rolling_speed(const BearingModel& model) {
  return kinematic_cage_speed(model.geometry, 0.0, model.point.outer_speed);
}

// Drag of rollers and cage alone grows with the square of the speed: D (1 - s)^2.
double drag_at_rolling(const BearingModel& model) {
  const double speed = std::abs(rolling_speed(model)), pitch = 17.82e-3;
  return 15.0 * model.orbit_drag.coefficient * pitch * pitch * speed * speed +
         model.cage_drag.coefficient * speed * speed / pitch;
}

TEST(DragSlip, BalancesDragAndTractionOfBothRaces) {
  const BearingModel model = lightly_loaded(1.0);
  const double drag = drag_at_rolling(model), mu = model.inner.friction.coulomb.friction,
               scale = model.inner.friction.coulomb.sliding_scale;
  for (const double part : {0.9, 0.5, 0.1}) {  // of the drag that full sliding would hold
    const double loads = part * drag / (2.0 * mu);
    const double slip = drag_slip(model, loads);
    const double sliding = slip * std::abs(rolling_speed(model)) * 17.82e-3;
    EXPECT_NEAR(2.0 * mu * loads * sliding / std::hypot(sliding, scale) / drag, (1.0 - slip) * (1.0 - slip),
                kTransition);
    // Full sliding nearly: 1 - s = root of the part.
    EXPECT_NEAR(1.0 - slip, std::sqrt(part), 0.05);
  }
}

TEST(DragSlip, EndsAtPureRollingAndAtRest) {
  EXPECT_EQ(drag_slip(lightly_loaded(0.0), 0.0), 0.0) << "nothing resists";
  const BearingModel model = lightly_loaded(1.0);
  EXPECT_NEAR(drag_slip(model, 0.0), 1.0, 1e-6) << "nothing drives";
  EXPECT_NEAR(drag_slip(model, 1e9), 0.0, 1e-6);
}

TEST(DragSlip, FallsWithLoadAndRisesWithOil) {
  double before = 1.0;
  for (const double loads : {10.0, 30.0, 100.0, 300.0}) {
    const double slip = drag_slip(lightly_loaded(1.0), loads);
    EXPECT_LT(slip, before);
    EXPECT_LT(drag_slip(lightly_loaded(0.5), loads), slip);
    before = slip;
  }
}

TEST(DragSlip, CountsTheFilmOfTheLand) {
  const BearingModel free = lightly_loaded(1.0), guided = lightly_loaded(1.0, true);
  const double speed = rolling_speed(guided), pitch = 17.82e-3;
  const double film = resistance_to_orbit(guided, speed) - resistance_to_orbit(free, speed);
  EXPECT_NEAR(film * pitch, guided.land.law.shear_scale * std::abs(speed), kHalvings + 1e-9 * film * pitch)
      << "by Petroff, of a land that stands";
  EXPECT_GT(drag_slip(guided, 60.0), drag_slip(free, 60.0));
}

TEST(DragSlip, DoesNotDependOnTheSenseOfRotation) {
  BearingModel model = lightly_loaded(1.0, true);
  const double forward = drag_slip(model, 60.0);
  model.point.outer_speed = -model.point.outer_speed;
  EXPECT_NEAR(drag_slip(model, 60.0), forward, kHalvings);
}

// A land of the bore drives the cage: in either sense a cage that stands is driven as much.
TEST(DragSlip, ALandOfTheBoreDrivesInEitherSense) {
  Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.cage.guide_diameter = 38.88e-3;
  OperatingPoint point = test::reducer_point(6000.0);
  point.carrier = {};
  BearingModel model = bearing_model(bearing, point, parameters);
  ASSERT_TRUE(model.land.on_bore);
  const double backward = resistance_to_orbit(model, -0.0);
  model.point.outer_speed = -model.point.outer_speed;
  EXPECT_NEAR(resistance_to_orbit(model, 0.0), backward, 1e-12 * std::abs(backward));
  EXPECT_LT(backward, 0.0);
}

}  // namespace
}  // namespace orbearing::bearing::motion::drag_slip_test
