// Functions of FMI 3.0 for what these FMUs have not: other types of variables, clocks, events, configuration,
// derivatives by time, model exchange and scheduled execution. They exist since importers look all of them
// up; each reports what is missing.
#include "coupling/fmu/fmi3.hpp"
#include "coupling/fmu/guard.hpp"

namespace {

using orbearing::fmu::Instance;
using orbearing::fmu::Refused;

fmi3Status refused(void* component, const char* function, const char* reason) noexcept {
  return static_cast<fmi3Status>(
      orbearing::fmu::guarded(component, function, [&](Instance&) { throw Refused(reason); }));
}

// An empty list of any type is legal.
fmi3Status only_empty(void* component, const char* function, size_t number) noexcept {
  return static_cast<fmi3Status>(orbearing::fmu::guarded(component, function, [&](Instance&) {
    if (number > 0) throw Refused("value reference: found one of a type that no such variable has");
  }));
}

constexpr const char* kNoEvents = "found a call of event mode; the model has no events";
constexpr const char* kNoStructure =
    "found a call of configuration mode; the model has no structural parameters";
constexpr const char* kNoClocks = "found a call for clocks; the model has none";
constexpr const char* kNoExchange = "found a call of model exchange; required: co-simulation";

}  // namespace

extern "C" {

// The functions use only the instance and the length of a list.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#define ORBEARING_ONLY_EMPTY(result, name, arguments) \
  result name arguments {                             \
    return only_empty(instance, __func__, number);    \
  }
ORBEARING_FMI3_OTHER_VARIABLES(ORBEARING_ONLY_EMPTY)
#undef ORBEARING_ONLY_EMPTY

#define ORBEARING_REFUSED(reason, result, name, arguments) \
  result name arguments {                                  \
    return refused(instance, __func__, reason);            \
  }
#define ORBEARING_NO_EVENTS(...) ORBEARING_REFUSED(kNoEvents, __VA_ARGS__)
#define ORBEARING_NO_STRUCTURE(...) ORBEARING_REFUSED(kNoStructure, __VA_ARGS__)
#define ORBEARING_NO_EXCHANGE(...) ORBEARING_REFUSED(kNoExchange, __VA_ARGS__)
#define ORBEARING_NO_CLOCKS(...) ORBEARING_REFUSED(kNoClocks, __VA_ARGS__)
ORBEARING_FMI3_EVENTS(ORBEARING_NO_EVENTS)
ORBEARING_FMI3_CONFIGURATION(ORBEARING_NO_STRUCTURE)
ORBEARING_FMI3_MODEL_EXCHANGE(ORBEARING_NO_EXCHANGE)
ORBEARING_FMI3_SCHEDULED_EXECUTION(ORBEARING_NO_CLOCKS)
#pragma GCC diagnostic pop

fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
  if (log != nullptr) log(environment, fmi3Error, "logStatusError", kNoExchange);
  return nullptr;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                               fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback log, fmi3ClockUpdateCallback,
                                               fmi3LockPreemptionCallback, fmi3UnlockPreemptionCallback) {
  if (log != nullptr) log(environment, fmi3Error, "logStatusError", kNoClocks);
  return nullptr;
}

}  // extern "C"
