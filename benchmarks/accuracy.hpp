// Differences of a run's means from the reference, and the loosest tolerance at which an integrator is
// accurate enough.
#pragma once

#include <vector>

#include "benchmarks/runs.hpp"

namespace orbearing::bench {

/// Deviations from the reference, each relative and positive.
struct MeanErrors {
  double rms = 0.0;         // [-]  of roller loads, the worse of both races
  double load_max = 0.0;    // [-]
  double cage_speed = 0.0;  // [-]
};

/// Equal accuracy: what every integrator that is compared must reach over ten cage revolutions.
inline constexpr MeanErrors kEqualAccuracy{.rms = 1e-3, .load_max = 1.5e-2, .cage_speed = 5e-4};
inline constexpr int kRevolutions = 10;
inline constexpr double kReferenceStep = 2e-7;  // [s]  of RK4

MeanErrors errors_of(const RunMeans& found, const RunMeans& reference);
bool within(const MeanErrors& errors, const MeanErrors& allowed);

/// A bearing settled, and its reference.
struct Trial {
  Contest contest;
  Eigen::VectorXd start;
  Span span;  // ten revolutions of the cage
  RunMeans reference;

  explicit Trial(const Duty& duty);
  MeanErrors errors(Method method, double tolerance);
};

/// Result of a search for a tolerance.
struct Fit {
  bool found = false;
  double tolerance = 0.0;  // [m]
  MeanErrors errors;
};

/// The loosest of `tolerances` [m], which fall, that meets the accuracy, by halving: errors are taken to fall
/// with the tolerance. Not found where even the last does not.
Fit loosest(Trial& trial, Method method, const std::vector<double>& tolerances);

}  // namespace orbearing::bench
