#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "tests/reference/rectangle_influence.hpp"
#include "tests/reference/rectangle_kernel.hpp"

namespace orbearing::bearing::half_space::rectangle_test {
namespace {

using Eigen::ArrayXXd;
using Eigen::Index;
using Rule = boost::math::quadrature::gauss<double, 15>;

constexpr double kSmooth = 1e-9;      // 15 places of Gauss on a smooth function
constexpr double kLogarithm = 3e-4;   // the same across the edge of the load, where Love's slope is infinite
constexpr double kExpansion = 1e-6;   // as promised
constexpr double kTransform = 1e-12;  // round-off of sums over all elements

/// Mean of Love's displacement over the receiving rectangle, times both areas.
double mean_of_love(const RectanglePair& pair) {
  return Rule::integrate(
      [&](double x) {
        return Rule::integrate(
            [&](double y) {
              RectanglePair point = pair;
              point.along += x;
              point.across += y;
              return love_integral(point);
            },
            -0.5 * pair.width, 0.5 * pair.width);
      },
      -0.5 * pair.receiver_length, 0.5 * pair.receiver_length);
}

TEST(Love, MiddleOfASquare) {
  // Eight triangles: 8 (a/2) arsinh(1) of a square of side a. [Johnson1985]
  EXPECT_NEAR(love_integral({.length = 2e-3, .receiver_length = 1e-3, .width = 2e-3}), 8e-3 * std::asinh(1.0),
              1e-17);
}

TEST(Love, IsTheIntegralOfTheReciprocalDistance) {
  const RectanglePair pair{
      .along = 3e-4, .across = -2e-4, .length = 2e-4, .receiver_length = 1e-4, .width = 1e-4};
  const double exact = Rule::integrate(
      [&](double x) {
        return Rule::integrate([&](double y) { return 1.0 / std::hypot(x, y); }, -2.5e-4, -1.5e-4);
      },
      2e-4, 4e-4);
  EXPECT_NEAR(love_integral(pair), exact, kSmooth * exact);
}

TEST(MutualIntegral, IsTheMeanOfLoves) {
  for (const double along : {2e-4, 9e-4, 3e-3}) {
    const RectanglePair pair{along, 3e-5, 1e-4, 2.5e-4, 1e-5};
    const double mean = mean_of_love(pair);
    EXPECT_NEAR(mutual_integral(pair), mean, kSmooth * mean + (along > 1e-3 ? kExpansion * mean : 0.0));
  }
  const RectanglePair own{0.0, 0.0, 1e-4, 1e-4, 2e-5};
  EXPECT_NEAR(mutual_integral(own), mean_of_love(own), kLogarithm * mean_of_love(own));
}

TEST(MutualIntegral, IsTheSameBothWays) {
  for (const double along : {0.0, 1e-4, 5e-4, 5e-3}) {
    const RectanglePair there{along, 2e-5, 1e-4, 3e-4, 1e-5}, back{-along, -2e-5, 3e-4, 1e-4, 1e-5};
    EXPECT_NEAR(mutual_integral(there), mutual_integral(back), kTransform * mutual_integral(there));
  }
}

TEST(MutualIntegral, ClosedFormMeetsTheExpansion) {
  const double side = 1e-4;
  const auto at = [&](double sides) { return mutual_integral({sides * side, 0.0, side, side, side}); };
  // 1/r over a thousandth of the way, beside both errors.
  EXPECT_NEAR(at(15.9999) / at(16.0001), 16.0001 / 15.9999, 2.0 * kExpansion);
}

/// The sum over all elements one by one; rows at negative y carry what their partners do.
ArrayXXd one_by_one(const LengthGrid& grid, const RowGrid& rows, double mirror_factor,
                    const ArrayXXd& pressure) {
  const double length = grid.edge(grid.edge.size() - 1) - grid.edge(0);
  ArrayXXd sum = ArrayXXd::Zero(pressure.rows(), pressure.cols());
  for (Index i = 0; i < sum.rows(); ++i) {
    for (Index m = 0; m < sum.cols(); ++m) {
      for (Index j = 0; j < sum.rows(); ++j) {
        for (Index n = 1 - sum.cols(); n < sum.cols(); ++n) {
          RectanglePair pair{0.0, static_cast<double>(m - n) * rows.spacing, grid.size(j), grid.size(i),
                             rows.spacing};
          const auto at = [&](double along) {
            pair.along = along;
            return mutual_integral(pair);
          };
          const double x = grid.middle(i), s = grid.middle(j);
          const double images = at(x - (length - s)) + at(x - (-length - s));
          sum(i, m) += (at(x - s) + mirror_factor * images) * pressure(j, std::abs(n));
        }
      }
    }
  }
  return sum;
}

TEST(RectangleInfluence, IsTheSumOverAllElements) {
  const LengthGrid grid = graded_grid(5e-3, 9);
  const RowGrid rows{5, 12e-6};
  const ArrayXXd pressure = ArrayXXd::Random(9, 5);
  for (const double factor : {0.0, 0.695}) {
    const ArrayXXd fast = RectangleInfluence(grid, rows, factor).apply(pressure);
    const ArrayXXd slow = one_by_one(grid, rows, factor, pressure);
    EXPECT_LE((fast - slow).abs().maxCoeff(), kTransform * slow.abs().maxCoeff());
  }
}

TEST(RectangleInfluence, OwnIsTheElementAlone) {
  const LengthGrid grid = graded_grid(5e-3, 6);
  const RectangleInfluence influence(grid, {4, 12e-6}, 0.0);
  ArrayXXd pressure = ArrayXXd::Zero(6, 4);
  pressure(2, 0) = 1.0;
  EXPECT_NEAR(influence.apply(pressure)(2, 0), influence.own()(2), kTransform * influence.own()(2));
}

}  // namespace
}  // namespace orbearing::bearing::half_space::rectangle_test
