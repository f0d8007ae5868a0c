// The shortest rotation from one direction to another. Eigen's own goes by singular values where they are opposite, which
// costs seconds in every file that compiles it.
#pragma once

#include <Eigen/Geometry>

namespace orbearing {

/// From `from` to `to`, of length 1 and not opposite.
inline Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d axis = from.cross(to);
  return Eigen::Quaterniond(1.0 + from.dot(to), axis.x(), axis.y(), axis.z()).normalized();
}

}  // namespace orbearing
