// The C interface of FMI 3.0: types, functions and their pointer types, after the standard [FMI3].
//
// The names are those of the standard, which gives the meaning of each function; here are only the
// signatures. A library that is an FMU defines them, an importer looks them up by name:
// ORBEARING_FMI3_FUNCTIONS lists those that our FMUs carry out, the other lists those that they refuse.
#pragma once

#include <cstddef>
#include <cstdint>

using fmi3Instance = void*;
using fmi3InstanceEnvironment = void*;
using fmi3FMUState = void*;
using fmi3ValueReference = std::uint32_t;
using fmi3Float32 = float;
using fmi3Float64 = double;
using fmi3Int8 = std::int8_t;
using fmi3UInt8 = std::uint8_t;
using fmi3Int16 = std::int16_t;
using fmi3UInt16 = std::uint16_t;
using fmi3Int32 = std::int32_t;
using fmi3UInt32 = std::uint32_t;
using fmi3Int64 = std::int64_t;
using fmi3UInt64 = std::uint64_t;
using fmi3Boolean = bool;
using fmi3Char = char;
using fmi3String = const fmi3Char*;
using fmi3Byte = std::uint8_t;
using fmi3Binary = const fmi3Byte*;
using fmi3Clock = bool;

inline constexpr fmi3Boolean fmi3True = true;
inline constexpr fmi3Boolean fmi3False = false;
inline constexpr fmi3Clock fmi3ClockActive = true;
inline constexpr fmi3Clock fmi3ClockInactive = false;

enum fmi3Status { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal };
enum fmi3DependencyKind {
  fmi3Independent,
  fmi3Constant,
  fmi3Fixed,
  fmi3Tunable,
  fmi3Discrete,
  fmi3Dependent
};
enum fmi3IntervalQualifier { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged };

extern "C" {
/// `message` is plain text, no format.
using fmi3LogMessageCallback = void (*)(fmi3InstanceEnvironment, fmi3Status status, fmi3String category,
                                        fmi3String message);
using fmi3ClockUpdateCallback = void (*)(fmi3InstanceEnvironment);
using fmi3IntermediateUpdateCallback = void (*)(fmi3InstanceEnvironment, fmi3Float64 time,
                                                fmi3Boolean set_requested, fmi3Boolean get_allowed,
                                                fmi3Boolean step_finished, fmi3Boolean can_return_early,
                                                fmi3Boolean* early_return_requested,
                                                fmi3Float64* early_return_time);
using fmi3LockPreemptionCallback = void (*)();
using fmi3UnlockPreemptionCallback = void (*)();
}

// make an instance of another kind.
#define ORBEARING_FMI3_LISTS(...) \
  (fmi3Instance instance, const fmi3ValueReference references[], size_t number, __VA_ARGS__)
#define ORBEARING_FMI3_VALUES(type) ORBEARING_FMI3_LISTS(type values[], size_t value_number)
#define ORBEARING_FMI3_FUNCTIONS(F)                                                                         \
  F(const char*, fmi3GetVersion, ())                                                                        \
  F(fmi3Status, fmi3SetDebugLogging,                                                                        \
    (fmi3Instance instance, fmi3Boolean on, size_t number, const fmi3String categories[]))                  \
  F(fmi3Instance, fmi3InstantiateModelExchange,                                                             \
    (fmi3String name, fmi3String token, fmi3String resource_path, fmi3Boolean visible, fmi3Boolean logging, \
     fmi3InstanceEnvironment environment, fmi3LogMessageCallback log))                                      \
  F(fmi3Instance, fmi3InstantiateCoSimulation,                                                              \
    (fmi3String name, fmi3String token, fmi3String resource_path, fmi3Boolean visible, fmi3Boolean logging, \
     fmi3Boolean event_mode, fmi3Boolean early_return, const fmi3ValueReference intermediate[],             \
     size_t intermediate_number, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,           \
     fmi3IntermediateUpdateCallback update))                                                                \
  F(fmi3Instance, fmi3InstantiateScheduledExecution,                                                        \
    (fmi3String name, fmi3String token, fmi3String resource_path, fmi3Boolean visible, fmi3Boolean logging, \
     fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, fmi3ClockUpdateCallback clock_update, \
     fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock))                                 \
  F(void, fmi3FreeInstance, (fmi3Instance instance))                                                        \
  F(fmi3Status, fmi3EnterInitializationMode,                                                                \
    (fmi3Instance instance, fmi3Boolean tolerance_defined, fmi3Float64 tolerance, fmi3Float64 start_time,   \
     fmi3Boolean stop_time_defined, fmi3Float64 stop_time))                                                 \
  F(fmi3Status, fmi3ExitInitializationMode, (fmi3Instance instance))                                        \
  F(fmi3Status, fmi3Terminate, (fmi3Instance instance))                                                     \
  F(fmi3Status, fmi3Reset, (fmi3Instance instance))                                                         \
  F(fmi3Status, fmi3GetFloat64, ORBEARING_FMI3_VALUES(fmi3Float64))                                         \
  F(fmi3Status, fmi3GetInt32, ORBEARING_FMI3_VALUES(fmi3Int32))                                             \
  F(fmi3Status, fmi3SetFloat64, ORBEARING_FMI3_VALUES(const fmi3Float64))                                   \
  F(fmi3Status, fmi3GetNumberOfVariableDependencies,                                                        \
    (fmi3Instance instance, fmi3ValueReference reference, size_t * number))                                 \
  F(fmi3Status, fmi3GetVariableDependencies,                                                                \
    (fmi3Instance instance, fmi3ValueReference dependent, size_t elements_of_dependent[],                   \
     fmi3ValueReference independents[], size_t elements_of_independents[], fmi3DependencyKind kinds[],      \
     size_t number))                                                                                        \
  F(fmi3Status, fmi3GetFMUState, (fmi3Instance instance, fmi3FMUState * state))                             \
  F(fmi3Status, fmi3SetFMUState, (fmi3Instance instance, fmi3FMUState state))                               \
  F(fmi3Status, fmi3FreeFMUState, (fmi3Instance instance, fmi3FMUState * state))                            \
  F(fmi3Status, fmi3SerializedFMUStateSize, (fmi3Instance instance, fmi3FMUState state, size_t * size))     \
  F(fmi3Status, fmi3SerializeFMUState,                                                                      \
    (fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], size_t size))                             \
  F(fmi3Status, fmi3DeserializeFMUState,                                                                    \
    (fmi3Instance instance, const fmi3Byte bytes[], size_t size, fmi3FMUState* state))                      \
  F(fmi3Status, fmi3GetDirectionalDerivative,                                                               \
    (fmi3Instance instance, const fmi3ValueReference unknowns[], size_t unknown_number,                     \
     const fmi3ValueReference knowns[], size_t known_number, const fmi3Float64 seed[], size_t seed_number,  \
     fmi3Float64 sensitivity[], size_t sensitivity_number))                                                 \
  F(fmi3Status, fmi3GetAdjointDerivative,                                                                   \
    (fmi3Instance instance, const fmi3ValueReference unknowns[], size_t unknown_number,                     \
     const fmi3ValueReference knowns[], size_t known_number, const fmi3Float64 seed[], size_t seed_number,  \
     fmi3Float64 sensitivity[], size_t sensitivity_number))                                                 \
  F(fmi3Status, fmi3DoStep,                                                                                 \
    (fmi3Instance instance, fmi3Float64 time, fmi3Float64 step_size, fmi3Boolean no_set_state_prior,        \
     fmi3Boolean * event_handling_needed, fmi3Boolean * terminate, fmi3Boolean * early_return,              \
     fmi3Float64 * last_successful_time))

// Those for variables that it has not: of other types, clocks, derivatives by time.
#define ORBEARING_FMI3_OTHER_VARIABLES(F)                                                                    \
  F(fmi3Status, fmi3GetFloat32, ORBEARING_FMI3_VALUES(fmi3Float32))                                          \
  F(fmi3Status, fmi3GetInt8, ORBEARING_FMI3_VALUES(fmi3Int8))                                                \
  F(fmi3Status, fmi3GetUInt8, ORBEARING_FMI3_VALUES(fmi3UInt8))                                              \
  F(fmi3Status, fmi3GetInt16, ORBEARING_FMI3_VALUES(fmi3Int16))                                              \
  F(fmi3Status, fmi3GetUInt16, ORBEARING_FMI3_VALUES(fmi3UInt16))                                            \
  F(fmi3Status, fmi3GetUInt32, ORBEARING_FMI3_VALUES(fmi3UInt32))                                            \
  F(fmi3Status, fmi3GetInt64, ORBEARING_FMI3_VALUES(fmi3Int64))                                              \
  F(fmi3Status, fmi3GetUInt64, ORBEARING_FMI3_VALUES(fmi3UInt64))                                            \
  F(fmi3Status, fmi3GetBoolean, ORBEARING_FMI3_VALUES(fmi3Boolean))                                          \
  F(fmi3Status, fmi3GetString, ORBEARING_FMI3_VALUES(fmi3String))                                            \
  F(fmi3Status, fmi3GetBinary,                                                                               \
    ORBEARING_FMI3_LISTS(size_t sizes[], fmi3Binary values[], size_t value_number))                          \
  F(fmi3Status, fmi3GetClock, ORBEARING_FMI3_LISTS(fmi3Clock values[]))                                      \
  F(fmi3Status, fmi3SetFloat32, ORBEARING_FMI3_VALUES(const fmi3Float32))                                    \
  F(fmi3Status, fmi3SetInt8, ORBEARING_FMI3_VALUES(const fmi3Int8))                                          \
  F(fmi3Status, fmi3SetUInt8, ORBEARING_FMI3_VALUES(const fmi3UInt8))                                        \
  F(fmi3Status, fmi3SetInt16, ORBEARING_FMI3_VALUES(const fmi3Int16))                                        \
  F(fmi3Status, fmi3SetUInt16, ORBEARING_FMI3_VALUES(const fmi3UInt16))                                      \
  F(fmi3Status, fmi3SetInt32, ORBEARING_FMI3_VALUES(const fmi3Int32))                                        \
  F(fmi3Status, fmi3SetUInt32, ORBEARING_FMI3_VALUES(const fmi3UInt32))                                      \
  F(fmi3Status, fmi3SetInt64, ORBEARING_FMI3_VALUES(const fmi3Int64))                                        \
  F(fmi3Status, fmi3SetUInt64, ORBEARING_FMI3_VALUES(const fmi3UInt64))                                      \
  F(fmi3Status, fmi3SetBoolean, ORBEARING_FMI3_VALUES(const fmi3Boolean))                                    \
  F(fmi3Status, fmi3SetString, ORBEARING_FMI3_VALUES(const fmi3String))                                      \
  F(fmi3Status, fmi3SetBinary,                                                                               \
    ORBEARING_FMI3_LISTS(const size_t sizes[], const fmi3Binary values[], size_t value_number))              \
  F(fmi3Status, fmi3SetClock, ORBEARING_FMI3_LISTS(const fmi3Clock values[]))                                \
  F(fmi3Status, fmi3GetIntervalDecimal,                                                                      \
    ORBEARING_FMI3_LISTS(fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[]))                       \
  F(fmi3Status, fmi3GetIntervalFraction,                                                                     \
    ORBEARING_FMI3_LISTS(fmi3UInt64 counters[], fmi3UInt64 resolutions[],                                    \
                         fmi3IntervalQualifier qualifiers[]))                                                \
  F(fmi3Status, fmi3GetShiftDecimal, ORBEARING_FMI3_LISTS(fmi3Float64 shifts[]))                             \
  F(fmi3Status, fmi3GetShiftFraction, ORBEARING_FMI3_LISTS(fmi3UInt64 counters[], fmi3UInt64 resolutions[])) \
  F(fmi3Status, fmi3SetIntervalDecimal, ORBEARING_FMI3_LISTS(const fmi3Float64 intervals[]))                 \
  F(fmi3Status, fmi3SetIntervalFraction,                                                                     \
    ORBEARING_FMI3_LISTS(const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]))                       \
  F(fmi3Status, fmi3SetShiftDecimal, ORBEARING_FMI3_LISTS(const fmi3Float64 shifts[]))                       \
  F(fmi3Status, fmi3SetShiftFraction,                                                                        \
    ORBEARING_FMI3_LISTS(const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]))                       \
  F(fmi3Status, fmi3GetOutputDerivatives,                                                                    \
    ORBEARING_FMI3_LISTS(const fmi3Int32 orders[], fmi3Float64 values[], size_t value_number))

// Those of event mode, of configuration mode, of model exchange and of scheduled execution.
#define ORBEARING_FMI3_EVENTS(F)                                                                     \
  F(fmi3Status, fmi3EnterEventMode, (fmi3Instance instance))                                         \
  F(fmi3Status, fmi3EnterStepMode, (fmi3Instance instance))                                          \
  F(fmi3Status, fmi3EvaluateDiscreteStates, (fmi3Instance instance))                                 \
  F(fmi3Status, fmi3UpdateDiscreteStates,                                                            \
    (fmi3Instance instance, fmi3Boolean * update_needed, fmi3Boolean * terminate,                    \
     fmi3Boolean * nominals_changed, fmi3Boolean * values_changed, fmi3Boolean * next_event_defined, \
     fmi3Float64 * next_event_time))
#define ORBEARING_FMI3_CONFIGURATION(F)                              \
  F(fmi3Status, fmi3EnterConfigurationMode, (fmi3Instance instance)) \
  F(fmi3Status, fmi3ExitConfigurationMode, (fmi3Instance instance))
#define ORBEARING_FMI3_MODEL_EXCHANGE(F)                                                                     \
  F(fmi3Status, fmi3EnterContinuousTimeMode, (fmi3Instance instance))                                        \
  F(fmi3Status, fmi3CompletedIntegratorStep,                                                                 \
    (fmi3Instance instance, fmi3Boolean no_set_state_prior, fmi3Boolean * enter_event_mode,                  \
     fmi3Boolean * terminate))                                                                               \
  F(fmi3Status, fmi3SetTime, (fmi3Instance instance, fmi3Float64 time))                                      \
  F(fmi3Status, fmi3SetContinuousStates, (fmi3Instance instance, const fmi3Float64 states[], size_t number)) \
  F(fmi3Status, fmi3GetContinuousStateDerivatives,                                                           \
    (fmi3Instance instance, fmi3Float64 derivatives[], size_t number))                                       \
  F(fmi3Status, fmi3GetEventIndicators, (fmi3Instance instance, fmi3Float64 indicators[], size_t number))    \
  F(fmi3Status, fmi3GetContinuousStates, (fmi3Instance instance, fmi3Float64 states[], size_t number))       \
  F(fmi3Status, fmi3GetNominalsOfContinuousStates,                                                           \
    (fmi3Instance instance, fmi3Float64 nominals[], size_t number))                                          \
  F(fmi3Status, fmi3GetNumberOfEventIndicators, (fmi3Instance instance, size_t * number))                    \
  F(fmi3Status, fmi3GetNumberOfContinuousStates, (fmi3Instance instance, size_t * number))
#define ORBEARING_FMI3_SCHEDULED_EXECUTION(F) \
  F(fmi3Status, fmi3ActivateModelPartition,   \
    (fmi3Instance instance, fmi3ValueReference clock, fmi3Float64 time))

// name ## TYPE: type of the function, as the standard calls it.
extern "C" {
#define ORBEARING_DECLARE(result, name, arguments) \
  using name##TYPE = result arguments;             \
  name##TYPE name;
ORBEARING_FMI3_FUNCTIONS(ORBEARING_DECLARE)
ORBEARING_FMI3_OTHER_VARIABLES(ORBEARING_DECLARE)
ORBEARING_FMI3_EVENTS(ORBEARING_DECLARE)
ORBEARING_FMI3_CONFIGURATION(ORBEARING_DECLARE)
ORBEARING_FMI3_MODEL_EXCHANGE(ORBEARING_DECLARE)
ORBEARING_FMI3_SCHEDULED_EXECUTION(ORBEARING_DECLARE)
#undef ORBEARING_DECLARE
}
