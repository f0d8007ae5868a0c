// The constants of the frozen equations, read from the program's model. This is the only file of the frozen
// code that uses the present program.
#pragma once

#include "bearing/motion/model.hpp"
#include "benchmarks/frozen/equations.hpp"

namespace orbearing::bench::frozen {

/// Throws std::invalid_argument where `model` has what the frozen equations leave out.
Model constants_of(const bearing::motion::BearingModel& model);

/// Each over the largest rate of its kind.
struct Difference {
  double of_rates = 0.0;     // [-]  frozen ones from those of the program
  double by_rounding = 0.0;  // [-]  frozen ones of states that differ in the last bit of each number
};

/// The largest over `states` bearings moved at random about `x`. Differences of rates beyond round-off mean
/// that ratios against the frozen equations compare different physics.
Difference largest_difference(const bearing::motion::BearingModel& model, const Eigen::VectorXd& x,
                              int states);

}  // namespace orbearing::bench::frozen
