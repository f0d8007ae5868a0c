// Tables of [ISO281] and capacities recomputed from its formulas by independent programs. The tables of balls
// and of reliability are from memory of the standard; that of rollers and the capacities come with the
// project's references.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "bearing/life/ball_capacity.hpp"
#include "bearing/life/basic_life.hpp"
#include "bearing/life/life_modification.hpp"
#include "bearing/life/roller_capacity.hpp"

namespace orbearing::bearing::rating::iso281_test {
namespace {

using Table = std::vector<std::pair<double, double>>;

// To which the closed form is known to meet the table of rollers; half a unit of its last digit is up to 0.1
// %.
constexpr double kPublishedTable = 1.5e-3;

TEST(Iso281, RollerFactorOfTheTable) {
  const Table published{{0.01, 52.1}, {0.05, 74.1}, {0.10, 84.2}, {0.14, 87.7},
                        {0.18, 88.8}, {0.20, 88.7}, {0.30, 83.7}};
  for (const auto& [gamma, factor] : published)
    EXPECT_NEAR(roller_capacity_factor(gamma) / factor, 1.0, kPublishedTable) << "gamma " << gamma;
}

TEST(Iso281, BallFactorOfTheTable) {
  const Table published{{0.05, 46.7}, {0.10, 55.5}, {0.12, 57.5}, {0.14, 58.8}, {0.16, 59.6},
                        {0.20, 59.9}, {0.26, 58.2}, {0.30, 56.0}, {0.40, 48.4}};
  for (const auto& [gamma, factor] : published)
    EXPECT_NEAR(ball_capacity_factor(gamma) / factor, 1.0, kPublishedTable) << "gamma " << gamma;
}

TEST(Iso281, CapacitiesOfTwoRollerBearings) {
  constexpr double four_digits = 5e-4;  // half a unit of the last of four
  const RollerSet harris{.rollers = 14, .diameter = 10e-3, .length = 9.6e-3, .pitch_diameter = 65e-3};
  const RollerSet planet{.rollers = 15, .diameter = 5.24e-3, .length = 5.7e-3, .pitch_diameter = 36e-3};
  EXPECT_NEAR(dynamic_capacity(harris) / 48.42e3, 1.0, four_digits);
  EXPECT_NEAR(dynamic_capacity(planet) / 16.92e3, 1.0, four_digits);
}

TEST(Iso281, ReliabilityTable) {
  const Table published{{0.90, 1.0},    {0.95, 0.64},    {0.96, 0.55},    {0.97, 0.47},   {0.98, 0.37},
                        {0.99, 0.25},   {0.992, 0.22},   {0.994, 0.19},   {0.996, 0.16},  {0.998, 0.12},
                        {0.999, 0.093}, {0.9992, 0.087}, {0.9994, 0.080}, {0.9995, 0.077}};
  for (const auto& [reliability, factor] : published) {
    const double half_a_digit = factor < 0.1 ? 0.0005 : 0.005;
    EXPECT_NEAR(reliability_factor(reliability), factor, half_a_digit) << "reliability " << reliability;
  }
}

}  // namespace
}  // namespace orbearing::bearing::rating::iso281_test
