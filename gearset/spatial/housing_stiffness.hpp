// Stiffness of the housing at the seats of the carrier's bearings, as finite elements condense it: a matrix
// of three directions for each bearing, x across, y upward and z along the axis, bearing by bearing.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace orbearing::gearset::spatial {

inline constexpr int kSeatDirections = 3;

/// Why a matrix is no stiffness of a housing, and where.
struct MatrixFault {
  Eigen::Index row = 0;
  Eigen::Index column = 0;
  std::string found;
  std::string required;
};

/// Rows one after the other [N/m] as a matrix; their number is a square.
Eigen::MatrixXd matrix_of_rows(const std::vector<double>& rows);

/// None where the matrix is symmetric to 1e-6 of its diagonal, never negative as an energy, and holds the
/// housing in all directions that bearings at `positions` [m] load. Without positions the last is not
/// checked.
std::optional<MatrixFault> housing_fault(const Eigen::MatrixXd& stiffness,
                                         const std::vector<double>& positions = {});

/// The mean of both halves, in a frame at `angle` [rad] about the axis from that of the housing.
Eigen::MatrixXd housing_stiffness_at(const Eigen::MatrixXd& stiffness, double angle);

}  // namespace orbearing::gearset::spatial
