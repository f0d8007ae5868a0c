// Planets at unequal angles: where teeth fit, load sharing, modes and their excitation.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "coupling/analysis/load_sharing.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "gearset/checks.hpp"
#include "gearset/dynamics/mode_kind.hpp"
#include "gearset/dynamics/modes.hpp"
#include "gearset/mesh/planetary_meshes.hpp"
#include "gearset/planet_angles.hpp"
#include "mechanics/constants.hpp"
#include "tests/coupled_reducer.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::analysis::unequal_planets_test {
namespace {

using constants::degree;
using constants::two_pi;
using gearset::dynamics::ModeKind;
using gearset::dynamics::SetModel;

constexpr double kBalance = 1e-6;  // of a load, as in study_pin_error_test

/// The reducer with planets on these places, in steps of 360 deg/(sun + ring teeth).
PlanetaryDrivetrain placed(const std::vector<int>& steps, double sun_support = 0.0) {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.set.planets = static_cast<int>(steps.size());
  const double step = two_pi / (drivetrain.set.sun_teeth + drivetrain.set.ring_teeth);
  drivetrain.set.planet_angles.clear();
  for (const int k : steps) drivetrain.set.planet_angles.push_back(k * step);
  drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  gearset::dynamics::SetParameters gears = example::reducer_gears(drivetrain);
  gears.sun.support = {.stiffness = sun_support};
  gears.frame.centrifugal = false;  // of a sun off its place it would add what no closed form here has
  drivetrain.gear_set = [gears] { return gears; };
  drivetrain.uneven_planets = gearset::is_unequally_spaced(drivetrain.set);
  return drivetrain;
}

std::vector<double> shares_of(const PlanetaryDrivetrain& drivetrain) {
  return planet_balance(drivetrain, derive(drivetrain)).shares;
}

// Eq. (23): on every place where teeth fit, and on no other, both meshes of a planet agree.
TEST(UnequalPlanets, StandWhereBothMeshesAgree) {
  const gearset::PlanetarySet set = example::reducer().set;
  const gearset::MeshMotion motion;
  const double step = two_pi / (set.sun_teeth + set.ring_teeth);
  for (int k = 0; k < set.sun_teeth + set.ring_teeth; ++k) {
    const auto apart = [&](double position) {
      const double difference = gearset::sun_mesh_lag(set.sun_teeth, position, motion) -
                                gearset::ring_mesh_lag(set.ring_teeth, position, motion);
      return std::abs(difference - std::round(difference));
    };
    EXPECT_LT(apart(k * step), 1e-9) << k;
    EXPECT_GT(apart((k + 0.25) * step), 0.2) << k;
  }
}

std::string problem_of(std::vector<double> degrees) {
  gearset::PlanetarySet set = example::reducer().set;
  set.planets = 4;
  set.planet_angles.clear();
  for (const double angle : degrees) set.planet_angles.push_back(angle * degree);
  const gearset::Warnings problems = gearset::assembly_problems(set);
  return problems.empty() ? "" : problems.front().key + ": " + problems.front().text;
}

// The gap from the last planet to the first counts, too.
TEST(UnequalPlanets, HaveALeastGapAllAround) {
  EXPECT_NEAR(gearset::least_step({0.0, 100.0 * degree, 230.0 * degree}), 100.0 * degree, 1e-12);
  EXPECT_NEAR(gearset::least_step({0.0, 130.0 * degree, 270.0 * degree}), 90.0 * degree, 1e-12);
  EXPECT_NEAR(gearset::least_step({0.0, 130.0 * degree, 220.0 * degree}), 90.0 * degree, 1e-12);
  EXPECT_NEAR(gearset::least_step({0.0}), two_pi, 1e-12);
  const double step = 360.0 / 116.0;  // the last planet 10 steps before the first
  EXPECT_NE(problem_of({0.0, 35.0 * step, 70.0 * step, 106.0 * step}).find("must not touch"),
            std::string::npos);
}

TEST(UnequalPlanets, ThatCannotBeAssembledAreRefused) {
  const double step = 360.0 / 116.0;
  EXPECT_EQ(problem_of({0.0, 27.0 * step, 58.0 * step, 85.0 * step}), "");
  EXPECT_EQ(problem_of({0.0, 27.0 * step + 0.004, 58.0 * step, 85.0 * step - 0.004}), "");  // as written
  EXPECT_EQ(
      problem_of({0.0, 27.0 * step + 0.4, 58.0 * step, 85.0 * step}),
      "gearset.planet_angles: found 84.1931 deg, where teeth do not fit; whole steps of 360 deg/(sun + ring "
      "teeth) are required: 83.7931 deg or 86.8966 deg");
  EXPECT_NE(problem_of({0.0, 27.0 * step, 58.0 * step}).find("one for each of the 4 planets"),
            std::string::npos);
  EXPECT_NE(problem_of({step, 27.0 * step, 58.0 * step, 85.0 * step}).find("first planet"),
            std::string::npos);
  EXPECT_NE(problem_of({0.0, 58.0 * step, 27.0 * step, 85.0 * step}).find("ascending"), std::string::npos);
  EXPECT_NE(problem_of({0.0, 10.0 * step, 58.0 * step, 85.0 * step}).find("must not touch"),
            std::string::npos);
}

// Stated at their equal positions, planets are the equal ones to the last bit.
TEST(UnequalPlanets, AtEqualStepsAreEqualPlanets) {
  const PlanetaryDrivetrain stated = placed({0, 29, 58, 87}, 1e8);
  EXPECT_FALSE(stated.uneven_planets);
  PlanetaryDrivetrain plain = stated;
  plain.set.planet_angles.clear();
  plain.gear_set = [gears = example::reducer_gears(plain)]() mutable {
    gears.sun.support = {.stiffness = 1e8};
    gears.frame.centrifugal = false;
    return gears;
  };
  EXPECT_EQ(evaluate(stated, derive(stated)).life_hours, evaluate(plain, derive(plain)).life_hours);
  const gearset::dynamics::SetParameters a = stated.gear_set(), b = plain.gear_set();
  EXPECT_EQ(a.sun_phase, b.sun_phase);
  EXPECT_EQ(a.ring_phase, b.ring_phase);
  EXPECT_EQ(a.planet_angles, b.planet_angles);
}

// Three forces on a floating sun: each is proportional to the sine of the angle between the other two.
TEST(UnequalPlanets, ThreeAboutAFloatingSunCarryByItsBalance) {
  const std::vector<int> steps{0, 30, 75};
  const std::vector<double> shares = shares_of(placed(steps));
  const auto sine = [&](int from, int to) { return std::sin(two_pi * (to - from) / 116.0); };
  const std::vector<double> forces{sine(steps[1], steps[2]), sine(steps[2], steps[0] + 116),
                                   sine(steps[0], steps[1])};
  const double sum = std::accumulate(forces.begin(), forces.end(), 0.0);
  EXPECT_GT(forces[2] / sum, 0.4);  // far from even
  for (std::size_t n = 0; n < 3; ++n) EXPECT_NEAR(shares[n], 3.0 * forces[n] / sum, kBalance) << n;
}

// Opposite planets balance each other: no force is left that could move the sun.
TEST(UnequalPlanets, OppositePairsCarryEvenly) {
  for (const double support : {0.0, 1e8})
    for (const double share : shares_of(placed({0, 22, 58, 80}, support)))
      EXPECT_NEAR(share, 1.0, kBalance) << support;
}

TEST(UnequalPlanets, LiveUnderTheirOwnLoads) {
  const PlanetaryDrivetrain drivetrain = placed({0, 30, 75});
  const std::vector<double> shares = shares_of(drivetrain);
  const PointResult point = evaluate(drivetrain, derive(drivetrain));
  ASSERT_EQ(point.planets.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_NEAR(point.planets[n].load_share, shares[n], kBalance);
  EXPECT_GT(point.planets[0].life_hours, 3.0 * point.planets[2].life_hours);
  EXPECT_LT(shares[0], shares[2]);
}

SetModel reducer_placed(const std::vector<int>& steps) {
  const PlanetaryDrivetrain drivetrain = placed(steps, 1e8);
  gearset::dynamics::SetParameters gears = drivetrain.gear_set();
  gears.frame.centrifugal = true;
  return set_model(gears, gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive));
}

// [LinParker2000]: planets in opposite pairs keep all three kinds of modes, whatever the steps between the
// pairs; the rotational ones keep their frequencies.
TEST(UnequalPlanets, InOppositePairsKeepTheKindsOfModes) {
  const std::vector<gearset::dynamics::Mode> even = modes_at_rest(reducer_placed({0, 29, 58, 87}));
  const SetModel model = reducer_placed({0, 22, 58, 80});
  std::vector<double> rotational;
  for (const gearset::dynamics::Mode& mode : even)
    if (mode.kind == ModeKind::rotational) rotational.push_back(mode.frequency);
  std::size_t found = 0;
  for (const gearset::dynamics::Mode& mode : modes_at_rest(model)) {
    const Eigen::VectorXcd weighted = model.mass.cwiseSqrt().asDiagonal() * mode.shapes.col(0);
    const gearset::dynamics::KindShares shares = kind_shares(model, weighted);
    const double own = mode.kind == ModeKind::rotational      ? shares.rotational
                       : mode.kind == ModeKind::translational ? shares.translational
                                                              : shares.planet;
    EXPECT_NEAR(own, 1.0, 1e-9) << mode.frequency;
    if (mode.kind == ModeKind::rotational) {
      ASSERT_LT(found, rotational.size());
      EXPECT_NEAR(mode.frequency, rotational[found++], 1e-7 * rotational.back());
    }
  }
  EXPECT_EQ(found, rotational.size());
  // Pairs closer together than to the others: what was the same in both directions is so no more.
  int split = 0;
  for (const gearset::dynamics::Mode& mode : modes_at_rest(model))
    split += mode.kind == ModeKind::translational && mode.multiplicity == 1;
  EXPECT_GE(split, 4);
}

// Eq. (14): of equal steps l z_s mod N; of others as the forces add up.
TEST(UnequalPlanets, AreExcitedByWhatTheForcesOfAllMeshesLeave) {
  for (const int planets : {3, 4, 5, 6})
    for (const int teeth : {36, 37, 38, 39, 40}) {
      const std::vector<double> even = gearset::even_angles(planets);
      const int k = teeth % planets;
      const bool shifts = k == 1 || k == planets - 1;
      EXPECT_EQ(excites(even, teeth, ModeKind::rotational), k == 0) << planets << " " << teeth;
      EXPECT_EQ(excites(even, teeth, ModeKind::translational), shifts) << planets << " " << teeth;
      EXPECT_EQ(excites(even, teeth, ModeKind::planet), k != 0 && !shifts) << planets << " " << teeth;
    }
  const double step = two_pi / 116.0;
  const std::vector<double> pairs{0.0, 22 * step, 58 * step, 80 * step};
  EXPECT_FALSE(excites(pairs, 37, ModeKind::rotational));  // opposite planets half a period apart
  EXPECT_TRUE(excites(pairs, 37, ModeKind::translational));
  EXPECT_TRUE(
      excites(pairs, 2 * 37, ModeKind::rotational));  // no longer cancelled by the pair at right angles
  EXPECT_TRUE(excites(pairs, 2 * 37, ModeKind::planet));
  EXPECT_FALSE(excites(pairs, 2 * 37, ModeKind::translational));
}

TEST(UnequalPlanets, TellTheirPositionsToTheModel) {
  const SetModel model = reducer_placed({0, 22, 58, 80});
  EXPECT_NEAR(model.planet_angles[1], 22 * two_pi / 116.0, 1e-12);
  EXPECT_NEAR(model.bearings[1].radial.central.x(), std::cos(model.planet_angles[1]), 1e-12);
  gearset::dynamics::SetParameters wrong = model.parameters;
  wrong.planet_angles.pop_back();
  EXPECT_THROW(set_model(wrong, model.operation), std::invalid_argument);
}

}  // namespace
}  // namespace orbearing::analysis::unequal_planets_test
