// Which ports of which participants are one joint.
#pragma once

#include <cstddef>
#include <vector>

#include "coupling/cosim/port.hpp"

namespace orbearing::cosim {

/// A port of a side, both counted from 0.
struct PortPlace {
  std::size_t side = 0;
  std::size_t port = 0;
};

/// One joint: a side gives the motion; one or more give forces, which add up.
struct Connection {
  PortPlace motion;
  std::vector<PortPlace> forces;
};

/// Joins ports of one name, in the order in which their motion is given. Throws std::invalid_argument where a
/// name has not one giver of motion and at least one of force, or ports of different kinds.
std::vector<Connection> connect_by_name(const Sides& sides);

}  // namespace orbearing::cosim
