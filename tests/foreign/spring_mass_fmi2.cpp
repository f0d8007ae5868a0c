#include <cstring>
#include <string>

#include "tests/foreign/spring_mass.hpp"

using namespace spring_mass;

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
  return static_cast<fmi2Status>(end_initialization(c));
}
fmi2Status fmi2Terminate(fmi2Component c) {
  return static_cast<fmi2Status>(terminate(c));
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
  *state = new State{alive(c).state};
  return fmi2OK;
}
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  alive(c).state = *static_cast<State*>(state);
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
  *state = new State{copy};
  return fmi2OK;
}
}
