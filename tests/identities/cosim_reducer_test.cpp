// Gears and bearings of the reducer in co-simulation: orders against the system solved as one, bits after a
// restore, names of planets, energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupling/analysis/driven_setups.hpp"
#include "coupling/system/monolithic.hpp"
#include "tests/coupled_reducer.hpp"

namespace orbearing::cosim::cosim_reducer_test {
namespace {

using analysis::DrivetrainGeometry;
using analysis::PlanetaryDrivetrain;

// Rollers oscillate between their races within 10 us: an order is visible in windows far shorter than that.
constexpr double kPath = 16e-6;   // [s]
constexpr double kWindow = 1e-6;  // [s]  and half of it
constexpr double kOrder = 0.3;  // of a measured order: the next term is smaller by h times the frequency of a
                                // roller, 0.6

// Allowed errors of steps inside the participants: of gears over the mean mesh deflection, of a bearing [m].
struct Tolerances {
  double gears = system::DrivenGearsSetup{}.allowed_share;
  double bearing = system::DrivenBearingSetup{}.allowed_length_error;
};
const Tolerances kTight{1e-9, 1e-15};

system::CoupledSetup setup_of(const PlanetaryDrivetrain& drivetrain, const Tolerances& tolerances) {
  system::CoupledSetup setup = analysis::coupled_setup(drivetrain, analysis::derive(drivetrain));
  setup.gears.allowed_share = tolerances.gears;
  setup.bearing.allowed_length_error = tolerances.bearing;
  return setup;
}

// A drivetrain with its participants and their run.
struct ReducerRun {
  ReducerRun(const PlanetaryDrivetrain& drivetrain, const Tolerances& tolerances,
             const CoupledOptions& options)
      : parts(planetary_coupling(setup_of(drivetrain, tolerances))), run(parts.sides, options) {
    run.initialize(0.0);
  }

  PlanetaryCoupling parts;
  CoupledRun run;
};

// Displacements of all planets at the end of the path.
Eigen::Matrix2Xd displacements(const system::DrivenGearsOutput& gears) {
  Eigen::Matrix2Xd out(2, static_cast<Eigen::Index>(gears.planets.size()));
  for (Eigen::Index i = 0; i < out.cols(); ++i)
    out.col(i) = gears.planets[static_cast<std::size_t>(i)].displacement;
  return out;
}

const PlanetaryDrivetrain& smooth_reducer() {
  static const PlanetaryDrivetrain drivetrain = example::coupled_reducer(true);
  return drivetrain;
}

// The system solved as one, once for all schemes.
const Eigen::Matrix2Xd& solved_as_one() {
  static const Eigen::Matrix2Xd end = [] {
    system::Monolithic system(setup_of(smooth_reducer(), kTight));
    system.initialize(0.0);
    system.advance({0.0, kPath});
    return displacements(system.gears());
  }();
  return end;
}

struct Errors {
  double displacement = 0.0;  // [m]
  double residual = 0.0;      // [J]  sum of absolute values
};

struct Scheme {
  const char* name;
  ExchangeOrder order;
  int extrapolation;
  bool iterated;
  double expected;
};

class CosimReducerOrder : public ::testing::TestWithParam<Scheme> {
 protected:
  Errors errors(double window) const {
    CoupledOptions options{
        .order = GetParam().order, .extrapolation = GetParam().extrapolation, .window = window};
    if (GetParam().iterated) options.iteration = {.most_passes = 30, .allowed_change = 1e-10};
    ReducerRun reducer(smooth_reducer(), kTight, options);
    const CoupledReport report = reducer.run.advance(std::lround(kPath / window));
    EXPECT_TRUE(report.completed) << report.message;
    EXPECT_EQ(report.not_converged, 0);
    const Eigen::Matrix2Xd found = displacements(reducer.parts.gears->output());
    return {(found - solved_as_one()).cwiseAbs().maxCoeff(), report.absolute_residual};
  }
};

TEST_P(CosimReducerOrder, IsTheDerivedOne) {
  const Errors coarse = errors(kWindow), fine = errors(0.5 * kWindow);
  EXPECT_NEAR(std::log2(coarse.displacement / fine.displacement), GetParam().expected, kOrder);
  if (!GetParam().iterated) {
    EXPECT_NEAR(std::log2(coarse.residual / fine.residual), GetParam().expected, kOrder);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, CosimReducerOrder,
    ::testing::Values(Scheme{"jacobi_0", ExchangeOrder::jacobi, 0, false, 1.0},
                      Scheme{"jacobi_1", ExchangeOrder::jacobi, 1, false, 2.0},
                      Scheme{"jacobi_2", ExchangeOrder::jacobi, 2, false, 3.0},
                      Scheme{"gauss_seidel_0", ExchangeOrder::gauss_seidel, 0, false, 1.0},
                      Scheme{"gauss_seidel_1", ExchangeOrder::gauss_seidel, 1, false, 2.0},
                      Scheme{"gauss_seidel_2", ExchangeOrder::gauss_seidel, 2, false, 3.0},
                      Scheme{"iterated_0", ExchangeOrder::gauss_seidel, 0, true, 2.0},
                      Scheme{"iterated_1", ExchangeOrder::gauss_seidel, 1, true, 3.0}),
    [](const ::testing::TestParamInfo<Scheme>& scheme) { return scheme.param.name; });

// Gravity in the frame of the carrier: bearings that sum up its angle in windows fall as those of one system.
TEST(CosimReducer, WeightActsAsInOneSystem) {
  PlanetaryDrivetrain drivetrain = smooth_reducer();
  drivetrain.dynamics.gravity.across = 1e5;  // [m/s^2]  so that it shows within the path
  system::Monolithic one(setup_of(drivetrain, kTight));
  one.initialize(0.0);
  one.advance({0.0, kPath});
  ReducerRun exchanging(drivetrain, kTight,
                        {.order = ExchangeOrder::gauss_seidel, .extrapolation = 2, .window = 0.5 * kWindow});
  ASSERT_TRUE(exchanging.run.advance(std::lround(kPath / (0.5 * kWindow))).completed);
  const Eigen::Matrix2Xd heavy = displacements(one.gears()),
                         found = displacements(exchanging.parts.gears->output());
  const double effect = (heavy - solved_as_one()).cwiseAbs().maxCoeff();
  EXPECT_GT(effect, 1e-7);  // [m]
  EXPECT_LT((found - heavy).cwiseAbs().maxCoeff(), 1e-3 * effect);
}

CoupledOptions default_value(double window) {
  return {.extrapolation = 1, .window = window};
}

// All participants, in one list of numbers.
SavedState everything(const PlanetaryCoupling& parts) {
  SavedState all, one;
  for (const Side& side : parts.sides) {
    side.participant->save(one);
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

TEST(CosimReducer, ARestoredRunGivesTheSameBits) {
  const PlanetaryDrivetrain drivetrain = example::coupled_reducer(false);
  ReducerRun one(drivetrain, {}, default_value(1e-5)), other(drivetrain, {}, default_value(1e-5));
  one.run.advance(20);
  std::vector<SavedState> saved;
  for (const Side& side : one.parts.sides) side.participant->save(saved.emplace_back());
  const InterfaceHistory here{one.run.values()};
  one.run.start_from(here);
  one.run.advance(30);
  for (std::size_t s = 0; s < saved.size(); ++s) other.parts.sides[s].participant->restore(saved[s]);
  other.run.start_from(here);
  other.run.advance(30);
  EXPECT_EQ(everything(one.parts), everything(other.parts));
}

// Bearings come in any order: they hear of the gears alone.
TEST(CosimReducer, OrderOfTheBearingsDoesNotMatter) {
  const PlanetaryDrivetrain drivetrain = example::coupled_reducer(false);
  ReducerRun one(drivetrain, {}, default_value(1e-5));
  one.run.advance(20);
  const PlanetaryCoupling parts = planetary_coupling(setup_of(drivetrain, {}));
  Sides reversed = parts.sides;
  std::reverse(reversed.begin() + 1, reversed.end());
  CoupledRun run(reversed, default_value(1e-5));
  run.initialize(0.0);
  run.advance(20);
  EXPECT_EQ(everything(one.parts), everything(parts));
}

// Planets one place further on, with their phases: the same motion under other names.
TEST(CosimReducer, PlanetsCanBeRenamed) {
  PlanetaryDrivetrain drivetrain = example::coupled_reducer(false);
  ReducerRun one(drivetrain, {}, default_value(5e-6));
  gearset::dynamics::SetParameters gears = drivetrain.gear_set();
  for (std::vector<double>* phases : {&gears.sun_phase, &gears.ring_phase})
    std::rotate(phases->begin(), phases->begin() + 1, phases->end());
  drivetrain.gear_set = [gears] { return gears; };
  ReducerRun renamed(drivetrain, {}, default_value(5e-6));
  one.run.advance(40);
  renamed.run.advance(40);
  const Eigen::Matrix2Xd before = displacements(one.parts.gears->output());
  const Eigen::Matrix2Xd after = displacements(renamed.parts.gears->output());
  // Steps of the gears differ by round-off, which rollers amplify within 0.2 ms.
  for (Eigen::Index i = 0; i < 4; ++i)
    EXPECT_LT((after.col(i) - before.col((i + 1) % 4)).norm(), 1e-6 * before.col(i).norm());
  EXPECT_GT((after - before).norm(), 1e-3 * before.norm());  // planets do not all move equally
}

// At the start the bearings hold what the meshes leave and the planet's own centrifugal load.
TEST(CosimReducer, BeginsInBalance) {
  const PlanetaryDrivetrain& drivetrain = smooth_reducer();
  ReducerRun reducer(drivetrain, {}, default_value(1e-6));
  const gearset::MeanLoads loads = bearing_duty(drivetrain, analysis::derive(drivetrain)).gears;
  const gearset::dynamics::SetParameters gears = drivetrain.gear_set();
  const double centrifugal =
      gears.planet.mass * loads.carrier_speed * loads.carrier_speed * gears.carrier.radius;
  const Eigen::Vector2d load(loads.radial_force + centrifugal, loads.tangential_force);
  const double displaced = 1e-5 / gears.carrier.radius;  // [-]  which changes the centrifugal load
  for (std::size_t planet = 0; planet < 4; ++planet) {
    const JointValue* joint = &reducer.run.values().joints[3 * planet];
    EXPECT_LT((Eigen::Vector2d(joint[0].force, joint[1].force) + load).norm(), displaced * load.norm());
    EXPECT_EQ(joint[0].velocity, 0.0);
  }
}

}  // namespace
}  // namespace orbearing::cosim::cosim_reducer_test
