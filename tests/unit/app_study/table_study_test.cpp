// Inputs of a table as coordinates, and values of its results with their errors.
#include "app/study/table_study.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace orbearing::app::table_study_test {
namespace {

constexpr double kRoundOff = 1e-14;

TEST(TableStudy, RangeIsFromMinusOneToOne) {
  const TableInput input{.path = "input.speed", .from = 100.0, .to = 300.0, .by_logarithm = false};
  const Coordinate at(input);
  EXPECT_DOUBLE_EQ(at(100.0), -1.0);
  EXPECT_NEAR(at(200.0), 0.0, kRoundOff);
  EXPECT_DOUBLE_EQ(at(250.0), 0.5);
  EXPECT_DOUBLE_EQ(at(300.0), 1.0);
  EXPECT_DOUBLE_EQ(at(500.0), 3.0);  // beyond the range: told by its size
}

TEST(TableStudy, RangeByLogarithm) {
  const TableInput input{.path = "input.speed", .from = 10.0, .to = 1000.0, .by_logarithm = true};
  const Coordinate at(input);
  EXPECT_NEAR(at(10.0), -1.0, kRoundOff);
  EXPECT_NEAR(at(100.0), 0.0, kRoundOff);
  EXPECT_NEAR(at(std::pow(10.0, 2.5)), 0.5, kRoundOff);
}

// A value at an end that was printed and read again is that end.
TEST(TableStudy, RoundOffAtAnEndIsTheEnd) {
  const TableInput input{.path = "input.speed", .from = 100.0, .to = 300.0, .by_logarithm = false};
  const Coordinate at(input);
  EXPECT_EQ(at(300.0 * (1.0 + 1e-15)), 1.0);
  EXPECT_EQ(at(100.0 * (1.0 - 1e-15)), -1.0);
}

TEST(TableStudy, InputsAreShownInTheirCustomaryUnit) {
  EXPECT_EQ(in_customary({.path = "input.power", .from = 0.0, .to = 0.0}, 150e3), "150 kW");
  EXPECT_EQ(in_customary({.path = "life.reduction_factor", .from = 0.0, .to = 0.0}, 0.83), "0.83");
}

TEST(TableStudy, ErrorsOfLogarithmsAreOverTheValue) {
  const TabulatedResult life{.name = "life_h", .unit = "h", .by_logarithm = true};
  EXPECT_NEAR(life.value(life.tabulated(5000.0)), 5000.0, 5000.0 * kRoundOff);
  EXPECT_NEAR(life.error(5000.0, std::log(1.01)), 50.0, 5000.0 * kRoundOff);
  EXPECT_NEAR(life.error(-5000.0, std::log(1.01)), 50.0, 5000.0 * kRoundOff);
}

TEST(TableStudy, ErrorsOfOthersAreOverTheirScale) {
  const TabulatedResult slip{.name = "cage_slip", .unit = "", .by_logarithm = false, .scale = 0.2};
  EXPECT_DOUBLE_EQ(slip.tabulated(-0.1), -0.5);
  EXPECT_DOUBLE_EQ(slip.value(-0.5), -0.1);
  EXPECT_DOUBLE_EQ(slip.error(-0.1, 0.05), 0.01);
}

}  // namespace
}  // namespace orbearing::app::table_study_test
