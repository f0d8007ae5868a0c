// The bearing in motion: energy over time, convergence of the path, where unloaded rollers rest, the steady
// state.
#include <gtest/gtest.h>

#include <cstdlib>
#include <deque>

#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/motion/snapshot.hpp"
#include "bearing/motion/vector_bearing.hpp"
#include "coupling/integration/integrate.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/steady_state.hpp"
#include "tests/messages.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::dynamics_motion_test {
namespace {

using integration::IntegrationOptions;
using integration::Method;

integration::RightHandSide motion_of(vectorised::VectorBearing& equations) {
  return [&equations](double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                      Eigen::Ref<Eigen::VectorXd> dx) { equations.derivative(time, x, dx); };
}

// The state with two more variables, the energy that has entered and that has been lost [J], which the
// integrator carries along at its own order.
struct Audit {
  vectorised::VectorBearing& equations;
  mutable Snapshot now;

  void operator()(double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                  Eigen::Ref<Eigen::VectorXd> dx) const {
    const Eigen::Index n = x.size() - 2;
    equations.derivative(time, x.head(n), dx.head(n));
    take_snapshot(equations.model(), x.head(n), now, time);
    dx[n] = power_input(equations.model(), time, x.head(n), dx.head(n)).total();
    dx[n + 1] = now.loss.total();
  }
};

struct AuditedVariant {
  const char* name;
  void (*change)(Bearing&, DynamicsParameters&);
  double tilt = 0.0;  // [rad]  of the bore
  bool rim = false;   // bends
};

class EnergyAudit : public testing::TestWithParam<AuditedVariant> {};

// ENERGY_AUDIT_SECONDS: for that long instead.
TEST_P(EnergyAudit, Closes) {
  const char* text = std::getenv("ENERGY_AUDIT_SECONDS");
  const double seconds = text == nullptr ? 5e-4 : std::atof(text);
  constexpr double kClosure = 1e-6;  // of the energy turned over: a fourth-order method at steps of 0.2 us
  Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  GetParam().change(bearing, parameters);
  OperatingPoint point = test::reducer_point(6000.0);
  point.bore_tilt = GetParam().tilt * Vector2(0.8, 0.6);
  if (GetParam().rim) point.outer_race = test::bending_race();
  vectorised::VectorBearing equations(bearing_model(bearing, point, parameters));
  const Eigen::Index n = equations.model().layout.size();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n + 2);
  x.head(n) = initial_state(bearing, equations.model(), parameters, 0.3).x;
  const double before = stored_energy(equations.model(), x.head(n)).total();
  const IntegrationOptions reference{.method = Method::rk4, .allowed_error = {}, .step = 2e-7};
  const auto report = integration::integrate(Audit{equations, {}}, x, {0.0, seconds, 1}, reference, {});
  ASSERT_TRUE(report.completed) << report.message;
  const double after = stored_energy(equations.model(), x.head(n), seconds).total();
  const double turned_over = std::abs(x[n]) + x[n + 1] + std::abs(after - before);
  EXPECT_GT(x[n + 1], 0.0);
  EXPECT_NEAR(after - before, x[n] - x[n + 1], kClosure * turned_over);
  if (text)
    std::printf("residual %.2g of the %.4g J turned over\n", (after - before - x[n] + x[n + 1]) / turned_over,
                turned_over);
}

using Parameters = DynamicsParameters;

INSTANTIATE_TEST_SUITE_P(
    Variants, EnergyAudit,
    testing::Values(
        AuditedVariant{"dry", [](Bearing&, Parameters&) {}},
        AuditedVariant{"film", [](Bearing&, Parameters& p) { p.race.film_in_approach = true; }},
        // Squeeze film: the work of the oil is dissipated, and no more.
        AuditedVariant{"squeeze", [](Bearing&, Parameters& p) { p.race.squeeze = true; }},
        AuditedVariant{"squeeze_film",
                       [](Bearing& b, Parameters& p) {
                         p.race.squeeze = p.race.film_in_approach = true;
                         b.radial_clearance = 20e-6;
                       }},
        // Rollers that touch one another.
        AuditedVariant{"full_complement",
                       [](Bearing& b, Parameters&) { b = test::full_complement_bearing(); }},
        AuditedVariant{"forms",
                       [](Bearing& b, Parameters&) {
                         b.inner.form = {{2, 5e-6, 0.2, false}};
                         b.outer.form = {{2, 5e-6, 0.5, false}, {9, 4e-7, 0.0, true}};
                         b.rollers().diameter_deviation = {3e-6, -2e-6};
                       }},
        AuditedVariant{"mixed", [](Bearing&, Parameters& p) { p.race.lubrication = Lubrication::mixed; }},
        AuditedVariant{"pocket_film",
                       [](Bearing&, Parameters& p) { p.cage.pocket_film = PocketFilm::hydrodynamic; }},
        // Tilting rollers: the work that rotates them is dissipated by their resistance.
        AuditedVariant{"tilting",
                       [](Bearing& b, Parameters&) {
                         b.rollers().laminae = 12;
                         b.rollers().profile = profile::CircularCrown{b.rollers().length, 3e-6};
                       },
                       2e-3},
        // Elastic rim: the work that bends it is stored in its waves, moves with them or is dissipated by
        // them.
        AuditedVariant{"rim", [](Bearing&, Parameters& p) { p.driving.ramp = 200.0; }, 0.0, true},
        // A tenth more speed within that time.
        // Weight that turns against the carrier.
        AuditedVariant{"weight", [](Bearing&, Parameters& p) { p.gravity = {.across = 1e3, .angle = 0.4}; }},
        AuditedVariant{"run_up_with_weight",
                       [](Bearing&, Parameters& p) {
                         p.driving.ramp = 200.0;
                         p.gravity = {.across = 1e3, .angle = 0.4};
                       }},
        AuditedVariant{"run_up", [](Bearing&, Parameters& p) { p.driving.ramp = 200.0; }},
        AuditedVariant{"run_up_of_waves",
                       [](Bearing& b, Parameters& p) {
                         p.driving.ramp = -200.0;
                         b.outer.form = {{7, 5e-7, 0.3, true}};
                       }}),
    [](const testing::TestParamInfo<AuditedVariant>& variant) { return variant.param.name; });

BearingModel model_at_6000_rpm(const Bearing& bearing, const DynamicsParameters& parameters) {
  return bearing_model(bearing, test::reducer_point(6000.0), parameters);
}

// A bearing and how its path over 0.3 ms depends on the step.
class Path {
 public:
  Path(const Bearing& bearing, const DynamicsParameters& parameters, Eigen::VectorXd start)
      : equations_(model_at_6000_rpm(bearing, parameters)),
        start_(std::move(start)),
        weight_(system::allowed_errors(equations_.model().layout, 1.0, 17.8e-3, 6e5).cwiseInverse()),
        exact_(end(Method::fixed_dopri5, 1.25e-8)) {}

  /// Distance from the exact end of the path, as a length [m].
  double error(Method method, double step) {
    return (end(method, step) - exact_).cwiseProduct(weight_).norm();
  }

 private:
  Eigen::VectorXd end(Method method, double step) {
    Eigen::VectorXd x = start_;
    const IntegrationOptions options{.method = method, .allowed_error = {}, .step = step};
    const auto report = integration::integrate(motion_of(equations_), x, {0.0, 3e-4, 1}, options, {});
    EXPECT_TRUE(report.completed) << report.message;
    return x;
  }

  vectorised::VectorBearing equations_;
  Eigen::VectorXd start_;
  Eigen::VectorXd weight_;
  Eigen::VectorXd exact_;
};

// Preload keeps all race contacts closed and the cage floats free, so that the right-hand side is smooth and
// the order shows.
TEST(DynamicPath, ConvergesAtTheOrderOfTheMethodWhereContactsStayClosed) {
  constexpr double kMargin = 0.5;  // the term of next order, at steps near a fifth of the fastest decay time
  Bearing preloaded = test::reducer_bearing();
  preloaded.radial_clearance = -30e-6;
  DynamicsParameters free_cage = test::reducer_parameters();
  free_cage.cage.pocket_clearance = 2e-3;
  free_cage.cage.guide_diameter = 0.0;
  test::Random random;
  Path path(preloaded, free_cage,
            test::shaken_state(model_at_6000_rpm(preloaded, free_cage), preloaded, free_cage, 2.4e-6, 4e-2,
                               random));
  EXPECT_NEAR(std::log2(path.error(Method::rk4, 2e-7) / path.error(Method::rk4, 1e-7)), 4.0, kMargin);
  // Its constants of order 5 are small: the terms of orders 6 and 7 still lead where steps are long enough
  // for errors above round-off (7e-15 m).
  const double order =
      std::log2(path.error(Method::fixed_dopri5, 2e-7) / path.error(Method::fixed_dopri5, 1e-7));
  EXPECT_GT(order, 5.0 - kMargin);
  EXPECT_LT(order, 7.0 + kMargin);
}

// The load of a pocket begins with a kink, that of a race as the power 10/9: touch within a step leaves an
// error in speed of the order of step^2, whatever the method, which scatters with where in the step it falls.
class ImpactPath : public testing::TestWithParam<Bearing (*)()> {};

TEST_P(ImpactPath, ConvergesThroughImpacts) {
  const Bearing bearing = GetParam()();
  const DynamicsParameters parameters = test::reducer_parameters();
  constexpr double kLeastOrder = 1.5;  // 2 less the scatter: 0.6 of a start's order, 0.2 of the mean of eight
  constexpr int kStarts = 8;
  std::deque<Path> paths;  // which do not move
  for (int i = 0; i < kStarts; ++i)
    paths.emplace_back(
        bearing, parameters,
        initial_state(bearing, model_at_6000_rpm(bearing, parameters), parameters, 0.05 * i).x);
  for (Method method : {Method::rk4, Method::fixed_dopri5}) {
    double order = 0.0;
    for (Path& path : paths)
      order += std::log2(path.error(method, 8e-7) / path.error(method, 2e-7)) / 2.0 / kStarts;
    EXPECT_GT(order, kLeastOrder) << static_cast<int>(method);
  }
}

// Impacts on pockets, and on neighbours.
INSTANTIATE_TEST_SUITE_P(Variants, ImpactPath,
                         testing::Values(&test::reducer_bearing, &test::full_complement_bearing),
                         [](const testing::TestParamInfo<Bearing (*)()>& bearing) {
                           return bearing.index == 0 ? "cage" : "full_complement";
                         });

// Share of the time that unloaded rollers on the sun side (cos theta < -0.3, out of the load zone) spend on
// the pin, of the time they spend on either race.
double share_on_pin(bool coriolis) {
  const Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.inertia.coriolis = coriolis;
  const system::SteadyStateOptions options{.most_windows = 2, .observed_windows = 1, .integration = {}};
  const auto run = system::run_to_steady_state(bearing, test::reducer_point(6000.0), parameters, options);
  EXPECT_TRUE(run.completed) << run.message;
  const auto sun_side = (run.series.angle > 1.9 && run.series.angle < 2.5)
                            .cast<double>();  // 109 to 143 degrees: unloaded, sun side
  const double on_pin = (sun_side * (run.series.inner_load > 0.0).cast<double>()).sum();
  const double on_bore = (sun_side * (run.series.outer_load > 0.0).cast<double>()).sum();
  return on_pin / (on_pin + on_bore);
}

TEST(CoriolisSwitch, SeatsUnloadedRollersOfTheSunSideOnThePin) {
  EXPECT_GT(share_on_pin(true), 0.8);
  EXPECT_LT(share_on_pin(false), 0.2);
}

class SteadyStateOfRims : public testing::TestWithParam<bool> {};

// The steady state against the quasi-static bearing: the same loads within 2 %. Also on an elastic rim, whose
// mean form is that of the equilibrium.
TEST_P(SteadyStateOfRims, AgreesWithTheQuasiStaticBearing) {
  constexpr double kAgreement = 0.02;
  const Bearing bearing = test::reducer_bearing();
  for (double rpm : {6000.0, 12000.0}) {
    OperatingPoint point = test::reducer_point(rpm);
    if (GetParam()) point.outer_race = test::bending_race();
    const QuasiStaticResult expected = quasi_static_bearing(bearing, point, {});
    const auto run =
        system::run_to_steady_state(bearing, point, test::reducer_parameters(), {.integration = {}});
    ASSERT_TRUE(run.completed) << run.message;
    EXPECT_TRUE(run.steady);
    const double inner = std::sqrt(expected.inner_load.square().mean());
    const double outer = std::sqrt(expected.outer_load.square().mean());
    EXPECT_NEAR(run.statistics.inner.load_rms, inner, kAgreement * inner) << rpm << " rpm";
    EXPECT_NEAR(run.statistics.outer.load_rms, outer, kAgreement * outer) << rpm << " rpm";
    EXPECT_NEAR(run.orbit_slip(), 0.0, kAgreement);
    EXPECT_TRUE(run.final_state.allFinite());
    ASSERT_EQ(run.statistics.mean_waves.size() > 0, GetParam());
    if (!GetParam()) continue;
    Eigen::ArrayXd form = Eigen::ArrayXd::Zero(expected.angle.size());
    orbearing::bearing::add_form(run.statistics.mean_waves, 1.0, expected.angle, form);
    EXPECT_LT((form - expected.race_form).abs().maxCoeff(), kAgreement * expected.race_form.abs().maxCoeff());
  }
}

INSTANTIATE_TEST_SUITE_P(Rims, SteadyStateOfRims, testing::Bool(),
                         [](const testing::TestParamInfo<bool>& rim) {
                           return rim.param ? "elastic" : "rigid";
                         });

// Cage slip of the bearing in a stationary housing, 20 um clearance, one ring rotating at 1000 rad/s.
double slip_in_housing(double OperatingPoint::*rotating, double load) {
  Bearing bearing = test::reducer_bearing();
  bearing.radial_clearance = 20e-6;
  OperatingPoint point;
  point.*rotating = 1000.0;
  point.bore_load = {load, 0.0};
  const system::SteadyStateOptions options{.most_windows = 3, .observed_windows = 1, .integration = {}};
  return system::run_to_steady_state(bearing, point, test::reducer_parameters(), options).orbit_slip();
}

// Centrifugal force holds unloaded rollers to the outer race. If that race is stationary they brake the cage,
// if it rotates they drive the cage; a load that presses enough rollers on the inner race holds it to pure
// rolling.
TEST(CageSlip, LagsBehindADrivingInnerRaceAndRunsAheadWithADrivingOuterRace) {
  constexpr double kRolling =
      0.02;  // pockets and clearance let the cage gain or lose about their share of the pitch
  constexpr double kSkidding = 0.10;  // several times that: no clearance accounts for it
  EXPECT_NEAR(slip_in_housing(&OperatingPoint::inner_speed, 1000.0), 0.0, kRolling);
  EXPECT_NEAR(slip_in_housing(&OperatingPoint::outer_speed, 1000.0), 0.0, kRolling);
  EXPECT_GT(slip_in_housing(&OperatingPoint::inner_speed, 10.0), kSkidding);
  EXPECT_LT(slip_in_housing(&OperatingPoint::outer_speed, 10.0), -kSkidding);
}

// A look among the observed windows is called once. If it ends the run, the means are those of a run with so
// many windows; if not, those of a run without it, except for steps that end at the look (and before the last
// window).
TEST(SteadyState, EndsAtALookThatSaysSo) {
  constexpr int kAll = 4, kBefore = 2;
  const auto run = [](int windows, const system::EarlyCheck& look) {
    system::SteadyStateOptions options{.observed_windows = windows, .integration = {}, .look = look};
    return system::run_to_steady_state(test::reducer_bearing(), test::reducer_point(6000.0),
                                       test::reducer_parameters(), options);
  };
  int asked = 0;
  const auto saying = [&](bool on) {
    return system::EarlyCheck{kBefore, [&asked, on] { return ++asked, on; }};
  };
  const auto short_run = run(kBefore, {}), long_run = run(kAll, {});
  const auto ended = run(kAll, saying(false)), went_on = run(kAll, saying(true));
  EXPECT_EQ(asked, 2);
  ASSERT_TRUE(ended.completed && went_on.completed);
  EXPECT_EQ(ended.statistics.duration, short_run.statistics.duration);
  EXPECT_EQ(ended.duration, short_run.duration);
  EXPECT_NEAR(ended.statistics.outer.load_rms / short_run.statistics.outer.load_rms, 1.0, 2e-3);
  EXPECT_DOUBLE_EQ(went_on.statistics.duration, long_run.statistics.duration);
  EXPECT_NEAR(went_on.statistics.outer.load_rms / long_run.statistics.outer.load_rms, 1.0, 2e-3);
  EXPECT_EQ(went_on.series.time.size(), long_run.series.time.size());
  EXPECT_NEAR(went_on.series.time[0], long_run.series.time[0], 1e-12);
}

TEST(SteadyState, RefusesABearingInWhichNothingTurns) {
  OperatingPoint point = test::reducer_point(6000.0);
  point.outer_speed = 0.0;
  EXPECT_REFUSED(std::invalid_argument, "dynamics_motion 1",
                 system::run_to_steady_state(test::reducer_bearing(), point, test::reducer_parameters(),
                                             {.integration = {}}));
}

}  // namespace
}  // namespace orbearing::bearing::motion::dynamics_motion_test
