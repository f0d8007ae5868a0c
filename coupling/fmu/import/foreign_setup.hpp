// How an FMU that others made takes part: which of its variables are the quantities of which port.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coupling/cosim/port.hpp"
#include "coupling/fmu/import/foreign_instance.hpp"

namespace orbearing::fmu {

/// What an input that the FMU holds over a step is held at.
enum class Held { at_begin, mean, at_end };

/// quantity of the port = factor x variable + offset, all in SI units: where the FMU states the base units of
/// its variable, these are converted; where it states none, they are taken as SI.
struct ForeignQuantity {
  std::string variable;                     // empty: the FMU has no such quantity
  double factor = 1.0;                      // [-]  e.g. -1 where the FMU counts the other way
  double offset = 0.0;                      // [unit of the quantity]
  std::optional<Held> held = std::nullopt;  // where not stated: mean for forces, at_end for motions
  /// The FMU lets this displacement go on with the velocity beside it: it gets its value at the beginning and
  /// no derivatives.
  bool follows_velocity = false;
};

/// A giver of motion has all three; a giver of force has the force and at least one of the motions.
struct ForeignPort {
  cosim::Port port;
  ForeignQuantity displacement;
  ForeignQuantity velocity;
  ForeignQuantity force;
};

struct ForeignSetup {
  std::filesystem::path file;
  std::string name;  // of the participant; the name of the model where empty
  std::vector<ForeignPort> ports;
  /// Of parameters, and of inputs that no port drives; in the units of the FMU.
  std::map<std::string, StartValue> values;
  /// Communication steps in one window. Inputs that are held are held over one such step.
  int steps_per_window = 1;
  /// Highest order of the derivatives that an FMU gets which interpolates its inputs (FMI 2.0).
  int slopes = 1;
  /// The FMU answers inputs that are set between two steps with outputs that belong to them. Many do; FMI 2.0
  /// does not promise it. Where false, outputs after set_input() are still those of the last step.
  bool answers_between_steps = false;
  /// Libraries that the FMU expects its host to have loaded, e.g. libpython3.11.so.1.0.
  std::vector<std::string> host_libraries;
};

/// A quantity of a port found in an FMU: quantity = factor x variable + offset.
struct ForeignChannel {
  unsigned reference = 0;
  double factor = 1.0;
  double offset = 0.0;
  Held held = Held::at_end;
  bool follows_velocity = false;
};

/// The three quantities of one port; those that the FMU has not are empty.
struct ForeignPortChannels {
  std::optional<ForeignChannel> displacement, velocity, force;
};

/// Throws ForeignFmuError where a variable is missing, of another type, causality or unit, or where a port
/// lacks a quantity that it needs.
std::vector<ForeignPortChannels> find_channels(const ForeignDescription& description,
                                               const std::vector<ForeignPort>& ports);

/// Of `values`, in the order of their names. Throws where one is missing or cannot be set.
std::vector<const ForeignVariableInfo*> find_start_values(const ForeignDescription& description,
                                                          const std::map<std::string, StartValue>& values);

}  // namespace orbearing::fmu
