// The quasi-static bearing finds its equilibrium for any load from 0.01 N to 1 MN: the corners that draws of
// ordinary bearings leave out, such as three rollers, no clearance at all, much clearance or interference,
// and a roller right under the load or opposite to it. RANDOM_BEARINGS scales the number of draws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <random>
#include <sstream>
#include <vector>

#include "bearing/equilibrium/quasi_static.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::bearing_any_load_test {
namespace {

using constants::pi;

constexpr unsigned kSeed = 16281;
constexpr int kDrawsEach = 40;     // for each unit of RANDOM_BEARINGS
constexpr double kBalance = 1e-8;  // of the largest force: the solver stops at 1e-9, and the sum rounds again

struct Corner {
  Bearing bearing;
  OperatingPoint point;
  QuasiStaticOptions options;
  double first_roller = 0.0;  // [rad]
};

std::ostream& operator<<(std::ostream& out, const Corner& c) {
  return out << c.bearing.rollers().count << " rollers " << c.bearing.rollers().diameter << " x "
             << c.bearing.rollers().length << " m on " << c.bearing.pitch_diameter << " m, clearance "
             << c.bearing.radial_clearance << " m, law " << static_cast<int>(c.bearing.contact_law)
             << ", first roller " << c.first_roller << " rad, load " << c.point.bore_load.transpose()
             << " N, carrier " << c.point.carrier.speed << " rad/s at " << c.point.carrier.orbit_radius
             << " m, bore " << c.point.outer_speed << " rad/s, film " << c.options.film.has_value();
}

class Corners {
 public:
  Corner next() {
    Corner corner;
    corner.bearing = bearing();
    corner.point = point();
    const double pitch = 2.0 * pi / corner.bearing.rollers().count;
    // The load lies on a roller, between two of them, or anywhere.
    const double direction = std::atan2(corner.point.bore_load.y(), corner.point.bore_load.x());
    corner.first_roller = direction + pitch * one_of({0.0, 0.5, between(0.0, 1.0)});
    if (yes()) corner.options.film = Lubricant{between(1e-3, 1.0), between(5e-9, 4e-8)};
    return corner;
  }

 private:
  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }
  double decades(double least, double most) { return std::pow(10.0, between(least, most)); }
  bool yes() { return between(0.0, 1.0) < 0.5; }
  double one_of(const std::vector<double>& choices) {
    return choices[std::uniform_int_distribution<std::size_t>(0, choices.size() - 1)(engine_)];
  }

  Bearing bearing() {
    Bearing bearing;
    bearing.rollers().count = std::uniform_int_distribution<int>(3, 60)(engine_);
    bearing.rollers().diameter = decades(-3.0, -1.0);
    bearing.rollers().length = bearing.rollers().diameter * between(0.5, 4.0);
    bearing.pitch_diameter =
        bearing.rollers().diameter / std::sin(pi / bearing.rollers().count) * between(1.01, 2.0);
    bearing.radial_clearance =
        one_of({0.0, decades(-12.0, -3.0), -decades(-12.0, -4.0), between(0.0, 100e-6)});
    bearing.contact_law = yes() ? ContactLaw::palmgren : ContactLaw::iso16281;
    bearing.cage.guidance = yes() ? Race::inner : Race::outer;
    return bearing;
  }

  OperatingPoint point() {
    OperatingPoint point;
    const double direction = one_of({0.0, 0.5 * pi, between(-pi, pi)});
    point.bore_load = decades(-2.0, 6.0) * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    if (yes()) return point;
    point.carrier = {.speed = between(-500.0, 500.0),
                     .acceleration = one_of({0.0, between(-1e4, 1e4)}),
                     .orbit_radius = between(0.0, 1.0)};
    point.inner_speed = one_of({0.0, between(-1000.0, 1000.0)});
    point.outer_speed = between(-1000.0, 1000.0);
    return point;
  }

  std::mt19937_64 engine_{kSeed};
};

int number_of_draws() {
  const char* text = std::getenv("RANDOM_BEARINGS");
  return kDrawsEach * (text == nullptr ? 100 : std::atoi(text));
}

void expect_balance(const Corner& corner, const QuasiStaticState& state) {
  ASSERT_TRUE(state.report.converged) << state.report.message;
  ASSERT_TRUE(state.outer_load.allFinite() && state.inner_load.allFinite() && state.displacement.allFinite());
  EXPECT_GE(std::min(state.outer_load.minCoeff(), state.inner_load.minCoeff()), 0.0);
  Eigen::Vector2d load = corner.point.bore_load;
  if (corner.bearing.cage.guidance == Race::outer) {
    load += load_through_cage(corner.bearing, geometry_of(corner.bearing), corner.point.carrier, {});
  }
  const Eigen::Vector2d rollers((state.outer_load * state.angle.cos()).sum(),
                                (state.outer_load * state.angle.sin()).sum());
  EXPECT_LE((load + rollers).norm(), kBalance * (load.norm() + state.outer_load.maxCoeff()));
}

TEST(AnyLoad, RandomCornersBalance) {
  Corners corners;
  const int draws = number_of_draws();
  ASSERT_GT(draws, 0) << "RANDOM_BEARINGS must be a positive number";
  for (int i = 0; i < draws; ++i) {
    const Corner corner = corners.next();
    std::ostringstream position;
    position << "draw " << i << " of seed " << kSeed << ": " << corner;
    SCOPED_TRACE(position.str());
    expect_balance(corner,
                   quasi_static_state(corner.bearing, corner.point, corner.options, corner.first_roller));
  }
}

}  // namespace
}  // namespace orbearing::bearing::bearing_any_load_test
