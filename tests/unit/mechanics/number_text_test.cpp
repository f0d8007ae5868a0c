// Numbers in messages are those of printf in the C locale.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/number_text.hpp"

namespace orbearing::mechanics::number_text_test {
namespace {

TEST(NumberText, HasSignificantDigits) {
  EXPECT_EQ(significant(839.0996, 4), "839.1");
  EXPECT_EQ(significant(0.5, 4), "0.5");
  EXPECT_EQ(significant(1234567.0, 3), "1.23e+06");
}

TEST(NumberText, HasDecimals) {
  EXPECT_EQ(with_decimals(71.26, 1), "71.3");
  EXPECT_EQ(with_decimals(0.52, 2), "0.52");
}

TEST(NumberInUnit, IsWithoutTheLastBits) {
  EXPECT_EQ(in_unit(0.3, 1.0), 0.3);
  EXPECT_EQ(in_unit(0.1 * 3.0, 1000.0), 300.0);
  EXPECT_TRUE(std::isnan(in_unit(std::numeric_limits<double>::infinity(), 1.0)));
}

}  // namespace
}  // namespace orbearing::mechanics::number_text_test
