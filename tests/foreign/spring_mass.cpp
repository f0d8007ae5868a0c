// An FMU for the tests of the import, of both versions of FMI: a body on a spring of its own, moved by a
// force, and beside it a spring with a damper that others move. It can be told to fail in each way in which
// an FMU may fail.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

#include "coupling/fmu/fmi2.hpp"
#include "coupling/fmu/fmi3.hpp"

namespace {

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

Instance& alive(void* component) {
  auto& instance = *static_cast<Instance*>(component);
  if (instance.dead) std::abort();
  return instance;
}

double force_at(const State& state, double since) {
  const auto& d = state.slopes;
  return state.real[force] + since * (d[0] + since * (d[1] / 2.0 + since * d[2] / 6.0));
}

// The classical Runge-Kutta scheme: exact for cubics.
void move(State& state, double length) {
  const auto& r = state.real;
  const int steps = std::max(1, static_cast<int>(std::ceil(length / 1e-5)));
  const double h = length / steps;
  const auto acceleration = [&](double t, double x, double v) {
    return (force_at(state, t) - r[stiffness] * x - r[damping] * v) / r[mass];
  };
  double x = r[displacement] * 1e-3, v = r[velocity];  // mm outside
  for (int k = 0; k < steps; ++k) {
    const double t = k * h;
    const double a1 = acceleration(t, x, v), v2 = v + h / 2 * a1;
    const double a2 = acceleration(t + h / 2, x + h / 2 * v, v2), v3 = v + h / 2 * a2;
    const double a3 = acceleration(t + h / 2, x + h / 2 * v2, v3), v4 = v + h * a3;
    const double a4 = acceleration(t + h, x + h * v3, v4);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  state.real[displacement] = x * 1e3;
  state.real[velocity] = v;
}

// A status of either version: both count OK 0, Warning 1, Discard 2, Error 3, Fatal 4.
int step(Instance& instance, double length) {
  State& state = instance.state;
  if (instance.fault == discards_long_steps && length > state.real[longest_step] * (1.0 + 1e-9)) {
    instance.log(2, "the step is too long");
    move(state, length / 2.0);  // and is left halfway
    state.time += length / 2.0;
    return 2;
  }
  if (instance.fault == fails || instance.fault == breaks_down) {
    instance.log(instance.fault == fails ? 3 : 4, "the spring broke");
    instance.dead = instance.fault == breaks_down;
    return instance.fault == fails ? 3 : 4;
  }
  move(state, length);
  state.slopes = {};
  state.time += length;
  return 0;
}

template <typename References, typename Values>
int set_reals(void* component, const References* references, std::size_t number, const Values* values) {
  Instance& instance = alive(component);
  for (std::size_t i = 0; i < number; ++i) {
    if (references[i] >= reals) return 3;
    instance.state.real[references[i]] = values[i];
  }
  return 0;
}

int get_reals(void* component, const unsigned* references, std::size_t number, double* values) {
  Instance& instance = alive(component);
  auto& r = instance.state.real;
  r[spring_force] = -r[spring_stiffness] * r[moved] - r[spring_damping] * r[moved_velocity];
  for (std::size_t i = 0; i < number; ++i) {
    if (references[i] >= reals) return 3;
    values[i] = instance.fault == gives_nan ? std::numeric_limits<double>::quiet_NaN() : r[references[i]];
  }
  return 0;
}

void start(Instance& instance) {
  auto& r = instance.state.real;
  r[mass] = 1.0;
  r[longest_step] = 1.0;
}

void* new_state(const State& state) {
  return new State{state};
}
State& as_state(void* state) {
  return *static_cast<State*>(state);
}

}  // namespace

extern "C" {

const char* fmi2GetTypesPlatform() {
  return "default";
}
const char* fmi2GetVersion() {
  return "2.0";
}
fmi2Component fmi2Instantiate(fmi2String, fmi2Type, fmi2String token, fmi2String resources,
                              const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean) {
  if (std::strncmp(resources, "file:///", 8) != 0) return nullptr;
  if (std::string(token) != "the token") {
    functions->logger(functions->componentEnvironment, "test", fmi2Error, "logStatus", "wrong token %s",
                      token);
    return nullptr;
  }
  auto* instance = new Instance;
  instance->environment = functions->componentEnvironment;
  instance->second = functions;
  start(*instance);
  return instance;
}
void fmi2FreeInstance(fmi2Component c) {
  delete &alive(c);
}
fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean, fmi2Real, fmi2Real time, fmi2Boolean, fmi2Real) {
  alive(c).state.time = time;
  return fmi2OK;
}
fmi2Status fmi2EnterInitializationMode(fmi2Component) {
  return fmi2OK;
}
fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  if (!alive(c).strict) return fmi2OK;
  alive(c).log(3, alive(c).label.c_str());
  return fmi2Error;
}
fmi2Status fmi2Terminate(fmi2Component c) {
  return alive(c).fault == fails ? std::abort(), fmi2OK : fmi2OK;
}
fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2Real v[]) {
  return static_cast<fmi2Status>(set_reals(c, r, n, v));
}
fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference r[], size_t, const fmi2Integer v[]) {
  alive(c).fault = *v;
  return *r == fault ? fmi2OK : fmi2Error;
}
fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference r[], size_t, const fmi2Boolean v[]) {
  alive(c).strict = *v != 0;
  return *r == strict ? fmi2OK : fmi2Error;
}
fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference r[], size_t, const fmi2String v[]) {
  alive(c).label = *v;
  return *r == label ? fmi2OK : fmi2Error;
}
fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2Real v[]) {
  return static_cast<fmi2Status>(get_reals(c, r, n, v));
}
fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference r[], size_t n,
                                       const fmi2Integer o[], const fmi2Real v[]) {
  for (std::size_t i = 0; i < n; ++i) {
    if (r[i] == force) alive(c).state.slopes[static_cast<std::size_t>(o[i] - 1)] = v[i];
  }
  return fmi2OK;
}
fmi2Status fmi2DoStep(fmi2Component c, fmi2Real, fmi2Real length, fmi2Boolean) {
  return static_cast<fmi2Status>(step(alive(c), length));
}
fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind, fmi2Real* value) {
  *value = alive(c).state.time;
  return fmi2OK;
}
fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state) {
  *state = new_state(alive(c).state);
  return fmi2OK;
}
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  alive(c).state = as_state(state);
  return fmi2OK;
}
fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
  alive(c);
  delete static_cast<State*>(*state);
  *state = nullptr;
  return fmi2OK;
}
fmi2Status fmi2SerializedFMUstateSize(fmi2Component, fmi2FMUstate, size_t* size) {
  *size = sizeof(State) + 1;  // not a multiple of the bytes in a number
  return fmi2OK;
}
fmi2Status fmi2SerializeFMUstate(fmi2Component, fmi2FMUstate state, fmi2Byte bytes[], size_t) {
  std::memcpy(bytes, state, sizeof(State));
  bytes[sizeof(State)] = 'e';
  return fmi2OK;
}
fmi2Status fmi2DeSerializeFMUstate(fmi2Component, const fmi2Byte bytes[], size_t size, fmi2FMUstate* state) {
  if (size != sizeof(State) + 1 || bytes[sizeof(State)] != 'e') return fmi2Error;
  State copy;
  std::memcpy(&copy, bytes, sizeof(State));
  *state = new_state(copy);
  return fmi2OK;
}

const char* fmi3GetVersion() {
  return "3.0";
}
fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String resources, fmi3Boolean,
                                         fmi3Boolean, fmi3Boolean, fmi3Boolean, const fmi3ValueReference[],
                                         size_t, fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback) {
  if (resources[0] != '/' || resources[std::strlen(resources) - 1] != '/') return nullptr;
  if (std::string(token) != "the token") {
    log(environment, fmi3Error, "logStatus", ("wrong token " + std::string(token)).c_str());
    return nullptr;
  }
  auto* instance = new Instance;
  instance->environment = environment;
  instance->third = log;
  start(*instance);
  return instance;
}
void fmi3FreeInstance(fmi3Instance c) {
  delete &alive(c);
}
fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean, fmi3Float64, fmi3Float64 time,
                                       fmi3Boolean, fmi3Float64) {
  alive(c).state.time = time;
  return fmi3OK;
}
fmi3Status fmi3ExitInitializationMode(fmi3Instance c) {
  return static_cast<fmi3Status>(fmi2ExitInitializationMode(c));
}
fmi3Status fmi3Terminate(fmi3Instance c) {
  return static_cast<fmi3Status>(fmi2Terminate(c));
}
fmi3Status fmi3SetFloat64(fmi3Instance c, const fmi3ValueReference r[], size_t n, const fmi3Float64 v[],
                          size_t) {
  return static_cast<fmi3Status>(set_reals(c, r, n, v));
}
fmi3Status fmi3SetInt32(fmi3Instance c, const fmi3ValueReference r[], size_t, const fmi3Int32 v[], size_t) {
  alive(c).fault = *v;
  return *r == fault ? fmi3OK : fmi3Error;
}
fmi3Status fmi3SetInt64(fmi3Instance, const fmi3ValueReference[], size_t, const fmi3Int64[], size_t) {
  return fmi3Error;
}
fmi3Status fmi3SetBoolean(fmi3Instance c, const fmi3ValueReference r[], size_t, const fmi3Boolean v[],
                          size_t) {
  alive(c).strict = *v;
  return *r == strict ? fmi3OK : fmi3Error;
}
fmi3Status fmi3SetString(fmi3Instance c, const fmi3ValueReference r[], size_t, const fmi3String v[], size_t) {
  alive(c).label = *v;
  return *r == label ? fmi3OK : fmi3Error;
}
fmi3Status fmi3GetFloat64(fmi3Instance c, const fmi3ValueReference r[], size_t n, fmi3Float64 v[], size_t) {
  return static_cast<fmi3Status>(get_reals(c, r, n, v));
}
fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64, fmi3Float64 length, fmi3Boolean, fmi3Boolean* event,
                      fmi3Boolean* terminate, fmi3Boolean* early, fmi3Float64* reached) {
  *event = *terminate = *early = false;
  const int status = step(alive(c), length);
  *reached = static_cast<Instance*>(c)->state.time;
  return static_cast<fmi3Status>(status);
}
fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState* s) {
  return static_cast<fmi3Status>(fmi2GetFMUstate(c, s));
}
fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState s) {
  return static_cast<fmi3Status>(fmi2SetFMUstate(c, s));
}
fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState* s) {
  return static_cast<fmi3Status>(fmi2FreeFMUstate(c, s));
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState s, size_t* size) {
  return static_cast<fmi3Status>(fmi2SerializedFMUstateSize(c, s, size));
}
fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState s, fmi3Byte bytes[], size_t size) {
  return static_cast<fmi3Status>(fmi2SerializeFMUstate(c, s, reinterpret_cast<fmi2Byte*>(bytes), size));
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState* s) {
  return static_cast<fmi3Status>(
      fmi2DeSerializeFMUstate(c, reinterpret_cast<const fmi2Byte*>(bytes), size, s));
}
}
