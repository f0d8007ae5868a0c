// Slip of lightly loaded rollers and their cage by drag, rolling resistance and guidance
// against traction.
#include "bearing/motion/drag_slip.hpp"

#include <gtest/gtest.h>

#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::drag_slip_test {
namespace {

constexpr double kFound = 1e-6;  // [-]  to which the search comes

// A bore that rotates about a stationary pin, the cage on a land of the pin or on none.
BearingModel lightly_loaded(double oil_share, bool land = false, bool rolling_resistance = false) {
  Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.drag.oil_share = oil_share;
  parameters.race.rolling_resistance = rolling_resistance;
  parameters.cage.guide_diameter = 0.0;
  parameters.cage.pocket_friction = 0.0;
  if (land) {
    bearing.cage.guidance = Race::inner;
    parameters.cage.guide_diameter = bearing.cage.inner_diameter - 0.4e-3;
  }
  OperatingPoint point = test::reducer_point(6000.0);
  point.carrier = {};
  BearingModel model = bearing_model(bearing, point, parameters);
  model.spin_drag.coefficient = 0.0;
  model.frame.own_orbit = 0.0;  // quasi-static loads, whatever the slip
  return model;
}

// All rollers equal, `total` [N] on each race.
LoadsOfOrbit even(double inner, double outer) {
  return {Eigen::ArrayXd::Constant(60, inner / 15.0), Eigen::ArrayXd::Constant(60, outer / 15.0)};
}

double slip_under(const BearingModel& model, double total) {
  return drag_slip(model, even(total, total)).value();
}

double rolling_speed(const BearingModel& model) {
  return kinematic_cage_speed(model.geometry, model.point.inner_speed, model.point.outer_speed);
}

// Drag of rollers and cage alone grows with the square of the speed: D (1 - s)^2.
double drag_at_rolling(const BearingModel& model) {
  const double speed = std::abs(rolling_speed(model)), pitch = 17.82e-3;
  return 15.0 * model.orbit_drag.coefficient * pitch * pitch * speed * speed +
         model.cage_drag.coefficient * speed * speed / pitch;
}

// Drag along the pitch circle and no moment about a roller's axis leave it the same friction at both races,
// so that both slide by s omega_k d_m / 2 and 2 mu sum(Q) sigma / sqrt(sigma^2 + s_0^2) = D (1 - s)^2.
TEST(DragSlip, BalancesDragAndTractionOfBothRaces) {
  const BearingModel model = lightly_loaded(1.0);
  const double drag = drag_at_rolling(model), mu = model.inner.friction.coulomb.friction,
               scale = model.inner.friction.coulomb.sliding_scale;
  for (const double part : {0.9, 0.5, 0.1}) {  // of the drag that full sliding would hold
    const double loads = part * drag / (2.0 * mu);
    EXPECT_NEAR(drag_over_traction(model, even(loads, loads)), 1.0 / part, 1e-12 / part);
    const double slip = slip_under(model, loads);
    const double sliding = slip * std::abs(rolling_speed(model)) * 17.82e-3;
    // The slope of traction by the slip is mu Q s_0^2 / (..)^(3/2) < 1/s_0 times the speed: some hundred.
    EXPECT_NEAR(2.0 * mu * loads * sliding / std::hypot(sliding, scale) / drag, (1.0 - slip) * (1.0 - slip),
                200.0 * kFound);
    // Full sliding nearly: 1 - s = root of the part.
    EXPECT_NEAR(1.0 - slip, std::sqrt(part), 0.05);
  }
}

// Rollers that the outer race alone touches take their spin from it, and the oil at the inlet pushes them
// with 2 F R_o / r_m in its sense: they orbit where their drag is as large.
TEST(DragSlip, RollingResistanceDrivesUnloadedRollersOfATurningBore) {
  const BearingModel model = lightly_loaded(1.0, false, true);
  const double each = 40.0;  // [N]  with friction enough to spin the roller
  const double slip = drag_slip(model, even(0.0, 15.0 * each)).value();
  const double speed = (1.0 - slip) * rolling_speed(model), race = 17.82e-3 + 2.62e-3;
  const double rolling = std::abs(model.point.outer_speed - speed) * race;
  const double resistance = model.outer.friction.inlet(
      each, rolling, std::log(entrainment_speed(rolling, model.outer.entrainment_scale)));
  const double drag = drag_at_rolling(model) * (1.0 - slip) * (1.0 - slip);
  constexpr double kCreep = 0.02;  // [-]  by which the roller slides to take up F
  EXPECT_NEAR(15.0 * 2.0 * resistance * race / 17.82e-3 / drag, 1.0, kCreep);
  EXPECT_LT(slip, 1.0);
  EXPECT_EQ(drag_slip(lightly_loaded(1.0), even(0.0, 15.0 * each)).value(), 1.0) << "nothing drives";
}

// The same force pushes against the orbit where the inner race turns.
TEST(DragSlip, RollingResistanceHoldsRollersBackAboutATurningShaft) {
  const auto slip = [](bool inner_turns, bool rolling_resistance) {
    BearingModel model = lightly_loaded(1.0, false, rolling_resistance);
    if (inner_turns) std::swap(model.point.inner_speed, model.point.outer_speed);
    LoadsOfOrbit loads = even(0.0, 15.0);
    loads.inner.head(15).setConstant(100.0);
    loads.outer.head(15).setConstant(101.0);
    return drag_slip(model, loads).value();
  };
  EXPECT_LT(slip(false, true), slip(false, false));
  EXPECT_GT(slip(true, true), slip(true, false));
}

TEST(DragSlip, EndsAtPureRollingAndAtRest) {
  EXPECT_NEAR(slip_under(lightly_loaded(0.0), 100.0), 0.0, kFound) << "nothing resists";
  EXPECT_EQ(drag_over_traction(lightly_loaded(0.0), even(100.0, 100.0)), 0.0);
  const BearingModel model = lightly_loaded(1.0);
  EXPECT_NEAR(slip_under(model, 0.0), 1.0, kFound) << "nothing drives";
  EXPECT_NEAR(slip_under(model, 1e9), 0.0, kFound);
}

TEST(DragSlip, FallsWithLoadAndRisesWithOil) {
  double before = 1.0;
  for (const double loads : {10.0, 30.0, 100.0, 300.0}) {
    const double slip = slip_under(lightly_loaded(1.0), loads);
    EXPECT_LT(slip, before);
    EXPECT_LT(slip_under(lightly_loaded(0.5), loads), slip);
    before = slip;
  }
}

TEST(DragSlip, CountsTheFilmOfTheLand) {
  const BearingModel free = lightly_loaded(1.0), guided = lightly_loaded(1.0, true);
  const double speed = rolling_speed(guided), pitch = 17.82e-3;
  const double film = resistance_to_orbit(guided, speed) - resistance_to_orbit(free, speed);
  EXPECT_NEAR(film * pitch, guided.land.law.shear_scale * std::abs(speed), 1e-12 + 1e-9 * film * pitch)
      << "by Petroff, of a land that stands";
  EXPECT_GT(slip_under(guided, 60.0), slip_under(free, 60.0));
}

// A cage that the carrier's field presses to one side shears the film of its land more.
TEST(DragSlip, ADisplacedCageIsHeldBackMore) {
  BearingModel model = lightly_loaded(1.0, true);
  const double centred = slip_under(model, 60.0);
  model.roller.mass = 0.0;  // rollers without weight leave the cage where its own takes it
  model.frame.centrifugal = 1e4;
  model.frame.orbit_radius = 0.1;
  EXPECT_GT(slip_under(model, 60.0), centred);
}

TEST(DragSlip, DoesNotDependOnTheSenseOfRotation) {
  for (const bool rolling_resistance : {false, true}) {
    BearingModel model = lightly_loaded(1.0, true, rolling_resistance);
    const double forward = slip_under(model, 60.0);
    model.point.outer_speed = -model.point.outer_speed;
    EXPECT_NEAR(slip_under(model, 60.0), forward, kFound);
  }
}

// A land of the bore drives the cage: in either sense a stationary cage is driven as much.
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
