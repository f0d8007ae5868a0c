// Equilibria vectorised over operating points against the readable solver, on bearings, loads and motions
// drawn at random.
#include "bearing/equilibrium/equilibrium_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/random_bearings.hpp"

namespace orbearing::bearing::vectorised::equilibrium_batch_test {
namespace {

// Of the largest force at hand: required; where round-off ends their search both solvers accept as much.
constexpr double kAgreement = 1e-9;
constexpr int kPointsOfOneBearing = 65;  // whole blocks and one point more

int number_of_bearings() {
  const char* text = std::getenv("RANDOM_BEARINGS");
  return text == nullptr ? 100 : std::atoi(text);
}

struct Study {
  Bearing bearing;
  std::vector<EquilibriumPoint> points;
};

Study next_study(RandomBearings& bearings) {
  Study study{bearings.next().bearing, {}};
  for (int i = 0; i < kPointsOfOneBearing; ++i) {
    const Draw draw = bearings.next();
    study.points.push_back({draw.point, draw.options.first_roller});
  }
  return study;
}

double largest_force(const EquilibriumPoint& point, const QuasiStaticState& state) {
  return std::max({point.point.bore_load.norm(), state.outer_load.maxCoeff(), state.inner_load.maxCoeff()});
}

void expect_agreement(const Study& study, const InertiaSwitches& inertia, const EquilibriumResults& results,
                      const std::string& set) {
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const EquilibriumPoint& point = study.points[i];
    const QuasiStaticState state =
        quasi_static_state(study.bearing, point.point, {.inertia = inertia}, point.first_roller);
    const auto row = static_cast<Eigen::Index>(i);
    const double allowed = kAgreement * largest_force(point, state);
    const double inner = (results.inner_load.row(row).transpose() - state.inner_load).abs().maxCoeff();
    const double outer = (results.outer_load.row(row).transpose() - state.outer_load).abs().maxCoeff();
    EXPECT_LE(std::max(inner, outer), allowed)
        << set << ", point " << i << " after " << results.iterations[row]
        << " iterations: " << Draw{study.bearing, point.point, {}};
  }
}

TEST(EquilibriumBatch, RandomPointsAgreeWithTheReadableSolver) {
  for (const mechanics::InstructionSet set : mechanics::instruction_sets()) {
    RandomBearings bearings;
    long points = 0, singly = 0, iterations = 0;
    for (int i = 0; i < number_of_bearings(); ++i) {
      const Study study = next_study(bearings);
      EquilibriumBatch batch(study.bearing, {}, set);
      EquilibriumResults results;
      batch.solve(study.points, results);
      EXPECT_TRUE(results.failures.empty());
      expect_agreement(study, {}, results, name_of(set) + ", bearing " + std::to_string(i));
      points += kPointsOfOneBearing;
      singly += results.solved_singly;
      iterations += results.iterations.sum();
    }
    RecordProperty("singly_" + name_of(set), std::to_string(singly));
    RecordProperty("iterations_" + name_of(set), std::to_string(iterations));
    EXPECT_LE(singly, points / 1000);
  }
}

// Neighbours in a register do not touch each other's results, not in the last bit.
TEST(EquilibriumBatch, OrderOfPointsDoesNotMatter) {
  RandomBearings bearings;
  Study study = next_study(bearings);
  for (const mechanics::InstructionSet set : mechanics::instruction_sets()) {
    EquilibriumBatch batch(study.bearing, {}, set);
    EquilibriumResults forward, backward;
    batch.solve(study.points, forward);
    std::vector<EquilibriumPoint> reversed(study.points.rbegin(), study.points.rend());
    batch.solve(reversed, backward);
    EXPECT_TRUE((forward.inner_load == backward.inner_load.colwise().reverse()).all()) << name_of(set);
    EXPECT_TRUE((forward.outer_load == backward.outer_load.colwise().reverse()).all()) << name_of(set);
    EXPECT_TRUE((forward.displacement == backward.displacement.rowwise().reverse()).all()) << name_of(set);
  }
}

TEST(EquilibriumBatch, KeepsToSwitchesAndInnerGuidance) {
  RandomBearings bearings;
  Study study = next_study(bearings);
  study.bearing.cage.guidance = Race::inner;
  const InertiaSwitches inertia{.own_orbit = false, .coriolis = true, .carrier_centrifugal = false};
  EquilibriumBatch batch(study.bearing, inertia);
  EquilibriumResults results;
  batch.solve(study.points, results);
  expect_agreement(study, inertia, results, "switches");
}

TEST(EquilibriumBatch, RefusesLoadsThatAreNotFinite) {
  RandomBearings bearings;
  Study study = next_study(bearings);
  study.points[9].point.bore_load.x() = std::numeric_limits<double>::quiet_NaN();
  EquilibriumBatch batch(study.bearing);
  EquilibriumResults results;
  EXPECT_THROW(batch.solve(study.points, results), std::invalid_argument);
}

TEST(EquilibriumBatch, NothingToDoIsDone) {
  RandomBearings bearings;
  EquilibriumBatch batch(bearings.next().bearing);
  EquilibriumResults results;
  batch.solve({}, results);
  EXPECT_EQ(results.inner_load.rows(), 0);
}

TEST(EquilibriumBatch, WithoutAnyLoadNothingIsCarried) {
  RandomBearings bearings;
  Bearing bearing = bearings.next().bearing;
  bearing.radial_clearance = 0.0;
  const std::vector<EquilibriumPoint> points(3);
  EquilibriumBatch batch(bearing);
  EquilibriumResults results;
  batch.solve(points, results);
  EXPECT_TRUE(results.failures.empty());
  EXPECT_EQ(results.outer_load.abs().maxCoeff(), 0.0);
}

TEST(EquilibriumBatch, LeavesWhatIsNotRoundToTheReadableSolver) {
  RandomBearings bearings;
  Study study = next_study(bearings);
  study.bearing.outer.form.push_back({.order = 2, .amplitude = 20e-6});
  EquilibriumBatch batch(study.bearing);
  EquilibriumResults results;
  batch.solve(study.points, results);
  EXPECT_EQ(results.solved_singly, kPointsOfOneBearing);
  expect_agreement(study, {}, results, "oval bore");
}

}  // namespace
}  // namespace orbearing::bearing::vectorised::equilibrium_batch_test
