// The C interface of FMI 2.0 for co-simulation: types, functions and their pointer types, after the standard
// [FMI2]. The functions of model exchange are not among them.
//
// The names are those of the standard, which gives the meaning of each function; here are only the
// signatures. A library that is an FMU defines them, an importer looks them up by name:
// ORBEARING_FMI2_FUNCTIONS lists all of them.
#pragma once

#include <cstddef>

using fmi2Component = void*;
using fmi2ComponentEnvironment = void*;
using fmi2FMUstate = void*;
using fmi2ValueReference = unsigned int;
using fmi2Real = double;
using fmi2Integer = int;
using fmi2Boolean = int;
using fmi2Char = char;
using fmi2String = const fmi2Char*;
using fmi2Byte = char;

inline constexpr fmi2Boolean fmi2True = 1;
inline constexpr fmi2Boolean fmi2False = 0;

enum fmi2Status { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending };
enum fmi2Type { fmi2ModelExchange, fmi2CoSimulation };
enum fmi2StatusKind { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated };

extern "C" {
/// `message` is a format as of printf, and may hold #r<value reference># for names.
using fmi2CallbackLogger = void (*)(fmi2ComponentEnvironment, fmi2String instance, fmi2Status status,
                                    fmi2String category, fmi2String message, ...);
using fmi2CallbackAllocateMemory = void* (*)(size_t number, size_t size);
using fmi2CallbackFreeMemory = void (*)(void* memory);
using fmi2StepFinished = void (*)(fmi2ComponentEnvironment, fmi2Status);
}

struct fmi2CallbackFunctions {
  fmi2CallbackLogger logger;
  fmi2CallbackAllocateMemory allocateMemory;
  fmi2CallbackFreeMemory freeMemory;
  fmi2StepFinished stepFinished;  // may be NULL: all steps are synchronous
  fmi2ComponentEnvironment componentEnvironment;
};

#define ORBEARING_FMI2_LISTS(...) \
  (fmi2Component instance, const fmi2ValueReference references[], size_t number, __VA_ARGS__)
#define ORBEARING_FMI2_FUNCTIONS(F)                                                                          \
  F(const char*, fmi2GetTypesPlatform, ())                                                                   \
  F(const char*, fmi2GetVersion, ())                                                                         \
  F(fmi2Status, fmi2SetDebugLogging,                                                                         \
    (fmi2Component instance, fmi2Boolean on, size_t number, const fmi2String categories[]))                  \
  F(fmi2Component, fmi2Instantiate,                                                                          \
    (fmi2String name, fmi2Type type, fmi2String guid, fmi2String resource_location,                          \
     const fmi2CallbackFunctions* functions, fmi2Boolean visible, fmi2Boolean logging))                      \
  F(void, fmi2FreeInstance, (fmi2Component instance))                                                        \
  F(fmi2Status, fmi2SetupExperiment,                                                                         \
    (fmi2Component instance, fmi2Boolean tolerance_defined, fmi2Real tolerance, fmi2Real start_time,         \
     fmi2Boolean stop_time_defined, fmi2Real stop_time))                                                     \
  F(fmi2Status, fmi2EnterInitializationMode, (fmi2Component instance))                                       \
  F(fmi2Status, fmi2ExitInitializationMode, (fmi2Component instance))                                        \
  F(fmi2Status, fmi2Terminate, (fmi2Component instance))                                                     \
  F(fmi2Status, fmi2Reset, (fmi2Component instance))                                                         \
  F(fmi2Status, fmi2GetReal, ORBEARING_FMI2_LISTS(fmi2Real values[]))                                        \
  F(fmi2Status, fmi2GetInteger, ORBEARING_FMI2_LISTS(fmi2Integer values[]))                                  \
  F(fmi2Status, fmi2GetBoolean, ORBEARING_FMI2_LISTS(fmi2Boolean values[]))                                  \
  F(fmi2Status, fmi2GetString, ORBEARING_FMI2_LISTS(fmi2String values[]))                                    \
  F(fmi2Status, fmi2SetReal, ORBEARING_FMI2_LISTS(const fmi2Real values[]))                                  \
  F(fmi2Status, fmi2SetInteger, ORBEARING_FMI2_LISTS(const fmi2Integer values[]))                            \
  F(fmi2Status, fmi2SetBoolean, ORBEARING_FMI2_LISTS(const fmi2Boolean values[]))                            \
  F(fmi2Status, fmi2SetString, ORBEARING_FMI2_LISTS(const fmi2String values[]))                              \
  F(fmi2Status, fmi2GetFMUstate, (fmi2Component instance, fmi2FMUstate * state))                             \
  F(fmi2Status, fmi2SetFMUstate, (fmi2Component instance, fmi2FMUstate state))                               \
  F(fmi2Status, fmi2FreeFMUstate, (fmi2Component instance, fmi2FMUstate * state))                            \
  F(fmi2Status, fmi2SerializedFMUstateSize, (fmi2Component instance, fmi2FMUstate state, size_t * size))     \
  F(fmi2Status, fmi2SerializeFMUstate,                                                                       \
    (fmi2Component instance, fmi2FMUstate state, fmi2Byte bytes[], size_t size))                             \
  F(fmi2Status, fmi2DeSerializeFMUstate,                                                                     \
    (fmi2Component instance, const fmi2Byte bytes[], size_t size, fmi2FMUstate* state))                      \
  F(fmi2Status, fmi2GetDirectionalDerivative,                                                                \
    (fmi2Component instance, const fmi2ValueReference unknowns[], size_t unknown_number,                     \
     const fmi2ValueReference knowns[], size_t known_number, const fmi2Real seed[], fmi2Real sensitivity[])) \
  F(fmi2Status, fmi2SetRealInputDerivatives,                                                                 \
    ORBEARING_FMI2_LISTS(const fmi2Integer orders[], const fmi2Real values[]))                               \
  F(fmi2Status, fmi2GetRealOutputDerivatives,                                                                \
    ORBEARING_FMI2_LISTS(const fmi2Integer orders[], fmi2Real values[]))                                     \
  F(fmi2Status, fmi2DoStep,                                                                                  \
    (fmi2Component instance, fmi2Real time, fmi2Real step_size, fmi2Boolean no_set_state_prior))             \
  F(fmi2Status, fmi2CancelStep, (fmi2Component instance))                                                    \
  F(fmi2Status, fmi2GetStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2Status * value))            \
  F(fmi2Status, fmi2GetRealStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2Real * value))          \
  F(fmi2Status, fmi2GetIntegerStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2Integer * value))    \
  F(fmi2Status, fmi2GetBooleanStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2Boolean * value))    \
  F(fmi2Status, fmi2GetStringStatus, (fmi2Component instance, fmi2StatusKind kind, fmi2String * value))

// name ## TYPE: type of the function, as the standard calls it.
extern "C" {
#define ORBEARING_DECLARE(result, name, arguments) \
  using name##TYPE = result arguments;             \
  name##TYPE name;
ORBEARING_FMI2_FUNCTIONS(ORBEARING_DECLARE)
#undef ORBEARING_DECLARE
}
