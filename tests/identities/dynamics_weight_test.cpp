// Weight in the motion of a bearing: where unloaded rollers rest, what bears the weight of all bodies, and
// windows of whole turns of the carrier.
#include <gtest/gtest.h>

#include "bearing/motion/initial_state.hpp"
#include "bearing/motion/snapshot.hpp"
#include "coupling/system/free_bearing.hpp"
#include "coupling/system/steady_state.hpp"
#include "mechanics/constants.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::dynamics_weight_test {
namespace {

using constants::two_pi;

constexpr double kLengthError = 2e-10;  // [m]

// A bearing so slow, on a carrier that does not rotate, that there are no centrifugal loads.
OperatingPoint slow_point() {
  OperatingPoint point;
  point.outer_speed = 5.0;  // [rad/s]
  point.carrier.orbit_radius = 87.891e-3;
  point.bore_load = {0.0, 800.0};  // [N]  upward: the rollers at the bottom carry
  return point;
}

DynamicsParameters oiled(const Gravity& gravity) {
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.gravity = gravity;
  parameters.race.squeeze = true;  // impacts are damped
  parameters.drag.on = false;
  return parameters;
}

// Mean over the rollers near the top of where they are between both races: 0 on the pin, 1 on the bore.
double height_at_top(double gravity_angle) {
  Bearing bearing = test::reducer_bearing();
  bearing.radial_clearance = 40e-6;
  const DynamicsParameters parameters = oiled({.across = 9.80665, .angle = gravity_angle});
  const BearingModel model = bearing_model(bearing, slow_point(), parameters);
  system::FreeBearing motion(model, initial_state(bearing, model, parameters, 0.1).x, kLengthError, {});
  motion.advance({0.0, 0.012, 1}, [](double) {});
  const ConstStateViews state = state_views(model.layout, motion.state().data());
  double sum = 0.0;
  int rollers = 0;
  for (Eigen::Index j = 0; j < model.layout.rollers; ++j) {
    const Vector2 outward = direction(state.angle[j]);
    if (outward.y() < 0.8) continue;
    const Vector2 centre = state.radius[j] * outward;
    const double from_pin = (centre - state.pin_position).norm() - model.inner.radius,
                 from_bore = model.outer.radius - (centre - state.bore_position).norm();
    const double radius = model.geometry.element_radius;
    sum += (from_pin - radius) / (from_pin + from_bore - 2.0 * radius);
    ++rollers;
  }
  return sum / rollers;
}

TEST(Weight, UnloadedRollersFallOnThePinAndOffIt) {
  EXPECT_LT(height_at_top(0.0), 0.2);           // gravity presses them on the pin
  EXPECT_GT(height_at_top(0.5 * two_pi), 0.8);  // the same bearing upside down
}

// Rollers bear the load and the weight of the planet: the closed form of a motion whose momentum does not
// grow. On a carrier that rotates the weight turns against it, and its mean over a turn is zero.
TEST(Weight, OfThePlanetIsBorneByItsRollers) {
  constexpr double kSpeed = 2000.0;          // [rad/s]  far below the frequency of the bore on its rollers
  constexpr double kTurn = two_pi / kSpeed;  // [s]
  const Bearing bearing = test::reducer_bearing();
  for (const double carrier_speed : {0.0, kSpeed}) {
    OperatingPoint point = slow_point();
    point.carrier = {.speed = carrier_speed, .orbit_radius = 0.0};
    DynamicsParameters parameters = oiled({.across = 300.0, .angle = 0.4});
    parameters.inertia = {.own_orbit = true, .coriolis = false, .carrier_centrifugal = false};
    const BearingModel model = bearing_model(bearing, point, parameters);
    system::FreeBearing motion(model, initial_state(bearing, model, parameters, 0.1).x, kLengthError, {});
    constexpr long kSamples = 400;
    motion.advance({0.0, kTurn, 1}, [](double) {});
    Vector2 mean = Vector2::Zero(), along = Vector2::Zero();  // along: the weight, and across it
    motion.advance({kTurn, kTurn / kSamples, kSamples}, [&](double time) {
      Snapshot now;
      motion.take_snapshot(0, now);
      const Vector2 borne = -now.on_bore.force - point.bore_load;
      const Vector2 down = gravity_at(model, carrier_speed * time).normalized();
      mean += borne / kSamples;
      along += Vector2(down.dot(borne), cross(down, borne)) / kSamples;
    });
    const double weight = model.bore_mass * parameters.gravity.across, allowed = 0.03 * weight;
    const Vector2 expected = carrier_speed == 0.0 ? weight_on_bore(model, 0.0) : Vector2::Zero();
    EXPECT_LT((mean - expected).norm(), allowed) << carrier_speed << " rad/s";
    EXPECT_NEAR(along.x(), weight, allowed) << carrier_speed << " rad/s";
    EXPECT_NEAR(along.y(), 0.0, allowed) << carrier_speed << " rad/s";
  }
}

TEST(Weight, WindowsAreTurnsOfTheCarrier) {
  const OperatingPoint point = test::reducer_point(24000.0);  // for short turns
  DynamicsParameters parameters = test::reducer_parameters();
  system::SteadyStateOptions options{.integration = {}};
  options.observed_windows = 1;
  options.most_windows = 2;
  parameters.gravity.across = 9.80665;
  const double turn = two_pi / point.carrier.speed;
  const system::SteadyStateResult heavy =
      run_to_steady_state(test::reducer_bearing(), point, parameters, options);
  ASSERT_TRUE(heavy.completed) << heavy.message;
  EXPECT_NEAR(heavy.duration / turn, static_cast<double>(heavy.windows.size()) + 1.0, 1e-9);
  parameters.gravity.across = 0.0;
  EXPECT_EQ(with_window(options, parameters.gravity, point.carrier.speed).window, 0.0);
}

}  // namespace
}  // namespace orbearing::bearing::motion::dynamics_weight_test
