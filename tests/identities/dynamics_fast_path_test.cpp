// What the steps of the vectorised bearing leave of the energy, and the order at which they converge.
#include <gtest/gtest.h>

#include <cstdlib>

#include "bearing/dynamics/equations.hpp"
#include "bearing/dynamics/snapshot.hpp"
#include "coupling/integration/integrate_bearing.hpp"
#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/integration/steady_state.hpp"
#include "tests/unit/dynamics/reducer_bearing.hpp"

namespace orbearing::bearing::dynamics {
namespace {

using fast::VectorBearing;
using integration::Method;

// Work done and lost along accepted steps, by the readable equations: each step is Hermite's cubic through both
// of its ends, its powers are integrated by Simpson's rule. What does not add up is the work of the method's error.
class PathAudit {
 public:
  explicit PathAudit(VectorBearing& bearing) : bearing_(bearing), equations_(bearing.model()) {}

  void add(const integration::StepSample& step) {
    Instant now;
    now.x.resize(bearing_.model().layout.size());
    bearing_.flatten(step.state, now.x);
    now.time = last_.time + ahead_;
    measure(now);
    if (last_.x.size() > 0)
      add_step(now);
    else
      first_ = now;
    ahead_ = 2.0 * step.weight - ahead_;
    last_ = std::move(now);
  }

  /// Energy that appeared from nowhere, of the energy turned over.
  double residual() const {
    const double gained = energy(last_) - energy(first_);
    return (gained - input_ + lost_) / (std::abs(input_) + lost_ + std::abs(gained));
  }
  double lost() const { return lost_; }
  double tin=0,tlo=0,lin_in=0,lin_lo=0;
  void show() const { const double g=energy(last_)-energy(first_);
   std::printf("   hermite in %.5f lost %.5f res %.3g | trapez in %.5f lost %.5f res %.3g | linear in %.5f lost %.5f res %.3g\n",input_,lost_,(g-input_+lost_),tin,tlo,g-tin+tlo,lin_in,lin_lo,g-lin_in+lin_lo);}

 private:
  struct Instant {
    double time = 0.0;
    Eigen::VectorXd x, rate;
    double input = 0.0, loss = 0.0;  // [W]
  };

  void measure(Instant& at) {
    at.rate.resize(at.x.size());
    equations_.derivative(at.time, at.x, at.rate);
    take_snapshot(bearing_.model(), at.x, snapshot_, at.time);
    at.input = power_input(bearing_.model(), at.time, at.x, at.rate).total();
    at.loss = snapshot_.loss.total();
  }

  void add_step(const Instant& now) {
    const double h = now.time - last_.time;
    middle_.time = 0.5 * (last_.time + now.time);
    middle_.x = 0.5 * (last_.x + now.x) + h / 8.0 * (last_.rate - now.rate);
    measure(middle_);
    input_ += h / 6.0 * (last_.input + 4.0 * middle_.input + now.input);
    lost_ += h / 6.0 * (last_.loss + 4.0 * middle_.loss + now.loss);
    tin += h/2*(last_.input+now.input); tlo += h/2*(last_.loss+now.loss);
    // positions by cubic, velocities linear
    const auto kinds = variable_kinds(bearing_.model().layout);
    Eigen::VectorXd lin = 0.5*(last_.x+now.x);
    for (Eigen::Index i=0;i<lin.size();++i) if (kinds[i]==VariableKind::length||kinds[i]==VariableKind::angle) lin[i]=middle_.x[i];
    middle_.x = lin; measure(middle_);
    lin_in += h / 6.0 * (last_.input + 4.0 * middle_.input + now.input);
    lin_lo += h / 6.0 * (last_.loss + 4.0 * middle_.loss + now.loss);
  }

  double energy(const Instant& at) const { return stored_energy(bearing_.model(), at.x, at.time).total(); }

  VectorBearing& bearing_;
  PlanetBearingEquations equations_;
  Snapshot snapshot_;
  Instant first_, last_, middle_;
  double ahead_ = 0.0;  // [s]  length of the step that follows
  double input_ = 0.0, lost_ = 0.0;
};

double audit(const CylindricalRollerBearing& bearing, const DynamicsParameters& parameters, double seconds,
             double length_error) {
  const BearingModel model = bearing_model(bearing, test::reducer_point(6000.0), parameters);
  VectorBearing vectorised(model);
  integration::SteadyStateOptions options;
  options.integration.method = Method::linearly_implicit;
  options.allowed_length_error = length_error;
  Eigen::VectorXd x = initial_state(bearing, model, parameters, 0.3).x;
  PathAudit audit(vectorised);
  const auto report = integration::integrate_bearing(
      vectorised, x, {0.0, seconds, 1}, integration::integration_options(model, options), {},
      [&](const integration::StepSample& step) { audit.add(step); });
  EXPECT_TRUE(report.completed) << report.message;
  EXPECT_GT(audit.lost(), 0.0);
  std::printf("%g s, %g m: %ld steps, residual %.3g, lost %.3g J\n", seconds, length_error, report.steps, audit.residual(), audit.lost());
  audit.show();
  return audit.residual();
}

TEST(FastPathEnergy, Explore) {
  DynamicsParameters film = test::reducer_parameters();
  film.race.film_in_approach = true;
  const char* text = std::getenv("ENERGY_AUDIT_SECONDS");
  const double s = text ? std::atof(text) : 0.02;
  for (double e : {8e-10, 2e-10, 5e-11, 1.25e-11, 3e-12, 8e-13}) {
    audit(test::reducer_bearing(), test::reducer_parameters(), s, e);
    audit(test::reducer_bearing(), film, s, e);
  }
}

// A bearing whose contacts all stay closed and whose cage floats free: the right-hand side is smooth.
struct SmoothCase {
  CylindricalRollerBearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  BearingModel model = make();
  Eigen::VectorXd start;

  SmoothCase() {
    test::Random random;
    start = test::shaken_state(model, bearing, parameters, 3e-7, 5e-3, random);
  }
  BearingModel make() {
    bearing.radial_clearance = -30e-6;
    parameters.cage.pocket_clearance = 2e-3;
    parameters.cage.guide_diameter = 0.0;
    parameters.race.film_in_approach = true;
    parameters.ripple = {.angular_frequency = 2e4,
                         .harmonics = {{.order = 1, .cosine = {0.0, 100.0}, .sine = {200.0, 49.0}}}};
    return bearing_model(bearing, test::reducer_point(6000.0), parameters);
  }
};

constexpr double kDuration = 3e-4;  // [s]

Eigen::VectorXd end_of_equal_steps(const SmoothCase& smooth, int steps) {
  VectorBearing bearing(smooth.model);
  std::vector<double> x = bearing.padded(smooth.start);
  integration::Rosenbrock2 stepper(std::vector<double>(x.size(), 0.0), kDuration);
  double time = 0.0;
  for (int i = 0; i < steps; ++i) {
    double step = kDuration * (i + 1) / steps - time;
    EXPECT_EQ(stepper.try_step(bearing, x, time, step), boost::numeric::odeint::success);
  }
  Eigen::VectorXd flat(smooth.start.size());
  bearing.flatten(x.data(), flat);
  return flat;
}

TEST(FastPathOrder, Explore) {
  const SmoothCase smooth;
  const PlanetBearingEquations equations(smooth.model);
  Eigen::VectorXd exact = smooth.start;
  const auto f = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> dx) {
    equations.derivative(time, x, dx);
  };
  integration::integrate(f, exact, {0.0, kDuration, 1}, {.method = Method::fixed_dopri5, .allowed_error = {}, .step = 2.5e-8}, {});
  const Eigen::VectorXd weight =
      integration::bearing_allowed_errors(smooth.model.layout, 1.0, 17.8e-3, 6e5).cwiseInverse();
  double before = 0;
  for (int n : {150, 300, 600, 1200, 2400, 4800, 9600}) {
    const double e = (end_of_equal_steps(smooth, n) - exact).cwiseProduct(weight).norm();
    std::printf("%d steps: %.3g order %.4f\n", n, e, std::log2(before / e));
    before = e;
  }
}

}  // namespace
}  // namespace orbearing::bearing::dynamics
