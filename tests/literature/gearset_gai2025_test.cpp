// The three sets of [Gai2025]. The paper prints teeth and shifts only; the numbers here were recomputed from
// them by a script independent of this project.
#include <gtest/gtest.h>

#include <numbers>

#include "gearset/planet_body.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::gearset_gai2025_test {
namespace {

struct Row {
  double planet_shift;     // [module]
  double centre_distance;  // [mm]
};

struct Angles {
  double sun, ring;  // [deg]
};

constexpr double half_digit_shift = 0.5e-4;   // [module]  four decimals are given
constexpr double half_digit_length = 0.5e-3;  // [mm]      three
constexpr double half_digit_angle = 0.5e-3;   // [deg]     three
constexpr double half_digit_mass = 0.5e-3;    // [kg]      three

void expect_rows(double sun_sign, const std::vector<Row>& rows) {
  const auto sets = gai_sets(sun_sign);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const WorkingGeometry geometry = working_geometry(sets[i]);
    EXPECT_NEAR(geometry.planet_shift, rows[i].planet_shift, half_digit_shift) << "set " << i;
    EXPECT_NEAR(1e3 * geometry.centre_distance, rows[i].centre_distance, half_digit_length) << "set " << i;
  }
}

TEST(Gai2025, ShiftsWithPositiveSun) {
  expect_rows(1.0, {{-0.4594, 87.891}, {-0.3965, 97.331}, {-0.3136, 81.969}});
}

TEST(Gai2025, ShiftsWithNegativeSun) {
  expect_rows(-1.0, {{-0.1661, 87.132}, {-0.1303, 96.445}, {0.0376, 80.865}});
}

TEST(Gai2025, WorkingPressureAngles) {
  const std::vector<Angles> rows{{18.879, 23.918}, {18.889, 24.834}, {19.940, 26.595}};
  const auto sets = gai_sets(1.0);
  constexpr double degree = std::numbers::pi / 180.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const WorkingGeometry geometry = working_geometry(sets[i]);
    EXPECT_NEAR(geometry.sun_mesh.working_pressure_angle / degree, rows[i].sun, half_digit_angle)
        << "set " << i;
    EXPECT_NEAR(geometry.ring_mesh.working_pressure_angle / degree, rows[i].ring, half_digit_angle)
        << "set " << i;
  }
}

// Planet gear and the outer rings of its two bearings.
double planet_mass(const PlanetarySet& set) {
  const double ring_area = std::numbers::pi / 4.0 * (47e-3 * 47e-3 - 40.88e-3 * 40.88e-3);
  return planet_body(set, working_geometry(set)).mass + 2.0 * 11.9e-3 * ring_area * set.density;
}

TEST(Gai2025, PlanetMass) {
  EXPECT_NEAR(planet_mass(gai_sets(1.0).front()), 0.372, half_digit_mass);
  EXPECT_NEAR(planet_mass(gai_sets(-1.0).front()), 0.416, half_digit_mass);
}

TEST(Gai2025, PositiveSunShiftsUndercutThePlanets) {
  for (const PlanetarySet& set : gai_sets(1.0)) EXPECT_TRUE(working_geometry(set).planet.undercut);
}

}  // namespace
}  // namespace orbearing::gearset::gearset_gai2025_test
