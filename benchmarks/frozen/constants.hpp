// The constants of the frozen equations, read from the program's model: the one place where the frozen code
// knows the program of today.
#pragma once

#include "bearing/motion/model.hpp"
#include "benchmarks/frozen/equations.hpp"

namespace orbearing::bench::frozen {

/// Throws std::invalid_argument where `model` has what the frozen equations leave out.
Model constants_of(const bearing::motion::BearingModel& model);

/// Largest difference of the frozen rates from those of the program's readable equations over `states`
/// bearings moved at random about `x`, each rate over the largest of its kind. Round-off, or the ratios
/// against the frozen equations compare different physics.
double largest_difference(const bearing::motion::BearingModel& model, const Eigen::VectorXd& x, int states);

}  // namespace orbearing::bench::frozen
