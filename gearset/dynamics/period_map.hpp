// Change of a small motion of the set over one mesh period: Floquet's theory.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// The map of departures from a motion over one mesh period at the nominal speed: meshes pass through their
/// stiffnesses, of loaded teeth those about the mean load, all in contact with the flank that carries;
/// dampers, turning frame and a drive of constant power included.
class PeriodMap {
 public:
  /// @throws std::invalid_argument for a run-up, and for a set at zero speed
  explicit PeriodMap(const SetModel& model);

  /// The fastest rate [1/s] at which a motion grows, of Floquet's multipliers: springs that pump are seen. At
  /// most zero where nothing grows; what is less than 1e-6 of the fastest frequency is round-off.
  double largest_growth() const { return growth_; }

  /// The change of a state after which it repeats each period, where all but a rotation of the whole set that
  /// costs nothing must repeat: Newton's step.
  /// @param departure of the state over a period that begins at time zero, or any number of periods later
  Eigen::VectorXd to_repeating(const Eigen::Ref<const Eigen::VectorXd>& departure) const;

 private:
  double frequency_;  // [rad/s]  of about the fastest motion; velocities are counted in positions times it
  double growth_;     // [1/s]
  Eigen::Index freedoms_;
  std::vector<Eigen::Index> free_;
  // 1 - map over positions and velocities of the free freedoms, bordered by the rotations that cost nothing.
  Eigen::MatrixXd bordered_;
};

}  // namespace orbearing::gearset::dynamics
