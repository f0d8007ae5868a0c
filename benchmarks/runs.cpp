#include "benchmarks/runs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/dynamics/equations.hpp"
#include "bearing/dynamics/initial_state.hpp"
#include "benchmarks/clocks.hpp"
#include "benchmarks/cvode.hpp"
#include "coupling/integration/integrate.hpp"
#include "coupling/integration/rosenbrock2.hpp"

namespace orbearing::bench {

namespace {

using bearing::fast::VectorBearing;

constexpr int kMostOrder = 5;              // of BDF, as CVODE comes
constexpr double kFirstStep = 1e-6;        // [s]
constexpr double kSmallestStep = 1e-12;    // [s]
constexpr double kFirstRollerAngle = 0.0;  // [rad]

// As in coupling/integration/steady_state.cpp: a roller between its races at a typical approach.
double roller_frequency(const bearing::dynamics::BearingModel& model) {
  constexpr double kTypicalApproach = 1e-6;  // [m]
  const double stiffness = 2.0 * model.inner.load.load(kTypicalApproach, 1.0) / kTypicalApproach;
  return std::sqrt(std::max(stiffness, 1.0) / model.roller.mass);
}

RunMeans means_of(const LoadTally& tally, double turned, double duration) {
  return {tally.inner_rms(), tally.outer_rms(), tally.largest(), turned / duration};
}

// From the flat state to the padded one, whose other entries stay as they are.
void scatter(const bearing::fast::PaddedLayout& layout, const double* flat, double* padded) {
  const int z = layout.rollers;
  for (int group = 0; group < 5; ++group) std::copy_n(flat + group * z, z, padded + group * layout.lanes());
  std::copy_n(flat + 5 * z, 14, padded + layout.cage());
}

// The fast path's own loop: loads are taken where the stepper linearises, each weighed by half of both steps.
class FastRun {
 public:
  FastRun(VectorBearing& bearing, std::vector<double> start, std::vector<double> allowed)
      : bearing_(bearing), stepper_(std::move(allowed), fast_longest_step()), x_(std::move(start)) {}

  long advance(double duration, LoadTally* tally) {
    long steps = 0;
    double t = 0.0, dt = kFirstStep, last = 0.0;
    while (t < duration * (1.0 - 1e-12)) {
      stepper_.begin(bearing_, x_, t);
      if (tally) keep_loads();
      const double before = t;
      step(t, dt, duration);
      ++steps;
      if (tally) tally->add(inner_.data(), outer_.data(), 0.5 * (last + t - before));
      last = t - before;
    }
    return steps;
  }

  const std::vector<double>& state() const { return x_; }

 private:
  void step(double& t, double& dt, double end) {
    dt = std::min(dt, end - t);
    while (stepper_.try_step(bearing_, x_, t, dt) == boost::numeric::odeint::fail)
      if (dt < kSmallestStep) throw std::runtime_error("the fast stepper found no step small enough");
  }

  void keep_loads() {
    const auto rollers = static_cast<std::size_t>(bearing_.layout().rollers);
    inner_.assign(bearing_.loads().inner, bearing_.loads().inner + rollers);
    outer_.assign(bearing_.loads().outer, bearing_.loads().outer + rollers);
  }

  VectorBearing& bearing_;
  integration::Rosenbrock2 stepper_;
  std::vector<double> x_;
  std::vector<double> inner_, outer_;
};

}  // namespace

double fast_tolerance() {
  return 1e-7;
}

double fast_longest_step() {
  return 5e-5;
}

Contest::Contest(const Duty& duty) : duty_(duty), model_(duty.model()), fast_(model_) {
  padded_state_ = fast_.padded(Eigen::VectorXd::Zero(model_.layout.size()));
  padded_rate_.resize(padded_state_.size());
}

Eigen::VectorXd Contest::allowed(double length) const {
  return integration::bearing_allowed_errors(model_.layout, length, model_.geometry.pitch_radius,
                                             roller_frequency(model_));
}

Eigen::VectorXd Contest::quasi_static_start() const {
  return bearing::dynamics::initial_state(duty_.bearing, model_, duty_.parameters, kFirstRollerAngle).x;
}

Eigen::VectorXd Contest::settled(double duration) {
  return run(Method::fast, quasi_static_start(), {duration}, fast_tolerance()).state;
}

Run Contest::run(Method method, const Eigen::VectorXd& start, const Span& span, double tolerance) {
  switch (method) {
    case Method::fast:
      return run_fast(start, span, tolerance);
    case Method::cvode:
      return run_cvode(start, span, tolerance, kMostOrder);
    case Method::cvode_order2:
      return run_cvode(start, span, tolerance, 2);
    case Method::fast_dopri5:
    case Method::plain_dopri5:
    case Method::rk4:
      break;
  }
  return run_odeint(method, start, span, tolerance);
}

Run Contest::run_fast(const Eigen::VectorXd& start, const Span& span, double tolerance) {
  LoadTally tally(duty_.bearing.rollers);
  std::vector<double> weights = fast_.padded(allowed(tolerance));
  FastRun run(fast_, fast_.padded(start), std::move(weights));
  Run result{.state = start};
  const Stopwatch watch;
  result.steps = run.advance(span.duration, span.samples > 0 ? &tally : nullptr);
  result.cpu_seconds = watch.cpu();
  result.wall_seconds = watch.wall();
  fast_.flatten(run.state().data(), result.state);
  const Eigen::Index angle = model_.layout.cage() + 2;
  if (span.samples > 0) result.means = means_of(tally, result.state[angle] - start[angle], span.duration);
  return result;
}

void Contest::derivative(double time, const double* x, double* dx) {
  scatter(fast_.layout(), x, padded_state_.data());
  fast_.derivative(time, padded_state_.data(), padded_rate_.data());
  fast_.flatten(padded_rate_.data(), Eigen::Map<Eigen::VectorXd>(dx, model_.layout.size()));
}

Run Contest::run_odeint(Method method, const Eigen::VectorXd& start, const Span& span, double tolerance) {
  const bearing::dynamics::PlanetBearingEquations plain(model_);
  const integration::RightHandSide rate = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                                              Eigen::Ref<Eigen::VectorXd> dx) {
    if (method == Method::plain_dopri5)
      plain.derivative(time, x, dx);
    else
      derivative(time, x.data(), dx.data());
  };
  integration::IntegrationOptions options;
  options.method = method == Method::rk4 ? integration::Method::rk4 : integration::Method::dopri5;
  options.step = method == Method::rk4 ? tolerance : kFirstStep;
  options.allowed_error = allowed(tolerance);
  LoadTally tally(duty_.bearing.rollers);
  Eigen::VectorXd ignored(start.size());
  const auto observe = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x) {
    derivative(time, x.data(), ignored.data());
    tally.add(fast_.loads().inner, fast_.loads().outer, 1.0);
  };
  const long samples = std::max(1L, span.samples);
  const integration::OutputTimes output{0.0, span.duration / static_cast<double>(samples), samples};
  Run result{.state = start};
  const Stopwatch watch;
  const integration::IntegrationReport report = integration::integrate(
      rate, result.state, output, options, span.samples > 0 ? integration::Observer(observe) : nullptr);
  result.cpu_seconds = watch.cpu();
  result.wall_seconds = watch.wall();
  if (!report.completed) throw std::runtime_error(report.message);
  result.steps = report.steps;
  const Eigen::Index angle = model_.layout.cage() + 2;
  if (span.samples > 0) result.means = means_of(tally, result.state[angle] - start[angle], span.duration);
  return result;
}

Run Contest::run_cvode(const Eigen::VectorXd& start, const Span& span, double tolerance, int most_order) {
  LoadTally tally(duty_.bearing.rollers);
  Eigen::VectorXd ignored(start.size());
  const auto rate = [&](double time, const double* x, double* dx) { derivative(time, x, dx); };
  const auto observe = [&](double time, const double* x) {
    derivative(time, x, ignored.data());
    tally.add(fast_.loads().inner, fast_.loads().outer, 1.0);
  };
  Run result{.state = start};
  const Stopwatch watch;
  const CvodeReport report =
      bench::run_cvode(rate, result.state, span.duration, std::max(1L, span.samples), allowed(tolerance),
                       most_order, span.samples > 0 ? FlatObserver(observe) : nullptr);
  result.cpu_seconds = watch.cpu();
  result.wall_seconds = watch.wall();
  result.steps = report.steps;
  const Eigen::Index angle = model_.layout.cage() + 2;
  if (span.samples > 0) result.means = means_of(tally, result.state[angle] - start[angle], span.duration);
  return result;
}

}  // namespace orbearing::bench
