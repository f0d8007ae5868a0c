#include "coupling/system/coupled_steps.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "coupling/integration/window.hpp"

namespace orbearing::system {

namespace {

using bearing::motion::BoreMotion;

// Error of a step, over what is allowed, up to which a bearing is substepped: beyond it the
// bearing's force in the step of all is not to be trusted.
constexpr double kLargestSubstepped = 30.0;
// What it takes to begin substepping a bearing, in steps of one bearing.
constexpr double kSubsteppingBegins = 1.5;

std::vector<double> gears_alone(const CoupledSystem& system, const std::vector<double>& gears) {
  std::vector<double> allowed(system.size(), 0.0);
  std::copy(gears.begin(), gears.end(), allowed.begin());
  return allowed;
}

// The cubic through places and velocities at both ends of a step, and its slope.
void join(double h, double from, double v_from, double to, double v_to, InputPolynomial& position,
          InputPolynomial& velocity) {
  const double mean = (to - from) / h;
  const double bend = (3.0 * mean - 2.0 * v_from - v_to) / h, twist = (v_from + v_to - 2.0 * mean) / (h * h);
  position = {{from, v_from, bend, twist}};
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

void CoupledSteps::take_errors(const CoupledSystem& system, double h) {
  for (int b = 0; b < system.bearings(); ++b) {
    const auto first = static_cast<std::size_t>(system.offset(b));
    errors_[static_cast<std::size_t>(b)] = all_.share(h, first, weight_.data(), weight_.size());
  }
  sorted_ = errors_;
  std::sort(sorted_.begin(), sorted_.end(), std::greater<>());
}

bool CoupledSteps::is_kept(double gears) const {
  if (!(gears <= 1.0 && sorted_.front() <= kLargestSubstepped)) return false;
  const auto substepped =
      std::count_if(sorted_.begin(), sorted_.end(), [](double error) { return error > 1.0; });
  return substepped <= options_.most_substepped;
}

// The error that decides on the next step. With the k worst bearings substepped and errors that grow as the
// square of the step, a step costs all bearings once and these again; the k is taken that costs least over
// the time passed.
double CoupledSteps::cheapest_error(double gears) const {
  using integration::StepControl;
  const double all = static_cast<double>(sorted_.size());
  const double least = std::max(gears, sorted_.front() / kLargestSubstepped);
  double cheapest = std::max(least, sorted_.front());
  double cost = all / StepControl::share(cheapest);
  const std::size_t most = std::min(sorted_.size(), static_cast<std::size_t>(options_.most_substepped));
  for (std::size_t k = 1; k <= most; ++k) {
    const double error = k < sorted_.size() ? std::max(least, sorted_[k]) : least;
    const double share = StepControl::share(error);
    double work = all;
    for (std::size_t i = 0; i < k; ++i)
      work += kSubsteppingBegins + 1.0 / StepControl::share(sorted_[i] * share * share);
    if (work / share >= cost) continue;
    cost = work / share;
    cheapest = error;
  }
  return cheapest;
}

integration::StepResult CoupledSteps::try_step(CoupledSystem& system, std::vector<double>& x, double& t,
                                               double& dt) {
  const double h = dt;
  const double gears = all_.attempt(system, x, t, h);
  if (std::isfinite(gears)) take_errors(system, h);
  if (!std::isfinite(gears) || !is_kept(gears)) {
    dt = control_.after_refusal(h, std::isfinite(gears) ? std::max(1.0, cheapest_error(gears)) : gears);
    return integration::kRefused;
  }
  all_.accept(x);
  substep_all(system, all_.taken_away(), t, h, x);
  t += h;
  dt = control_.after_acceptance(h, cheapest_error(gears));
  return integration::kAccepted;
}

// Substepped bearings do to the gears what the step of all did not know: the gears take up the difference
// of the impulses at the end of the step, so that momentum is kept.
void CoupledSteps::substep_all(CoupledSystem& system, const std::vector<double>& before, double t, double h,
                               std::vector<double>& x) {
  bool any = false;
  for (int b = 0; b < system.bearings(); ++b) {
    if (!(errors_[static_cast<std::size_t>(b)] > 1.0)) continue;
    if (!any) {
      missed_.force.setZero(2, system.model().gears.layout.planets);
      missed_.moment.setZero(system.model().gears.layout.planets);
      any = true;
    }
    const bearing::motion::BoreReaction mean = system.mean_reaction(b);
    const bearing::motion::BoreReaction impulse = substep(system, b, before, t, h, x);
    const Eigen::Index planet = b / system.model().per_planet;
    missed_.force.col(planet) += impulse.force - h * mean.force;
    missed_.moment[planet] += impulse.moment - h * mean.moment;
  }
  if (any) system.push(missed_, x.data());
}

// Returns what it did to the bore over the step [N s], [N m s].
bearing::motion::BoreReaction CoupledSteps::substep(CoupledSystem& system, int b,
                                                    const std::vector<double>& before, double t, double h,
                                                    std::vector<double>& x) {
  const CoupledModel& model = system.model();
  const auto motion_at = [&](const std::vector<double>& state, double time) {
    return bore_motion(model, model.port_of(b), system.true_time(time), system.part(state.data(), 0),
                       system.part(state.data(), system.freedoms()));
  };
  const BoreMotion from = motion_at(before, t);
  const BoreInputs polynomial = polynomial_between(from, motion_at(x, t + h), h);
  const auto position = static_cast<std::size_t>(b);
  DrivenSystem driven(system.bearing(b), polynomial, from.angle, system.loads[position],
                      system.sums[position]);
  std::copy_n(system.of_bearing(before.data(), b), bearing_.size(), bearing_.begin());
  driven.resume(all_.slope().data() + system.offset(b), system.begin_reaction(b));
  double step = h * integration::StepControl::share(errors_[position]);
  integration::through_window(within_, driven, bearing_, h, {.most_steps = options_.most_steps}, step);
  std::copy(bearing_.begin(), bearing_.end(), system.of_bearing(x.data(), b));
  system.counted[position] = true;
  ++substepped_;
  return driven.impulse();
}

}  // namespace orbearing::system
