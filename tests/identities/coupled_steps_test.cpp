// Effect of substepped bearings on the gears, and the reactions that a step of the whole system reports.
#include "coupling/system/coupled_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bearing/motion/driven_start.hpp"
#include "coupling/integration/window.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/monolithic.hpp"
#include "tests/unit/cosim/coupled_reducer.hpp"

namespace orbearing::system::coupled_steps_test {
namespace {

constexpr double kGamma = 0.29289321881345248;

// A reducer of constant mesh stiffness, so that nothing jumps within a step.
CoupledSetup smooth_reducer() {
  CoupledSetup setup = test::coupled_reducer();
  for (gearset::dynamics::Mesh* mesh : {&setup.gears.set.sun_mesh, &setup.gears.set.ring_mesh})
    mesh->stiffness = gearset::PeriodicCurve::constant(4e8);
  return setup;
}

std::vector<double> state_of(const CoupledSystem& system, const Monolithic& run) {
  const CoupledStart now = run.state();
  std::vector<double> x(system.size(), 0.0);
  std::copy(now.gears.begin(), now.gears.end(), x.begin());
  for (int b = 0; b < system.bearings(); ++b) {
    const auto padded = system.bearing(b).padded(now.bearings[static_cast<std::size_t>(b)]);
    std::copy(padded.begin(), padded.end(), system.of_bearing(x.data(), b));
  }
  return x;
}

// The coupled reducer, from a state in which meshes whose stiffness jumps have made its rollers bounce.
class CoupledStepsOfReducer : public testing::Test {
 protected:
  CoupledSetup setup = smooth_reducer();
  CoupledModel model = coupled_model(setup);
  CoupledSystem system{model};
  Eigen::Index n = model.gears.layout.freedoms();
  double begin = 1e-3;  // [s]

  void SetUp() override { system.set_piece(begin, begin, begin + 1.0); }

  std::vector<double> bouncing() {
    Monolithic run(test::coupled_reducer());
    run.initialize(0.0);
    run.advance({0.0, begin});
    return state_of(system, run);
  }

  // Velocities of the gears after `length` [s], by steps of the whole system of `h` [s]; with `substepped`,
  // at most that number of bearings is substepped, in steps as long as `tolerance` allows.
  Eigen::VectorXd velocities(std::vector<double> x, double length, double h, int substepped,
                             double tolerance) {
    const auto bearing = linearly_implicit_errors(
        system.bearing(0), allowed_errors(model.bearing, tolerance * setup.bearing.allowed_length_error));
    const std::vector<double> gears(static_cast<std::size_t>(2 * n), 0.0);
    CoupledSteps steps(system, {gears, bearing, h, substepped, 100'000});
    integration::Rosenbrock2 plain(std::vector<double>(x.size(), 0.0), h);
    const long count = std::lround(length / h);
    double time = 0.0;
    for (long i = 0; i < count; ++i) {
      double step = h;
      if (substepped > 0) {
        steps.begin(system, x, time);
        system.begun(x);
        EXPECT_EQ(steps.try_step(system, x, time, step), integration::kAccepted);
      } else {
        plain.begin(system, x, time);
        system.begun(x);
        EXPECT_EQ(plain.try_step(system, x, time, step), integration::kAccepted);
      }
      system.stepped(time, h);
      system.settle(time, x);
    }
    EXPECT_EQ(steps.substepped() > 0, substepped > 0);
    return system.part(x.data(), n);
  }
};

// Steps of order 4 need the slope of the rate by time, which is that of the mesh stiffness: within one piece,
// however long, it is that of central differences.
TEST(TimeSlope, IsThatOfTheMeshStiffness) {
  CoupledSetup setup = test::oiled_reducer();
  const auto wave = [](double fraction) { return 4e8 + 1e8 * std::sin(2.0 * M_PI * fraction); };
  for (gearset::dynamics::Mesh* mesh : {&setup.gears.set.sun_mesh, &setup.gears.set.ring_mesh})
    mesh->stiffness = gearset::PeriodicCurve(wave, {}, 400);
  const CoupledModel model = coupled_model(setup);
  Monolithic run(setup);
  run.initialize(0.0);
  run.advance({0.0, 1e-4});
  WithAllSlopes system(model);
  const double begin = 1e-4, period = 1.0 / model.gears.operation.mesh_frequency;
  system.set_piece(begin, begin, begin + 100.0 * period);
  const std::vector<double> x = state_of(system, run);
  std::vector<double> slope(x), rate(x), after(x), before(x);
  const double at = 50.2 * period, step = 1e-3 * period;
  system.linearise(at, x.data(), rate.data());
  system.time_slope(at, slope.data());
  system.derivative(at + step, x.data(), after.data());
  system.derivative(at - step, x.data(), before.data());
  const Eigen::Index gears = 2 * system.freedoms();
  const Eigen::Map<const Eigen::VectorXd> found(slope.data(), gears), later(after.data(), gears),
      sooner(before.data(), gears);
  const Eigen::VectorXd differences = (later - sooner) / (2.0 * step);
  EXPECT_GT(differences.norm(), 0.0);
  EXPECT_LT((found - differences).norm(), 2e-3 * differences.norm());
}

// The mean force that a step reports for each bearing is the force on the gears: with the forces of the gears
// in both stages it equals the whole change of their momentum, to round-off.
TEST_F(CoupledStepsOfReducer, MeanReactionsAreWhatTheGearsFelt) {
  const std::vector<double> x = bouncing();
  const double h = 3e-6, g = kGamma * h;
  std::vector<double> f(x.size()), k1(x.size()), k2(x.size()), ahead(x), rhs(x.size());
  system.linearise(0.0, x.data(), f.data());
  ASSERT_TRUE(system.factor(g));
  system.solve(f.data(), k1.data());
  for (std::size_t i = 0; i < x.size(); ++i) ahead[i] = x[i] + h * k1[i];
  system.derivative(h, ahead.data(), rhs.data());
  for (std::size_t i = 0; i < x.size(); ++i) rhs[i] -= 2.0 * k1[i];
  system.solve(rhs.data(), k2.data());

  const gearset::dynamics::SetModel& gears = model.gears;
  gearset::dynamics::ForceSlopes slopes;
  force_slopes(gears, begin, Eigen::Map<const Eigen::VectorXd>(x.data(), 2 * n), slopes);
  const auto of_gears = [&](double time, const std::vector<double>& at, const std::vector<double>& k) {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
    add_forces(gears, time, Eigen::Map<const Eigen::VectorXd>(at.data(), 2 * n), force);
    return (force + g * (slopes.by_position * system.part(k.data(), 0) +
                         slopes.by_velocity * system.part(k.data(), n)))
        .eval();
  };
  const Eigen::VectorXd own = 0.5 * (of_gears(begin, x, k1) + of_gears(begin + h, ahead, k2));
  gearset::dynamics::PortLoads loads{Eigen::Matrix2Xd::Zero(2, 4), Eigen::VectorXd::Zero(4)};
  for (int b = 0; b < system.bearings(); ++b) {
    loads.force.col(b / model.per_planet) += system.mean_reaction(b).force;
    loads.moment[b / model.per_planet] += system.mean_reaction(b).moment;
  }
  Eigen::VectorXd all = own;
  add_port_loads(gears, loads, all);
  EXPECT_GT((all - own).norm(), 100.0) << "bearings carry the set [N]";
  for (Eigen::Index i = 0; i < n; ++i) {
    if (gears.mobility[i] == 0.0) continue;
    const auto v = static_cast<std::size_t>(n + i);
    const double change = gears.mass[i] * (1.5 * k1[v] + 0.5 * k2[v]);  // [N]
    EXPECT_NEAR(change, all[i], 1e-8 * own.norm()) << "freedom " << i;
  }
}

// Gears include the motion of substepped bearings beyond the step of the whole system. Long steps with
// substepped bearings come closer to short ones than long steps alone, over successive states: as many as
// required so that no single impact dominates.
TEST_F(CoupledStepsOfReducer, GearsFeelWhatSubsteppedBearingsDid) {
  const double length = 60e-6, h = 6e-6;  // [s]
  Monolithic run(test::coupled_reducer());
  run.initialize(0.0);
  double plain = 0.0, substepped = 0.0;
  for (int k = 0; k < 36; ++k) {
    run.advance({k == 0 ? 0.0 : begin + 1e-4 * (k - 1), begin + 1e-4 * k});
    const std::vector<double> x = state_of(system, run);
    const Eigen::VectorXd exact = velocities(x, length, h / 128, 0, 1.0);
    plain += (velocities(x, length, h, 0, 1.0) - exact).squaredNorm();
    substepped += (velocities(x, length, h, 8, 1.0) - exact).squaredNorm();
  }
  RecordProperty("substepped_over_plain", std::to_string(std::sqrt(substepped / plain)));
  EXPECT_LT(substepped, 0.4 * 0.4 * plain);
}

// The impulses act on planet, carrier and load as forces do.
TEST_F(CoupledStepsOfReducer, ImpulsesChangeMomentumAndNothingElse) {
  const std::vector<double> x = bouncing();
  std::vector<double> after = x;
  gearset::dynamics::PortLoads impulses{Eigen::Matrix2Xd::Random(2, 4), Eigen::VectorXd::Random(4)};
  system.push(impulses, after.data());
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(n);
  add_port_loads(model.gears, impulses, expected);
  EXPECT_GT(expected.norm(), 0.1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto position = static_cast<Eigen::Index>(i) - n;
    const double change =
        position >= 0 && position < n ? model.gears.mobility[position] * expected[position] : 0.0;
    EXPECT_NEAR(after[i] - x[i], change, 1e-12 * (1.0 + std::abs(x[i])));
  }
}

// Rate and slopes that are known at the beginning of a step of the whole system need not be computed again:
// the same motion to the last bit.
TEST(DrivenSystem, ResumesFromWhatIsKnown) {
  const DrivenBearingSetup setup = test::driven_reducer();
  const bearing::motion::BearingModel model = driven_model(setup);
  const BoreInputs inputs = test::swinging_polynomial(test::pressed_motion(), 0.5e-6, 1e4, 0.0);
  bearing::vectorised::VectorBearing vectorised(model);
  const std::vector<double> start =
      vectorised.padded(driven_start(setup.bearing, model, setup.dynamics, inputs.at(0.0), 0.3));
  const auto allowed =
      linearly_implicit_errors(vectorised, allowed_errors(model, setup.allowed_length_error));
  struct End {
    std::vector<double> x;
    bearing::motion::BoreReaction impulse;
    Eigen::ArrayXd load;
  };
  const auto run = [&](bool resumes) {
    LoadsAtStep loads(setup.bearing.rollers().count);
    bearing::motion::DamageSums sums(72);
    DrivenSystem system(vectorised, inputs, {}, loads, &sums);
    std::vector<double> x = start, rate(start.size());
    if (resumes) {
      system.linearise(0.0, x.data(), rate.data());
      system.begun(x);
      const bearing::motion::BoreReaction reaction = vectorised.reaction();
      // Evaluated elsewhere in between, as the second stage of the step of all is.
      std::vector<double> ahead = x, other(x.size());
      ahead[0] += 1e-7;
      system.derivative(2e-6, ahead.data(), other.data());
      system.resume(rate.data(), reaction);
    }
    integration::Rosenbrock2 stepper(allowed, longest_step(model));
    double step = 1e-6;
    integration::through_window(stepper, system, x, 20e-6, {}, step);
    return End{x, system.impulse(), sums.outer.power};
  };
  const End plain = run(false), resumed = run(true);
  EXPECT_EQ(plain.x, resumed.x);
  EXPECT_EQ(plain.impulse.force, resumed.impulse.force);
  EXPECT_EQ(plain.impulse.moment, resumed.impulse.moment);
  EXPECT_TRUE((plain.load == resumed.load).all());
  EXPECT_GT(plain.impulse.force.norm(), 0.0);
}

// Fewer than a tenth of the steps of the whole system are rejected where the mesh stiffness jumps, since
// single bearings are substepped before all are rejected.
TEST(CoupledSteps, RefuseFewSteps) {
  Monolithic system(test::coupled_reducer());
  system.initialize(0.0);
  system.advance({0.0, 10e-3});
  const integration::IntegrationReport report = system.report();
  EXPECT_GT(system.substepped(), 100);
  EXPECT_LT(static_cast<double>(report.rejected), 0.1 * static_cast<double>(report.steps + report.rejected));
}

}  // namespace
}  // namespace orbearing::system::coupled_steps_test
