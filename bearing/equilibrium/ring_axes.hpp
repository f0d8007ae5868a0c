// Displacement and stiffness of a ring in the order x, y, z, tilt about x, tilt about y, by the right hand:
// what others ask for. Tilts in the plane of x and z and of y and z, as equilibria have them, are such
// rotations in another order and with signs.
#pragma once

#include <Eigen/Core>

#include "bearing/equilibrium/ring_balance.hpp"

namespace orbearing::bearing::equilibrium {

/// [m], [rad]: x, y, z, tilt about x, tilt about y.
using RingDisplacement = Eigen::Vector<double, 5>;
/// [N/m], [N/rad], [N m/m], [N m/rad] in the same order.
using RingStiffness = Eigen::Matrix<double, 5, 5>;

/// From (x, y, z, tilt in the plane of x and z, of y and z) of a ring that goes forward along z where it is
/// positive in x or y by a positive tilt.
inline RingStiffness turned_to_axes() {
  RingStiffness turned = RingStiffness::Zero();
  turned.topLeftCorner<3, 3>().setIdentity();
  turned(3, 4) = 1.0;   // forward where y is positive: about x
  turned(4, 3) = -1.0;  // forward where x is positive: about -y
  return turned;
}

inline RingStiffness stiffness_by_axes(const RingState& state) {
  return turned_to_axes() * state.stiffness * turned_to_axes().transpose();
}

inline RingDisplacement displacement_by_axes(const RingState& state) {
  return turned_to_axes() *
         RingDisplacement(state.radial, state.lateral, state.axial, state.tilt, state.lateral_tilt);
}

}  // namespace orbearing::bearing::equilibrium
