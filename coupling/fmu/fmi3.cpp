// The C interface of FMI 3.0 over an instance: what co-simulation needs. The rest: fmi3_refusing.cpp.
#include "coupling/fmu/fmi3.hpp"

#include "coupling/fmu/guard.hpp"

namespace {

using orbearing::fmu::Instance;
using orbearing::fmu::InstanceState;
using orbearing::fmu::Log;
using orbearing::fmu::Refused;
using orbearing::fmu::require_position;
using orbearing::fmu::Role;
using orbearing::fmu::Status;
using orbearing::fmu::Variable;

template <class Body>
fmi3Status guarded(void* component, const char* function, Body&& body) noexcept {
  return static_cast<fmi3Status>(orbearing::fmu::guarded(component, function, std::forward<Body>(body)));
}

void require_equal(size_t found, size_t required) {
  if (found != required)
    throw Refused("number of values: found " + std::to_string(found) +
                  "; required: " + std::to_string(required) + ", since all variables are scalars");
}

// Inputs on which an output depends in step mode, or in initialization mode.
const std::vector<size_t>& dependencies_of(const Instance& it, fmi3ValueReference reference) {
  const Variable& one = it.variable(reference);
  if (one.role != Role::output) throw Refused(one.name + ": found as a dependent; required: an output");
  return it.facts().outputs[one.index].inputs;
}

}  // namespace

extern "C" {

const char* fmi3GetVersion() {
  return "3.0";
}

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, size_t number,
                               const fmi3String categories[]) {
  return guarded(instance, __func__, [&](Instance& it) {
    it.set_logging(on, orbearing::fmu::categories_of(number, categories));
  });
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resource_path,
                                         fmi3Boolean, fmi3Boolean logging, fmi3Boolean, fmi3Boolean,
                                         const fmi3ValueReference*, size_t intermediate_number,
                                         fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback log_message, fmi3IntermediateUpdateCallback) {
  try {
    Log log;
    if (log_message != nullptr)
      log = [=](Status status, const char* category, const char* text) {
        log_message(environment, static_cast<fmi3Status>(status), category, text);
      };
    const char* wrong = name == nullptr || *name == '\0' ? "found an instance without name; required: a name"
                        : intermediate_number > 0
                            ? "found intermediate variables; required: none, as the model "
                              "description says"
                            : nullptr;
    return orbearing::fmu::new_instance(__func__, wrong, token, resource_path, log, logging);
  } catch (...) {  // no memory for the logger
  }
  return nullptr;
}

void fmi3FreeInstance(fmi3Instance instance) {
  delete static_cast<Instance*>(instance);
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean, fmi3Float64,
                                       fmi3Float64 start_time, fmi3Boolean stop_time_defined,
                                       fmi3Float64 stop_time) {
  return guarded(instance, __func__, [&](Instance& it) {
    it.setup_experiment({start_time, stop_time_defined ? std::optional(stop_time) : std::nullopt});
    it.enter_initialization();
  });
}
fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
  return guarded(instance, __func__, [](Instance& it) { it.exit_initialization(); });
}
fmi3Status fmi3Terminate(fmi3Instance instance) {
  return guarded(instance, __func__, [](Instance& it) { it.terminate(); });
}
fmi3Status fmi3Reset(fmi3Instance instance) {
  return guarded(instance, __func__, [](Instance& it) { it.reset(); });
}

fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference references[], size_t number,
                          fmi3Float64 values[], size_t value_number) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_equal(value_number, number);
    it.get({references, number}, values);
  });
}
fmi3Status fmi3GetInt32(fmi3Instance instance, const fmi3ValueReference references[], size_t number,
                        fmi3Int32 values[], size_t value_number) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_equal(value_number, number);
    it.get_whole({references, number}, values);
  });
}
fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference references[], size_t number,
                          const fmi3Float64 values[], size_t value_number) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_equal(value_number, number);
    it.set({references, number}, values);
  });
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance, fmi3ValueReference reference,
                                               size_t* number) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_position(number, "number");
    *number = dependencies_of(it, reference).size();
  });
}
fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent,
                                       size_t elements_of_dependent[], fmi3ValueReference independents[],
                                       size_t elements_of_independents[], fmi3DependencyKind kinds[],
                                       size_t number) {
  return guarded(instance, __func__, [&](Instance& it) {
    const std::vector<size_t>& inputs = dependencies_of(it, dependent);
    require_equal(number, inputs.size());
    if (number == 0) return;
    require_position(elements_of_dependent, "elements of the dependent");
    require_position(independents, "independents");
    require_position(elements_of_independents, "elements of the independents");
    require_position(kinds, "kinds");
    const std::uint32_t first = orbearing::fmu::first_reference(it.variables(), Role::input);
    for (size_t i = 0; i < number; ++i) {
      elements_of_dependent[i] = elements_of_independents[i] = 0;  // as a whole
      independents[i] = first + static_cast<std::uint32_t>(inputs[i]);
      kinds[i] = fmi3Dependent;
    }
  });
}

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_position(state, "state");
    *state = it.keep_state(static_cast<InstanceState*>(*state));
  });
}
fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state) {
  return guarded(instance, __func__,
                 [&](Instance& it) { it.go_to_state(static_cast<InstanceState*>(state)); });
}
fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* state) {
  return guarded(instance, __func__, [&](Instance& it) {
    if (state == nullptr) return;
    it.free_state(static_cast<InstanceState*>(*state));
    *state = nullptr;
  });
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState state, size_t* size) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_position(size, "size");
    *size = it.state_size(static_cast<InstanceState*>(state));
  });
}
fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
  return guarded(instance, __func__, [&](Instance& it) {
    it.serialize(static_cast<InstanceState*>(state), reinterpret_cast<char*>(bytes), size);
  });
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], size_t size,
                                   fmi3FMUState* state) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_position(state, "state");
    *state = it.deserialize(reinterpret_cast<const char*>(bytes), size, static_cast<InstanceState*>(*state));
  });
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                        size_t unknown_number, const fmi3ValueReference knowns[],
                                        size_t known_number, const fmi3Float64 seed[], size_t seed_number,
                                        fmi3Float64 sensitivity[], size_t sensitivity_number) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_equal(seed_number, known_number);
    require_equal(sensitivity_number, unknown_number);
    it.directional({unknowns, unknown_number}, {knowns, known_number}, seed, sensitivity);
  });
}
fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                    size_t unknown_number, const fmi3ValueReference knowns[],
                                    size_t known_number, const fmi3Float64 seed[], size_t seed_number,
                                    fmi3Float64 sensitivity[], size_t sensitivity_number) {
  return guarded(instance, __func__, [&](Instance& it) {
    require_equal(seed_number, unknown_number);
    require_equal(sensitivity_number, known_number);
    it.adjoint({unknowns, unknown_number}, {knowns, known_number}, seed, sensitivity);
  });
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 time, fmi3Float64 step_size, fmi3Boolean,
                      fmi3Boolean* event_handling_needed, fmi3Boolean* terminate, fmi3Boolean* early_return,
                      fmi3Float64* last_successful_time) {
  return guarded(instance, __func__, [&](Instance& it) {
    for (fmi3Boolean* flag : {event_handling_needed, terminate, early_return})
      if (flag != nullptr) *flag = false;
    if (last_successful_time != nullptr) *last_successful_time = it.time();
    it.step(time, step_size);
    if (last_successful_time != nullptr) *last_successful_time = it.time();
  });
}

}  // extern "C"
