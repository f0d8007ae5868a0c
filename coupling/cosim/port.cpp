#include "coupling/cosim/port.hpp"

#include <algorithm>
#include <stdexcept>

namespace orbearing::cosim {

namespace {

struct NamedPosition {
  const Port& port;
  PortPosition position;
};

std::vector<NamedPosition> all_ports(const Sides& sides) {
  std::vector<NamedPosition> out;
  for (std::size_t s = 0; s < sides.size(); ++s)
    for (std::size_t i = 0; i < sides[s].ports.size(); ++i) out.push_back({sides[s].ports[i], {s, i}});
  return out;
}

bool is_same(const PortPosition& a, const PortPosition& b) {
  return a.side == b.side && a.port == b.port;
}

[[noreturn]] void refuse(const std::string& name, const char* problem) {
  throw std::invalid_argument("port " + name + ": found " + problem +
                              "; required: one participant that gives its motion, others that give forces");
}

Connection joined(const NamedPosition& motion, const std::vector<NamedPosition>& ports) {
  Connection out{motion.position, {}};
  for (const NamedPosition& other : ports) {
    if (other.port.name != motion.port.name || is_same(other.position, motion.position)) continue;
    if (other.port.kind != motion.port.kind) refuse(motion.port.name, "a translation and a rotation");
    if (other.port.gives == Gives::motion) refuse(motion.port.name, "two participants that give its motion");
    out.forces.push_back(other.position);
  }
  if (out.forces.empty()) refuse(motion.port.name, "no participant that gives a force");
  return out;
}

void require_whole(const Port& port) {
  if (port.velocity == kNone || port.force == kNone ||
      (port.gives == Gives::motion && port.displacement == kNone))
    throw std::invalid_argument("port " + port.name +
                                ": found no input or output for its motion or force; required: one each");
}

}  // namespace

std::vector<Connection> connect_by_name(const Sides& sides) {
  const std::vector<NamedPosition> ports = all_ports(sides);
  for (const NamedPosition& port : ports) require_whole(port.port);
  std::vector<Connection> out;
  for (const NamedPosition& port : ports)
    if (port.port.gives == Gives::motion) out.push_back(joined(port, ports));
  for (const NamedPosition& port : ports) {
    const auto same = [&](const NamedPosition& other) {
      return other.port.name == port.port.name && other.port.gives == Gives::motion;
    };
    if (std::none_of(ports.begin(), ports.end(), same))
      refuse(port.port.name, "no participant that gives its motion");
  }
  return out;
}

}  // namespace orbearing::cosim
