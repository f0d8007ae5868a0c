#include "coupling/integration/integrate_switches.hpp"

#include <optional>

#include "coupling/integration/dopri5.hpp"

namespace orbearing::integration {

namespace {

using namespace detail;

// Time within a step at which a switch changes its sign.
struct Crossing {
  double time = 0.0;  // [s]
  Eigen::Index which = 0;
};

// One stepper that is started anew at each switch.
class SwitchedRun : public DenseRun {
 public:
  SwitchedRun(const System& system, const OutputTimes& output, const Switches& switches,
              const IntegrationOptions& options, const Observer& observe, Run& run, long& starts)
      : DenseRun(output, observe, run,
                 ControlledDopri5(WeightedError(options), Adjuster(switches.largest_step)), starts),
        system_(system),
        switches_(switches),
        values_(switches.count),
        sides_(switches.count) {}

  double next_step() const { return stepper_.current_time_step(); }

  /// The first step is `step` [s] long.
  bool advance(Eigen::VectorXd& x, double step) {
    const double end = output_.time(output_.samples);
    double time = output_.time(0);
    switches_.values(time, x, values_);
    for (Eigen::Index i = 0; i < switches_.count; ++i) set(i, values_[i] > 0.0);
    at_.assign(x.data(), x.data() + x.size());
    start(at_, time, step);
    while (time < end) {
      if (!DenseRun::step(system_)) return false;
      const double taken = last_step();
      const std::optional<Crossing> crossing = first_crossing();
      time = crossing ? crossing->time : stepper_.current_time();
      show_until(std::min(time, end));
      stepper_.calc_state(std::min(time, end), at_);
      x = view(at_);
      if (!run_.accept(std::min(time, end), taken)) return false;
      if (crossing && time < end) {
        set(crossing->which, !sides_[crossing->which]);
        start(at_, time, stepper_.current_time_step());
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

  System system_;
  const Switches& switches_;
  Eigen::ArrayXd values_;
  Eigen::Array<bool, Eigen::Dynamic, 1> sides_;  // the form that now holds
  State at_;
  State sample_;
};

}  // namespace

IntegrationReport integrate_switches(const RightHandSide& derivative, Eigen::VectorXd& x,
                                     const OutputTimes& output, const Switches& switches,
                                     const IntegrationOptions& options, const Observer& observe) {
  long starts = 0;
  return reported(derivative, x, output, options, starts,
                  [&](System system, Run& run, IntegrationReport& report) {
                    SwitchedRun switched(system, output, switches, options, observe, run, starts);
                    const bool completed = switched.advance(x, options.step);
                    report.next_step = switched.next_step();
                    return completed;
                  });
}

}  // namespace orbearing::integration
