// Static equilibrium of the set under its mean loads.
#pragma once

#include <Eigen/Core>

#include "gearset/dynamics/matrices.hpp"
#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// State at rest in the carrier's frame with mean mesh stiffness and mean errors, centrifugal forces
/// included. Rotations without stiffness are zero. Solved for the flanks in contact, until those found in
/// contact are the same.
/// @throws std::runtime_error where no equilibrium is found
Eigen::VectorXd static_state(const SetModel& model);

/// The set at rest while its pins are displaced, again and again. It follows them in straight lines as long
/// as the flanks in contact stay the same: then a displacement costs one product.
class StaticSet {
 public:
  /// Starts where static_state() has it, and throws as that does.
  explicit StaticSet(SetModel model);

  /// State at rest with pins displaced by `offset` [m] (radial and tangential, planets) beyond their errors.
  /// @throws std::runtime_error where no equilibrium is found
  Eigen::VectorXd at(const Eigen::Matrix2Xd& offset);
  /// Force [N] of the bearings on each planet (2, planets) in such a state.
  Eigen::Matrix2Xd bearing_forces(const Eigen::VectorXd& state, const Eigen::Matrix2Xd& offset) const;
  /// Their derivatives by the offsets of the pins [N/m] (2 planets, 2 planets), while the flanks in contact
  /// stay the same.
  const Eigen::MatrixXd& forces_by_offset() const { return forces_by_offset_; }

 private:
  void rest(const Eigen::Matrix2Xd& offset);

  SetModel model_;
  Eigen::MatrixXd centrifugal_;  // [N/m]
  ContactState contact_;         // where it was last sought
  Eigen::VectorXd positions_;
  Eigen::Matrix2Xd offset_;
  Eigen::MatrixXd by_offset_;         // [-]    (freedoms, 2 planets)
  Eigen::MatrixXd forces_by_offset_;  // [N/m]
};

}  // namespace orbearing::gearset::dynamics
