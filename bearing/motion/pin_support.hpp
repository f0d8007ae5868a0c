// Spring and damper between the pin ring and the carrier.
#pragma once

#include "bearing/plane.hpp"

namespace orbearing::bearing::motion {

/// Support of the pin ring, alike in all directions.
struct PinSupport {
  double stiffness = 0.0;  // [N/m]
  double damping = 0.0;    // [N s/m]

  /// Force on the pin ring [N] at its displacement [m] and velocity [m/s].
  Vector2 force(const Vector2& position, const Vector2& velocity) const {
    return -stiffness * position - damping * velocity;
  }
  /// Stored energy [J].
  double energy(const Vector2& position) const { return 0.5 * stiffness * position.squaredNorm(); }
  /// Dissipated power [W].
  double power(const Vector2& velocity) const { return damping * velocity.squaredNorm(); }
};

}  // namespace orbearing::bearing::motion
