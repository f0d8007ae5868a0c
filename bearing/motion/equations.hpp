// Equations of motion of the planet bearing, in the form x' = f(t, x).
#pragma once

#include <Eigen/Core>
#include <utility>

#include "bearing/motion/model.hpp"

namespace orbearing::bearing::motion {

/// Right-hand side. Pure and free of allocation; one object may serve several threads.
class PlanetBearingEquations {
 public:
  explicit PlanetBearingEquations(BearingModel model) : model_(std::move(model)) {}

  /// Rate `dx` of the state `x` at `time` [s]; both have the order of StateLayout.
  void derivative(double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                  Eigen::Ref<Eigen::VectorXd> dx) const;

  const BearingModel& model() const { return model_; }

 private:
  BearingModel model_;
};

}  // namespace orbearing::bearing::motion
