#include "coupling/system/free_bearing.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "coupling/integration/rosenbrock3.hpp"
#include "coupling/integration/rosenbrock4.hpp"
#include "coupling/integration/run.hpp"
#include "coupling/integration/window.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/loads_at_step.hpp"

namespace orbearing::system {

namespace {

using bearing::motion::BearingModel;
using bearing::vectorised::VectorBearing;
using integration::IntegrationOptions;
using integration::IntegrationReport;
using integration::OutputTimes;

// The vectorised bearing as the linearly implicit stepper and its windows see it.
class FreeSystem {
 public:
  FreeSystem(VectorBearing& bearing, const StepObserver& on_step,
             bearing::motion::StatisticsCollector* collector)
      : bearing_(bearing), on_step_(on_step), loads_(static_cast<int>(bearing.layout().rollers)) {
    loads_.collector = collector;
  }

  void linearise(double time, const double* x, double* dx) { bearing_.linearise(time, x, dx); }
  void derivative(double time, const double* x, double* dx) { bearing_.derivative(time, x, dx); }
  void time_slope(double time, double* rate) { bearing_.time_slope(time, rate); }
  bool factor(double g) { return bearing_.factor(g); }
  void solve(const double* rhs, double* k) const { bearing_.solve(rhs, k); }

  void begun(const std::vector<double>& x) {
    from_ = x;
    force_ = bearing_.reaction().force;
    loads_.take(bearing_, x.data());
  }
  void stepped(double time, double length) {
    const double weight = loads_.count(length);
    if (on_step_) on_step_({time, weight, from_.data(), loads_.loads(), force_});
  }
  void settle(double, std::vector<double>&) const {}

  // Where rates of tilts go, if anywhere.
  std::vector<double>* tilt_rate = nullptr;

  /// State at the beginning of the last step.
  const std::vector<double>& from() const { return from_; }

 private:
  VectorBearing& bearing_;
  const StepObserver& on_step_;
  LoadsAtStep loads_;
  std::vector<double> from_;
  Eigen::Vector2d force_ = Eigen::Vector2d::Zero();  // [N]
};

// False where the budget is used up. The last step ends with `output`.
template <class Stepper>
bool run(Stepper& stepper, VectorBearing& bearing, FreeSystem& system, Eigen::VectorXd& x,
         const OutputTimes& output, const IntegrationOptions& options, const integration::Observer& observe,
         integration::Run& budget, IntegrationReport& report) {
  const integration::WindowLimits limits{.smallest_step = options.smallest_step, .stretch = 1.0};
  std::vector<double> state = bearing.padded(x), sample = state;
  constexpr double kWholeStep = 0.5;  // of the one before: one that is cut at the end shows no rate
  double time = output.time(0), step = options.step, length = 0.0;
  long next = 1;
  while (next <= output.samples) {
    const double before = time;
    long attempts = 0;
    step_within_window(stepper, system, state, time, output.time(output.samples), limits, step, attempts);
    report.rejected += attempts - 1;
    report.rhs_calls += attempts + 1;
    if (!budget.accept(time, time - before)) return false;
    if (system.tilt_rate && time - before >= kWholeStep * length)
      *system.tilt_rate = tilt_rates(bearing.layout(), system.from().data(), state.data(), time - before);
    length = time - before;
    for (; next <= output.samples && output.time(next) <= time; ++next) {
      WithinStep(before, system.from(), time, state, output.time(next), sample).bend(bearing.layout(), 0);
      bearing.flatten(sample.data(), x);
      if (observe) observe(output.time(next), x);
    }
  }
  stepper.begin(system, state, time);
  system.begun(state);
  system.stepped(time, 0.0);
  bearing.flatten(state.data(), x);
  return true;
}

// The same by the stepper that suits the bearing.
bool run(VectorBearing& bearing, FreeSystem& system, Eigen::VectorXd& x, const OutputTimes& output,
         const IntegrationOptions& options, const integration::Observer& observe, integration::Run& budget,
         IntegrationReport& report) {
  const Eigen::VectorXd allowed = options.tolerance * options.allowed_error;
  const auto by = [&](auto stepper) {
    return run(stepper, bearing, system, x, output, options, observe, budget, report);
  };
  const BearingModel& model = bearing.model();
  const int order = order_of_steps(model, !model.excitation.harmonics.empty());
  const StepBounds steps = steps_of_order(order, bearing, allowed, slowness(model));
  if (order == 2) return by(integration::Rosenbrock2(steps.allowed, steps.longest, steps.rule));
  if (order == 3) return by(integration::Rosenbrock3(steps.allowed, steps.longest, steps.rule));
  return by(integration::Rosenbrock4(steps.allowed, steps.longest, steps.rule));
}

}  // namespace

IntegrationReport integrate_bearing(VectorBearing& bearing, Eigen::VectorXd& x, const OutputTimes& output,
                                    const IntegrationOptions& options, const integration::Observer& observe,
                                    const StepObserver& on_step,
                                    bearing::motion::StatisticsCollector* collector,
                                    std::vector<double>* tilt_rate) {
  IntegrationReport report;
  report.reached = output.time(0);
  report.smallest_step = std::numeric_limits<double>::infinity();
  integration::Run budget(options, report);
  FreeSystem system(bearing, on_step, collector);
  system.tilt_rate = tilt_rate;
  try {
    report.completed = x.allFinite() ? run(bearing, system, x, output, options, observe, budget, report)
                                     : budget.fail("the state is not finite");
  } catch (const integration::NoStep& error) {
    report.message = error.what() + ("; " + fastest_vibration(bearing.model()));
  } catch (const std::runtime_error& error) {
    report.message = error.what();
  }
  if (report.steps == 0) report.smallest_step = 0.0;
  report.wall_seconds = budget.seconds();
  return report;
}

FreeBearing::FreeBearing(const BearingModel& model, Eigen::VectorXd start, double length_error,
                         const IntegrationOptions& options)
    : bearing_(model), options_(options), state_(std::move(start)), shown_(state_) {
  options_.allowed_error = allowed_errors(model, length_error);
}

void FreeBearing::take_snapshot(int, bearing::motion::Snapshot& into) const {
  bearing::motion::take_snapshot(model(), shown_, into, time_,
                                 tilt_rate_.empty() ? nullptr : tilt_rate_.data());
}

void FreeBearing::advance(const OutputTimes& times, const std::function<void(double time)>& observe) {
  const auto show = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x) {
    const std::string reason = out_of_place(model(), x);
    if (!reason.empty()) throw std::runtime_error(reason);
    shown_ = x;
    time_ = time;
    observe(time);
  };
  IntegrationOptions options = options_;
  options.step = std::min(options.step, times.interval);
  options.most_seconds -= report_.wall_seconds;
  options.most_steps -= report_.steps;
  append(shows_steps() ? advance_implicitly(times, options, show) : advance_explicitly(times, options, show),
         report_);
  shown_ = state_;
  if (!report_.completed) throw std::runtime_error(report_.message);
}

IntegrationReport FreeBearing::advance_implicitly(const OutputTimes& times, const IntegrationOptions& options,
                                                  const integration::Observer& show) {
  const auto on_step = [this](const StepSample& step) {
    const double* bore = step.state + bearing_.layout().bore();
    observers_.on_bore({step.time, step.weight, {bore[0], bore[1]}, {bore[2], bore[3]}, step.bore_force});
  };
  return integrate_bearing(bearing_, state_, times, options, show,
                           observers_.on_bore ? StepObserver(on_step) : nullptr, observers_.loads.front(),
                           &tilt_rate_);
}

IntegrationReport FreeBearing::advance_explicitly(const OutputTimes& times, const IntegrationOptions& options,
                                                  const integration::Observer& show) {
  const auto derivative = [this](double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                                 Eigen::Ref<Eigen::VectorXd> dx) { bearing_.derivative(time, x, dx); };
  const auto observe = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x) {
    show(time, x);
    if (!observers_.on_bore) return;
    const Eigen::Index bore = model().layout.bore();
    observers_.on_bore(
        {time, 1.0, x.segment<2>(bore), x.segment<2>(bore + 2), snapshot(model(), x, time).on_bore.force});
  };
  return integrate(derivative, state_, times, options, observe);
}

}  // namespace orbearing::system
