// Balance at rest of a planetary set in three dimensions, at one angle of the carrier.
#pragma once

#include <Eigen/Core>

#include "gearset/spatial/spatial_set.hpp"
#include "mechanics/convex_search.hpp"

namespace orbearing::gearset::spatial {

/// The same mesh of all planets.
struct MeshForces {
  Eigen::ArrayXd force;      // [N]    (planets)  sum of the normal forces of the driving flanks
  Eigen::ArrayXd back;       // [N]    (planets)  the same of the back flanks
  Eigen::ArrayXd face_load;  // [-]    (planets)  largest load per width over its mean, 0: it carries nothing
  Eigen::ArrayXXd by_width;  // [N/m]  (slices, planets)  of the driving flanks
};

/// Loads that are in equilibrium at one angle of the carrier. Directions are those of the carrier's frame,
/// for a planet radially outward and tangentially in the sense of positive rotation.
struct SpatialBalance {
  Eigen::MatrixXd bearing_load;        // [N]  (rows of a pin, planets)  radial, its magnitude
  Eigen::MatrixXd bearing_radial;      // [N]  (rows, planets)  of the pin on the planet, outward
  Eigen::MatrixXd bearing_tangential;  // [N]  (rows, planets)
  MeshForces sun_mesh, ring_mesh;
  Eigen::Matrix2Xd
      planet_tilt;  // [rad]  (radial and tangential, planets)  of the bore's axis against the pin's
  Eigen::VectorXd carrier_bearing;                          // [N]  radial load of each
  Eigen::Vector3d carrier_shift = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector3d carrier_tilt = Eigen::Vector3d::Zero();   // [rad]
  double sun_torque = 0.0;                                  // [N m]  by which the sun is held
  Eigen::VectorXd position;  // of all coordinates [m], a start for the next angle
  mechanics::SearchReport search;
};

/// Coordinates of the search: for carrier, sun and each planet three displacements and three rotations at the
/// lever of the centre distance. The energy is convex, so there is one equilibrium. Gear teeth are cut into
/// `slices` over the face width; back flanks touch where the backlash is used up.
/// @param angle [rad] of the carrier in the housing; its first planet is upward at 90 degrees
/// @param start coordinates of a neighbouring equilibrium, or none
/// @throws std::runtime_error where no equilibrium is found
SpatialBalance balance(const SpatialSet& set, const SpatialLoad& load, double angle, int slices,
                       const Eigen::VectorXd& start = {});

/// Unbalanced force [N] and stiffness at any `position`, as the search uses them: for tests.
mechanics::Imbalance<Eigen::Dynamic> imbalance(const SpatialSet& set, const SpatialLoad& load, double angle,
                                               int slices, const Eigen::VectorXd& position);

/// Stiffness [N/m] about a loaded set: all driving flanks touch, no back flank does, and bearings have used
/// up their clearance. The sun may turn; `ring_moves`: the ring is a body behind the planets, which nothing
/// but the meshes holds here. An elastic housing is at angle 0 to the carrier; its seats have no mass.
Eigen::MatrixXd closed_stiffness(const SpatialSet& set, int slices, bool ring_moves);

}  // namespace orbearing::gearset::spatial
