// Properties of every roller bearing, load and motion: bearings drawn at random, RANDOM_BEARINGS of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "bearing/carrier_frame.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "tests/random_bearings.hpp"

namespace orbearing::bearing::bearing_random_test {
namespace {

// Tolerance over the largest force: the solver stops below 1e-9, and the sum over up to 30 rollers adds
// round-off.
constexpr double kBalance = 1e-8;

int number_of_draws() {
  const char* text = std::getenv("RANDOM_BEARINGS");
  return text == nullptr ? 100 : std::atoi(text);
}

double largest_force(const Draw& draw, const QuasiStaticState& state) {
  return std::max({draw.point.bore_load.norm(), state.outer_load.maxCoeff(), state.inner_load.maxCoeff()});
}

/// Force of the rollers on the outer ring [N].
Eigen::Vector2d roller_force(const QuasiStaticState& state) {
  return {(state.outer_load * state.angle.cos()).sum(), (state.outer_load * state.angle.sin()).sum()};
}

void expect_ring_balance(const Draw& draw, const QuasiStaticState& state) {
  const BearingGeometry geometry = geometry_of(draw.bearing);
  const Eigen::Vector2d cage =
      load_through_cage(draw.bearing, geometry, draw.point.carrier, draw.options.inertia);
  const Eigen::Vector2d sum = draw.point.bore_load + cage + roller_force(state);
  EXPECT_LE(sum.norm(), kBalance * (largest_force(draw, state) + cage.norm())) << draw;
}

void expect_roller_balance(const Draw& draw, const QuasiStaticState& state) {
  const BearingGeometry geometry = geometry_of(draw.bearing);
  const CarrierFrame frame = carrier_frame(draw.point.carrier, draw.options.inertia);
  const double cage_speed = kinematic_cage_speed(geometry, draw.point.inner_speed, draw.point.outer_speed);
  for (Eigen::Index j = 0; j < state.angle.size(); ++j) {
    const double inertial = geometry.element_mass * radial_inertial_acceleration(frame, geometry.pitch_radius,
                                                                                 state.angle[j], cage_speed);
    EXPECT_NEAR(state.outer_load[j] - state.inner_load[j], inertial, kBalance * largest_force(draw, state))
        << draw;
  }
}

TEST(RandomBearings, BalanceUnderAnyLoadAndMotion) {
  RandomBearings bearings;
  const int draws = number_of_draws();
  ASSERT_GT(draws, 0) << "RANDOM_BEARINGS must be a positive number";
  for (int i = 0; i < draws; ++i) {
    const Draw draw = bearings.next();
    SCOPED_TRACE("draw " + std::to_string(i) + " of seed " + std::to_string(kSeed));
    const QuasiStaticState state =
        quasi_static_state(draw.bearing, draw.point, draw.options, draw.options.first_roller);
    ASSERT_TRUE(state.report.converged) << draw << ": " << state.report.message;
    ASSERT_TRUE(state.outer_load.allFinite() && state.inner_load.allFinite()) << draw;
    EXPECT_GE(state.outer_load.minCoeff(), 0.0) << draw;
    EXPECT_GE(state.inner_load.minCoeff(), 0.0) << draw;
    expect_ring_balance(draw, state);
    expect_roller_balance(draw, state);
  }
}

}  // namespace
}  // namespace orbearing::bearing::bearing_random_test
