#include "coupling/system/coupled_steps.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "coupling/integration/window.hpp"

namespace orbearing::system {

namespace {

using bearing::motion::BoreMotion;

// Error of a step, over what is allowed, up to which a bearing is gone over again by itself: beyond it the
// bearing's force in the step of all is not to be trusted.
constexpr double kLargestRefined = 30.0;

std::vector<double> gears_alone(const CoupledSystem& system, const std::vector<double>& gears) {
  std::vector<double> allowed(system.size(), 0.0);
  std::copy(gears.begin(), gears.end(), allowed.begin());
  return allowed;
}

// The cubic through places and velocities at both ends of a step, and its slope.
void join(double h, double from, double v_from, double to, double v_to, InputPolynomial& place,
          InputPolynomial& velocity) {
  const double mean = (to - from) / h;
  const double bend = (3.0 * mean - 2.0 * v_from - v_to) / h, twist = (v_from + v_to - 2.0 * mean) / (h * h);
  place = {{from, v_from, bend, twist}};
  velocity = {{v_from, 2.0 * bend, 3.0 * twist, 0.0}};
}

InputPolynomial straight(double h, double from, double to) {
  return {{from, (to - from) / h, 0.0, 0.0}};
}

BoreInputs polynomial_between(const BoreMotion& from, const BoreMotion& to, double h) {
  BoreInputs polynomial;
  join(h, from.position.x(), from.velocity.x(), to.position.x(), to.velocity.x(), polynomial.x,
       polynomial.v_x);
  join(h, from.position.y(), from.velocity.y(), to.position.y(), to.velocity.y(), polynomial.y,
       polynomial.v_y);
  polynomial.speed = straight(h, from.speed, to.speed);
  polynomial.carrier_speed = straight(h, from.carrier_speed, to.carrier_speed);
  polynomial.carrier_acceleration = straight(h, from.carrier_acceleration, to.carrier_acceleration);
  return polynomial;
}

}  // namespace

CoupledSteps::CoupledSteps(const CoupledSystem& system, const CoupledStepOptions& options)
    : options_(options),
      all_(gears_alone(system, options.gears), options.longest_step),
      within_(options.bearing, options.longest_step),
      control_(options.longest_step),
      weight_(options.bearing.size()),
      errors_(static_cast<std::size_t>(system.bearings())),
      sorted_(errors_),
      bearing_(options.bearing.size()) {
  std::transform(options.bearing.begin(), options.bearing.end(), weight_.begin(),
                 [](double allowed) { return allowed > 0.0 ? 1.0 / allowed : 0.0; });
}

// The largest error of the gears and of all bearings but those that will be gone over again.
double CoupledSteps::decisive_error(const CoupledSystem& system, double h, double gears) {
  for (int b = 0; b < system.bearings(); ++b) {
    const auto first = static_cast<std::size_t>(system.offset(b));
    errors_[static_cast<std::size_t>(b)] = all_.share(h, first, weight_.data(), weight_.size());
  }
  sorted_ = errors_;
  std::sort(sorted_.begin(), sorted_.end(), std::greater<>());
  const auto refined = std::min(sorted_.size(), static_cast<std::size_t>(options_.most_refined));
  double error = gears;
  if (refined < sorted_.size()) error = std::max(error, sorted_[refined]);
  if (refined > 0) error = std::max(error, sorted_[0] / kLargestRefined);
  return error;
}

integration::StepResult CoupledSteps::try_step(CoupledSystem& system, std::vector<double>& x, double& t,
                                               double& dt) {
  const double h = dt;
  const double gears = all_.attempt(system, x, t, h);
  const double error = std::isfinite(gears) ? decisive_error(system, h, gears) : gears;
  if (!(error <= 1.0)) {
    ++rejected_;
    dt = control_.after_refusal(h, error);
    return integration::kRefused;
  }
  all_.accept(x);
  for (int b = 0; b < system.bearings(); ++b)
    if (errors_[static_cast<std::size_t>(b)] > 1.0) refine(system, b, all_.taken_away(), t, h, x);
  t += h;
  dt = control_.after_acceptance(h, error);
  return integration::kAccepted;
}

void CoupledSteps::refine(CoupledSystem& system, int b, const std::vector<double>& before, double t, double h,
                          std::vector<double>& x) {
  const CoupledModel& model = system.model();
  const auto motion_at = [&](const std::vector<double>& state, double time) {
    return bore_motion(model, model.port_of(b), system.true_time(time), system.part(state.data(), 0),
                       system.part(state.data(), system.freedoms()));
  };
  const BoreMotion from = motion_at(before, t);
  const BoreInputs polynomial = polynomial_between(from, motion_at(x, t + h), h);
  const auto place = static_cast<std::size_t>(b);
  DrivenSystem driven(system.bearing(b), polynomial, from.angle, system.loads[place], system.sums[place]);
  std::copy_n(system.of_bearing(before.data(), b), bearing_.size(), bearing_.begin());
  double step = h * integration::StepControl::share(errors_[place]);
  integration::through_window(within_, driven, bearing_, h, {.most_steps = options_.most_steps}, step);
  std::copy(bearing_.begin(), bearing_.end(), system.of_bearing(x.data(), b));
  system.counted[place] = true;
  ++refined_;
}

}  // namespace orbearing::system
