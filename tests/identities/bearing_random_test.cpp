// What must hold for every roller bearing, load and motion: bearings drawn at random, RANDOM_BEARINGS of
// them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <random>
#include <string>

#include "bearing/carrier_frame.hpp"
#include "bearing/quasi_static.hpp"

namespace orbearing::bearing {
namespace {

constexpr unsigned kSeed = 20260101;
// Of the largest force at hand: the solver stops below 1e-9, and the sum over up to 30 rollers rounds again.
constexpr double kBalance = 1e-8;

struct Draw {
  CylindricalRollerBearing bearing;
  OperatingPoint point;
  QuasiStaticOptions options;
};

std::ostream& operator<<(std::ostream& out, const Draw& draw) {
  const CylindricalRollerBearing& b = draw.bearing;
  return out << b.rollers << " rollers of " << b.roller_diameter << " x " << b.roller_length << " m on "
             << b.pitch_diameter << " m, clearance " << b.radial_clearance << " m, load "
             << draw.point.bore_load.transpose() << " N, carrier " << draw.point.carrier.speed << " rad/s at "
             << draw.point.carrier.orbit_radius << " m, bore " << draw.point.outer_speed << " rad/s, film "
             << draw.options.film.has_value();
}

class RandomBearings {
 public:
  Draw next() {
    Draw draw;
    draw.bearing = bearing();
    draw.point = point();
    draw.options.cage_positions = 1;
    draw.options.first_roller = between(0.0, 6.0);
    if (between(0.0, 1.0) < 0.5) draw.options.film = Lubricant{between(0.003, 0.2), 1.5e-8};
    return draw;
  }

 private:
  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }

  CylindricalRollerBearing bearing() {
    CylindricalRollerBearing bearing;
    bearing.rollers = std::uniform_int_distribution<int>(6, 30)(engine_);
    bearing.roller_diameter = between(2e-3, 30e-3);
    bearing.roller_length = bearing.roller_diameter * between(0.8, 3.0);
    const double touching = bearing.roller_diameter / std::sin(3.141592653589793 / bearing.rollers);
    bearing.pitch_diameter = touching * between(1.02, 1.5);
    bearing.radial_clearance = between(-20e-6, 100e-6);
    bearing.bore = 0.8 * (bearing.pitch_diameter - bearing.roller_diameter);
    bearing.outside_diameter = 1.2 * (bearing.pitch_diameter + bearing.roller_diameter);
    bearing.width = 1.2 * bearing.roller_length;
    bearing.cage = {.inner_diameter = bearing.pitch_diameter - 0.3 * bearing.roller_diameter,
                    .outer_diameter = bearing.pitch_diameter + 0.3 * bearing.roller_diameter,
                    .width = bearing.width,
                    .density = 7850.0};
    return bearing;
  }

  OperatingPoint point() {
    OperatingPoint point;
    const double load = std::pow(10.0, between(-2.0, 6.0));
    const double angle = between(0.0, 6.3);
    point.bore_load = load * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    point.carrier = {
        .speed = between(0.0, 600.0), .acceleration = between(-1e3, 1e3), .orbit_radius = between(0.0, 0.5)};
    point.outer_speed = between(-1500.0, 1500.0);
    return point;
  }

  std::mt19937_64 engine_{kSeed};
};

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
  const RollerBearingGeometry geometry = geometry_of(draw.bearing);
  const Eigen::Vector2d cage =
      load_through_cage(draw.bearing, geometry, draw.point.carrier, draw.options.inertia);
  const Eigen::Vector2d sum = draw.point.bore_load + cage + roller_force(state);
  EXPECT_LE(sum.norm(), kBalance * (largest_force(draw, state) + cage.norm())) << draw;
}

void expect_roller_balance(const Draw& draw, const QuasiStaticState& state) {
  const RollerBearingGeometry geometry = geometry_of(draw.bearing);
  const CarrierFrame frame = carrier_frame(draw.point.carrier, draw.options.inertia);
  const double cage_speed = kinematic_cage_speed(geometry, draw.point.inner_speed, draw.point.outer_speed);
  for (Eigen::Index j = 0; j < state.angle.size(); ++j) {
    const double inertial = geometry.roller_mass * radial_inertial_acceleration(frame, geometry.pitch_radius,
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
}  // namespace orbearing::bearing
