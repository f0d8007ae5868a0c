// Published and third-party numbers for gears and sets.
#include <gtest/gtest.h>

#include "gearset/checks.hpp"
#include "gearset/contact_path.hpp"
#include "gearset/mean_loads.hpp"

namespace orbearing::gearset::gearset_reference_numbers_test {
namespace {

TEST(SpurPair62, ContactRatio) {
  constexpr double half_digit = 0.5e-10;
  const ExternalTooth gear = make_external_tooth(62, 0.0, 2e-3, {});
  EXPECT_NEAR(contact_ratio(external_contact_path(gear, gear, 124e-3), gear), 1.7897798668, half_digit);
}

TEST(SpurPair62, BaseRadius) {
  constexpr double half_digit = 0.5e-5;  // [mm]
  EXPECT_NEAR(1e3 * make_external_tooth(62, 0.0, 2e-3, {}).base_radius, 58.26094, half_digit);
}

// Low-speed stage of the 750 kW research gearbox, two bearings in each planet [Oyague2011].
TEST(Oyague2011, MeanPlanetBearingLoad) {
  constexpr double half_digit = 0.05;  // [kN]
  EXPECT_NEAR(1e-3 * planet_tangential_load(325e3, 3, 308e-3) / 2.0, 175.9, half_digit);
}

bool equally_spaced(int sun, int planet, int ring, int planets) {
  const PlanetarySet set{sun, planet, ring, planets, 3e-3, {}, 0.0, 0.0, 20e-3, 0.0};
  for (const Warning& problem : assembly_problems(set)) {
    if (problem.text.find("divisor") != std::string::npos) return false;
  }
  return true;
}

TEST(Assembly, OfEquallySpacedPlanets) {
  EXPECT_TRUE(equally_spaced(21, 39, 99, 3));
  EXPECT_TRUE(equally_spaced(37, 22, 79, 4));
  EXPECT_FALSE(equally_spaced(27, 35, 99, 4));
}

}  // namespace
}  // namespace orbearing::gearset::gearset_reference_numbers_test
