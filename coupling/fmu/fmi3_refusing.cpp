// Functions of FMI 3.0 for what these FMUs have not: other types of variables, clocks, events, configuration,
// derivatives by time, model exchange and scheduled execution. They exist since importers look all of them
// up; each says what is missing.
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
constexpr const char* kNoClocks = "found a call for clocks; the model has none";
constexpr const char* kNoExchange = "found a call of model exchange; required: co-simulation";

}  // namespace

extern "C" {

#define ORBEARING_ONLY_EMPTY(name, ...)                                                           \
  fmi3Status name(fmi3Instance instance, const fmi3ValueReference*, size_t number, __VA_ARGS__) { \
    return only_empty(instance, __func__, number);                                                \
  }
ORBEARING_ONLY_EMPTY(fmi3GetFloat32, fmi3Float32*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetFloat32, const fmi3Float32*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetInt8, fmi3Int8*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetInt8, const fmi3Int8*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetUInt8, fmi3UInt8*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetUInt8, const fmi3UInt8*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetInt16, fmi3Int16*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetInt16, const fmi3Int16*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetUInt16, fmi3UInt16*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetUInt16, const fmi3UInt16*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetUInt32, fmi3UInt32*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetUInt32, const fmi3UInt32*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetInt64, fmi3Int64*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetInt64, const fmi3Int64*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetUInt64, fmi3UInt64*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetUInt64, const fmi3UInt64*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetBoolean, fmi3Boolean*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetBoolean, const fmi3Boolean*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetString, fmi3String*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetString, const fmi3String*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetInt32, const fmi3Int32*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetBinary, size_t*, fmi3Binary*, size_t)
ORBEARING_ONLY_EMPTY(fmi3SetBinary, const size_t*, const fmi3Binary*, size_t)
ORBEARING_ONLY_EMPTY(fmi3GetClock, fmi3Clock*)
ORBEARING_ONLY_EMPTY(fmi3SetClock, const fmi3Clock*)
ORBEARING_ONLY_EMPTY(fmi3GetIntervalDecimal, fmi3Float64*, fmi3IntervalQualifier*)
ORBEARING_ONLY_EMPTY(fmi3GetIntervalFraction, fmi3UInt64*, fmi3UInt64*, fmi3IntervalQualifier*)
ORBEARING_ONLY_EMPTY(fmi3GetShiftDecimal, fmi3Float64*)
ORBEARING_ONLY_EMPTY(fmi3GetShiftFraction, fmi3UInt64*, fmi3UInt64*)
ORBEARING_ONLY_EMPTY(fmi3SetIntervalDecimal, const fmi3Float64*)
ORBEARING_ONLY_EMPTY(fmi3SetIntervalFraction, const fmi3UInt64*, const fmi3UInt64*)
ORBEARING_ONLY_EMPTY(fmi3SetShiftDecimal, const fmi3Float64*)
ORBEARING_ONLY_EMPTY(fmi3SetShiftFraction, const fmi3UInt64*, const fmi3UInt64*)
ORBEARING_ONLY_EMPTY(fmi3GetOutputDerivatives, const fmi3Int32*, fmi3Float64*, size_t)
#undef ORBEARING_ONLY_EMPTY

#define ORBEARING_REFUSED(reason, name, ...)                          \
  fmi3Status name(fmi3Instance instance __VA_OPT__(, ) __VA_ARGS__) { \
    return refused(instance, __func__, reason);                       \
  }
ORBEARING_REFUSED(kNoEvents, fmi3EnterEventMode)
ORBEARING_REFUSED(kNoEvents, fmi3EnterStepMode)
ORBEARING_REFUSED(kNoEvents, fmi3EvaluateDiscreteStates)
ORBEARING_REFUSED(kNoEvents, fmi3UpdateDiscreteStates, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*,
                  fmi3Boolean*, fmi3Float64*)
ORBEARING_REFUSED("found a call of configuration mode; the model has no structural parameters",
                  fmi3EnterConfigurationMode)
ORBEARING_REFUSED("found a call of configuration mode; the model has no structural parameters",
                  fmi3ExitConfigurationMode)
ORBEARING_REFUSED(kNoExchange, fmi3EnterContinuousTimeMode)
ORBEARING_REFUSED(kNoExchange, fmi3CompletedIntegratorStep, fmi3Boolean, fmi3Boolean*, fmi3Boolean*)
ORBEARING_REFUSED(kNoExchange, fmi3SetTime, fmi3Float64)
ORBEARING_REFUSED(kNoExchange, fmi3SetContinuousStates, const fmi3Float64*, size_t)
ORBEARING_REFUSED(kNoExchange, fmi3GetContinuousStateDerivatives, fmi3Float64*, size_t)
ORBEARING_REFUSED(kNoExchange, fmi3GetEventIndicators, fmi3Float64*, size_t)
ORBEARING_REFUSED(kNoExchange, fmi3GetContinuousStates, fmi3Float64*, size_t)
ORBEARING_REFUSED(kNoExchange, fmi3GetNominalsOfContinuousStates, fmi3Float64*, size_t)
ORBEARING_REFUSED(kNoExchange, fmi3GetNumberOfEventIndicators, size_t*)
ORBEARING_REFUSED(kNoExchange, fmi3GetNumberOfContinuousStates, size_t*)
ORBEARING_REFUSED(kNoClocks, fmi3ActivateModelPartition, fmi3ValueReference, fmi3Float64)
#undef ORBEARING_REFUSED

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
