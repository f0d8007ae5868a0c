// Natural frequencies of a planetary set in three dimensions at rest: its stiffness with all driving flanks
// in contact and no clearance, and the masses of its bodies.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearset/spatial/spatial_set.hpp"

namespace orbearing::gearset::spatial {

/// A rigid body that is round about the axis.
struct RoundBody {
  double mass = 0.0;        // [kg]
  double polar = 0.0;       // [kg m2]  moment of inertia about its axis
  double transverse = 0.0;  // [kg m2]  about a diameter through its centre of mass
  double centre = 0.0;      // [m]      axial position of that centre
};

/// Support of a body in the housing besides the springs of the set.
struct BodySupport {
  double radial = 0.0;   // [N/m]
  double axial = 0.0;    // [N/m]
  double tilt = 0.0;     // [N m/rad]
  double torsion = 0.0;  // [N m/rad]
  bool held_in_rotation = false;
};

/// The set, whose own masses do not count here, with the bodies that move.
struct MovingSet {
  SpatialSet set;
  RoundBody carrier, sun, planet, ring;
  BodySupport carrier_support, sun_support, ring_support;
};

/// Modes of one frequency.
struct SpatialMode {
  double frequency = 0.0;  // [Hz]
  int multiplicity = 1;
  /// [-]  of the kinetic energy, mean over the modes of the frequency: displacement in the plane and rotation
  /// about the axis; along the axis; tilt
  double in_plane = 0.0, axial = 0.0, tilting = 0.0;
  double carrier = 0.0, sun = 0.0, ring = 0.0, planets = 0.0;  // [-]  likewise, by bodies
  /// (bodies, x y z and rotations about them times the centre distance)  over the largest; carrier, sun,
  /// planets, ring. Of several shapes of one frequency the first.
  Eigen::Matrix<double, Eigen::Dynamic, 6> shape;
};

/// Ascending. A free motion has the frequency zero. Directions are those of a frame fixed to the carrier, x
/// toward the first planet if that is at angle 0.
std::vector<SpatialMode> modes_at_rest(const MovingSet& moving);

}  // namespace orbearing::gearset::spatial
