#include "gearset/spatial/housing_stiffness.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "mechanics/linear_algebra.hpp"

namespace orbearing::gearset::spatial {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kAsymmetry = 1e-6;  // [-]  of files with seven digits
constexpr double kNegative = 1e-9;   // [-]  of the largest eigenvalue: round-off of condensation
constexpr double kUnheld = 1e-9;     // [-]  of the largest stiffness against a rigid motion

std::string number(double value) {
  std::ostringstream text;
  text.precision(6);
  text << value;
  return text.str();
}

std::optional<MatrixFault> asymmetry(const MatrixXd& k) {
  for (Index i = 0; i < k.rows(); ++i)
    for (Index j = 0; j < i; ++j) {
      const double apart = std::abs(k(i, j) - k(j, i));
      const double size = std::max(std::sqrt(std::abs(k(i, i) * k(j, j))), std::abs(k(j, i)));
      if (apart > kAsymmetry * size)
        return MatrixFault{i, j,
                           number(k(i, j)) + " N/m in row " + std::to_string(i + 1) + ", column " +
                               std::to_string(j + 1) + ", and " + number(k(j, i)) +
                               " N/m in the opposite place",
                           "a symmetric matrix"};
    }
  return std::nullopt;
}

std::optional<MatrixFault> negative_energy(const MatrixXd& k) {
  for (Index i = 0; i < k.rows(); ++i)
    if (k(i, i) < 0.0)
      return MatrixFault{i, i, number(k(i, i)) + " N/m on the diagonal", "stiffness of at least 0"};
  const mechanics::SymmetricModes found = mechanics::symmetric_modes(0.5 * (k + k.transpose()));
  const double largest = found.values.maxCoeff();
  if (!(largest > 0.0)) return MatrixFault{0, 0, "a matrix without stiffness", "stiffness above 0"};
  if (found.values[0] >= -kNegative * largest) return std::nullopt;
  Index most = 0;
  found.vectors.col(0).cwiseAbs().maxCoeff(&most);
  return MatrixFault{most, most, "a negative eigenvalue, " + number(found.values[0]) + " N/m",
                     "a positive semidefinite matrix"};
}

// Rigid motions of the carrier that its bearings pass on: along x, y, z, about x and y. The first bearing
// alone locates it along the axis; directions in which no bearing loads the housing are zero.
MatrixXd rigid_motions(const std::vector<double>& positions) {
  const auto seats = static_cast<Index>(positions.size());
  MatrixXd motions = MatrixXd::Zero(kSeatDirections * seats, 5);
  double span = 0.0;
  for (const double z : positions) span = std::max(span, std::abs(z - positions.front()));
  motions(2, 2) = 1.0;
  for (Index b = 0; b < seats; ++b) {
    const double arm = span > 0.0 ? (positions[static_cast<std::size_t>(b)] - positions.front()) / span : 0.0;
    motions.block<2, 2>(kSeatDirections * b, 0).setIdentity();
    motions(kSeatDirections * b + 1, 3) = -arm;
    motions(kSeatDirections * b, 4) = arm;
  }
  return motions;
}

// Housing stiffness with the directions that no bearing loads free to deflect.
MatrixXd without_unloaded(const MatrixXd& k) {
  std::vector<Index> unloaded;
  for (Index b = 1; kSeatDirections * b < k.rows(); ++b) unloaded.push_back(kSeatDirections * b + 2);
  const MatrixXd across = k(unloaded, Eigen::all);
  return k - across.transpose() * mechanics::least_squares(k(unloaded, unloaded), across, kUnheld);
}

std::optional<MatrixFault> unheld(const MatrixXd& k, const std::vector<double>& positions) {
  const MatrixXd motions = rigid_motions(positions);
  const mechanics::SymmetricModes found =
      mechanics::symmetric_modes(motions.transpose() * without_unloaded(k) * motions);
  if (found.values[0] > kUnheld * found.values.maxCoeff()) return std::nullopt;
  static constexpr const char* names[] = {"across", "upward", "along the axis", "about the axis across",
                                          "about the upward axis"};
  Index most = 0;
  found.vectors.col(0).cwiseAbs().maxCoeff(&most);
  return MatrixFault{0, 0, std::string("a housing that moves freely ") + names[most],
                     "a housing that is held on its foundation"};
}

}  // namespace

MatrixXd matrix_of_rows(const std::vector<double>& rows) {
  const auto size = static_cast<Index>(std::lround(std::sqrt(static_cast<double>(rows.size()))));
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(rows.data(), size, size);
}

std::optional<MatrixFault> housing_fault(const MatrixXd& stiffness, const std::vector<double>& positions) {
  if (auto fault = asymmetry(stiffness)) return fault;
  if (auto fault = negative_energy(stiffness)) return fault;
  return positions.empty() ? std::nullopt : unheld(stiffness, positions);
}

MatrixXd housing_stiffness_at(const MatrixXd& stiffness, double angle) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  MatrixXd turned = 0.5 * (stiffness + stiffness.transpose());
  for (Index i = 0; i < turned.rows(); i += kSeatDirections)
    for (Index j = 0; j < turned.cols(); j += kSeatDirections) {
      const Eigen::Matrix3d block = turned.block<3, 3>(i, j);
      turned.block<3, 3>(i, j) = turn * block * turn.transpose();
    }
  return turned;
}

}  // namespace orbearing::gearset::spatial
