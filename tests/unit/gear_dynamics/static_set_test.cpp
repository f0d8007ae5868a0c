// A static set that follows its pins, against a new search at each of their positions.
#include <gtest/gtest.h>

#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/static_state.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::gearset::dynamics::test {
namespace {

constexpr double kRoundOff = 1e-9;  // of the largest force

SetModel displaced(const SetModel& model, const Eigen::Matrix2Xd& offset) {
  SetModel other = model;
  for (std::size_t i = 0; i < other.bearings.size(); ++i)
    other.bearings[i].pin_error += offset.col(static_cast<Eigen::Index>(i));
  return other;
}

Eigen::Matrix2Xd forces_of_springs(const SetModel& model, const Eigen::VectorXd& state) {
  const Eigen::VectorXd q = state.head(model.layout.freedoms()), still = Eigen::VectorXd::Zero(q.size());
  Eigen::Matrix2Xd forces(2, static_cast<Eigen::Index>(model.bearings.size()));
  for (std::size_t i = 0; i < model.bearings.size(); ++i)
    forces.col(static_cast<Eigen::Index>(i)) =
        bearing_force(model.parameters.planet, model.bearings[i], q, still);
  return forces;
}

// By forces: if the teeth of a planet have separated, its position between them is undetermined.
void expect_search_anew(const SetModel& model, StaticSet& set, const Eigen::Matrix2Xd& offset) {
  const SetModel other = displaced(model, offset);
  const Eigen::Matrix2Xd found = set.bearing_forces(set.at(offset), offset),
                         expected = forces_of_springs(other, static_state(other));
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), kRoundOff * expected.cwiseAbs().maxCoeff());
}

TEST(StaticSet, FollowsSmallDisplacementsOfThePins) {
  for (const SetParameters& parameters : {reducer_dynamics(), full_set()}) {
    const SetModel model = set_model(parameters, reducer_operation(600.0));
    StaticSet set(model);
    expect_search_anew(model, set, Eigen::Matrix2Xd::Zero(2, 4));
    Random random;
    for (int i = 0; i < 10; ++i) expect_search_anew(model, set, 2e-6 * random.vector(8).reshaped(2, 4));
  }
}

// Pins so far off that teeth part or meet on their backs, and back again.
TEST(StaticSet, SearchesAnewWherePinsPartTheFlanks) {
  const SetModel model = set_model(reducer_dynamics(), reducer_operation(600.0));
  StaticSet set(model);
  Random random(7);
  for (const double reach : {300e-6, 1e-6, 1e-3, 0.0})
    for (int i = 0; i < 5; ++i) expect_search_anew(model, set, reach * random.vector(8).reshaped(2, 4));
}

// By differences of the forces, exact as long as flanks stay in contact.
TEST(StaticSet, SlopeOfTheForcesIsThatOfDifferences) {
  StaticSet set(set_model(reducer_dynamics(), reducer_operation(600.0)));
  constexpr double kStep = 1e-6;  // [m]
  const auto forces = [&](const Eigen::Matrix2Xd& offset) {
    return Eigen::Matrix2Xd(set.bearing_forces(set.at(offset), offset));
  };
  const Eigen::Matrix2Xd none = Eigen::Matrix2Xd::Zero(2, 4);
  for (Eigen::Index i = 0; i < 8; ++i) {
    Eigen::Matrix2Xd offset = none;
    offset.reshaped()[i] = kStep;
    const Eigen::VectorXd expected = ((forces(offset) - forces(none)) / kStep).reshaped();
    EXPECT_LE((set.forces_by_offset().col(i) - expected).norm(), 1e-8 * expected.norm());
  }
}

}  // namespace
}  // namespace orbearing::gearset::dynamics::test
