// An oil by its grade and temperature.
#include "bearing/film/oil_grade.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/messages.hpp"

namespace orbearing::bearing::oil_grade_test {
namespace {

constexpr double kMm2 = 1e-6;  // [m^2/s]

// Oils of index 0 and 100 as the table of ASTM D2270 prints them, at 40 degC for 2, 4, 10, 20, 50 and 70
// mm^2/s at 100 degC.
TEST(OilGrade, ViscosityIndexAsInTheTableOfTheStandard) {
  struct Row {
    double at_100, low, high;
  };
  for (const Row& row : {Row{2.0, 7.994, 6.394}, Row{4.0, 25.32, 19.56}, Row{10.0, 147.7, 82.87},
                         Row{20.0, 493.2, 229.6}, Row{50.0, 2618.0, 919.6}, Row{70.0, 4905.0, 1558.0}}) {
    EXPECT_NEAR(viscosity_at_100(row.low * kMm2, 0.0) / (row.at_100 * kMm2), 1.0, 2e-3) << row.at_100;
    EXPECT_NEAR(viscosity_at_100(row.high * kMm2, 100.0) / (row.at_100 * kMm2), 1.0, 2e-3) << row.at_100;
  }
}

// Two viscosities as a data sheet states them, interpolated by ASTM D341: 200 and 16 mm^2/s at 40 and 100
// degC.
TEST(OilGrade, ByTwoViscositiesAsInTheChartOfTheStandard) {
  const OilGrade oil{.viscosity_40 = 200.0 * kMm2, .viscosity_100 = 16.0 * kMm2};
  constexpr double printed = 0.05 * kMm2;  // digits of the values by hand
  EXPECT_NEAR(kinematic_viscosity(oil, 50.0), 112.9 * kMm2, printed);
  EXPECT_NEAR(kinematic_viscosity(oil, 60.0), 68.7 * kMm2, printed);
  EXPECT_NEAR(kinematic_viscosity(oil, 65.0), 54.9 * kMm2, printed);
  EXPECT_NEAR(kinematic_viscosity(oil, 40.0) / (200.0 * kMm2), 1.0, 1e-12);
  EXPECT_NEAR(kinematic_viscosity(oil, 100.0) / (16.0 * kMm2), 1.0, 1e-12);
}

// The pieces of the table's formulas meet: no jump of the viscosity at 100 degC over that at 40.
TEST(OilGrade, RisesSteadilyWithTheGrade) {
  double last = 0.0;
  for (double at_40 = 7.0; at_40 < 3000.0; at_40 *= 1.01) {
    const double at_100 = viscosity_at_100(at_40 * kMm2, 95.0);
    EXPECT_GT(at_100, last) << at_40;
    if (last > 0.0) {
      EXPECT_LT(at_100, 1.012 * last) << at_40;
    }
    last = at_100;
  }
}

TEST(OilGrade, IsItsNumberAt40DegreesAndItsIndexAt100) {
  const OilGrade oil{.viscosity_40 = 220.0 * kMm2, .viscosity_index = 95.0};
  EXPECT_NEAR(kinematic_viscosity(oil, 40.0) / kMm2, 220.0, 1e-9);
  EXPECT_NEAR(kinematic_viscosity(oil, 100.0), viscosity_at_100(oil.viscosity_40, 95.0), 1e-12);
  // Straight in the double logarithm over the logarithm of the absolute temperature.
  const auto height = [&](double t) {
    return std::log10(std::log10(kinematic_viscosity(oil, t) / kMm2 + 0.7));
  };
  const auto along = [](double t) { return std::log10(t + 273.15); };
  const double slope = (height(100.0) - height(40.0)) / (along(100.0) - along(40.0));
  EXPECT_NEAR(height(70.0), height(40.0) + slope * (along(70.0) - along(40.0)), 1e-12);
}

TEST(OilGrade, ThinnerAndLessSensitiveToPressureWhenWarm) {
  const OilGrade oil{.viscosity_40 = 220.0 * kMm2};
  const Lubricant cold = lubricant_at(oil, 40.0), warm = lubricant_at(oil, 90.0);
  EXPECT_GT(cold.viscosity, 6.0 * warm.viscosity);
  EXPECT_GT(cold.pressure_viscosity, warm.pressure_viscosity);
  EXPECT_NEAR(cold.viscosity, 220.0 * kMm2 * 850.0, 1e-12);
  EXPECT_GT(warm.pressure_viscosity, 1e-8);
  EXPECT_LT(cold.pressure_viscosity, 3e-8);
}

TEST(OilGrade, OilsOfWhichNothingIsKnownAreRefused) {
  EXPECT_REFUSED(std::invalid_argument, "oil_grade 1", viscosity_at_100(3.0 * kMm2, 95.0));
  EXPECT_REFUSED(std::invalid_argument, "oil_grade 2", viscosity_at_100(220.0 * kMm2, 160.0));
}

}  // namespace
}  // namespace orbearing::bearing::oil_grade_test
