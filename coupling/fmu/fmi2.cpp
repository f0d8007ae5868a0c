// The C interface of FMI 2.0 over an instance: co-simulation.
#include "coupling/fmu/fmi2.hpp"

#include <array>

#include "coupling/fmu/guard.hpp"

namespace {

using orbearing::fmu::Instance;
using orbearing::fmu::InstanceState;
using orbearing::fmu::Log;
using orbearing::fmu::References;
using orbearing::fmu::Refused;
using orbearing::fmu::require_position;
using orbearing::fmu::Status;

template <class Body>
fmi2Status guarded(void* component, const char* function, Body&& body) noexcept {
  return static_cast<fmi2Status>(orbearing::fmu::guarded(component, function, std::forward<Body>(body)));
}

// The message is a format for the logger.
std::string format_of(const char* text) {
  std::string format;
  for (; *text != '\0'; ++text) {
    if (*text == '%' || *text == '#') format += *text;
    format += *text;
  }
  return format;
}

Log log_of(const fmi2CallbackFunctions* functions, const std::string& name) {
  if (functions == nullptr || functions->logger == nullptr) return {};
  return [log = functions->logger, environment = functions->componentEnvironment, name](
             Status status, const char* category, const char* text) {
    log(environment, name.c_str(), static_cast<fmi2Status>(status), category, format_of(text).c_str());
  };
}

// No variable is Boolean or a string.
fmi2Status no_variables(void* component, const char* function, size_t number) {
  return guarded(component, function, [&](Instance&) {
    if (number > 0) throw Refused("value reference: found one of a type that no variable has");
  });
}

}  // namespace

extern "C" {

const char* fmi2GetTypesPlatform() {
  return "default";
}
const char* fmi2GetVersion() {
  return "2.0";
}

fmi2Status fmi2SetDebugLogging(fmi2Component instance, fmi2Boolean on, size_t number,
                               const fmi2String categories[]) {
  return guarded(instance, __func__, [&](Instance& it) {
    it.set_logging(on != fmi2False, orbearing::fmu::categories_of(number, categories));
  });
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resource_location,
                              const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean logging) {
  try {
    const Log log = log_of(functions, name == nullptr ? "" : name);
    const char* wrong = type != fmi2CoSimulation ? "found model exchange; required: co-simulation"
                        : name == nullptr || *name == '\0'
                            ? "found an instance without name; required: a name"
                            : nullptr;
    return orbearing::fmu::new_instance(__func__, wrong, guid, resource_location, log, logging != fmi2False);
  } catch (...) {  // no memory for the logger
  }
  return nullptr;
}

void fmi2FreeInstance(fmi2Component instance) {
  delete static_cast<Instance*>(instance);
}

fmi2Status fmi2SetupExperiment(fmi2Component instance, fmi2Boolean, fmi2Real, fmi2Real start_time,
                               fmi2Boolean stop_time_defined, fmi2Real stop_time) {
  return guarded(instance, __func__, [&](Instance& it) {
    it.setup_experiment(
        {start_time, stop_time_defined != fmi2False ? std::optional(stop_time) : std::nullopt});
  });
}

fmi2Status fmi2EnterInitializationMode(fmi2Component instance) {
  return guarded(instance, __func__, [](Instance& it) { it.enter_initialization(); });
}
fmi2Status fmi2ExitInitializationMode(fmi2Component instance) {
  return guarded(instance, __func__, [](Instance& it) { it.exit_initialization(); });
}
fmi2Status fmi2Terminate(fmi2Component instance) {
  return guarded(instance, __func__, [](Instance& it) { it.terminate(); });
}
fmi2Status fmi2Reset(fmi2Component instance) {
  return guarded(instance, __func__, [](Instance& it) { it.reset(); });
}

fmi2Status fmi2GetReal(fmi2Component instance, const fmi2ValueReference references[], size_t number,
                       fmi2Real values[]) {
  return guarded(instance, __func__, [&](Instance& it) { it.get({references, number}, values); });
}
fmi2Status fmi2GetInteger(fmi2Component instance, const fmi2ValueReference references[], size_t number,
                          fmi2Integer values[]) {
  return guarded(instance, __func__, [&](Instance& it) { it.get_whole({references, number}, values); });
}
fmi2Status fmi2GetBoolean(fmi2Component instance, const fmi2ValueReference*, size_t number, fmi2Boolean*) {
  return no_variables(instance, __func__, number);
}
fmi2Status fmi2GetString(fmi2Component instance, const fmi2ValueReference*, size_t number, fmi2String*) {
  return no_variables(instance, __func__, number);
}

fmi2Status fmi2SetReal(fmi2Component instance, const fmi2ValueReference references[], size_t number,
                       const fmi2Real values[]) {
  return guarded(instance, __func__, [&](Instance& it) { it.set({references, number}, values); });
}
fmi2Status fmi2SetInteger(fmi2Component instance, const fmi2ValueReference*, size_t number,
                          const fmi2Integer*) {
  return guarded(instance, __func__, [&](Instance&) {
    if (number > 0) throw Refused("value to set: found an integer; required: an input or a parameter");
  });
}
fmi2Status fmi2SetBoolean(fmi2Component instance, const fmi2ValueReference*, size_t number,
                          const fmi2Boolean*) {
  return no_variables(instance, __func__, number);
}
fmi2Status fmi2SetString(fmi2Component instance, const fmi2ValueReference*, size_t number,
                         const fmi2String*) {
  return no_variables(instance, __func__, number);
}

fmi2Status fmi2GetFMUstate(fmi2Component instance, fmi2FMUstate* state) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_position(state, "state");
    *state = it.keep_state(static_cast<InstanceState*>(*state));
  });
}
fmi2Status fmi2SetFMUstate(fmi2Component instance, fmi2FMUstate state) {
  return guarded(instance, __func__,
                 [&](Instance& it) { it.go_to_state(static_cast<InstanceState*>(state)); });
}
fmi2Status fmi2FreeFMUstate(fmi2Component instance, fmi2FMUstate* state) {
  return guarded(instance, __func__, [&](Instance& it) {
    if (state == nullptr) return;
    it.free_state(static_cast<InstanceState*>(*state));
    *state = nullptr;
  });
}
fmi2Status fmi2SerializedFMUstateSize(fmi2Component instance, fmi2FMUstate state, size_t* size) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_position(size, "size");
    *size = it.state_size(static_cast<InstanceState*>(state));
  });
}
fmi2Status fmi2SerializeFMUstate(fmi2Component instance, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
  return guarded(instance, __func__,
                 [&](Instance& it) { it.serialize(static_cast<InstanceState*>(state), bytes, size); });
}
fmi2Status fmi2DeSerializeFMUstate(fmi2Component instance, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate* state) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_position(state, "state");
    *state = it.deserialize(bytes, size, static_cast<InstanceState*>(*state));
  });
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component instance, const fmi2ValueReference unknowns[],
                                        size_t unknown_number, const fmi2ValueReference knowns[],
                                        size_t known_number, const fmi2Real seed[], fmi2Real sensitivity[]) {
  return guarded(instance, __func__, [&](Instance& it) {
    it.directional({unknowns, unknown_number}, {knowns, known_number}, seed, sensitivity);
  });
}
fmi2Status fmi2SetRealInputDerivatives(fmi2Component instance, const fmi2ValueReference references[],
                                       size_t number, const fmi2Integer orders[], const fmi2Real values[]) {
  return guarded(instance, __func__, [&](Instance& it) {
    it.set_derivatives({references, number}, orders, values);
  });
}
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component instance, const fmi2ValueReference*, size_t number,
                                        const fmi2Integer*, fmi2Real*) {
  return guarded(instance, __func__, [&](Instance&) {
    if (number > 0) throw Refused("derivatives of outputs by time: found a call; there are none");
  });
}

fmi2Status fmi2DoStep(fmi2Component instance, fmi2Real time, fmi2Real step_size, fmi2Boolean) {
  return guarded(instance, __func__, [&](Instance& it) { it.step(time, step_size); });
}
fmi2Status fmi2CancelStep(fmi2Component instance) {
  return guarded(instance, __func__, [](Instance&) { throw Refused("found no step that is under way"); });
}

}  // extern "C"

namespace {

[[noreturn]] void no_status() {
  throw Refused(Status::discard, "status: found a kind that does not apply; no step is ever pending");
}

}  // namespace

extern "C" {

fmi2Status fmi2GetStatus(fmi2Component instance, fmi2StatusKind, fmi2Status*) {
  return guarded(instance, __func__, [](Instance&) { no_status(); });
}
fmi2Status fmi2GetRealStatus(fmi2Component instance, fmi2StatusKind kind, fmi2Real* value) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_position(value, "value");
    if (kind != fmi2LastSuccessfulTime) no_status();
    *value = it.time();
  });
}
fmi2Status fmi2GetIntegerStatus(fmi2Component instance, fmi2StatusKind, fmi2Integer*) {
  return guarded(instance, __func__, [](Instance&) { no_status(); });
}
fmi2Status fmi2GetBooleanStatus(fmi2Component instance, fmi2StatusKind kind, fmi2Boolean* value) {
  return guarded(instance, __func__, [&](Instance&) {
    require_position(value, "value");
    if (kind != fmi2Terminated) no_status();
    *value = fmi2False;  // an instance ends at the request of its importer
  });
}
fmi2Status fmi2GetStringStatus(fmi2Component instance, fmi2StatusKind, fmi2String*) {
  return guarded(instance, __func__, [](Instance&) { no_status(); });
}

}  // extern "C"
