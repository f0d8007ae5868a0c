#include <cstring>
#include <string>

#include "tests/foreign/spring_mass.hpp"

using namespace spring_mass;

extern "C" {

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
  return static_cast<fmi3Status>(end_initialization(c));
}
fmi3Status fmi3Terminate(fmi3Instance c) {
  return static_cast<fmi3Status>(terminate(c));
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
