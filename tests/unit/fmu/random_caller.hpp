// An instance of either version of FMI with what a caller has in hand: for random calls.
#pragma once

#include <gtest/gtest.h>

#include "coupling/fmu/fmi3.hpp"
#include "tests/unit/fmu/fmu_model.hpp"

namespace orbearing::fmu::test {

inline constexpr long kFewSteps =
    300;  // internal ones of one call: wild inputs shall not take the time of the test

inline NumberTable short_bearing() {
  system::DrivenBearingSetup model = test::bearing_model();
  model.bearing.rollers().count = 5;
  model.most_steps = kFewSteps;
  return numbers_of(model);
}

inline NumberTable short_gears() {
  system::DrivenGearsSetup model = test::gear_model();
  model.most_steps = kFewSteps;
  return numbers_of(model);
}

/// One instance of either version with what a caller has in hand.
struct Caller {
  Caller(const Resources& model, bool of_fmi3) : resources(&model), fmi3(of_fmi3) {
    callbacks = {&Messages::take, nullptr, nullptr, nullptr, &messages};
    make();
  }
  ~Caller() { drop(); }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  void make() {
    component =
        fmi3 ? fmi3InstantiateCoSimulation("a", resources->token().c_str(), resources->folder().c_str(),
                                           false, false, false, false, nullptr, 0, this, &take, nullptr)
             : fmi2Instantiate("a", fmi2CoSimulation, resources->token().c_str(), resources->uri().c_str(),
                               &callbacks, fmi2False, fmi2False);
    ASSERT_NE(component, nullptr) << messages.last();
  }
  void drop() {
    fmi3 ? fmi3FreeInstance(component) : fmi2FreeInstance(component);
    states.clear();
    time = 0.0;
  }
  // The same verbs for both versions.
  int reset() {
    time = 0.0;
    return fmi3 ? int{fmi3Reset(component)} : int{fmi2Reset(component)};
  }
  int terminate() { return fmi3 ? int{fmi3Terminate(component)} : int{fmi2Terminate(component)}; }
  int get(const std::uint32_t* references, std::size_t number, double* values, std::size_t value_number) {
    return fmi3 ? int{fmi3GetFloat64(component, references, number, values, value_number)}
                : int{fmi2GetReal(component, references, number, values)};
  }
  int set(const std::uint32_t* references, std::size_t number, const double* values) {
    return fmi3 ? int{fmi3SetFloat64(component, references, number, values, number)}
                : int{fmi2SetReal(component, references, number, values)};
  }
  int keep(void** state) {
    return fmi3 ? int{fmi3GetFMUState(component, state)} : int{fmi2GetFMUstate(component, state)};
  }
  int go_to(void* state) {
    return fmi3 ? int{fmi3SetFMUState(component, state)} : int{fmi2SetFMUstate(component, state)};
  }
  int free_state(void** state) {
    return fmi3 ? int{fmi3FreeFMUState(component, state)} : int{fmi2FreeFMUstate(component, state)};
  }
  int state_size(void* state, std::size_t* size) {
    return fmi3 ? int{fmi3SerializedFMUStateSize(component, state, size)}
                : int{fmi2SerializedFMUstateSize(component, state, size)};
  }
  int write_state(void* state) {
    return fmi3 ? int{fmi3SerializeFMUState(component, state, reinterpret_cast<fmi3Byte*>(bytes.data()),
                                            bytes.size())}
                : int{fmi2SerializeFMUstate(component, state, bytes.data(), bytes.size())};
  }
  int read_state(const char* from, std::size_t size, void** state) {
    return fmi3
               ? int{fmi3DeserializeFMUState(component, reinterpret_cast<const fmi3Byte*>(from), size, state)}
               : int{fmi2DeSerializeFMUstate(component, from, size, state)};
  }
  /// From a reset straight on to steps.
  int start() {
    int status = reset();
    if (!fmi3) status = std::max(status, int{fmi2SetupExperiment(component, 0, 0.0, 0.0, 0, 0.0)});
    status = std::max(status, fmi3 ? int{fmi3EnterInitializationMode(component, false, 0.0, 0.0, false, 0.0)}
                                   : int{fmi2EnterInitializationMode(component)});
    return std::max(status, fmi3 ? int{fmi3ExitInitializationMode(component)}
                                 : int{fmi2ExitInitializationMode(component)});
  }
  int step(double point, double size) {
    bool flag = false;
    if (fmi3) return fmi3DoStep(component, point, size, true, &flag, nullptr, &flag, &time);
    const int status = fmi2DoStep(component, point, size, fmi2True);
    fmi2GetRealStatus(component, fmi2LastSuccessfulTime, &time);
    return status;
  }

  static void take(fmi3InstanceEnvironment to, fmi3Status status, fmi3String, fmi3String text) {
    static_cast<Caller*>(to)->messages.list.emplace_back(status, text);
  }

  const Resources* resources;
  bool fmi3;
  fmi2CallbackFunctions callbacks{};
  Messages messages;
  void* component = nullptr;
  double time = 0.0;          // [s]  where the caller believes it to be
  std::vector<void*> states;  // some of them freed
  std::vector<char> bytes;    // of some state
};

}  // namespace orbearing::fmu::test
