// Which ports of which participants are one joint.
#pragma once

#include <cstddef>
#include <vector>

#include "coupling/cosim/participant.hpp"

namespace orbearing::cosim {

/// A port of a participant, both counted from 0.
struct PortPlace {
  std::size_t participant = 0;
  std::size_t port = 0;
};

/// One joint: a participant gives the motion; one or more give forces, which add up.
struct Connection {
  PortPlace motion;
  std::vector<PortPlace> forces;
};

using Participants = std::vector<Participant*>;  // not owned

/// Joins ports of one name, in the order in which their motion is given. Throws std::invalid_argument where a
/// name has not one giver of motion and at least one of force, or ports of different kinds.
std::vector<Connection> connect_by_name(const Participants& participants);

}  // namespace orbearing::cosim
