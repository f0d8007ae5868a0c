// Equilibrium of a bearing whose outer race bends.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::elastic_race_test {
namespace {

constexpr int kOrders = 7;

// About that of the reducer's planet, teeth pressing it together; `softness` 0: rigid in all but name.
ElasticRace thin_race(double softness) {
  ElasticRace race;
  race.compliance = Eigen::ArrayXd::Zero(kOrders);
  race.cosine = race.sine = Eigen::ArrayXd::Zero(kOrders);
  race.compliance[0] = softness * 2e-10;
  for (int order = 2; order < kOrders; ++order) {
    race.compliance[order] = softness * 4e-8 / std::pow(order * order - 1.0, 2);
    race.cosine[order] = -softness * 4e-6 / (order * order);
    race.sine[order] = softness * 1e-6 / (order * order);
  }
  return race;
}

OperatingPoint reducer_point(double softness) {
  OperatingPoint point;
  point.carrier = {.speed = 200.0, .orbit_radius = 0.0895};
  point.outer_speed = -720.0;
  point.bore_load = {600.0, 1400.0};
  point.outer_race = thin_race(softness);
  return point;
}

RaceEquilibrium problem_with(double softness) {
  const Bearing bearing = example_bearings::planet_bearing();
  return quasi_static_problem(bearing, geometry_of(bearing), reducer_point(softness), {}, 0.07);
}

mechanics::Imbalance<Eigen::Dynamic> imbalance_at(const RaceEquilibrium& problem,
                                                  const Eigen::VectorXd& position) {
  std::vector<laminae::RollerState> rollers(static_cast<std::size_t>(problem.angle.size()));
  return ring_on_rollers<Eigen::Dynamic>(problem, rollers)(position);
}

TEST(ElasticRace, StiffnessIsTheSlopeOfTheForce) {
  const RaceEquilibrium problem = problem_with(1.0);
  std::vector<laminae::RollerState> none;
  Eigen::VectorXd position = ring_on_rollers<Eigen::Dynamic>(problem, none).rest;
  position.head<2>() << 5e-6, 12e-6;
  position[3] += 1e-6;
  const Eigen::MatrixXd stiffness = imbalance_at(problem, position).stiffness;
  EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-14 * stiffness.norm());
  for (Eigen::Index i = 0; i < position.size(); ++i) {
    const Eigen::VectorXd h = 1e-9 * Eigen::VectorXd::Unit(position.size(), i);
    const Eigen::VectorXd slope =
        (imbalance_at(problem, position + h).force - imbalance_at(problem, position - h).force) / 2e-9;
    EXPECT_LT((stiffness.col(i) + slope).norm(), 1e-5 * stiffness.col(i).norm()) << i;
  }
}

// Waves required by the roller loads that were found: w = rest + sum of c_n Q_j cos(n (phi - phi_j)).
TEST(ElasticRace, StandsWhereItsRollersBendIt) {
  const RaceEquilibrium problem = problem_with(1.0);
  const QuasiStaticState state = solve(problem);
  ASSERT_TRUE(state.report.converged) << state.report.message;
  const ElasticRace& race = problem.outer_race;
  Eigen::ArrayXd form = Eigen::ArrayXd::Zero(1);
  const double at = 1.3;
  add_form(state.waves, 1.0, Eigen::ArrayXd::Constant(1, at), form);
  double expected = 0.0;
  Eigen::Vector2d force = problem.load;
  for (int order = 0; order < kOrders; ++order) {
    expected += race.cosine[order] * std::cos(order * at) + race.sine[order] * std::sin(order * at);
    for (Eigen::Index j = 0; j < state.angle.size(); ++j)
      expected += race.compliance[order] * state.outer_load[j] * std::cos(order * (at - state.angle[j]));
  }
  for (Eigen::Index j = 0; j < state.angle.size(); ++j)
    force += state.outer_load[j] * Eigen::Vector2d(std::cos(state.angle[j]), std::sin(state.angle[j]));
  EXPECT_NEAR(form[0], expected, 1e-9 * std::abs(expected));
  EXPECT_LT(force.norm(), 1e-9 * problem.load.norm());
}

TEST(ElasticRace, OfAStiffBodyIsTheRigidOne) {
  const QuasiStaticState rigid = solve(problem_with(0.0).outer_race.is_rigid() ? problem_with(0.0) : [] {
    RaceEquilibrium problem = problem_with(1.0);
    problem.outer_race = {};
    return problem;
  }());
  const QuasiStaticState stiff = solve(problem_with(1e-6));
  ASSERT_TRUE(stiff.report.converged) << stiff.report.message;
  EXPECT_LT((stiff.outer_load - rigid.outer_load).abs().maxCoeff(), 1e-5 * rigid.outer_load.maxCoeff());
  EXPECT_LT((stiff.displacement - rigid.displacement).norm(), 1e-5 * rigid.displacement.norm());
}

// A soft race spreads the load over more rollers.
TEST(ElasticRace, SpreadsTheLoad) {
  const auto loaded = [](const QuasiStaticState& state) { return (state.inner_load > 1.0).count(); };
  const QuasiStaticState soft = solve(problem_with(1.0)), stiff = solve(problem_with(1e-6));
  EXPECT_LT(soft.outer_load.maxCoeff(), stiff.outer_load.maxCoeff());
  EXPECT_GE(loaded(soft), loaded(stiff));
}

TEST(ElasticRace, BearingGivesWayAsItsStiffnessSays) {
  RaceEquilibrium problem = problem_with(1.0);
  const QuasiStaticState state = solve(problem);
  const Eigen::Matrix2d compliance = state.stiffness.inverse();
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d more = 0.05 * Eigen::Vector2d::Unit(axis), load = problem.load;
    problem.load = load + more;
    const Eigen::Vector2d ahead = solve(problem).displacement;
    problem.load = load - more;
    const Eigen::Vector2d behind = solve(problem).displacement;
    problem.load = load;
    EXPECT_LT(((ahead - behind) / 0.1 - compliance.col(axis)).norm(), 1e-5 * compliance.norm());
  }
}

TEST(ElasticRace, FormIsAResultOfTheMeansOverAPitch) {
  const Bearing bearing = example_bearings::planet_bearing();
  const QuasiStaticResult bent = quasi_static_bearing(bearing, reducer_point(1.0), {});
  OperatingPoint rigid_point = reducer_point(1.0);
  rigid_point.outer_race = {};
  const QuasiStaticResult rigid = quasi_static_bearing(bearing, rigid_point, {});
  EXPECT_EQ(rigid.race_form.abs().maxCoeff(), 0.0);
  EXPECT_GT(bent.race_form.maxCoeff() - bent.race_form.minCoeff(), 1e-6);
  const double first_order = (bent.race_form * bent.angle.cos()).mean();
  EXPECT_LT(std::abs(first_order), 1e-12 * bent.race_form.maxCoeff() + 1e-18);
}

}  // namespace
}  // namespace orbearing::bearing::elastic_race_test
