#include "coupling/integration/integrate_switches.hpp"

#include <optional>

#include "coupling/integration/dopri5.hpp"
#include "coupling/integration/run.hpp"

namespace orbearing::integration {

namespace {

using namespace detail;

// Where a switch changes its sign within a step.
struct Crossing {
  double time = 0.0;  // [s]
  Eigen::Index which = 0;
};

// The run in progress: one stepper that is started anew at each switch.
class SwitchedRun {
 public:
  SwitchedRun(System system, const OutputTimes& output, const Switches& switches,
              const IntegrationOptions& options, const Observer& observe, Run& run)
      : system_(system),
        output_(output),
        switches_(switches),
        observe_(observe),
        run_(run),
        stepper_(ControlledDopri5(WeightedError(options), Adjuster(switches.largest_step))),
        step_(options.step),
        values_(switches.count),
        sides_(switches.count) {}

  long starts() const { return starts_; }
  double next_step() const { return stepper_.current_time_step(); }

  bool advance(Eigen::VectorXd& x) {
    const double end = output_.time(output_.samples);
    double time = output_.time(0);
    switches_.values(time, x, values_);
    for (Eigen::Index i = 0; i < switches_.count; ++i) set(i, values_[i] > 0.0);
    at_.assign(x.data(), x.data() + x.size());
    start(time);
    while (time < end) {
      try {
        stepper_.do_step(system_);
      } catch (const odeint::odeint_error&) {
        return run_.fail("no step was small enough, or the state is not finite,");
      }
      const double step = stepper_.current_time() - stepper_.previous_time();
      const std::optional<Crossing> crossing = first_crossing();
      time = crossing ? crossing->time : stepper_.current_time();
      emit(std::min(time, end));
      stepper_.calc_state(std::min(time, end), at_);
      x = view(at_);
      if (!run_.accept(std::min(time, end), step)) return false;
      if (crossing && time < end) {
        set(crossing->which, !sides_[crossing->which]);
        start(time);
      }
    }
    return true;
  }

 private:
  using Adjuster = odeint::default_step_adjuster<double, double>;

  void set(Eigen::Index which, bool positive) {
    sides_[which] = positive;
    switches_.set(which, positive);
  }

  void start(double time) {
    if (starts_ > 0) step_ = stepper_.current_time_step();
    stepper_.initialize(at_, time, step_);
    ++starts_;
  }

  bool has_changed(Eigen::Index which, double time) {
    stepper_.calc_state(time, sample_);
    switches_.values(time, view(sample_), values_);
    return (values_[which] > 0.0) != sides_[which];
  }

  // Looked for at a few points of the step, so that a short opening is not passed over.
  std::optional<Crossing> first_crossing() {
    constexpr int kLooks = 4;
    const double begin = stepper_.previous_time(), end = stepper_.current_time();
    sample_.resize(at_.size());
    double before = begin;
    for (int look = 1; look <= kLooks; ++look) {
      const double now = look == kLooks ? end : begin + (end - begin) * look / kLooks;
      stepper_.calc_state(now, sample_);
      switches_.values(now, view(sample_), values_);
      std::vector<Eigen::Index> changed;
      for (Eigen::Index i = 0; i < switches_.count; ++i)
        if ((values_[i] > 0.0) != sides_[i]) changed.push_back(i);
      if (!changed.empty()) return earliest(changed, before, now);
      before = now;
    }
    return std::nullopt;
  }

  Crossing earliest(const std::vector<Eigen::Index>& changed, double before, double now) {
    Crossing first{now, changed.front()};
    for (const Eigen::Index which : changed) {
      double low = before, high = now;  // changed at `high`
      while (high - low > 1e-9 * (now - before) && low < 0.5 * (low + high) && 0.5 * (low + high) < high) {
        const double middle = 0.5 * (low + high);
        (has_changed(which, middle) ? high : low) = middle;
      }
      if (high < first.time || which == changed.front()) first = {high, which};
    }
    return first;
  }

  void emit(double time) {
    while (sample_number_ <= output_.samples && output_.time(sample_number_) <= time) {
      if (observe_) {
        sample_.resize(at_.size());
        stepper_.calc_state(output_.time(sample_number_), sample_);
        observe_(output_.time(sample_number_), view(sample_));
      }
      ++sample_number_;
    }
  }

  System system_;
  const OutputTimes& output_;
  const Switches& switches_;
  const Observer& observe_;
  Run& run_;
  DenseDopri5 stepper_;
  double step_;  // [s]
  Eigen::ArrayXd values_;
  Eigen::Array<bool, Eigen::Dynamic, 1> sides_;  // the form that now holds
  long starts_ = 0;
  long sample_number_ = 1;
  State at_;
  State sample_;
};

}  // namespace

IntegrationReport integrate_switches(const RightHandSide& derivative, Eigen::VectorXd& x,
                                     const OutputTimes& output, const Switches& switches,
                                     const IntegrationOptions& options, const Observer& observe) {
  IntegrationReport report;
  report.reached = output.time(0);
  Run run(options, report);
  if (!x.allFinite()) {
    run.fail("the state is not finite");
    return report;
  }
  report.smallest_step = std::numeric_limits<double>::infinity();
  SwitchedRun switched({derivative, report.rhs_calls}, output, switches, options, observe, run);
  report.completed = switched.advance(x);
  report.rejected = std::max(0L, (report.rhs_calls - switched.starts()) / kRhsPerAttempt - report.steps);
  report.next_step = switched.next_step();
  if (report.steps == 0) report.smallest_step = 0.0;
  report.wall_seconds = run.seconds();
  return report;
}

}  // namespace orbearing::integration
