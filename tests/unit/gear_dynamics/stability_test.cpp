// Whether a set on fitted bearings stays where it is: rates of growth, and runs that are given up in time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <chrono>

#include "coupling/study/gear_dynamics.hpp"
#include "gearset/dynamics/equations.hpp"
#include "gearset/dynamics/modes.hpp"
#include "gearset/dynamics/static_state.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::gearset::dynamics::stability_test {
namespace {

AffineBearing law(double stiffness, double across, double damping) {
  AffineBearing bearing;
  bearing.stiffness << stiffness, across, -across, stiffness;
  bearing.damping = damping * Eigen::Matrix2d::Identity();
  return bearing;
}

SetModel model_on(const AffineBearing& bearing) {
  SetParameters set = test::reducer_dynamics();
  set.planet.affine_bearing = bearing;
  set.separation = false;  // linear
  return set_model(std::move(set), test::reducer_operation(300.0));
}

// Independent: the largest real part among the eigenvalues of the right-hand side's differences.
double growth_by_differences(const SetModel& model) {
  const SetModel smooth = averaged(model);
  const PlanetarySetEquations equations(smooth);
  const Eigen::VectorXd x = static_state(smooth);
  Eigen::MatrixXd slopes(x.size(), x.size());
  Eigen::VectorXd up(x.size()), down(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double step = i < x.size() / 2 ? 1e-6 : 1e-2;  // [m], [m/s]
    equations.derivative(0.0, x + step * Eigen::VectorXd::Unit(x.size(), i), up);
    equations.derivative(0.0, x - step * Eigen::VectorXd::Unit(x.size(), i), down);
    slopes.col(i) = (up - down) / (2.0 * step);
  }
  const double length = std::sqrt(slopes.cwiseAbs().maxCoeff());  // velocities in units of the positions'
  const Eigen::Index n = x.size() / 2;
  slopes.topRightCorner(n, n) *= length;
  slopes.bottomLeftCorner(n, n) /= length;
  return slopes.eigenvalues().real().maxCoeff();
}

TEST(LargestGrowth, IsThatOfTheEquations) {
  int growing = 0;
  for (const double across : {0.0, 5e7, 2e8})
    for (const double damping : {200.0, 2e3, -3e3}) {
      SCOPED_TRACE(testing::Message() << across << " N/m across, " << damping << " N s/m");
      const SetModel model = model_on(law(3e8, across, damping));
      const double found = largest_growth(model), wanted = growth_by_differences(model);
      growing += wanted > 1.0 ? 1 : 0;
      if (wanted > 1.0)
        EXPECT_NEAR(found / wanted, 1.0, 1e-3);
      else
        EXPECT_LE(found, 0.0);
    }
  EXPECT_GT(growing, 2);
  EXPECT_LT(growing, 9);
}

// Dampers that take energy are not enough: springs that are not alike across give it.
TEST(LargestGrowth, SeesSpringsThatGiveEnergy) {
  EXPECT_LE(largest_growth(model_on(law(3e8, 0.0, 500.0))), 0.0);
  EXPECT_GT(largest_growth(model_on(law(3e8, 3e8, 500.0))), 0.0);
}

TEST(GearsThatRunAway, AreGivenUpWithTheReason) {
  const SetModel model = model_on(law(3e8, 0.0, -2e4));
  ASSERT_GT(largest_growth(model), 0.0);
  const auto begin = std::chrono::steady_clock::now();
  const study::GearRunResult run = study::run_gears(model, {});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;  // [s]
  EXPECT_FALSE(run.completed);
  EXPECT_THAT(run.message, testing::HasSubstr("off its pin"));
  EXPECT_LT(took.count(), 5.0);
}

}  // namespace
}  // namespace orbearing::gearset::dynamics::stability_test
