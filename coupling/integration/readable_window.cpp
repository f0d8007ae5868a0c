#include "coupling/integration/readable_window.hpp"

#include "coupling/integration/dopri5.hpp"

namespace orbearing::integration {

namespace {

// Dormand and Prince behind what a window asks of a stepper and its system.
class ReadableSteps {
 public:
  ReadableSteps(const RightHandSide& derivative, const IntegrationOptions& options, const StepBegin& on_step)
      : derivative_(derivative), on_step_(on_step), stepper_(detail::WeightedError(options)) {}

  void begin(ReadableSteps&, const detail::State& x, double) { start_ = x; }
  detail::odeint::controlled_step_result try_step(ReadableSteps&, detail::State& x, double& t, double& dt) {
    long calls = 0;
    return stepper_.try_step(detail::System{derivative_, calls}, x, t, dt);
  }
  void begun(const detail::State&) { stepper_.reset(); }
  void stepped(double time, double length) {
    if (on_step_) on_step_(time, length, detail::view(start_));
  }
  void settle(double, const detail::State&) {}

 private:
  const RightHandSide& derivative_;
  const StepBegin& on_step_;
  detail::ControlledDopri5 stepper_;
  detail::State start_;
};

}  // namespace

void through_window(const RightHandSide& derivative, Eigen::VectorXd& x, double length,
                    const Eigen::VectorXd& allowed, const WindowLimits& limits, double& step,
                    const StepBegin& on_step) {
  IntegrationOptions options;
  options.allowed_error = allowed;
  ReadableSteps steps(derivative, options, on_step);
  detail::State state(x.data(), x.data() + x.size());
  through_window(steps, steps, state, length, limits, step);
  x = detail::view(state);
}

}  // namespace orbearing::integration
