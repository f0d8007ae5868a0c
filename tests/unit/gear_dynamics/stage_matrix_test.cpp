// The matrix of a stage, planet by planet, against the dense one.
#include "gearset/dynamics/stage_matrix.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "mechanics/linear_algebra.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::gearset::dynamics::stage_matrix_test {
namespace {

constexpr double kRoundOff = 1e-12;  // [-]

struct Port {
  Eigen::Matrix3d of_carrier, of_planet, matrix;
};

Port port_of(int planet) {
  Port port;
  port.of_carrier << 0.3, -0.4, 0.1 * planet, 0.2, 0.5, -0.6, 0.7, 0.1, -0.2;
  port.of_planet << 1.0, 0.1, 0.2, -0.3, 0.9, 0.4, 0.3, -0.1, 0.8;
  port.matrix << 0.2 + planet, 0.05, -0.04, 0.3, 0.25, 0.02, 0.06, -0.03, 0.15;
  return port;
}

// The gears of one system are solved planet by planet.
TEST(StageMatrix, SolvesAsTheDenseOneDoes) {
  for (const int planets : {3, 4, 6}) {
    SetParameters set = test::lin_parker(planets);
    set.ring.support.held = true;
    set.carrier.support.held_in_rotation = true;
    const SetModel model = set_model(set, {});
    const Eigen::Index n = model.layout.freedoms();
    const Eigen::VectorXd x = Eigen::VectorXd::Constant(2 * n, 1e-6);
    ForceSlopes slopes;
    force_slopes(model, 0.0, x, slopes);
    const double g = 2e-5;  // [s]
    Eigen::MatrixXd dense = -g * slopes.by_velocity - g * g * slopes.by_position;
    dense.diagonal() += model.mass;
    StageMatrix matrix;
    matrix.assemble(model, slopes, g);
    for (int planet = 0; planet < planets; ++planet) {
      const Port port = port_of(planet);
      Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3, n);
      all.middleCols<3>(SetLayout::carrier()) = port.of_carrier;
      all.middleCols<3>(SetLayout::planet(planet)) = port.of_planet;
      dense += all.transpose() * port.matrix * all;
      matrix.add_port(model, planet, port.of_carrier, port.of_planet, port.matrix);
    }
    int held = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (model.mobility[i] != 0.0) continue;
      ++held;
      dense.row(i).setZero();
      dense(i, i) = 1.0;
    }
    ASSERT_EQ(held, 3);
    ASSERT_TRUE(matrix.factor(model));
    const Eigen::VectorXd rhs = Eigen::VectorXd::LinSpaced(n, -1.0, 3.0);
    Eigen::VectorXd solution = rhs;
    matrix.solve(solution);
    EXPECT_LT((dense * solution - rhs).norm(), kRoundOff * rhs.norm());
    EXPECT_LT((solution - mechanics::solution(dense, rhs)).norm(), kRoundOff * solution.norm());
  }
}

TEST(StageMatrix, SaysWhereAPivotVanishes) {
  const SetModel model = test::lin_parker_model(3);
  const Eigen::Index n = model.layout.freedoms();
  ForceSlopes none{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  StageMatrix matrix;
  matrix.assemble(model, none, 1e-6);
  EXPECT_TRUE(matrix.factor(model));
  for (const Eigen::Index position : {Eigen::Index{1}, SetLayout::planet(1)}) {
    ForceSlopes cancelling = none;
    cancelling.by_velocity(position, position) = model.mass[position];  // at g = 1 s
    matrix.assemble(model, cancelling, 1.0);
    EXPECT_FALSE(matrix.factor(model));
  }
}

}  // namespace
}  // namespace orbearing::gearset::dynamics::stage_matrix_test
