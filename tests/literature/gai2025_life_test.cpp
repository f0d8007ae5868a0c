// Life of the planet bearing of the reduction set over the sun's speed at 150 kW, printed in [Gai2025];
// quasi-static, without film, with the assumptions that the source leaves open fixed beforehand: two bearings
// per planet, no clearance, planet of 0.372 kg, cage in glass-filled polyamide, lambda nu = 0.83. Loads by
// hand from the gear data.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "mechanics/constants.hpp"
#include "tests/unit/bearing/example_bearings.hpp"
#include "tests/whole_contact_life.hpp"

namespace orbearing::bearing::gai2025_life_test {
namespace {

constexpr double kPublishedPeakLife = 43869.0;  // [h]
constexpr double kOpenAssumptions =
    0.15;                         // planet mass, cage, clearance and shifts are not given: agreed beforehand
constexpr double kPower = 150e3;  // [W]
constexpr double kPlanets = 4.0;
constexpr double kBearingsPerPlanet = 2.0;
constexpr double kPlanetMass = 0.372;  // [kg]

using constants::degree;  // [rad]

// Half of the planet's mesh forces and of its own centrifugal load.
OperatingPoint planet_bearing_at(double sun_speed) {
  OperatingPoint point = example_bearings::planet_motion(sun_speed);
  const double sun_base_radius = 0.5 * 37.0 * 3e-3 * std::cos(20.0 * degree);
  const double tooth_force = kPower / sun_speed / (kPlanets * sun_base_radius);
  const double tangential = tooth_force * (std::cos(18.879 * degree) + std::cos(23.918 * degree));
  const double radial = tooth_force * (std::sin(18.879 * degree) - std::sin(23.918 * degree));
  const double centrifugal =
      kPlanetMass * point.carrier.speed * point.carrier.speed * point.carrier.orbit_radius;
  point.bore_load = Eigen::Vector2d(radial + centrifugal, tangential) / kBearingsPerPlanet;
  return point;
}

struct SpeedPoint {
  double life;          // [h]  of one bearing
  double largest_load;  // [N]  of a roller
};

SpeedPoint speed_point(double sun_speed_rpm) {
  const Bearing bearing = example_bearings::planet_bearing();
  const OperatingPoint point = planet_bearing_at(example_bearings::rpm(sun_speed_rpm));
  const QuasiStaticResult result = quasi_static_bearing(bearing, point, {});
  EXPECT_TRUE(result.report.converged) << result.report.message;
  const BearingLife life = whole_contact_life(bearing, 0.83, result.inner_load, result.outer_load);
  return {hours(life.bearing, point.outer_speed), result.outer_load.maxCoeff()};
}

std::vector<SpeedPoint> published_grid() {
  std::vector<SpeedPoint> points;
  for (int thousand = 1; thousand <= 12; ++thousand) points.push_back(speed_point(1000.0 * thousand));
  return points;
}

TEST(Gai2025, LongestLifeAndLeastLoadOfTheGridAt6000rpm) {
  const std::vector<SpeedPoint> grid = published_grid();
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (i == 5) continue;
    EXPECT_LT(grid[i].life, grid[5].life) << 1000 * (i + 1) << " rpm";
    EXPECT_GT(grid[i].largest_load, grid[5].largest_load) << 1000 * (i + 1) << " rpm";
  }
}

TEST(Gai2025, LifeAtThePeak) {
  RecordProperty("life_h", std::to_string(speed_point(6000.0).life));
  EXPECT_NEAR(speed_point(6000.0).life / kPublishedPeakLife, 1.0, kOpenAssumptions);
}

// The source finds the shortest life of its whole grid at 12000 rpm. From 2000 rpm on so do we; at 1000 rpm
// we do not, since 150 kW there take a sixth of the speed and six times the tooth forces of 6000 rpm, more
// than its printed loads.
TEST(Gai2025, ShortestLifeAt12000rpmButForThePointOf1000rpm) {
  const std::vector<SpeedPoint> grid = published_grid();
  for (std::size_t i = 1; i + 1 < grid.size(); ++i)
    EXPECT_GT(grid[i].life, grid.back().life) << 1000 * (i + 1);
  EXPECT_LT(grid.front().life, grid.back().life);
}

}  // namespace
}  // namespace orbearing::bearing::gai2025_life_test
