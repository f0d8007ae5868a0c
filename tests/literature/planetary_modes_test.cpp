// Natural frequencies of [LinParker1999], Table 2, for three to five planets, and of [CooleyParker2012],
// Table 2, as printed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearset/dynamics/modes.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::gearset::dynamics::planetary_modes_test {
namespace {

struct Published {
  int planets;
  ModeKind kind;
  int multiplicity;
  std::vector<double> frequencies;  // above zero
};

// Frequencies of one kind above zero, over `unit`.
std::vector<double> frequencies_of(const SetModel& model, const Published& published, double unit) {
  const double still = 1e-3 * unit;  // a free rotation, to round-off
  std::vector<double> ours;
  for (const Mode& mode : modes_at_rest(model)) {
    if (mode.kind != published.kind || mode.frequency < still) continue;
    EXPECT_EQ(mode.multiplicity, published.multiplicity) << mode.frequency << " Hz";
    ours.push_back(mode.frequency / unit);
  }
  return ours;
}

class LinParker1999 : public testing::TestWithParam<Published> {};

TEST_P(LinParker1999, NaturalFrequencies) {
  const std::vector<double> ours =
      frequencies_of(test::lin_parker_model(GetParam().planets), GetParam(), 1.0);
  ASSERT_EQ(ours.size(), GetParam().frequencies.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double published = GetParam().frequencies[i];
    // 727, 1091, 710 and 1072 Hz are rounded to whole hertz.
    const double last_digit = published == std::round(published) && published < 1100.0 ? 0.5 : 0.1;  // [Hz]
    EXPECT_NEAR(ours[i], published, last_digit);
  }
}

constexpr ModeKind rotational = ModeKind::rotational, translational = ModeKind::translational,
                   planet = ModeKind::planet;

INSTANTIATE_TEST_SUITE_P(
    Table, LinParker1999,
    testing::Values(Published{3, rotational, 1, {1475.7, 1930.3, 2658.3, 7462.8, 11775.3}},
                    Published{3, translational, 2, {743.2, 1102.4, 1896.0, 2276.4, 6986.3, 9647.9}},
                    Published{3, planet, 0, {}},
                    Published{4, rotational, 1, {1536.6, 1970.6, 2625.7, 7773.6, 13071.1}},
                    Published{4, translational, 2, {727.0, 1091.0, 1892.8, 2342.5, 7189.9, 10437.6}},
                    Published{4, planet, 1, {1808.2, 5963.8, 6981.7}},
                    Published{5, rotational, 1, {1567.4, 2006.1, 2614.8, 8065.4, 14253.1}},
                    Published{5, translational, 2, {710.0, 1072.0, 1888.1, 2425.3, 7382.4, 11172.3}},
                    Published{5, planet, 2, {1808.2, 5963.8, 6981.7}}));

// Stationary carrier; all members held against rotation.
SetParameters cooley_parker(int planets) {
  const Mesh mesh{.pressure_angle = 20.0 * std::numbers::pi / 180.0,
                  .stiffness = PeriodicCurve::constant(100e6)};
  SetParameters set{.planets = planets,
                    .sun = {3.0, 1.75, 1.0, {.stiffness = 20e6, .torsional_stiffness = 20e6}},
                    .ring = {7.64, 8.09, 1.0, {.stiffness = 100e6, .torsional_stiffness = 100e6}},
                    .carrier = {12.0, 6.80, 1.0, {.stiffness = 50e6, .torsional_stiffness = 100e6}},
                    .planet = {.mass = 1.86, .inertia = 1.25, .radius = 1.0, .bearing_stiffness = 10e6},
                    .sun_mesh = mesh,
                    .ring_mesh = mesh};
  set.sun_phase.assign(static_cast<std::size_t>(planets), 0.0);
  set.ring_phase.assign(static_cast<std::size_t>(planets), 0.0);
  return set;
}

class CooleyParker2012 : public testing::TestWithParam<Published> {};

// Printed over the frequency of a planet on its bearing, with four digits: below one four decimals, else
// three.
TEST_P(CooleyParker2012, NaturalFrequencies) {
  const double unit = std::sqrt(10e6 / 1.86) / (2.0 * std::numbers::pi);  // [Hz]
  const std::vector<double> ours =
      frequencies_of(set_model(cooley_parker(GetParam().planets), {}), GetParam(), unit);
  ASSERT_EQ(ours.size(), GetParam().frequencies.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double published = GetParam().frequencies[i];
    EXPECT_NEAR(ours[i], published, published < 1.0 ? 1e-4 : 1e-3);  // the last digit, rounded or cut off
  }
}

INSTANTIATE_TEST_SUITE_P(
    Table, CooleyParker2012,
    testing::Values(Published{3, rotational, 1, {0.9296, 1.090, 1.358, 1.931, 5.566, 7.741}},
                    Published{3, translational, 2, {0.7432, 1.018, 1.265, 1.487, 4.976, 6.282}},
                    Published{4, rotational, 1, {0.9077, 1.046, 1.317, 2.013, 5.809, 8.383}},
                    Published{4, translational, 2, {0.7199, 1.001, 1.317, 1.481, 5.153, 6.488}},
                    Published{4, planet, 1, {0.9617, 4.320, 5.672}},
                    Published{5, rotational, 1, {0.8802, 1.019, 1.281, 2.090, 6.030, 8.986}},
                    Published{5, translational, 2, {0.6992, 0.9863, 1.344, 1.496, 5.317, 6.693}},
                    Published{5, planet, 2, {0.9617, 4.320, 5.672}}));

}  // namespace
}  // namespace orbearing::gearset::dynamics::planetary_modes_test
