// The set linearised about its loaded state: mass, stiffness, gyroscopic and damping matrix.
#pragma once

#include <Eigen/Core>

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

/// M q'' + (C + G) q' + K q = f, in the order of SetLayout, held freedoms included.
struct SetMatrices {
  Eigen::VectorXd mass;         // [kg]     diagonal
  Eigen::MatrixXd stiffness;    // [N/m]    mean mesh stiffness, planet bearings, supports: without speed
  Eigen::MatrixXd centrifugal;  // [N/m]   to be added at speed
  Eigen::MatrixXd gyroscopic;   // [N s/m]  skew-symmetric
  Eigen::MatrixXd damping;      // [N s/m]  of meshes, planet bearings, supports
  Eigen::MatrixXd circulatory;  // [N/m]   dampers of the housing seen from the turning frame, skew-symmetric
};

/// Matrices at the nominal speed, all teeth in contact with the flank that carries. Built from the deflection
/// vectors: each spring adds k d d^T.
SetMatrices set_matrices(const SetModel& model);

/// [N/m]  what the turning frame adds to the stiffness at the nominal speed.
Eigen::MatrixXd centrifugal_stiffness(const SetModel& model);

/// Which flanks carry, for `stiffness_at`: one entry a mesh.
struct ContactState {
  std::vector<bool> loaded;
  std::vector<bool> back;

  bool operator==(const ContactState&) const = default;
};

/// Stiffness matrix [N/m] with the given flanks in contact.
Eigen::MatrixXd stiffness_with(const SetModel& model, const ContactState& contact);

}  // namespace orbearing::gearset::dynamics
