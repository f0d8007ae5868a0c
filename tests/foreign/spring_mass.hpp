// A model for the tests of the import, as an FMU of both versions of FMI: a body on a spring of its own,
// moved by a force, and beside it a spring with a damper that others move. It can be told to fail in each way
// in which an FMU may fail.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "coupling/fmu/fmi2.hpp"
#include "coupling/fmu/fmi3.hpp"

namespace spring_mass {

enum Reference : unsigned {
  mass,
  stiffness,
  damping,
  force,
  displacement,
  velocity,
  moved,
  moved_velocity,
  spring_force,
  spring_stiffness,
  spring_damping,
  longest_step,
  reals
};
constexpr unsigned fault = 20, label = 21, strict = 22;
enum Fault { none, discards_long_steps, fails, breaks_down, gives_nan };

// Numbers alone, so that a state is a copy.
struct State {
  std::array<double, reals> real{};
  std::array<double, 3> slopes{};  // of the force: by time, order 1 to 3
  double time = 0.0;
};

struct Instance {
  State state;
  int fault = none;
  bool strict = false;
  bool dead = false;  // after Fatal no function may be called
  std::string label = "label";
  void* environment = nullptr;
  const fmi2CallbackFunctions* second = nullptr;
  fmi3LogMessageCallback third = nullptr;

  void log(int status, const char* text) const {
    if (second != nullptr) {
      second->logger(environment, "test", static_cast<fmi2Status>(status), "logStatus", "%s (%d)", text, 42);
    } else {
      third(environment, static_cast<fmi3Status>(status), "logStatus", text);
    }
  }
};

/// Aborts where the instance may not be called any more.
Instance& alive(void* component);

// Statuses of either version: both count OK 0, Warning 1, Discard 2, Error 3, Fatal 4.
int step(Instance& instance, double length);
int set_reals(void* component, const unsigned* references, std::size_t number, const double* values);
int get_reals(void* component, const unsigned* references, std::size_t number, double* values);
int end_initialization(void* component);
int terminate(void* component);
void start(Instance& instance);

}  // namespace spring_mass
