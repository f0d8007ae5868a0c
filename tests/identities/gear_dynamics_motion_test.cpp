// The planetary set in time: energy, order of the method, symmetry, and the limits with closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/analysis/gear_dynamics.hpp"
#include "gearset/dynamics/energy.hpp"
#include "gearset/dynamics/static_state.hpp"
#include "gearset/mean_loads.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::gearset::dynamics::gear_dynamics_motion_test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using integration::IntegrationOptions;

// The state with the work that entered, the work lost, and all work turned over, whatever its sign.
class WithWorks {
 public:
  explicit WithWorks(const SetModel& model) : equations_(model) {}

  VectorXd start(const VectorXd& x) const {
    VectorXd all = VectorXd::Zero(x.size() + 3);
    all.head(x.size()) = x;
    return all;
  }

  integration::RightHandSide derivative() const {
    return [this](double time, const Eigen::Ref<const VectorXd>& all, Eigen::Ref<VectorXd> rate) {
      const Index n = all.size() - 3;
      equations_.derivative(time, all.head(n), rate.head(n));
      const PowerFlow flow = power_flow(equations_.model(), time, all.head(n));
      rate.tail(3) << flow.input(), flow.loss(),
          std::abs(flow.drive) + std::abs(flow.stiffness) + std::abs(flow.error) + std::abs(flow.frame) +
              flow.loss();
    };
  }

 private:
  PlanetarySetEquations equations_;
};

struct Balance {
  double residual = 0.0;     // [J]
  double turned_over = 0.0;  // [J]
  double at_jumps = 0.0;     // [J]  sum of their sizes
};

Balance work_balance(const SetModel& model, double share, double periods) {
  const WithWorks works(model);
  VectorXd x = static_state(model);
  const Index n = x.size();
  const double end = time_of_periods(model.operation, periods);
  const double before = energy(model, 1e-9 / model.operation.mesh_frequency, x).total();
  IntegrationOptions options;
  options.step = 1e-7;
  options.allowed_error.resize(n + 3);
  options.allowed_error << integration::gear_allowed_errors(model, share), VectorXd::Constant(3, 1e-12);
  VectorXd all = works.start(x);
  double jumped = 0.0;
  Balance balance;
  const auto stored = [&](double time) { return energy(model, time, all.head(n)).stored(); };
  const integration::Jumps jumps = integration::jumps_of(model);
  long jump = 0;
  for (double begin = 0.0; begin < end;) {
    double next = end;
    while (jumps.time && (next = jumps.time(jump)) <= begin + jumps.margin) ++jump;
    const double stop = std::min(next, end);
    const integration::IntegrationReport report =
        integrate_pieces(works.derivative(), all, {begin, stop - begin, 1}, jumps, options, {});
    EXPECT_TRUE(report.completed) << report.message;
    if (!report.completed) break;
    options.step = report.next_step;
    begin = stop;
    if (stop == end) break;
    const double change = stored(stop + jumps.margin) - stored(stop - jumps.margin);
    jumped += change;
    balance.at_jumps += std::abs(change);
  }
  const double after = energy(model, end + 1e-9 / model.operation.mesh_frequency, all.head(n)).total();
  balance.residual = after - before - (all[n] - all[n + 1] + jumped);
  balance.turned_over = all[n + 2] + balance.at_jumps;
  return balance;
}

constexpr double kBalance = 1e-8;  // of the energy turned over

TEST(GearDynamicsMotion, WorkBalancesOverAThousandMeshPeriods) {
  const SetModel model = set_model(test::reducer_dynamics(), test::reducer_operation(628.0));
  const Balance balance = work_balance(model, 1e-8, 1000.0 + 0.11);
  EXPECT_LT(std::abs(balance.residual), kBalance * balance.turned_over);
  // Without the work of the stiffness at its jumps the balance would be far off.
  EXPECT_GT(balance.at_jumps, 1e4 * kBalance * balance.turned_over);
}

TEST(GearDynamicsMotion, WorkBalancesInARunUpWithPartingTeethAndErrors) {
  SetParameters set = test::reducer_dynamics();
  set.sun_mesh.error = PeriodicCurve([](double f) { return 2e-5 * std::sin(2.0 * M_PI * f); }, {}, 64);
  Operation operation = test::reducer_operation(628.0);
  operation.run_up = {.from = 0.5, .duration = 0.01};
  operation.power = 1e3;
  operation.torques = member_torques(reducer(), {Member::sun, 1e3, 628.0});
  const SetModel model = set_model(set, operation);
  const Balance balance = work_balance(model, 1e-8, 50.13);
  EXPECT_LT(std::abs(balance.residual), kBalance * balance.turned_over);
}

// Teeth under load do no work at jumps, since there are none.
TEST(GearDynamicsMotion, WorkBalancesWithLoadedTeeth) {
  SetParameters set = test::reducer_dynamics();
  test::load_teeth(set);
  const SetModel model = set_model(set, test::reducer_operation(628.0));
  EXPECT_TRUE(jump_phases(model).empty());
  // Tables that leave a step of a billionth of the period's gap at their corners are seen at this accuracy.
  const Balance balance = work_balance(model, 1e-9, 30.0 + 0.11);
  EXPECT_LT(std::abs(balance.residual), kBalance * balance.turned_over);
  EXPECT_EQ(balance.at_jumps, 0.0);
}

// Static position on springs about the mean load, which the teeth themselves carry on the mean.
TEST(GearDynamicsLimits, LoadedTeethRestUnderTheirMeanLoad) {
  const PlanetarySet set = reducer();
  const Drive drive{Member::sun, 150e3, 104.72};
  const MeanLoads loads = mean_loads(set, working_geometry(set), drive);
  SetParameters parameters = test::reducer_dynamics();
  test::load_teeth(parameters);
  const SetModel model = set_model(parameters, operation_of(set, drive));
  const VectorXd x = static_state(model);
  for (const PlanetMesh& mesh : model.meshes) {
    const Mesh& law = model.mesh(mesh.kind);
    const double approach = mesh.loaded.of(x.head(21), mesh.central, mesh.planet_index) - 0.5 * law.backlash;
    EXPECT_NEAR(law.stiffness.mean() * (approach - law.free_approach), loads.normal_force,
                1e-6 * loads.normal_force);
    double mean = 0.0;
    for (int i = 0; i < 500; ++i) mean += law.loaded->at(i / 500.0, approach).force / 500.0;
    // Their mean force at the mean approach is not quite that at which each place has its own.
    EXPECT_NEAR(mean, loads.normal_force, 0.05 * loads.normal_force);
  }
  const SetModel mean = averaged(model);
  EXPECT_EQ(mean.parameters.sun_mesh.loaded, nullptr);
  EXPECT_LT((static_state(mean) - x).norm(), 1e-9 * x.norm());
}

// Halving the allowed error by 32 lets dopri5's steps halve: the error falls with the tolerance.
TEST(GearDynamicsMotion, ConvergesWithTheAllowedError) {
  SetParameters set = test::reducer_dynamics();
  set.separation = false;
  const SetModel model = set_model(set, test::reducer_operation(628.0));
  const auto run = [&](double share) {
    const PlanetarySetEquations equations(model);
    VectorXd x = static_state(model);
    IntegrationOptions options;
    options.step = 1e-6;
    options.allowed_error = integration::gear_allowed_errors(model, share);
    const auto derivative = [&](double time, const Eigen::Ref<const VectorXd>& at, Eigen::Ref<VectorXd> dx) {
      equations.derivative(time, at, dx);
    };
    const integration::IntegrationReport report =
        integrate_pieces(derivative, x, {0.0, 20.2 / model.operation.mesh_frequency, 1},
                         integration::jumps_of(model), options, {});
    return std::pair(x, static_cast<double>(report.steps));
  };
  const auto [exact, most] = run(1e-11);
  const auto [coarse, few] = run(1e-6);
  const auto [fine, many] = run(1e-8);
  const Index n = model.layout.freedoms();
  const double order =
      std::log((coarse - exact).head(n).norm() / (fine - exact).head(n).norm()) / std::log(many / few);
  EXPECT_GT(order, 4.0);
}

// The static state carries the mean loads of Eqs. (18) to (20) of gearset/README.md.
TEST(GearDynamicsLimits, StaticStateCarriesTheMeanLoads) {
  const PlanetarySet set = reducer();
  const Drive drive{Member::sun, 150e3, 628.0};
  const MeanLoads loads = mean_loads(set, working_geometry(set), drive);
  for (const bool separation : {true, false}) {
    SetParameters parameters = test::reducer_dynamics();
    parameters.separation = separation;
    const SetModel model = set_model(parameters, operation_of(set, drive));
    const VectorXd x = static_state(model);
    const auto along = [&](const PlanetMesh& mesh) {
      const double gap = separation ? 0.5 * model.mesh(mesh.kind).backlash : 0.0;
      return model.mesh(mesh.kind).stiffness.mean() *
             (mesh.loaded.of(x.head(21), mesh.central, mesh.planet_index) - gap);
    };
    const double round_off = 1e-6;  // relative: the springs' 1e8 N/m times round-off of the backlash
    for (const PlanetMesh& mesh : model.meshes)
      EXPECT_NEAR(along(mesh), loads.normal_force, round_off * loads.normal_force);
    const double centrifugal =
        parameters.planet.mass * parameters.carrier.radius * std::pow(loads.carrier_speed, 2);
    for (const PlanetBearing& bearing : model.bearings) {
      const double radial = bearing.radial.of(x.head(21), SetLayout::carrier(), bearing.planet_index);
      const double tangential = bearing.tangential.of(x.head(21), SetLayout::carrier(), bearing.planet_index);
      // The planet's own outward shift adds a share of some 1e-5 to its centrifugal force.
      EXPECT_NEAR(-radial * parameters.planet.bearing_stiffness, loads.radial_force + centrifugal,
                  1e-4 * loads.normal_force);
      EXPECT_NEAR(-tangential * parameters.planet.bearing_stiffness, loads.tangential_force,
                  round_off * loads.normal_force);
    }
  }
}

// A driving carrier loads the other flanks, with the same forces.
TEST(GearDynamicsLimits, TheOtherSenseLoadsTheOtherFlanks) {
  const PlanetarySet set = reducer();
  const Drive drive{Member::carrier, 150e3, 200.0};
  const MeanLoads loads = mean_loads(set, working_geometry(set), drive);
  const SetModel model = set_model(test::reducer_dynamics(), operation_of(set, drive));
  const VectorXd x = static_state(model);
  for (const PlanetMesh& mesh : model.meshes) {
    const double approach = mesh.loaded.of(x.head(21), mesh.central, mesh.planet_index) - 50e-6;
    EXPECT_NEAR(model.mesh(mesh.kind).stiffness.mean() * approach, loads.normal_force,
                1e-6 * loads.normal_force);
  }
}

// One sun mesh between a sun and a planet that can only turn: a mass of I_s I_p / (I_s + I_p) on a spring.
TEST(GearDynamicsLimits, ASingleMeshSwingsAsOneFreedom) {
  SetParameters set = test::lin_parker(1);
  set.separation = false;
  set.sun.support.held = set.carrier.support.held = true;
  set.carrier.support.held_in_rotation = true;
  set.planet.bearing_stiffness = 1e15;
  set.ring_mesh.stiffness = PeriodicCurve::constant(1e-3);
  const SetModel model = set_model(set, {});
  const double mass = set.sun.inertia * set.planet.inertia / (set.sun.inertia + set.planet.inertia);
  const double frequency = std::sqrt(5e8 / mass);  // [rad/s]
  VectorXd x = VectorXd::Zero(model.layout.size());
  const double deflection = 1e-5;  // [m]
  x[SetLayout::sun() + 2] = deflection * mass / set.sun.inertia;
  x[SetLayout::planet(0) + 2] = deflection * mass / set.planet.inertia;
  const PlanetarySetEquations equations(model);
  IntegrationOptions options;
  options.allowed_error = VectorXd::Constant(model.layout.size(), 1e-13);
  options.allowed_error.tail(model.layout.freedoms()) *= 1e5;
  options.step = 1e-9;
  const auto derivative = [&](double time, const Eigen::Ref<const VectorXd>& at, Eigen::Ref<VectorXd> dx) {
    equations.derivative(time, at, dx);
  };
  double worst = 0.0;
  const auto observe = [&](double time, const Eigen::Ref<const VectorXd>& at) {
    const double now = model.meshes[0].loaded.of(at.head(12), SetLayout::sun(), SetLayout::planet(0));
    worst = std::max(worst, std::abs(now - deflection * std::cos(frequency * time)));
  };
  integrate_pieces(derivative, x, {0.0, 5e-6, 60}, {}, options, observe);
  // The bearing yields by 5e8 / 1e15 of the deflection; the rest is the integration.
  EXPECT_LT(worst, 1e-5 * deflection);
}

class GearRun : public testing::Test {
 protected:
  static analysis::GearRunOptions options() {
    analysis::GearRunOptions out;
    out.observed_periods = 20;
    out.window_periods = 20;
    return out;
  }
};

// Planet n does what planet 0 does a phase step earlier: all planets of a run have the same statistics.
TEST_F(GearRun, PlanetsOfEqualPhaseStepsAreAlike) {
  const analysis::GearRunResult result =
      run_gears(set_model(test::reducer_dynamics(), test::reducer_operation(628.0)), options());
  ASSERT_TRUE(result.completed) << result.message;
  EXPECT_TRUE(result.steady);
  const analysis::PlanetStatistics& first = result.planets.front();
  for (const analysis::PlanetStatistics& planet : result.planets) {
    // Tolerance for the drift between two windows and for the allowed error of the steps.
    EXPECT_NEAR(planet.radial_acceleration.rms, first.radial_acceleration.rms,
                2e-2 * first.radial_acceleration.rms);
    EXPECT_NEAR(planet.load_share, 1.0, 1e-3);
    EXPECT_NEAR(planet.sun_mesh_force.mean, first.sun_mesh_force.mean, 1e-3 * first.sun_mesh_force.mean);
  }
}

// The torques determine the mean mesh forces, and no planet moves away: means over whole mesh periods hold
// where the stiffness jumps too, though forces and accelerations there have two values.
TEST_F(GearRun, MeansAreThoseOfTheTorqueBalance) {
  constexpr double kForce = 1e-3;        // [-]
  constexpr double kAcceleration = 1.0;  // [m/s^2]  of some hundred to some thousand at an instant
  for (const double rpm : {1000.0, 6000.0, 12000.0}) {
    const SetModel model =
        set_model(test::reducer_dynamics(), test::reducer_operation(rpm * 2.0 * M_PI / 60.0));
    analysis::GearRunOptions default_value;
    default_value.observed_periods = 100;
    const analysis::GearRunResult result = run_gears(model, default_value);
    ASSERT_TRUE(result.completed) << result.message;
    const double force =
        model.operation.torques.sun / (model.parameters.planets * model.parameters.sun.radius);
    for (const analysis::PlanetStatistics& planet : result.planets) {
      EXPECT_NEAR(planet.sun_mesh_force.mean, force, kForce * force) << rpm << " rpm";
      EXPECT_NEAR(planet.ring_mesh_force.mean, force, kForce * force) << rpm << " rpm";
      EXPECT_NEAR(planet.radial_acceleration.mean, 0.0, kAcceleration) << rpm << " rpm";
      EXPECT_NEAR(planet.tangential_acceleration.mean, 0.0, kAcceleration) << rpm << " rpm";
    }
  }
}

// The harmonics hold phase and amplitude: they rebuild the series, whose samples lie elsewhere, up to the
// orders left out.
TEST_F(GearRun, HarmonicsRebuildTheSeries) {
  analysis::GearRunOptions many = options();
  many.harmonics = 40;
  const SetModel model = set_model(test::reducer_dynamics(), test::reducer_operation(628.0));
  const analysis::GearRunResult result = run_gears(model, many);
  ASSERT_TRUE(result.completed) << result.message;
  const analysis::SignalStatistics& force = result.planets[1].tangential_force;  // a spring's: without jumps
  Eigen::ArrayXd rebuilt = Eigen::ArrayXd::Constant(result.series.time.size(), force.mean);
  for (std::size_t i = 0; i < force.cosines.size(); ++i) {
    const Eigen::ArrayXd angle =
        2.0 * M_PI * result.mesh_frequency * static_cast<double>(i + 1) * result.series.time;
    rebuilt += force.cosines[i] * angle.cos() + force.sines[i] * angle.sin();
  }
  constexpr double kLeft = 0.01;  // of the swing: the force bends at jumps, orders fall as their square
  EXPECT_LT((rebuilt - result.series.tangential_force.row(1).transpose()).abs().maxCoeff(),
            kLeft * (force.largest - force.least));
  EXPECT_NEAR(force.amplitudes[0], std::hypot(force.cosines[0], force.sines[0]), 1e-12 * force.amplitudes[0]);
}

// Teeth that engage gradually excite the planets less than those that engage at once.
TEST_F(GearRun, LoadedTeethCarryTheMeanLoads) {
  SetParameters set = test::reducer_dynamics();
  test::load_teeth(set);
  const SetModel model = set_model(set, test::reducer_operation(628.0));
  analysis::GearRunOptions default_value;
  default_value.observed_periods = 100;
  const analysis::GearRunResult result = run_gears(model, default_value);
  ASSERT_TRUE(result.completed) << result.message;
  const double force = model.operation.torques.sun / (set.planets * set.sun.radius);
  for (const analysis::PlanetStatistics& planet : result.planets) {
    EXPECT_NEAR(planet.sun_mesh_force.mean, force, 1e-3 * force);
    EXPECT_NEAR(planet.ring_mesh_force.mean, force, 1e-3 * force);
    // In the housing the planet is also carried round.
    const double carried = std::pow(model.operation.speeds.carrier, 2) * set.carrier.radius;
    const double relative = std::hypot(planet.radial_acceleration.rms, planet.tangential_acceleration.rms);
    EXPECT_NEAR(2.0 * std::pow(planet.housing_acceleration, 2), relative * relative + carried * carried,
                0.05 * (relative * relative + carried * carried));
  }
}

// Constant stiffness excites nothing: the mean loads for all time.
TEST_F(GearRun, RestsWithoutExcitation) {
  SetParameters set = test::reducer_dynamics();
  const SetModel model = averaged(set_model(set, test::reducer_operation(628.0)));
  analysis::GearRunOptions fine = options();
  fine.allowed_share = 1e-8;  // steps ring at their limit of stability by some ten times the allowed error
  const analysis::GearRunResult result = run_gears(model, fine);
  ASSERT_TRUE(result.completed);
  const double force = result.planets[0].sun_mesh_force.mean;
  EXPECT_LT(result.planets[0].radial_acceleration.maximum * set.planet.mass, 1e-5 * force);
  EXPECT_LT(result.planets[0].sun_mesh_force.largest - result.planets[0].sun_mesh_force.least, 1e-5 * force);
}

// A pin set back by e takes load off its planet; the mean over all planets stays.
TEST_F(GearRun, PinErrorsShiftTheLoads) {
  SetParameters set = test::reducer_dynamics();
  set.pin_error = Eigen::Matrix2Xd::Zero(2, 4);
  set.pin_error(1, 0) = -2e-6;  // behind its place: the driven pin meets its planet earlier
  const analysis::GearRunResult result = run_gears(set_model(set, test::reducer_operation(628.0)), options());
  ASSERT_TRUE(result.completed);
  EXPECT_GT(std::abs(result.planets[0].load_share - 1.0), 0.02);
  EXPECT_NEAR(result.planets[0].load_share + result.planets[1].load_share + result.planets[2].load_share +
                  result.planets[3].load_share,
              4.0, 1e-12);
  EXPECT_GT(result.planets[0].load_share, 1.0);
}

// At constant power and constant load the speed finds its own level, and the set does not run away.
TEST_F(GearRun, DoesNotDriftAway) {
  const analysis::GearRunResult result =
      run_gears(set_model(test::reducer_dynamics(), test::reducer_operation(628.0)), options());
  ASSERT_TRUE(result.completed);
  const double sun_speed = 628.0 * test::reducer_dynamics().sun.radius;
  EXPECT_LT(std::abs(result.final_state[2]) / result.report.reached, 1e-3 * sun_speed);
}

}  // namespace
}  // namespace orbearing::gearset::dynamics::gear_dynamics_motion_test
