// The life of a case at rest as what a derivative needs: ln of the life, the numbers behind it as an explicit
// map of the case, and the slope of ln of the life by these numbers.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "app/case/resolved_case.hpp"

namespace orbearing::app {

struct DifferentiatedLife {
  /// Of one planet bearing "life_h", or the column that life.method chooses; of a single bearing "L10r_Mrev".
  std::string quantity;
  std::string unit;      // "h" or "Mrev"
  double value = 0.0;    // [unit]
  std::string of_set;    // of several sets, the one whose bearings live shortest; else empty
  use::Analysis analysis = use::quasi_static;
  /// Of a case that differs in numbers alone. May be called from several threads. Throws as the case's own
  /// analysis.
  std::function<Eigen::VectorXd(const ResolvedCase&)> numbers;
  /// Of ln of the life as the numbers change by that much a unit.
  std::function<double(const Eigen::VectorXd&)> slope;
};

/// At the case's operating point. Throws BadInput where the case has no life at rest, ComputationFailed where
/// there is no balance.
DifferentiatedLife differentiated_life(const ResolvedCase& resolved);

}  // namespace orbearing::app
