// Stability of a set on fitted bearings: rates of growth, parametric excitation, the periodic motion, and
// runs that are stopped in time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupling/analysis/gear_dynamics.hpp"
#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/equations.hpp"
#include "gearset/dynamics/period_map.hpp"
#include "gearset/dynamics/static_state.hpp"
#include "mechanics/linear_algebra.hpp"
#include "tests/gear_sets.hpp"
#include "tests/messages.hpp"

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
  return mechanics::eigenvalues(slopes).real().maxCoeff();
}

double largest_growth(const SetModel& model) {
  return PeriodMap(model).largest_growth();
}

TEST(LargestGrowth, IsThatOfTheEquations) {
  int growing = 0;
  for (const double across : {0.0, 5e7, 2e8})
    for (const double damping : {200.0, 2e3, -3e3}) {
      SCOPED_TRACE(testing::Message() << across << " N/m across, " << damping << " N s/m");
      const SetModel model = model_on(law(3e8, across, damping));
      const double found = largest_growth(averaged(model)), wanted = growth_by_differences(model);
      growing += wanted > 1.0 ? 1 : 0;
      if (wanted > 1.0)
        EXPECT_NEAR(found / wanted, 1.0, 1e-3);
      else
        EXPECT_LE(found, 0.0);
    }
  EXPECT_GT(growing, 2);
  EXPECT_LT(growing, 9);
}

// Dampers that dissipate energy are not enough: springs with different stiffness across supply it.
TEST(LargestGrowth, SeesSpringsThatGiveEnergy) {
  EXPECT_LE(largest_growth(model_on(law(3e8, 0.0, 500.0))), 0.0);
  EXPECT_GT(largest_growth(model_on(law(3e8, 3e8, 500.0))), 0.0);
}

// The state a mesh period after time zero; errors of a step some 1e-6 of a mesh's deflection.
Eigen::VectorXd after_period(const SetModel& model, const Eigen::VectorXd& from) {
  const PlanetarySetEquations equations(model);
  const double duration = 1.0 / model.operation.mesh_frequency;
  integration::IntegrationOptions options;
  options.allowed_error = integration::gear_allowed_errors(model, 1e-6);
  options.step = 0.01 * duration;
  Eigen::VectorXd x = from;
  const auto rate = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& at,
                        Eigen::Ref<Eigen::VectorXd> dx) { equations.derivative(time, at, dx); };
  const auto report =
      integrate_pieces(rate, x, {0.0, duration, 1}, integration::jumps_of(model), options, {});
  EXPECT_TRUE(report.completed) << report.message;
  return x;
}

// Without what rotates the whole set: of deflections and velocities.
double size_of(const SetModel& model, const Eigen::VectorXd& x) {
  double size = 0.0;
  for (const PlanetBearing& bearing : model.bearings)
    size = std::max(size, bearing_deflection(bearing, x).norm());
  return size;
}

// A bearing with hardly any dampers on meshes whose stiffness changes by two to one: Mathieu's equation. What
// the mean stiffness calls stable grows at some speeds, and does so at the rate of the map.
TEST(LargestGrowth, SeesMeshesThatPump) {
  const auto pumped = [](double speed) {
    SetParameters set = test::reducer_dynamics();
    set.planet.affine_bearing = law(3e8, 0.0, 20.0);
    set.separation = false;
    for (Mesh* mesh : {&set.sun_mesh, &set.ring_mesh}) mesh->damping = 20.0;
    for (CentralMember* member : {&set.sun, &set.ring, &set.carrier})
      member->support.damping = member->support.torsional_damping = 20.0;
    return set_model(std::move(set), test::reducer_operation(speed));
  };
  double worst = 0.0, growth = 0.0;
  for (double speed = 100.0; speed < 1500.0; speed *= 1.02) {
    const double found = largest_growth(pumped(speed));
    if (found > growth) growth = found, worst = speed;
  }
  const SetModel model = pumped(worst);
  ASSERT_GT(growth * 40.0 / model.operation.mesh_frequency, 0.5);  // e^0.5 over forty periods, or more
  EXPECT_LE(largest_growth(averaged(model)), 0.0);
  // Departures from one motion, period by period, brought back to one size each time.
  const Eigen::VectorXd from = static_state(model), to = after_period(model, from);
  Eigen::VectorXd departure = Eigen::VectorXd::LinSpaced(from.size(), -1.0, 1.0).array().cube();
  constexpr int kSettled = 80, kPeriods = 60;
  double logarithm = 0.0;
  for (int period = 0; period < kSettled + kPeriods; ++period) {
    departure *= 1e-6 / size_of(model, departure);
    departure = after_period(model, from + departure) - to;
    if (period >= kSettled) logarithm += std::log(size_of(model, departure) / 1e-6);
  }
  const double rate = logarithm * model.operation.mesh_frequency / kPeriods;
  EXPECT_NEAR(rate / growth, 1.0, 0.05) << "at " << worst << " rad/s";
}

// Newton's step leads from rest to the motion that repeats; waiting for it takes dozens of periods.
TEST(PeriodMap, LeadsToTheMotionThatRepeats) {
  const SetModel model = model_on(law(3e8, 2e7, 500.0));
  const Eigen::VectorXd rest = static_state(model);
  const PeriodMap map(model);
  const Eigen::VectorXd departure = after_period(model, rest) - rest;
  const Eigen::VectorXd x = rest + map.to_repeating(departure);
  const Eigen::VectorXd left = after_period(model, x) - x;
  ASSERT_GT(size_of(model, departure), 1e-8);  // [m]
  EXPECT_LT(size_of(model, left), 2e-3 * size_of(model, departure));
  EXPECT_LT(size_of(model, map.to_repeating(left)), 2e-3 * size_of(model, map.to_repeating(departure)));
}

// The same from the drivers of the study: found, and waited for, with teeth in contact and with teeth that
// part.
TEST(RepeatingGears, AreThoseThatAreWaitedFor) {
  for (const double speed : {300.0, 900.0}) {
    SetParameters set = test::reducer_dynamics();
    set.planet.affine_bearing = law(3e8, 0.0, 500.0);
    const SetModel model = set_model(std::move(set), test::reducer_operation(speed));
    const Eigen::VectorXd rest = static_state(model);
    analysis::GearRunOptions options;
    options.drift = 1e-3;
    const analysis::GearRunResult found =
                                      analysis::run_gears_repeating(rest, model, PeriodMap(model), options),
                                  waited = analysis::run_gears(model, options);
    ASSERT_TRUE(found.completed && waited.completed);
    EXPECT_LT(found.report.steps, waited.report.steps / 4);
    for (std::size_t i = 0; i < 4; ++i) {
      const analysis::SignalStatistics &one = found.planets[0].tangential_force,
                                       &other = waited.planets[0].tangential_force;
      const double allowed = 2e-3 * *std::max_element(other.amplitudes.begin(), other.amplitudes.end());
      EXPECT_NEAR(one.cosines[i], other.cosines[i], allowed) << "order " << i + 1 << " at " << speed;
      EXPECT_NEAR(one.sines[i], other.sines[i], allowed) << "order " << i + 1 << " at " << speed;
    }
  }
}

// A map of loaded teeth is that of their tangent about the mean load, backlash or not: Newton's step from
// rest takes nine tenths of the way to the motion that repeats, and what is left is what their bend leaves.
TEST(PeriodMap, KnowsLoadedTeethByTheirMeanLoad) {
  SetParameters set = test::reducer_dynamics();
  test::load_teeth(set);
  set.planet.affine_bearing = law(3e8, 0.0, 500.0);
  ASSERT_TRUE(set.sun_mesh.loaded);
  ASSERT_GT(set.sun_mesh.backlash, 0.0);
  const SetModel model = set_model(std::move(set), test::reducer_operation(300.0));
  const Eigen::VectorXd rest = static_state(model);
  const PeriodMap map(model);
  const Eigen::VectorXd step = map.to_repeating(after_period(model, rest) - rest), x = rest + step;
  EXPECT_LT(size_of(model, map.to_repeating(after_period(model, x) - x)), 0.1 * size_of(model, step));
}

// Faster than any vibration, as the friction of slow, heavily loaded bearings: nothing grows.
TEST(PeriodMap, FollowsADamperThatIsFasterThanVibrations) {
  EXPECT_LE(PeriodMap(model_on(law(3e8, 0.0, 1e6))).largest_growth(), 0.0);
}

TEST(PeriodMap, RefusesWhatHasNoPeriod) {
  SetModel model = model_on(law(3e8, 0.0, 500.0));
  model.operation.run_up = {.from = 0.5, .duration = 1.0};
  EXPECT_REFUSED(std::invalid_argument, "stability 1", PeriodMap{model});
  model = model_on(law(3e8, 0.0, 500.0));
  model.operation.mesh_frequency = 0.0;
  EXPECT_REFUSED(std::invalid_argument, "stability 2", PeriodMap{model});
}

// A motion that repeats where small ones grow is found by Newton, too, and yet is none that gears come to.
TEST(RepeatingGears, AreNotTakenWhereSmallMotionsGrow) {
  const SetModel model = model_on(law(3e8, 0.0, -200.0));
  const PeriodMap map(model);
  ASSERT_GT(map.largest_growth(), 0.0);
  analysis::GearRunOptions options;
  options.most_windows = 4;
  const analysis::GearRunResult found =
                                    analysis::run_gears_repeating(static_state(model), model, map, options),
                                waited = analysis::run_gears(model, options);
  EXPECT_EQ(found.completed, waited.completed);
  EXPECT_EQ(found.message, waited.message);
  EXPECT_EQ(found.final_state, waited.final_state);
}

TEST(GearsThatRunAway, AreGivenUpWithTheReason) {
  const SetModel model = model_on(law(3e8, 0.0, -2e4));
  ASSERT_GT(largest_growth(model), 0.0);
  analysis::GearRunOptions options;
  options.integration.most_steps = 100'000;  // a run that is not given up uses all of them, and says so
  const analysis::GearRunResult run = analysis::run_gears(model, options);
  EXPECT_FALSE(run.completed);
  EXPECT_THAT(run.message, testing::HasSubstr("grows without bound"));
}

TEST(GearsOnSoftPins, HaveNoMotionAboutTheirRest) {
  const analysis::GearRunResult run = analysis::run_gears(model_on(law(1e3, 0.0, 0.0)), {});
  EXPECT_FALSE(run.completed);
  EXPECT_EQ(run.report.steps, 0);
  EXPECT_THAT(run.message,
              testing::HasSubstr("off its pin under the load at rest, more than 1 % of the centre distance"));
}

}  // namespace
}  // namespace orbearing::gearset::dynamics::stability_test
