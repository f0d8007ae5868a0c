#include "coupling/integration/integrate_bearing.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/integration/run.hpp"

namespace orbearing::integration {

namespace {

using bearing::fast::PaddedLayout;
using bearing::fast::VectorBearing;
using State = std::vector<double>;
namespace odeint = boost::numeric::odeint;

constexpr double kStepOfImpact = 1.05;  // [rad]  of the faster of both vibrations in the longest step
// Share of the allowed error for the radial speeds of rollers: they open and close the contacts, and life
// errs with them more than with all other variables together.
constexpr double kRadialSpeedShare = 0.2;

// State between two steps: positions by Hermite's cubic from their velocities, velocities in a straight line,
// which does not ring where they are stiff.
class Interpolation {
 public:
  explicit Interpolation(const PaddedLayout& layout) : layout_(layout) {}

  void set(double from, const State& a, double to, const State& b, double time, State& x) const {
    const double h = to - from;
    const double s = (time - from) / h;
    for (std::size_t i = 0; i < a.size(); ++i) x[i] = a[i] + s * (b[i] - a[i]);
    const double rise = s * (1.0 - s);
    const auto bend = [&](int position, int velocity, int count) {
      for (int i = 0; i < count; ++i) {
        const auto p = static_cast<std::size_t>(position + i), v = static_cast<std::size_t>(velocity + i);
        const double mean = b[p] - a[p];
        x[p] += rise * ((1.0 - s) * (h * a[v] - mean) - s * (h * b[v] - mean));
      }
    };
    bend(0, 2 * layout_.lanes(), 2 * layout_.lanes());
    bend(layout_.cage(), layout_.cage() + 3, 3);
    bend(layout_.bore(), layout_.bore() + 2, 2);
    bend(layout_.pin(), layout_.pin() + 2, 2);
  }

 private:
  PaddedLayout layout_;
};

// The loads of the state that waits for its weight.
struct Waiting {
  State state, inner, outer;
  double time = 0.0, step_before = 0.0;
  Eigen::Vector2d bore_force = Eigen::Vector2d::Zero();
  State inner_approach, outer_approach, tip;  // of contacts cut into laminae

  void take(double now, const State& x, const VectorBearing& bearing, double step) {
    const bearing::fast::ContactLoads loads = bearing.loads();
    time = now;
    state = x;
    std::copy(loads.inner, loads.inner + inner.size(), inner.begin());
    std::copy(loads.outer, loads.outer + outer.size(), outer.begin());
    bore_force = bearing.reaction().force;
    step_before = step;
    if (!loads.tip) return;
    inner_approach.assign(loads.inner_approach, loads.inner_approach + inner.size());
    outer_approach.assign(loads.outer_approach, loads.outer_approach + inner.size());
    tip.assign(loads.tip, loads.tip + inner.size());
  }
};

class BearingRun {
 public:
  BearingRun(VectorBearing& bearing, const IntegrationOptions& options, const Observer& observe,
             const StepObserver& on_step, Run& run, IntegrationReport& report)
      : bearing_(bearing),
        options_(options),
        observe_(observe),
        on_step_(on_step),
        run_(run),
        report_(report),
        stepper_(linearly_implicit_errors(bearing, options.tolerance * options.allowed_error),
                 longest_step(bearing.model())),
        between_(bearing.layout()) {}

  bool go(Eigen::VectorXd& x, const OutputTimes& output) {
    State state = bearing_.padded(x);
    State sample = state;
    waiting_ = {state,
                State(static_cast<std::size_t>(bearing_.layout().rollers)),
                State(static_cast<std::size_t>(bearing_.layout().rollers)),
                0.0,
                0.0,
                Eigen::Vector2d::Zero()};
    double time = output.start, step = options_.step;
    const double end = output.time(output.samples);
    stepper_.begin(bearing_, state, time);
    waiting_.take(time, state, bearing_, 0.0);
    long next = 1;
    while (next <= output.samples) {
      const double before = time;
      if (!advance(state, time, step, end)) return false;
      const State& old = waiting_.state;
      for (; next <= output.samples && output.time(next) <= time; ++next) {
        between_.set(before, old, time, state, output.time(next), sample);
        bearing_.flatten(sample.data(), x);
        if (observe_) observe_(output.time(next), x);
      }
      count(time - before);
      stepper_.begin(bearing_, state, time);
      waiting_.take(time, state, bearing_, time - before);
    }
    count(0.0);
    bearing_.flatten(state.data(), x);
    return true;
  }

 private:
  // One accepted step that does not pass `end`.
  bool advance(State& state, double& time, double& step, double end) {
    const double before = time;
    const bool last = time + step >= end;
    double attempt = last ? end - time : step;
    while (stepper_.try_step(bearing_, state, time, attempt) == odeint::fail) {
      ++report_.rejected;
      report_.rhs_calls += 1;
      step = attempt;
      if (attempt < options_.smallest_step)
        return run_.fail("no step was small enough, or the state is not finite,");
    }
    report_.rhs_calls += 2;
    step = last ? std::max(step, attempt) : attempt;
    if (last && end - time < options_.smallest_step) time = end;
    return run_.accept(time, time - before);
  }

  void count(double step_after) const {
    if (!on_step_) return;
    const double weight = 0.5 * (waiting_.step_before + step_after);
    on_step_({waiting_.time, weight, waiting_.state.data(), waiting_.inner.data(), waiting_.outer.data(),
              waiting_.bore_force, waiting_.inner_approach.data(), waiting_.outer_approach.data(),
              waiting_.tip.data()});
  }

  VectorBearing& bearing_;
  const IntegrationOptions& options_;
  const Observer& observe_;
  const StepObserver& on_step_;
  Run& run_;
  IntegrationReport& report_;
  Rosenbrock2 stepper_;
  Interpolation between_;
  Waiting waiting_;
};

}  // namespace

State linearly_implicit_errors(const VectorBearing& bearing, const Eigen::VectorXd& allowed_error) {
  State allowed = bearing.padded(kLinearlyImplicitErrorFactor * allowed_error);
  const PaddedLayout& layout = bearing.layout();
  const auto radial_speeds = allowed.begin() + 2 * layout.lanes();
  std::for_each(radial_speeds, radial_speeds + layout.rollers,
                [](double& error) { error *= kRadialSpeedShare; });
  for (int group = 0; group < 5; ++group)
    std::fill(allowed.begin() + group * layout.lanes() + layout.rollers,
              allowed.begin() + (group + 1) * layout.lanes(), 0.0);
  return allowed;
}

double roller_frequency(const bearing::dynamics::BearingModel& model) {
  constexpr double kTypicalApproach = 1e-6;  // [m]
  const double stiffness = 2.0 * model.inner.load.load(kTypicalApproach, 1.0) / kTypicalApproach;
  return std::sqrt(std::max(stiffness, 1.0) / model.roller.mass);
}

double longest_step(const bearing::dynamics::BearingModel& model) {
  constexpr double kTypicalApproach = 1e-6;  // [m]
  const double load = model.inner.load.load(kTypicalApproach, 1.0);
  const double races = 0.25 * static_cast<double>(model.layout.rollers) * load / kTypicalApproach;
  const double ring = std::sqrt(model.bore_mass / std::max(races, 1.0));
  const double pocket = std::sqrt(model.roller.mass / std::max(model.pocket.stiffness, 1.0));
  return kStepOfImpact * std::min(ring, pocket);
}

IntegrationReport integrate_bearing(VectorBearing& bearing, Eigen::VectorXd& x, const OutputTimes& output,
                                    const IntegrationOptions& options, const Observer& observe,
                                    const StepObserver& on_step) {
  IntegrationReport report;
  report.reached = output.start;
  report.smallest_step = std::numeric_limits<double>::infinity();
  Run run(options, report);
  if (!x.allFinite())
    run.fail("the state is not finite");
  else
    report.completed = BearingRun(bearing, options, observe, on_step, run, report).go(x, output);
  if (report.steps == 0) report.smallest_step = 0.0;
  report.wall_seconds = run.seconds();
  return report;
}

}  // namespace orbearing::integration
