#include "coupling/cosim/connection.hpp"

#include <algorithm>
#include <stdexcept>

namespace orbearing::cosim {

namespace {

struct NamedPlace {
  const Port& port;
  PortPlace place;
};

std::vector<NamedPlace> all_ports(const Participants& participants) {
  std::vector<NamedPlace> out;
  for (std::size_t p = 0; p < participants.size(); ++p)
    for (std::size_t i = 0; i < participants[p]->ports().size(); ++i)
      out.push_back({participants[p]->ports()[i], {p, i}});
  return out;
}

bool is_same(const PortPlace& a, const PortPlace& b) {
  return a.participant == b.participant && a.port == b.port;
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

}  // namespace

std::vector<Connection> connect_by_name(const Participants& participants) {
  const std::vector<NamedPlace> ports = all_ports(participants);
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
