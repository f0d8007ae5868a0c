// Ports: power-conjugate pairs of a motion and a force, at which participants meet, and which of them are one
// joint.
//
// A port is one freedom of a body. The displacement counts from the place where the joint is neither pressed
// nor turned; the force is that which acts on the body whose motion it is, so that force x velocity [W] is
// the power that flows into that body. One participant gives the motion and takes the force; all others that
// are connected give forces, which add up.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "coupling/system/participant.hpp"

namespace orbearing::cosim {

// What the exchange speaks of belongs to the system in time.
using system::Input;
using system::InputPolynomial;
using system::kNone;
using system::Output;
using system::Participant;
using system::SavedState;
using system::Window;

/// Fixes the units of a pair: m, m/s and N, or rad, rad/s and N m.
enum class PortKind { translation, rotation };

/// The half of the pair that a participant gives; it takes the other.
enum class Gives { motion, force };

/// Inputs and outputs of a participant that belong together: the motion among its outputs and the force among
/// its inputs where it gives the motion, else the other way round.
struct Port {
  std::string name;  // e.g. "planet_1.y"; unique within a participant
  PortKind kind = PortKind::translation;
  Gives gives = Gives::motion;
  std::size_t displacement = kNone;  // may be missing where the motion is taken
  std::size_t velocity = kNone;      // slope of the displacement
  std::size_t force = kNone;
};

/// What an input or output runs through where nothing moves at the ports. A port's velocity adds to it.
struct Nominal {
  std::size_t position = kNone;
  std::function<InputPolynomial(double time)> polynomial;  // from `time` [s] on
};

/// One side of a co-simulation.
struct Side {
  Participant* participant = nullptr;  // not owned
  std::vector<Port> ports;
  std::vector<Nominal> inputs = {};
  std::vector<Nominal> outputs = {};
};
using Sides = std::vector<Side>;

/// A port of a side, both counted from 0.
struct PortPosition {
  std::size_t side = 0;
  std::size_t port = 0;
};

/// One joint: a side gives the motion; one or more give forces, which add up.
struct Connection {
  PortPosition motion;
  std::vector<PortPosition> forces;
};

/// Joins ports of one name, in the order in which their motion is given. Throws std::invalid_argument where a
/// name has not one giver of motion and at least one of force, or ports of different kinds.
std::vector<Connection> connect_by_name(const Sides& sides);

}  // namespace orbearing::cosim
