#include "coupling/cosim/port.hpp"

#include <algorithm>
#include <stdexcept>

namespace orbearing::cosim {

namespace {

struct NamedPlace {
  const Port& port;
  PortPlace place;
};

std::vector<NamedPlace> all_ports(const Sides& sides) {
  std::vector<NamedPlace> out;
  for (std::size_t s = 0; s < sides.size(); ++s)
    for (std::size_t i = 0; i < sides[s].ports.size(); ++i) out.push_back({sides[s].ports[i], {s, i}});
  return out;
}

bool is_same(const PortPlace& a, const PortPlace& b) {
  return a.side == b.side && a.port == b.port;
}

[[noreturn]] void refuse(const std::string& name, const char* problem) {
  throw std::invalid_argument("port " + name + ": found " + problem +
                              "; required: one participant that gives its motion, others that give forces");
}

Connection joined(const NamedPlace& motion, const std::vector<NamedPlace>& ports) {
  Connection out{motion.place, {}};
  for (const NamedPlace& other : ports) {
    if (other.port.name != motion.port.name || is_same(other.place, motion.place)) continue;
    if (other.port.kind != motion.port.kind) refuse(motion.port.name, "a translation and a rotation");
    if (other.port.gives == Gives::motion) refuse(motion.port.name, "two that give its motion");
    out.forces.push_back(other.place);
  }
  if (out.forces.empty()) refuse(motion.port.name, "nobody that gives a force");
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
  const std::vector<NamedPlace> ports = all_ports(sides);
  for (const NamedPlace& port : ports) require_whole(port.port);
  std::vector<Connection> out;
  for (const NamedPlace& port : ports)
    if (port.port.gives == Gives::motion) out.push_back(joined(port, ports));
  for (const NamedPlace& port : ports) {
    const auto same = [&](const NamedPlace& other) {
      return other.port.name == port.port.name && other.port.gives == Gives::motion;
    };
    if (std::none_of(ports.begin(), ports.end(), same))
      refuse(port.port.name, "nobody that gives its motion");
  }
  return out;
}

}  // namespace orbearing::cosim
