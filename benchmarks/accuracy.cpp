#include "benchmarks/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace orbearing::bench {

namespace {

constexpr int kSettling = 3;                   // [-]  revolutions before all runs begin
constexpr double kLeastSettling = 20e-3;       // [s]
constexpr long kSamplesPerRevolution = 20000;  // fine enough for the crests of the loads

double relative(double found, double reference) {
  return std::abs(found / reference - 1.0);
}

}  // namespace

MeanErrors errors_of(const RunMeans& found, const RunMeans& reference) {
  return {.rms = std::max(relative(found.inner_rms, reference.inner_rms),
                          relative(found.outer_rms, reference.outer_rms)),
          .load_max = relative(found.load_max, reference.load_max),
          .cage_speed = relative(found.cage_speed, reference.cage_speed)};
}

bool within(const MeanErrors& errors, const MeanErrors& allowed) {
  return errors.rms <= allowed.rms && errors.load_max <= allowed.load_max &&
         errors.cage_speed <= allowed.cage_speed;
}

Trial::Trial(const Duty& duty)
    : contest(duty),
      start(contest.settled(std::max(kSettling * duty.cage_revolution(), kLeastSettling))),
      span{kRevolutions * duty.cage_revolution(), kRevolutions * kSamplesPerRevolution},
      reference(contest.run(Method::rk4, start, span, kReferenceStep).means) {}

MeanErrors Trial::errors(Method method, double tolerance) {
  return errors_of(contest.run(method, start, span, tolerance).means, reference);
}

Fit loosest(Trial& trial, Method method, const std::vector<double>& tolerances) {
  Fit best;
  std::size_t low = 0, high = tolerances.size();  // the answer is in [low, high); high: none
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    MeanErrors errors{.rms = INFINITY, .load_max = INFINITY, .cage_speed = INFINITY};
    try {
      errors = trial.errors(method, tolerances[middle]);
    } catch (const std::runtime_error&) {
      // An integrator that gives up has not met the accuracy.
    }
    if (within(errors, kEqualAccuracy)) {
      best = {true, tolerances[middle], errors};
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return best;
}

}  // namespace orbearing::bench
