// Energy error of the steps of the vectorised bearing, and their order of convergence.
#include <gtest/gtest.h>

#include <cstdlib>

#include "bearing/motion/snapshot.hpp"
#include "bearing/motion/vector_bearing.hpp"
#include "coupling/integration/rosenbrock3.hpp"
#include "coupling/integration/rosenbrock4.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/free_bearing.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::dynamics_fast_path_test {
namespace {

using integration::Method;
using vectorised::VectorBearing;

// Energy that steps add to the exact motion: each step is repeated from the same state by explicit steps of
// order 5 with a far smaller error, and the difference in energy of the two ends is summed. Nothing is
// interpolated, and no power is integrated over an impact.
class LocalFlowAudit {
 public:
  LocalFlowAudit(const VectorBearing& bearing, double length_error)
      : bearing_(bearing), equations_(bearing.model()) {
    exact_.step = 1e-7;
    exact_.allowed_error = system::allowed_errors(bearing.model(), kShareOfStep * length_error);
  }

  /// The step from the last state, after `length` [s].
  void add(const Eigen::VectorXd& x, double length) {
    if (x_.size() > 0 && length > 0.0) {
      const auto report = integration::integrate(
          [this](double at, const Eigen::Ref<const Eigen::VectorXd>& from, Eigen::Ref<Eigen::VectorXd> rate) {
            equations_.derivative(at, from, rate);
          },
          x_, {time_, length, 1}, exact_, {});
      EXPECT_TRUE(report.completed) << report.message;
      time_ += length;
      const double gift = energy(x) - energy(x_);
      added_ += gift;
      stirred_ += std::abs(gift);
      take_snapshot(bearing_.model(), x, snapshot_, time_);
      lost_ += length * snapshot_.loss.total();
    }
    x_ = x;
  }

  double power() const { return added_ / time_; }      // [W]  net
  double stirred() const { return stirred_ / time_; }  // [W]  whatever the sign
  double loss() const { return lost_ / time_; }        // [W]  by friction

 private:
  static constexpr double kShareOfStep = 1e-3;  // of what a linearly implicit step is allowed

  double energy(const Eigen::VectorXd& x) const { return stored_energy(bearing_.model(), x, time_).total(); }

  const VectorBearing& bearing_;
  VectorBearing equations_;
  integration::IntegrationOptions exact_;
  Snapshot snapshot_;
  Eigen::VectorXd x_;
  double time_ = 0.0;                                // [s]
  double added_ = 0.0, stirred_ = 0.0, lost_ = 0.0;  // [J]
};

LocalFlowAudit audited(VectorBearing& bearing, Eigen::VectorXd x, double seconds, double length_error) {
  integration::IntegrationOptions options;
  options.allowed_error = system::allowed_errors(bearing.model(), length_error);
  LocalFlowAudit audit(bearing, length_error);
  double ahead = 0.0;  // [s]  length of the step that follows
  const auto report = system::integrate_bearing(bearing, x, {0.0, seconds, 1}, options, {},
                                                [&](const system::StepSample& step) {
                                                  Eigen::VectorXd flat(bearing.model().layout.size());
                                                  bearing.flatten(step.state, flat);
                                                  audit.add(flat, ahead);
                                                  ahead = 2.0 * step.weight - ahead;
                                                });
  EXPECT_TRUE(report.completed) << report.message;
  return audit;
}

struct AuditedSteps {
  const char* name;
  bool film;
  double excitation;  // [N]
  bool full = false;  // no cage
  bool squeeze = false;
  bool pockets = false;  // oil in them
};

DynamicsParameters parameters_of(const AuditedSteps& audited) {
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.race.film_in_approach = audited.film;
  parameters.race.squeeze = audited.squeeze;
  if (audited.pockets) parameters.cage.pocket_film = PocketFilm::hydrodynamic;
  if (audited.excitation > 0.0)
    parameters.excitation = {
        .angular_frequency = 2.0 * M_PI * 2520.0,
        .harmonics = {
            {.order = 1, .cosine = {0.0, audited.excitation}, .sine = {0.3 * audited.excitation, 0.0}},
            {.order = 2, .cosine = {0.0, 0.5 * audited.excitation}}}};
  return parameters;
}

class FastPathEnergy : public testing::TestWithParam<AuditedSteps> {};

// The energy that steps add shall be no more than a hundredth of the friction loss, whose models are no more
// accurate (0.4 % in the worst of these; 1.4 % if the radial speeds of rollers had the same weight as the
// rest). It decreases with the allowed error: in proportion where the motion is smooth, with its root at
// least where contacts open and close, since the error of such a step is of second order and steps are
// proportional to the root; with its cube root where steps of order 3 are proportional to that.
// ENERGY_AUDIT_SECONDS: simulated time.
TEST_P(FastPathEnergy, StepsAddLittleAndLessAtASmallerAllowedError) {
  constexpr double kShareOfLoss = 0.01;
  constexpr double kStandard = 2e-10;  // [m]  what a run allows unless stated otherwise
  const char* text = std::getenv("ENERGY_AUDIT_SECONDS");
  const double seconds = text != nullptr ? std::atof(text) : GetParam().squeeze ? 8e-3 : 4e-3;
  const int order = GetParam().squeeze ? 3 : 2;  // of the steps
  const DynamicsParameters parameters = parameters_of(GetParam());
  const Bearing given = GetParam().full ? test::full_complement_bearing() : test::reducer_bearing();
  const BearingModel model = bearing_model(given, test::reducer_point(6000.0), parameters);
  VectorBearing bearing(model);
  const Eigen::VectorXd start = initial_state(given, model, parameters, 0.3).x;
  double coarse = 0.0;
  for (const double finer : {1.0, 16.0}) {
    const LocalFlowAudit audit = audited(bearing, start, seconds, kStandard / finer);
    EXPECT_GT(audit.loss(), 10.0) << "tens of watts of friction";
    EXPECT_LT(std::abs(audit.power()), kShareOfLoss * audit.loss()) << kStandard / finer << " m";
    if (finer == 1.0) coarse = audit.stirred();
    EXPECT_LE(audit.stirred(), coarse / std::pow(finer, 1.0 / order));
    std::printf("%s, %g s, allowed %.3g m: friction %.4g W, steps add %.3g W net, %.3g W whatever the sign\n",
                GetParam().name, seconds, kStandard / finer, audit.loss(), audit.power(), audit.stirred());
  }
  EXPECT_GT(coarse, 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    Variants, FastPathEnergy,
    testing::Values(AuditedSteps{"dry", false, 0.0}, AuditedSteps{"film", true, 0.0},
                    AuditedSteps{"dry_shaken", false, 400.0}, AuditedSteps{"film_shaken", true, 400.0},
                    // Rollers that touch one another.
                    AuditedSteps{"full_complement", false, 0.0, true},
                    // Squeeze film.
                    AuditedSteps{"squeeze", false, 0.0, false, true},
                    AuditedSteps{"squeeze_film_shaken", true, 400.0, false, true},
                    // Steps that only the ring limits.
                    AuditedSteps{"squeeze_pockets", true, 0.0, false, true, true},
                    AuditedSteps{"squeeze_pockets_shaken", true, 400.0, false, true, true}),
    [](const testing::TestParamInfo<AuditedSteps>& variant) { return variant.param.name; });

// Fed with explicit steps of order 5 at 0.05 us the audit finds next to nothing; a bore that is pushed by
// hand in one of them shows with the energy of that push.
TEST(EnergyOfSteps, FindsWhatWasAddedByHandAndNothingElse) {
  // [J]  40 steps, each of some ten within that may err by 2e-13 m under 1243 N
  constexpr double kNothing = 1e-7;
  constexpr double kPush = 0.1;  // [m/s]
  const DynamicsParameters parameters = test::reducer_parameters();
  const BearingModel model = bearing_model(test::reducer_bearing(), test::reducer_point(6000.0), parameters);
  const VectorBearing bearing(model);
  VectorBearing equations(model);
  const integration::IntegrationOptions fine{
      .method = Method::fixed_dopri5, .allowed_error = {}, .step = 5e-8};
  for (const double push : {0.0, kPush}) {
    Eigen::VectorXd x = initial_state(test::reducer_bearing(), model, parameters, 0.3).x;
    LocalFlowAudit audit(bearing, 2e-10);
    audit.add(x, 0.0);
    double expected = 0.0;
    constexpr int kSteps = 40;
    constexpr double kLength = 5e-6;  // [s]
    for (int i = 0; i < kSteps; ++i) {
      integration::integrate([&](double time, const Eigen::Ref<const Eigen::VectorXd>& at,
                                 Eigen::Ref<Eigen::VectorXd> rate) { equations.derivative(time, at, rate); },
                             x, {i * kLength, kLength, 1}, fine, {});
      if (i == kSteps / 2) {
        double& speed = x[model.layout.bore() + 3];
        expected = model.bore_mass * (speed * push + 0.5 * push * push);
        speed += push;
      }
      audit.add(x, kLength);
    }
    EXPECT_NEAR(audit.power() * kSteps * kLength, expected, kNothing) << push << " m/s";
  }
}

// A bearing whose race contacts all stay closed under preload and whose cage floats free, on a film and
// shaken by teeth: the right-hand side is smooth.
struct SmoothCase {
  Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();

  SmoothCase() {
    bearing.radial_clearance = -30e-6;
    parameters.cage.pocket_clearance = 2e-3;
    parameters.cage.guide_diameter = 0.0;
    parameters.race.film_in_approach = true;
    parameters.excitation = {.angular_frequency = 2e4,
                             .harmonics = {{.order = 1, .cosine = {0.0, 100.0}, .sine = {200.0, 49.0}}}};
  }
};

constexpr double kDuration = 3e-4;  // [s]

template <class Stepper = integration::Rosenbrock2>
Eigen::VectorXd end_of_equal_steps(const BearingModel& model, const Eigen::VectorXd& start, int steps) {
  VectorBearing bearing(model);
  std::vector<double> x = bearing.padded(start);
  Stepper stepper(std::vector<double>(x.size(), 0.0), kDuration);  // no error refuses a step
  double time = 0.0;
  for (int i = 0; i < steps; ++i) {
    double step = kDuration * (i + 1) / steps - time;
    EXPECT_EQ(stepper.try_step(bearing, x, time, step), boost::numeric::odeint::success);
  }
  Eigen::VectorXd end(start.size());
  bearing.flatten(x.data(), end);
  return end;
}

// By a method of order 5: its error, 1e-5 of the ones to be measured, is negligible.
Eigen::VectorXd exact_end(const BearingModel& model, Eigen::VectorXd x) {
  VectorBearing equations(model);
  const auto motion = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& at,
                          Eigen::Ref<Eigen::VectorXd> rate) { equations.derivative(time, at, rate); };
  const integration::IntegrationOptions fine{
      .method = Method::fixed_dopri5, .allowed_error = {}, .step = 2.5e-8};
  const auto report = integration::integrate(motion, x, {0.0, kDuration, 1}, fine, {});
  EXPECT_TRUE(report.completed) << report.message;
  return x;
}

class FastPath : public testing::TestWithParam<bool> {};

// With the waves of an elastic rim as well, whose slopes by the rollers are not in the matrix.
TEST_P(FastPath, ConvergesAtOrderTwoWhereContactsStayClosed) {
  constexpr double kMargin = 0.1;  // the term of next order, at steps of a fiftieth of the fastest period
  const SmoothCase smooth;
  OperatingPoint point = test::reducer_point(6000.0);
  if (GetParam()) point.outer_race = test::bending_race();
  const BearingModel model = bearing_model(smooth.bearing, point, smooth.parameters);
  test::Random random;
  const Eigen::VectorXd start =
      test::shaken_state(model, smooth.bearing, smooth.parameters, 3e-7, 5e-3, random);
  const Eigen::VectorXd exact = exact_end(model, start);
  const Eigen::VectorXd weight = system::allowed_errors(model.layout, 1.0, 17.8e-3, 6e5).cwiseInverse();
  const auto error = [&](int steps) {
    return (end_of_equal_steps(model, start, steps) - exact).cwiseProduct(weight).norm();
  };
  EXPECT_NEAR(std::log2(error(2400) / error(4800)), 2.0, kMargin);
  EXPECT_NEAR(std::log2(error(4800) / error(9600)), 2.0, kMargin);
}

// On a rigid rim, where the matrix lacks nothing: errors of equal steps by `Stepper`, over those allowed.
template <class Stepper>
std::vector<double> errors_on_a_rigid_rim(const std::vector<int>& steps) {
  const SmoothCase smooth;
  const BearingModel model = bearing_model(smooth.bearing, test::reducer_point(6000.0), smooth.parameters);
  test::Random random;
  const Eigen::VectorXd start =
      test::shaken_state(model, smooth.bearing, smooth.parameters, 3e-7, 5e-3, random);
  const Eigen::VectorXd exact = exact_end(model, start);
  const Eigen::VectorXd weight = system::allowed_errors(model.layout, 1.0, 17.8e-3, 6e5).cwiseInverse();
  std::vector<double> errors;
  for (const int count : steps)
    errors.push_back((end_of_equal_steps<Stepper>(model, start, count) - exact).cwiseProduct(weight).norm());
  return errors;
}

// ROS3 is of order 3 there. Shorter steps come near to the error of the solution that is taken as exact.
TEST(FastPathOfOrderThree, ConvergesWhereContactsStayClosed) {
  constexpr double kMargin = 0.1;
  const auto errors = errors_on_a_rigid_rim<integration::Rosenbrock3>({1200, 2400});
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 3.0, kMargin);
}

// The steps of order 4 are of order 4, at longer ones for the same reason.
TEST(FastPathOfOrderFour, ConvergesWhereContactsStayClosed) {
  constexpr double kMargin = 0.2;
  const auto errors = errors_on_a_rigid_rim<integration::Rosenbrock4>({300, 600, 1200});
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 4.0, kMargin);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 4.0, kMargin);
}

// Order of the steps by impacts and excitation of the bearing.
TEST(OrderOfSteps, FollowsWhatBouncesAndWhatShakes) {
  const auto order = [](const AuditedSteps& audited, bool shaken) {
    return system::order_of_steps(
        bearing_model(test::reducer_bearing(), test::reducer_point(6000.0), parameters_of(audited)), shaken);
  };
  const AuditedSteps dry{"", true, 0.0}, races{"", true, 0.0, false, true},
      oil{"", true, 0.0, false, true, true};
  for (const bool shaken : {false, true}) {
    EXPECT_EQ(order(dry, shaken), 2);
    EXPECT_EQ(order(races, shaken), 3) << "blows on dry bars";
  }
  EXPECT_EQ(order(oil, false), 3);
  EXPECT_EQ(order(oil, true), 4);
  OperatingPoint point = test::reducer_point(6000.0);
  point.outer_race = test::bending_race();
  EXPECT_EQ(system::order_of_steps(bearing_model(test::reducer_bearing(), point, parameters_of(oil)), true),
            2)
      << "waves of a rim, whose slopes the matrix lacks";
}

// Excited by teeth at 6000 rpm, with a squeeze film less than a tenth of the steps is rejected, and steps of
// order 3 are longer than the longest of order 2 at the same allowed error.
TEST(FastPathOfOrderThree, TakesLongStepsAndRefusesFew) {
  constexpr double kSeconds = 10e-3;
  const Bearing given = test::reducer_bearing();
  const DynamicsParameters parameters = parameters_of({"", true, 200.0, false, true});
  const BearingModel model = bearing_model(given, test::reducer_point(6000.0), parameters);
  VectorBearing bearing(model);
  Eigen::VectorXd x = initial_state(given, model, parameters, 0.3).x;
  integration::IntegrationOptions options;
  options.allowed_error = system::allowed_errors(model, 2e-10);
  const auto report = system::integrate_bearing(bearing, x, {0.0, kSeconds, 1}, options, {}, {});
  ASSERT_TRUE(report.completed) << report.message;
  EXPECT_LT(report.rejected, 0.1 * static_cast<double>(report.steps));
  EXPECT_LT(static_cast<double>(report.steps), kSeconds / system::longest_step(model));
}

// If oil damps impacts on the bars too, steps without tooth forces are four times the longest of order 2, and
// few are rejected with them.
TEST(FastPathOfOrderThree, TakesStepsOfTheRingWhereOilIsInThePockets) {
  constexpr double kSeconds = 20e-3;
  constexpr double kTimesLonger = 3.5;
  const Bearing given = test::reducer_bearing();
  for (const double excitation : {0.0, 200.0}) {
    const DynamicsParameters parameters = parameters_of({"", true, excitation, false, true, true});
    const BearingModel model = bearing_model(given, test::reducer_point(6000.0), parameters);
    VectorBearing bearing(model);
    Eigen::VectorXd x = initial_state(given, model, parameters, 0.3).x;
    integration::IntegrationOptions options;
    options.allowed_error = system::allowed_errors(model, 2e-10);
    const auto report = system::integrate_bearing(bearing, x, {0.0, kSeconds, 1}, options, {}, {});
    ASSERT_TRUE(report.completed) << report.message;
    const double mean = kSeconds / static_cast<double>(report.steps) / system::longest_step(model);
    EXPECT_LT(report.rejected, 0.15 * static_cast<double>(report.steps)) << excitation;
    EXPECT_GT(mean, excitation > 0.0 ? 1.0 : kTimesLonger) << excitation;
  }
}

// In slow motion, steps follow the rollers' passage. They are several times the longest one of fast motion,
// and mean loads are those of steps that the vibration of the ring limits. Torque is that of 6000 rpm.
TEST(SlowMotion, StepsFollowThePassageOfTheRollers) {
  constexpr double kRpm = 100.0, kSeconds = 60e-3, kTimesLonger = 3.0, kShareOfLoad = 2e-3;
  const Bearing given = test::reducer_bearing();
  OperatingPoint point = test::reducer_point(kRpm);
  point.bore_load *= kRpm / 6000.0;
  for (const bool squeezed : {false, true}) {
    DynamicsParameters parameters = test::reducer_parameters();
    parameters.race.squeeze = squeezed;
    const BearingModel model = bearing_model(given, point, parameters);
    EXPECT_EQ(system::order_of_steps(model, false), squeezed ? 4 : 2);
    const auto mean_load = [&](double tolerance) {
      VectorBearing bearing(model);
      Eigen::VectorXd x = initial_state(given, model, parameters, 0.3).x;
      integration::IntegrationOptions options;
      options.most_steps = 200'000;
      options.tolerance = tolerance;
      options.allowed_error = system::allowed_errors(model, 2e-10);
      double sum = 0.0;
      constexpr int kSamples = 600;
      const auto report =
          system::integrate_bearing(bearing, x, {0.0, kSeconds / kSamples, kSamples}, options,
                                    [&](double time, const Eigen::Ref<const Eigen::VectorXd>& at) {
                                      Snapshot now;
                                      take_snapshot(model, at, now, time);
                                      sum += now.inner.load.square().sum();
                                    },
                                    {});
      EXPECT_TRUE(report.completed) << report.message;
      return std::pair(std::sqrt(sum / kSamples), static_cast<double>(report.steps));
    };
    const auto [load, steps] = mean_load(1.0);
    const auto [reference, many] = mean_load(0.01);
    EXPECT_NEAR(load, reference, kShareOfLoad * reference) << squeezed;
    EXPECT_LT(steps, kSeconds / (kTimesLonger * system::longest_step(model))) << squeezed;
    EXPECT_GT(many, 1.5 * steps) << squeezed;
  }
}

// A rim a million times as stiff is a rigid one: the same path of all bodies, within the remaining waves.
TEST(FastPathOfRims, TendsToTheRigidOneWithTheModulus) {
  constexpr int kSteps = 2400;
  constexpr double kLeft = 1e-10;  // [m]  a millionth of some micrometres, grown over 0.3 ms
  const SmoothCase smooth;
  OperatingPoint point = test::reducer_point(6000.0);
  const auto end = [&] {
    const BearingModel model = bearing_model(smooth.bearing, point, smooth.parameters);
    const Eigen::VectorXd start = initial_state(smooth.bearing, model, smooth.parameters, 0.3).x;
    const Eigen::VectorXd x = end_of_equal_steps(model, start, kSteps);
    const Eigen::VectorXd weight = system::allowed_errors(model.layout, 1.0, 17.8e-3, 6e5).cwiseInverse();
    return Eigen::VectorXd(x.cwiseProduct(weight).head(model.layout.wave()));
  };
  const Eigen::VectorXd rigid = end();
  point.outer_race = test::bending_race();
  const Eigen::VectorXd soft = end();
  for (Eigen::ArrayXd* stiffer :
       {&point.outer_race.compliance, &point.outer_race.cosine, &point.outer_race.sine})
    *stiffer *= 1e-6;
  EXPECT_LT((end() - rigid).cwiseAbs().maxCoeff(), kLeft);
  EXPECT_GT((soft - rigid).cwiseAbs().maxCoeff(), 1e3 * kLeft);
}

INSTANTIATE_TEST_SUITE_P(Rims, FastPath, testing::Bool(), [](const testing::TestParamInfo<bool>& rim) {
  return rim.param ? "elastic" : "rigid";
});

// Steps of order 3 and radial speeds without a weight of their own are for impacts that lose their energy;
// thin or distant oil does not dissipate it.
TEST(ImpactsAreDamped, ByOilThatIsThickAndNear) {
  const auto damped = [](double rpm, double viscosity, double roughness, bool squeeze) {
    DynamicsParameters parameters = test::reducer_parameters();
    parameters.race.squeeze = squeeze;
    parameters.race.roughness = roughness;
    parameters.lubricant.viscosity = viscosity;
    return system::impacts_are_damped(
        bearing_model(test::reducer_bearing(), test::reducer_point(rpm), parameters));
  };
  for (const double rpm : {1000.0, 6000.0, 12000.0}) {
    EXPECT_TRUE(damped(rpm, 0.01, 0.2e-6, true)) << rpm;
    EXPECT_FALSE(damped(rpm, 0.01, 0.2e-6, false)) << rpm;
    EXPECT_FALSE(damped(rpm, 1e-5, 0.2e-6, true)) << rpm;
    EXPECT_FALSE(damped(rpm, 0.01, 100e-6, true)) << rpm;
  }
}

// Only the ring limits steps where oil stops rollers before the bars.
TEST(BlowsAreDamped, ByOilInThePocketsThatIsThickAndNear) {
  const auto damped = [](PocketFilm film, double viscosity, double roughness) {
    DynamicsParameters parameters = test::reducer_parameters();
    parameters.cage.pocket_film = film;
    parameters.cage.pocket_roughness = roughness;
    parameters.lubricant.viscosity = viscosity;
    return system::blows_are_damped(
        bearing_model(test::reducer_bearing(), test::reducer_point(6000.0), parameters));
  };
  EXPECT_TRUE(damped(PocketFilm::hydrodynamic, 0.01, 0.4e-6));
  EXPECT_FALSE(damped(PocketFilm::none, 0.01, 0.4e-6));
  EXPECT_FALSE(damped(PocketFilm::hydrodynamic, 1e-3, 0.4e-6));
  EXPECT_FALSE(damped(PocketFilm::hydrodynamic, 0.01, 20e-6));
}

// A roller that moves towards a bar through the modelled oil film, step by step, stops before contact if it
// is no faster than in the closed form, and touches the bar if it is faster.
TEST(BlowsAreDamped, WhereTheFilmStopsARoller) {
  constexpr double kStopped = 1e-3 * system::kStoppedBlow;  // [m/s]  it stops in no finite time
  constexpr double kMargin = 0.04;                          // the film that opens behind takes 3 % more
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.cage.pocket_film = PocketFilm::hydrodynamic;
  const auto model_of = [&](double viscosity) {
    parameters.lubricant.viscosity = viscosity;
    return bearing_model(test::reducer_bearing(), test::reducer_point(6000.0), parameters);
  };
  const auto speed_at_the_bar = [&](double viscosity) {
    const BearingModel model = model_of(viscosity);
    const PocketLaw& law = model.pocket;
    const double radius = model.geometry.element_radius, spin = 1e6 / radius;  // [m], [rad/s]  rolling alone
    double offset = 0.0, speed = system::kStoppedBlow;
    const auto squeezed = [&](double v) {
      return law.oil(radius, 0.0, PocketMotion{offset, 0.0, v, 0.0, spin, 0.0}).ahead;
    };
    constexpr double kStep = 1e-7;  // [s]
    while (speed > kStopped && offset < model.pocket.half_clearance - model.pocket.roughness) {
      speed += kStep * (squeezed(speed) - squeezed(0.0)) / model.roller.mass;
      offset += kStep * speed;
    }
    return speed;
  };
  double thin = 1e-3, thick = 0.1;  // [Pa s]  the closed form is met above some viscosity between them
  while (thick / thin > 1.0 + 1e-3) {
    const double middle = std::sqrt(thin * thick);
    (system::blows_are_damped(model_of(middle)) ? thick : thin) = middle;
  }
  EXPECT_LE(speed_at_the_bar(thick * (1.0 + kMargin)), kStopped);
  EXPECT_GT(speed_at_the_bar(thin * (1.0 - kMargin)), kStopped);
}

}  // namespace
}  // namespace orbearing::bearing::motion::dynamics_fast_path_test
