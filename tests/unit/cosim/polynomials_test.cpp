#include "coupling/cosim/exchange.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/messages.hpp"

namespace orbearing::cosim::polynomials_test {
namespace {

constexpr double kRoundOff = 1e-12;  // of numbers of order ten

double cubic(double t) {
  return 2.0 - 3.0 * t + 0.5 * t * t + 4.0 * t * t * t;
}

TEST(Polynomials, GoThroughTheirPointsAtUnequalTimes) {
  const std::vector<TimedValue> points{{-0.7, 1.0}, {0.1, -2.0}, {0.4, 0.5}, {1.5, 3.0}};
  for (std::size_t count = 1; count <= points.size(); ++count) {
    const std::vector<TimedValue> some(points.begin(), points.begin() + static_cast<long>(count));
    const InputPolynomial polynomial = through(some, 0.3);
    for (const TimedValue& point : some) EXPECT_NEAR(polynomial.at(point.time - 0.3), point.value, kRoundOff);
  }
}

TEST(Polynomials, AreThePolynomialItself) {
  std::vector<TimedValue> points;
  for (const double t : {-0.7, 0.1, 0.4, 1.5}) points.push_back({t, cubic(t)});
  const InputPolynomial polynomial = through(points, 0.2);
  for (const double t : {-1.0, 0.0, 2.0}) EXPECT_NEAR(polynomial.at(t - 0.2), cubic(t), 10.0 * kRoundOff);
  EXPECT_NEAR(polynomial.coefficient[3], 4.0, kRoundOff);
}

TEST(Polynomials, HermiteKeepsValuesAndSlopes) {
  const InputPolynomial polynomial = hermite(1.0, -2.0, 0.3, 5.0, 0.25);
  EXPECT_NEAR(polynomial.at(0.0), 1.0, kRoundOff);
  EXPECT_NEAR(polynomial.slope(0.0), -2.0, kRoundOff);
  EXPECT_NEAR(polynomial.at(0.25), 0.3, kRoundOff);
  EXPECT_NEAR(polynomial.slope(0.25), 5.0, kRoundOff);
}

TEST(Polynomials, SlopeIntegralAndMoveBelongTogether) {
  const InputPolynomial polynomial{{1.0, 2.0, 3.0, 4.0}};
  EXPECT_NEAR(slope_of(polynomial).at(0.7), polynomial.slope(0.7), kRoundOff);
  EXPECT_NEAR(integral(1.0, slope_of(polynomial)).at(0.7), polynomial.at(0.7), kRoundOff);
  EXPECT_NEAR(polynomial.moved(0.4).at(0.3), polynomial.at(0.7), kRoundOff);
}

TEST(Polynomials, RefuseWhatFixesNoPolynomial) {
  EXPECT_REFUSED(std::invalid_argument, "polynomials 1", through({}, 0.0));
  EXPECT_REFUSED(std::invalid_argument, "polynomials 2",
                 through({{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}}, 0.0));
  EXPECT_REFUSED(std::invalid_argument, "polynomials 3", through({{0.5, 1.0}, {0.5, 2.0}}, 0.0));
}

}  // namespace
}  // namespace orbearing::cosim::polynomials_test
