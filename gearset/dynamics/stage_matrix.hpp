// M - g C - g^2 K of a set, for the stages of a linearly implicit method: planets meet the central members and no
// other planet, so they are eliminated one by one.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearset/dynamics/model.hpp"

namespace orbearing::gearset::dynamics {

// Slopes of all forces of the set by positions and velocities, for implicit integrators.

/// Slopes of the generalised forces.
struct ForceSlopes {
  Eigen::MatrixXd by_position;  // [N/m]    (freedoms, freedoms)
  Eigen::MatrixXd by_velocity;  // [N s/m]  (freedoms, freedoms)
};

/// Slopes of what `add_forces` gives at `time` [s] and `x`, with the flanks that touch there. `slopes` is
/// resized where it has not the right size. Coupled bearings have no part in it.
void force_slopes(const SetModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                  ForceSlopes& slopes);

/// The matrix with its factors, without pivoting: it is close to the masses, which are positive. Nothing is
/// allocated after the first use.
class StageMatrix {
 public:
  /// Builds the matrix from the slopes of all forces, with `g` [s] the implicit share of the step.
  void assemble(const SetModel& model, const ForceSlopes& slopes, double g);
  /// Adds to the rows of a planet and of the carrier: `matrix` acts on the motion of the port, displacement
  /// and rotation, `of_carrier` and `of_planet` times theirs, and pushes along it. [kg] with lengths for all
  /// three. A load that yields takes its share of the moment, as in add_port_loads().
  void add_port(const SetModel& model, Eigen::Index planet, const Eigen::Matrix3d& of_carrier,
                const Eigen::Matrix3d& of_planet, const Eigen::Matrix3d& matrix);
  /// Replaces the matrix by its factors, in which freedoms that the housing holds answer with their right-hand
  /// side; false where a pivot vanishes.
  bool factor(const SetModel& model);
  /// `b` (freedoms) becomes the solution.
  void solve(Eigen::Ref<Eigen::VectorXd> b) const;

 private:
  static constexpr int kCentre = 9;  // sun, ring, carrier
  using Centre = Eigen::Matrix<double, kCentre, kCentre, Eigen::RowMajor>;

  struct Planet {
    Eigen::Matrix3d own;  // after factor() its inverse
    Eigen::Matrix<double, 3, kCentre> by_centre;  // after factor() `own` times it
    Eigen::Matrix<double, kCentre, 3> centre_by;
  };
  bool factor_centre();

  Centre centre_;  // after factor() its factors, with the inverse of each pivot
  std::vector<Planet> planets_;
};

}  // namespace orbearing::gearset::dynamics
