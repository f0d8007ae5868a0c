// Medians of benchmarks with their spread; tested also where SUNDIALS, which other benchmarks require, is not
// installed.
#include "benchmarks/quartiles.hpp"

#include <gtest/gtest.h>

namespace orbearing::bench::quartiles_test {

TEST(Quartiles, LieOnTheValuesOfFiveInAnyOrder) {
  const Quartiles found = quartiles({50.0, 10.0, 40.0, 20.0, 30.0});
  EXPECT_EQ(found.lower, 20.0);
  EXPECT_EQ(found.median, 30.0);
  EXPECT_EQ(found.upper, 40.0);
}

TEST(Quartiles, LieBetweenTheValuesOfTwo) {
  const Quartiles found = quartiles({3.0, 1.0});
  EXPECT_EQ(found.lower, 1.0 + 0.25 * 2.0);
  EXPECT_EQ(found.median, 2.0);
  EXPECT_EQ(found.upper, 1.0 + 0.75 * 2.0);
}

TEST(Quartiles, OfOneValueAreThatValue) {
  const Quartiles found = quartiles({7.0});
  EXPECT_EQ(found.lower, 7.0);
  EXPECT_EQ(found.median, 7.0);
  EXPECT_EQ(found.upper, 7.0);
}

}  // namespace orbearing::bench::quartiles_test
