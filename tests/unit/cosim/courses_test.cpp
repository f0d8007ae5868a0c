#include "coupling/cosim/courses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace orbearing::cosim::courses_test {
namespace {

constexpr double kRoundOff = 1e-12;  // of numbers of order ten

double cubic(double t) {
  return 2.0 - 3.0 * t + 0.5 * t * t + 4.0 * t * t * t;
}

TEST(Courses, GoThroughTheirPointsAtUnequalTimes) {
  const std::vector<TimedValue> points{{-0.7, 1.0}, {0.1, -2.0}, {0.4, 0.5}, {1.5, 3.0}};
  for (std::size_t count = 1; count <= points.size(); ++count) {
    const std::vector<TimedValue> some(points.begin(), points.begin() + static_cast<long>(count));
    const Course course = through(some, 0.3);
    for (const TimedValue& point : some) EXPECT_NEAR(course.at(point.time - 0.3), point.value, kRoundOff);
  }
}

TEST(Courses, AreThePolynomialItself) {
  std::vector<TimedValue> points;
  for (const double t : {-0.7, 0.1, 0.4, 1.5}) points.push_back({t, cubic(t)});
  const Course course = through(points, 0.2);
  for (const double t : {-1.0, 0.0, 2.0}) EXPECT_NEAR(course.at(t - 0.2), cubic(t), 10.0 * kRoundOff);
  EXPECT_NEAR(course.coefficient[3], 4.0, kRoundOff);
}

TEST(Courses, HermiteKeepsValuesAndSlopes) {
  const Course course = hermite(1.0, -2.0, 0.3, 5.0, 0.25);
  EXPECT_NEAR(course.at(0.0), 1.0, kRoundOff);
  EXPECT_NEAR(course.slope(0.0), -2.0, kRoundOff);
  EXPECT_NEAR(course.at(0.25), 0.3, kRoundOff);
  EXPECT_NEAR(course.slope(0.25), 5.0, kRoundOff);
}

TEST(Courses, SlopeIntegralAndMoveBelongTogether) {
  const Course course{{1.0, 2.0, 3.0, 4.0}};
  EXPECT_NEAR(slope_of(course).at(0.7), course.slope(0.7), kRoundOff);
  EXPECT_NEAR(integral(1.0, slope_of(course)).at(0.7), course.at(0.7), kRoundOff);
  EXPECT_NEAR(course.moved(0.4).at(0.3), course.at(0.7), kRoundOff);
}

TEST(Courses, RefuseWhatFixesNoPolynomial) {
  EXPECT_THROW(through({}, 0.0), std::invalid_argument);
  EXPECT_THROW(through({{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}}, 0.0), std::invalid_argument);
  EXPECT_THROW(through({{0.5, 1.0}, {0.5, 2.0}}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace orbearing::cosim::courses_test
