#include "coupling/fmu/import/foreign_setup.hpp"

#include <cmath>

#include "coupling/fmu/import/errors.hpp"

namespace orbearing::fmu {
namespace {

enum class Quantity { displacement, velocity, force };

// Exponents of kg, m, s alone: the radian of angles is written by some tools and left out by others.
using Dimension = std::array<int, 3>;

Dimension dimension_of(cosim::PortKind kind, Quantity quantity) {
  const bool turns = kind == cosim::PortKind::rotation;
  switch (quantity) {
    case Quantity::displacement:
      return {0, turns ? 0 : 1, 0};
    case Quantity::velocity:
      return {0, turns ? 0 : 1, -1};
    case Quantity::force:
      break;
  }
  return {1, turns ? 2 : 1, -2};
}

const char* unit_name(const cosim::Port& port, Quantity quantity) {
  switch (quantity) {
    case Quantity::displacement:
      return port.displacement_unit();
    case Quantity::velocity:
      return port.velocity_unit();
    case Quantity::force:
      break;
  }
  return port.force_unit();
}

std::string names_of(const ForeignDescription& description, const std::string& causality) {
  constexpr int most = 20;
  std::string names;
  int count = 0;
  for (const ForeignVariableInfo& variable : description.variables) {
    if (variable.causality != causality || !variable.is_real() || ++count > most) continue;
    names += (names.empty() ? "" : ", ") + variable.name;
  }
  return count == 0 ? "none" : names + (count > most ? ", ..." : "");
}

struct Looked {
  const ForeignDescription& description;
  const cosim::Port& port;
  Quantity quantity;
};

[[noreturn]] void refuse(const Looked& looked, const std::string& variable, const std::string& reason) {
  throw ForeignFmuError("port " + looked.port.name + ": variable '" + variable + "' " + reason);
}

const ForeignVariableInfo& find_variable(const Looked& looked, const ForeignQuantity& quantity) {
  const bool given = (looked.port.gives == cosim::Gives::force) == (looked.quantity == Quantity::force);
  const std::string causality = given ? "output" : "input";
  const ForeignVariableInfo* variable = looked.description.find(quantity.variable);
  const std::string offered = "; " + causality + "s of the FMU: " + names_of(looked.description, causality);
  if (variable == nullptr) refuse(looked, quantity.variable, "is missing" + offered);
  if (variable->causality != causality) {
    refuse(looked, quantity.variable, "is " + variable->causality + ", required is " + causality + offered);
  }
  if (!variable->is_real()) {
    refuse(looked, quantity.variable,
           "is of type " + variable->type + (variable->array ? " (array)" : "") +
               ", required is a scalar of type " + (looked.description.version == 2 ? "Real" : "Float64"));
  }
  return *variable;
}

// To SI units, as far as the FMU says what its unit is.
ForeignUnit unit_of(const Looked& looked, const ForeignVariableInfo& variable) {
  const auto found = looked.description.units.find(variable.unit);
  if (found == looked.description.units.end()) return {};
  const std::array<int, 8>& e = found->second.exponents;
  const bool others = e[3] != 0 || e[4] != 0 || e[5] != 0 || e[6] != 0;
  if (others || Dimension{e[0], e[1], e[2]} != dimension_of(looked.port.kind, looked.quantity)) {
    refuse(looked, variable.name,
           "has the unit '" + variable.unit + "', required is one of the kind of " +
               unit_name(looked.port, looked.quantity));
  }
  return found->second;
}

std::optional<ForeignChannel> find_channel(const Looked& looked, const ForeignQuantity& quantity) {
  if (quantity.variable.empty()) return std::nullopt;
  const ForeignVariableInfo& variable = find_variable(looked, quantity);
  const ForeignUnit unit = unit_of(looked, variable);
  ForeignChannel channel;
  channel.reference = variable.reference;
  channel.factor = quantity.factor * unit.factor;
  channel.offset = quantity.factor * unit.offset + quantity.offset;
  channel.follows_velocity = quantity.follows_velocity;
  channel.held = quantity.held.value_or(looked.quantity == Quantity::force ? Held::mean : Held::at_end);
  if (!(std::isfinite(channel.factor) && channel.factor != 0.0 && std::isfinite(channel.offset))) {
    refuse(looked, quantity.variable, "has a factor of zero or one that is not finite");
  }
  return channel;
}

void require_all(const cosim::Port& port, const ForeignPortChannels& channels) {
  const bool motion = port.gives == cosim::Gives::motion;
  const bool enough = motion ? channels.displacement && channels.velocity && channels.force
                             : channels.force && (channels.displacement || channels.velocity);
  if (enough) return;
  throw ForeignFmuError(
      "port " + port.name +
      (motion ? " gives a motion: variables for displacement, velocity and force are required"
              : " gives a force: variables for the force and for displacement or velocity are required"));
}

}  // namespace

std::vector<ForeignPortChannels> find_channels(const ForeignDescription& description,
                                               const std::vector<ForeignPort>& ports) {
  std::vector<ForeignPortChannels> all;
  for (const ForeignPort& port : ports) {
    ForeignPortChannels channels;
    channels.displacement = find_channel({description, port.port, Quantity::displacement}, port.displacement);
    channels.velocity = find_channel({description, port.port, Quantity::velocity}, port.velocity);
    channels.force = find_channel({description, port.port, Quantity::force}, port.force);
    require_all(port.port, channels);
    all.push_back(channels);
  }
  return all;
}

std::vector<const ForeignVariableInfo*> find_start_values(const ForeignDescription& description,
                                                          const std::map<std::string, StartValue>& values) {
  std::vector<const ForeignVariableInfo*> found;
  for (const auto& [name, value] : values) {
    const ForeignVariableInfo* variable = description.find(name);
    if (variable == nullptr) {
      throw ForeignFmuError("no variable '" + name +
                            "'; parameters of the FMU: " + names_of(description, "parameter"));
    }
    const std::string& type = variable->type;
    const bool number = type == "Real" || type == "Integer" || type == "Boolean" || type == "Enumeration" ||
                        type == "Float64" || type == "Int32" || type == "Int64";
    const bool matches = std::holds_alternative<double>(value) ? number : type == "String";
    if (!matches || variable->array) {
      throw ForeignFmuError(
          "variable '" + name + "' is of type " + type + (variable->array ? " (array)" : "") + ", to which " +
          (std::holds_alternative<double>(value) ? "a number" : "a text") + " cannot be set");
    }
    found.push_back(variable);
  }
  return found;
}

}  // namespace orbearing::fmu
