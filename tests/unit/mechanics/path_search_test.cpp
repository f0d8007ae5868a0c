// A path that turns back twice between its ends.
#include "mechanics/path_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace orbearing::mechanics::path_search_test {
namespace {

// x^3 - 3 x in units of the length, against a force from -pull to pull; a second place follows the first.
struct Folded {
  double length, pull;

  PathForces operator()(const Eigen::VectorXd& position, double share) const {
    const double x = position[0] / length, y = position[1] / length;
    PathForces now;
    now.force = Eigen::Vector2d(pull * (2.0 * share - 1.0) - (x * x * x - 3.0 * x), x - y);
    now.stiffness = (Eigen::Matrix2d() << 3.0 * x * x - 3.0, 0.0, -1.0, 1.0).finished() / length;
    now.by_share = Eigen::Vector2d(2.0 * pull, 0.0);
    now.scale = pull;
    return now;
  }
};

TEST(PathSearch, GoesThroughTurningPoints) {
  constexpr double length = 1e-5, end = 2.5;
  const Folded forces{length, end * end * end - 3.0 * end};
  Eigen::VectorXd position = Eigen::Vector2d(-end * length, -end * length);
  const PathReport report = follow_path(forces, length, position);
  ASSERT_TRUE(report.converged);
  EXPECT_NEAR(position[0] / length, end, 1e-9);
  EXPECT_NEAR(position[1] / length, end, 1e-9);
}

TEST(PathSearch, SaysWhereThePathWasLost) {
  constexpr double length = 1e-5;
  const auto wall = [](const Eigen::VectorXd& position, double share) {
    const double x = position[0] / length;  // holds no more than 0.5
    PathForces now;
    now.force = Eigen::VectorXd::Constant(1, share - 0.5 * std::tanh(x));
    now.stiffness = Eigen::MatrixXd::Constant(1, 1, 0.5 / (std::cosh(x) * std::cosh(x) * length));
    now.by_share = Eigen::VectorXd::Constant(1, 1.0);
    now.scale = 1.0;
    return now;
  };
  Eigen::VectorXd position = Eigen::VectorXd::Zero(1);
  const PathReport report = follow_path(wall, length, position);
  EXPECT_FALSE(report.converged);
  EXPECT_NEAR(report.share, 0.5, 1e-2);
}

}  // namespace
}  // namespace orbearing::mechanics::path_search_test
