// Ports: power-conjugate pairs of a motion and a force, at which two participants meet.
//
// A port is one freedom of a body. The displacement counts from the place where the joint is neither pressed
// nor turned; the force is that which acts on the body whose motion it is, so that force x velocity [W] is
// the power that flows into that body. One participant gives the motion and takes the force; all others that
// are connected give forces, which add up.
#pragma once

#include <string>

#include "coupling/system/course.hpp"

namespace orbearing::cosim {

/// Fixes the units of a pair: m, m/s and N, or rad, rad/s and N m.
enum class PortKind { translation, rotation };

/// The half of the pair that a participant gives; it takes the other.
enum class Gives { motion, force };

struct Port {
  std::string name;  // e.g. "planet_1.y"; unique within a participant
  PortKind kind = PortKind::translation;
  Gives gives = Gives::motion;

  const char* displacement_unit() const { return kind == PortKind::translation ? "m" : "rad"; }
  const char* velocity_unit() const { return kind == PortKind::translation ? "m/s" : "rad/s"; }
  const char* force_unit() const { return kind == PortKind::translation ? "N" : "N.m"; }
};

/// What a participant takes at one port over a window: the motion, or the force.
struct PortInput {
  Course displacement;  // [m] or [rad]
  Course velocity;      // [m/s] or [rad/s]  the slope of the displacement
  Course force;         // [N] or [N m]
};

/// What it gives at the end of a window; its own half, the other is zero.
struct PortOutput {
  double displacement = 0.0;  // [m] or [rad]
  double velocity = 0.0;      // [m/s] or [rad/s]
  double force = 0.0;         // [N] or [N m]
};

}  // namespace orbearing::cosim
