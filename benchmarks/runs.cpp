#include "benchmarks/runs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bearing/motion/initial_state.hpp"
#include "benchmarks/cvode.hpp"
#include "benchmarks/frozen/constants.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/free_bearing.hpp"

namespace orbearing::bench {

namespace {

using bearing::vectorised::VectorBearing;

constexpr int kMostOrder = 5;              // of BDF, as CVODE comes
constexpr double kFirstStep = 1e-6;        // [s]
constexpr double kFirstRollerAngle = 0.0;  // [rad]

}  // namespace

Contest::Contest(const Duty& duty) : duty_(duty), model_(duty.model()), fast_(model_) {}

Eigen::VectorXd Contest::allowed(double length) const {
  return system::allowed_errors(model_, length);
}

Eigen::VectorXd Contest::quasi_static_start() const {
  return bearing::motion::initial_state(duty_.bearing, model_, duty_.parameters, kFirstRollerAngle).x;
}

Eigen::VectorXd Contest::settled(double duration) {
  return run(Method::fast, quasi_static_start(), {duration}, duty_.allowed_length_error).state;
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
  LoadTally tally(duty_.bearing.rollers().count);
  const auto on_step = [&](const system::StepSample& step) {
    tally.add(step.loads.inner, step.loads.outer, step.weight);
  };
  integration::IntegrationOptions options;
  options.step = kFirstStep;
  options.allowed_error = allowed(tolerance);
  Run result{.state = start};
  const Stopwatch watch;
  const integration::IntegrationReport report =
      system::integrate_bearing(fast_, result.state, {0.0, span.duration, 1}, options, nullptr,
                                span.samples > 0 ? system::StepObserver(on_step) : nullptr);
  finish(watch, start, span, tally, result);
  if (!report.completed) throw std::runtime_error(report.message);
  result.steps = report.steps;
  return result;
}

void Contest::finish(const Stopwatch& watch, const Eigen::VectorXd& start, const Span& span,
                     const LoadTally& tally, Run& result) const {
  result.cpu_seconds = watch.cpu();
  result.wall_seconds = watch.wall();
  const Eigen::Index angle = model_.layout.cage() + 2;
  const double turned = result.state[angle] - start[angle];
  if (span.samples > 0)
    result.means = {tally.inner_rms(), tally.outer_rms(), tally.largest(), turned / span.duration};
}

void Contest::derivative(double time, const double* x, double* dx) {
  const Eigen::Index size = model_.layout.size();
  fast_.derivative(time, Eigen::Map<const Eigen::VectorXd>(x, size), Eigen::Map<Eigen::VectorXd>(dx, size));
}

Run Contest::run_odeint(Method method, const Eigen::VectorXd& start, const Span& span, double tolerance) {
  std::optional<frozen::Equations> plain;
  if (method == Method::plain_dopri5) plain.emplace(frozen::constants_of(model_));
  const integration::RightHandSide rate = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                                              Eigen::Ref<Eigen::VectorXd> dx) {
    if (plain)
      plain->derivative(x, dx);
    else
      derivative(time, x.data(), dx.data());
  };
  integration::IntegrationOptions options;
  options.method = method == Method::rk4 ? integration::Method::rk4 : integration::Method::dopri5;
  options.step = method == Method::rk4 ? tolerance : kFirstStep;
  options.allowed_error = allowed(tolerance);
  LoadTally tally(duty_.bearing.rollers().count);
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
  finish(watch, start, span, tally, result);
  if (!report.completed) throw std::runtime_error(report.message);
  result.steps = report.steps;
  return result;
}

Run Contest::run_cvode(const Eigen::VectorXd& start, const Span& span, double tolerance, int most_order) {
  LoadTally tally(duty_.bearing.rollers().count);
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
  finish(watch, start, span, tally, result);
  result.steps = report.steps;
  return result;
}

}  // namespace orbearing::bench
