// Balls in time by linearly implicit steps: what runs, scratched bearings and benchmarks share.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bearing/motion/balls/ball_bearing.hpp"
#include "coupling/integration/rosenbrock2.hpp"
#include "coupling/integration/run.hpp"
#include "coupling/integration/window.hpp"
#include "coupling/system/bearing_steps.hpp"

namespace orbearing::system {

/// Allowed errors of the padded state in one linearly implicit step, from that of a length [m].
std::vector<double> ball_allowed_errors(const bearing::balls::BallNumbers& numbers, double length);

/// Bounds of steps of balls.
struct BallSteps {
  double longest = 0.0;  // [rad]  of a ball's vibration between its races
  double error_factor =
      0.0;  // [-]    allowed errors are this much larger than those of dopri5 at equal accuracy
};
/// If the vibration is not resolved, the method damps it: loads then follow from equilibrium, and the allowed
/// error shortens the step if a ball has an impact. Twice the allowed error of rollers changes loads, lives
/// and friction by 0.1 % at most, less than another start does.
inline constexpr BallSteps kStepsOfBalance{.longest = 10.0,
                                           .error_factor = 2.0 * kLinearlyImplicitErrorFactor};
/// To resolve the vibration itself.
inline constexpr BallSteps kStepsOfVibration{.longest = kStepOfImpact,
                                             .error_factor = kLinearlyImplicitErrorFactor};

/// The linearly implicit stepper for balls whose lengths may err by `length` [m] in one step.
integration::Rosenbrock2 ball_stepper(const bearing::balls::BallNumbers& numbers, double length,
                                      const BallSteps& steps = kStepsOfBalance);

/// Throws std::runtime_error, with what came out, unless balls are between the races and the cage about them
/// in the padded state `x`.
void require_containment(const bearing::balls::BallNumbers& numbers, const double* x);

/// The equations as the stepper and its windows see them. Who watches the steps derives from it and has
/// begun() and stepped() of its own.
class BallEquations {
 public:
  explicit BallEquations(bearing::balls::BallBearing& bearing) : bearing_(bearing) {}

  void linearise(double time, const double* x, double* dx) { bearing_.linearise(time, x, dx); }
  void derivative(double time, const double* x, double* dx) { bearing_.derivative(time, x, dx); }
  void time_slope(double time, double* rate) { bearing_.time_slope(time, rate); }
  bool factor(double g) { return bearing_.factor(g); }
  void solve(const double* rhs, double* k) const { bearing_.solve(rhs, k); }
  void begun(const std::vector<double>&) const {}
  void stepped(double, double) const {}
  void settle(double, std::vector<double>&) const {}

 protected:
  bearing::balls::BallBearing& bearing_;
};

/// A padded state on its way.
class BallsInTime {
 public:
  /// From `state` at time 0, by the steps of `stepper`.
  BallsInTime(std::vector<double> state, integration::Rosenbrock2 stepper)
      : state_(std::move(state)), stepper_(std::move(stepper)) {}

  /// To `end` [s], with the equations `system`; steps are booked with `budget`, refused ones in `report`,
  /// where it writes. Throws std::runtime_error where no step is small enough or the budget is used up.
  template <class System>
  void advance(System& system, double end, integration::Run& budget, integration::IntegrationReport& report) {
    while (time_ < end) {
      const double before = time_;
      long attempts = 0;
      step_within_window(stepper_, system, state_, time_, end, {}, step_, attempts);
      report.rejected += attempts - 1;
      if (!budget.accept(time_, time_ - before)) throw std::runtime_error(report.message);
    }
  }

  double time() const { return time_; }  // [s]
  const std::vector<double>& state() const { return state_; }

 private:
  static constexpr double kFirstStep = 1e-7;  // [s]

  std::vector<double> state_;
  integration::Rosenbrock2 stepper_;
  double time_ = 0.0, step_ = kFirstStep;
};

}  // namespace orbearing::system
