// What FMI 2.0 callers may do wrong: a status and a logged reason, and the instance goes on.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/unit/fmu/fmu_model.hpp"

namespace orbearing::fmu::fmi2_refusals_test {
namespace {

using test::Instance2;
using test::Resources;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Fmi2Refusals : public testing::Test {
 protected:
  static void SetUpTestSuite() { resources = new Resources(numbers_of(test::bearing_model())); }
  static void TearDownTestSuite() { delete resources; }

  // Error or discard, with a reason that holds `word`.
  void expect_refused(Instance2& it, fmi2Status status, const std::string& word) {
    EXPECT_TRUE(status == fmi2Error || status == fmi2Discard) << status;
    ASSERT_FALSE(it.messages.list.empty()) << word;
    EXPECT_NE(it.messages.last().find(word), std::string::npos) << it.messages.last();
    EXPECT_EQ(it.messages.list.back().first, status);
    it.messages.list.clear();
  }

  static Resources* resources;
};
Resources* Fmi2Refusals::resources = nullptr;

TEST_F(Fmi2Refusals, Instantiation) {
  test::Messages log;
  const fmi2CallbackFunctions callbacks{&test::Messages::take, nullptr, nullptr, nullptr, &log};
  const std::string token = resources->token(), uri = resources->uri();
  const auto make = [&](const char* name, fmi2Type type, const char* guid, const char* place) {
    log.list.clear();
    const fmi2Component made = fmi2Instantiate(name, type, guid, place, &callbacks, fmi2False, fmi2False);
    if (made == nullptr) {
      EXPECT_EQ(log.list.size(), 1u);
    }
    fmi2FreeInstance(made);
    return made != nullptr;
  };
  EXPECT_TRUE(make("a", fmi2CoSimulation, token.c_str(), uri.c_str()));
  EXPECT_FALSE(make(nullptr, fmi2CoSimulation, token.c_str(), uri.c_str()));
  EXPECT_FALSE(make("", fmi2CoSimulation, token.c_str(), uri.c_str()));
  EXPECT_FALSE(make("a", fmi2ModelExchange, token.c_str(), uri.c_str()));
  EXPECT_FALSE(make("a", fmi2CoSimulation, nullptr, uri.c_str()));
  EXPECT_FALSE(make("a", fmi2CoSimulation, "{00000000-0000-0000-0000-000000000000}", uri.c_str()));
  EXPECT_NE(log.last().find(token), std::string::npos) << log.last();
  EXPECT_FALSE(make("a", fmi2CoSimulation, token.c_str(), nullptr));
  EXPECT_FALSE(make("a", fmi2CoSimulation, token.c_str(), "file:///nowhere"));
  EXPECT_EQ(fmi2Instantiate("a", fmi2CoSimulation, token.c_str(), nullptr, nullptr, fmi2False, fmi2False),
            nullptr);
  const fmi2Component silent =
      fmi2Instantiate("a", fmi2CoSimulation, token.c_str(), uri.c_str(), nullptr, fmi2False, fmi2True);
  EXPECT_NE(silent, nullptr);
  EXPECT_EQ(fmi2DoStep(silent, 0.0, 1.0, fmi2False), fmi2Error);
  fmi2FreeInstance(silent);
}

TEST_F(Fmi2Refusals, NoInstance) {
  fmi2FreeInstance(nullptr);
  EXPECT_EQ(fmi2DoStep(nullptr, 0.0, 1.0, fmi2False), fmi2Error);
  EXPECT_EQ(fmi2GetReal(nullptr, nullptr, 0, nullptr), fmi2Error);
}

TEST_F(Fmi2Refusals, OrderOfCalls) {
  Instance2 it(*resources);
  expect_refused(it, fmi2ExitInitializationMode(it.component), "in initialization mode");
  expect_refused(it, fmi2EnterInitializationMode(it.component), "set-up");
  expect_refused(it, fmi2Terminate(it.component), "step mode");
  expect_refused(it, it.step(0.0, 1e-5), "step mode");
  const fmi2ValueReference force = it.reference("force.x");
  double value = 0.0;
  expect_refused(it, fmi2GetReal(it.component, &force, 1, &value), "force.x");
  ASSERT_EQ(it.begin(), fmi2OK);
  expect_refused(it, fmi2SetupExperiment(it.component, fmi2False, 0.0, 0.0, fmi2False, 0.0), "instantiated");
  expect_refused(it, fmi2EnterInitializationMode(it.component), "instantiated");
  expect_refused(it, it.set("bearing.width", 0.012), "bearing.width");
  expect_refused(it, fmi2CancelStep(it.component), "no step");
  ASSERT_EQ(fmi2Terminate(it.component), fmi2OK);
  expect_refused(it, it.set("planet.speed", 1.0), "terminated");
  expect_refused(it, it.step(0.0, 1e-5), "terminated");
  EXPECT_EQ(fmi2GetReal(it.component, &force, 1, &value), fmi2OK);
}

TEST_F(Fmi2Refusals, StepsThatAreNone) {
  Instance2 it(*resources);
  ASSERT_EQ(it.begin(1.0), fmi2OK);
  for (const double size : {0.0, -1e-5, kNaN, kInfinity, -kInfinity})
    expect_refused(it, it.step(1.0, size), "step");
  // Issue 52, item 12: a step that would never end.
  for (const double size : {1.1e4, 1e300}) expect_refused(it, it.step(1.0, size), "at most 10000 s");
  for (const double time : {0.0, 1.0 - 1e-5, 1.1, kNaN, kInfinity})
    expect_refused(it, it.step(time, 1e-5), "communication point");
  expect_refused(it, it.step(1.0, 1e-17), "does not move");
  EXPECT_EQ(it.get("time"), 1.0);
  EXPECT_EQ(it.step(1.0, 1e-5), fmi2OK) << it.messages.last();
  fmi2Real last = 0.0;
  EXPECT_EQ(fmi2GetRealStatus(it.component, fmi2LastSuccessfulTime, &last), fmi2OK);
  EXPECT_EQ(last, 1.0 + 1e-5);
}

TEST_F(Fmi2Refusals, ExperimentsThatAreNone) {
  Instance2 it(*resources);
  expect_refused(it, fmi2SetupExperiment(it.component, fmi2False, 0.0, kNaN, fmi2False, 0.0), "start time");
  expect_refused(it, fmi2SetupExperiment(it.component, fmi2False, 0.0, 1.0, fmi2True, 0.5), "stop time");
  expect_refused(it, fmi2SetupExperiment(it.component, fmi2False, 0.0, 1.0, fmi2True, kNaN), "stop time");
  ASSERT_EQ(fmi2SetupExperiment(it.component, fmi2False, 0.0, 0.0, fmi2True, 1e-5), fmi2OK);
  ASSERT_EQ(fmi2EnterInitializationMode(it.component), fmi2OK);
  ASSERT_EQ(fmi2ExitInitializationMode(it.component), fmi2OK);
  expect_refused(it, it.step(0.0, 1.1e-5), "stop time");
  EXPECT_EQ(it.step(0.0, 1e-5), fmi2OK);
  expect_refused(it, it.step(1e-5, 1e-5), "stop time");
}

TEST_F(Fmi2Refusals, ValuesAndReferences) {
  Instance2 it(*resources);
  expect_refused(it, it.set("planet.speed", kNaN), "planet.speed");
  expect_refused(it, it.set("planet.displacement.x", kInfinity), "finite");
  expect_refused(it, it.set("bearing.width", -1.0), "greater than 0");
  expect_refused(it, it.set("material.poisson_ratio", 0.5), "at least 0 and less than 0.5");
  expect_refused(it, it.set("force.x", 1.0), "an input or a parameter");
  expect_refused(it, it.set("time", 1.0), "an input or a parameter");
  double value = 0.0;
  for (const fmi2ValueReference unknown : {9999u, 0xffffffffu}) {
    expect_refused(it, fmi2GetReal(it.component, &unknown, 1, &value), "value reference");
    expect_refused(it, fmi2SetReal(it.component, &unknown, 1, &value), "value reference");
  }
  const fmi2ValueReference speed = it.reference("planet.speed"), rollers = it.reference("bearing.rollers");
  expect_refused(it, fmi2GetReal(it.component, nullptr, 1, &value), "NULL");
  expect_refused(it, fmi2GetReal(it.component, &speed, 1, nullptr), "NULL");
  expect_refused(it, fmi2SetReal(it.component, &speed, 1, nullptr), "NULL");
  expect_refused(it, fmi2GetReal(it.component, &rollers, 1, &value), "integers");
  int number = 0;
  expect_refused(it, fmi2GetInteger(it.component, &speed, 1, &number), "real");
  EXPECT_EQ(fmi2GetInteger(it.component, &rollers, 1, &number), fmi2OK);
  EXPECT_EQ(number, 15);
  expect_refused(it, fmi2SetInteger(it.component, &rollers, 1, &number), "integer");
  expect_refused(it, fmi2GetBoolean(it.component, &speed, 1, &number), "type");
  fmi2String text = nullptr;
  expect_refused(it, fmi2GetString(it.component, &speed, 1, &text), "type");
  EXPECT_EQ(fmi2GetReal(it.component, nullptr, 0, nullptr), fmi2OK);
}

TEST_F(Fmi2Refusals, OneWrongValueSetsNone) {
  Instance2 it(*resources);
  const double before = it.get("planet.speed");
  const fmi2ValueReference both[] = {it.reference("planet.speed"), it.reference("carrier.speed")};
  const double values[] = {7.0, kNaN};
  expect_refused(it, fmi2SetReal(it.component, both, 2, values), "carrier.speed");
  EXPECT_EQ(it.get("planet.speed"), before);
}

TEST_F(Fmi2Refusals, ParametersThatMakeNoBearing) {
  Instance2 it(*resources);
  it.set("bearing.pitch_diameter", 1.0);
  it.set("bearing.roller_diameter", 2.0);
  ASSERT_EQ(fmi2SetupExperiment(it.component, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
  ASSERT_EQ(fmi2EnterInitializationMode(it.component), fmi2OK);
  expect_refused(it, fmi2ExitInitializationMode(it.component), "");
  EXPECT_EQ(fmi2Reset(it.component), fmi2OK);
  EXPECT_EQ(it.begin(), fmi2OK) << it.messages.last();
}

TEST_F(Fmi2Refusals, DerivativesOfInputs) {
  Instance2 it(*resources);
  const fmi2ValueReference speed = it.reference("planet.speed"), force = it.reference("force.x");
  const int first = 1, zeroth = 0, third = 3;
  const double one = 1.0;
  expect_refused(it, fmi2SetRealInputDerivatives(it.component, &speed, 1, &first, &one), "instantiated");
  ASSERT_EQ(it.begin(), fmi2OK);
  expect_refused(it, fmi2SetRealInputDerivatives(it.component, &force, 1, &first, &one), "an input");
  expect_refused(it, fmi2SetRealInputDerivatives(it.component, &speed, 1, &zeroth, &one), "1 or 2");
  expect_refused(it, fmi2SetRealInputDerivatives(it.component, &speed, 1, &third, &one), "1 or 2");
  expect_refused(it, fmi2SetRealInputDerivatives(it.component, &speed, 1, &first, &kNaN), "finite");
  expect_refused(it, fmi2SetRealInputDerivatives(it.component, &speed, 1, nullptr, &one), "NULL");
  double value = 0.0;
  expect_refused(it, fmi2GetRealOutputDerivatives(it.component, &force, 1, &first, &value), "none");
  expect_refused(it, fmi2GetDirectionalDerivative(it.component, &speed, 1, &speed, 1, &one, &value),
                 "an output");
  expect_refused(it, fmi2GetDirectionalDerivative(it.component, &force, 1, &force, 1, &one, &value),
                 "an input");
  expect_refused(it, fmi2GetDirectionalDerivative(it.component, &force, 1, &speed, 1, nullptr, &value),
                 "NULL");
}

TEST_F(Fmi2Refusals, InputsBeyondAllMeasure) {
  Instance2 it(*resources);
  ASSERT_EQ(it.begin(), fmi2OK);
  it.set("planet.displacement.x", 1.0);  // a metre: no roller survives that
  const fmi2Status status = it.step(0.0, 1e-5);
  if (status != fmi2OK) {
    expect_refused(it, status, "step");
    EXPECT_EQ(it.get("time"), 0.0);
  }
  it.set("planet.displacement.x", 1e308);
  it.set("planet.velocity.x", 1e308);
  expect_refused(it, it.step(it.get("time"), 1e5), "");
}

TEST_F(Fmi2Refusals, States) {
  Instance2 it(*resources), other(*resources);
  fmi2FMUstate state = nullptr, none = nullptr;
  int stranger = 0;
  size_t size = 0;
  ASSERT_EQ(fmi2GetFMUstate(it.component, &state), fmi2OK);
  expect_refused(it, fmi2SetFMUstate(it.component, nullptr), "state");
  expect_refused(it, fmi2SetFMUstate(it.component, &stranger), "state");
  expect_refused(other, fmi2SetFMUstate(other.component, state), "state");
  expect_refused(it, fmi2GetFMUstate(it.component, nullptr), "NULL");
  expect_refused(it, fmi2SerializedFMUstateSize(it.component, none, &size), "state");
  expect_refused(it, fmi2SerializedFMUstateSize(it.component, state, nullptr), "NULL");
  EXPECT_EQ(fmi2FreeFMUstate(it.component, nullptr), fmi2OK);
  EXPECT_EQ(fmi2FreeFMUstate(it.component, &none), fmi2OK);
  fmi2FMUstate copy = state;
  ASSERT_EQ(fmi2FreeFMUstate(it.component, &state), fmi2OK);
  expect_refused(it, fmi2SetFMUstate(it.component, copy), "freed");
  expect_refused(it, fmi2FreeFMUstate(it.component, &copy), "freed");
}

TEST_F(Fmi2Refusals, BytesThatAreNoState) {
  Instance2 it(*resources);
  test::press(it);
  ASSERT_EQ(it.begin(), fmi2OK);
  fmi2FMUstate state = nullptr, made = nullptr;
  ASSERT_EQ(fmi2GetFMUstate(it.component, &state), fmi2OK);
  size_t size = 0;
  ASSERT_EQ(fmi2SerializedFMUstateSize(it.component, state, &size), fmi2OK);
  std::vector<char> bytes(size);
  expect_refused(it, fmi2SerializeFMUstate(it.component, state, bytes.data(), size - 1), "room");
  ASSERT_EQ(fmi2SerializeFMUstate(it.component, state, bytes.data(), size), fmi2OK);
  for (const size_t length : {size_t{0}, size_t{7}, size_t{40}, size / 2, size - 8, size - 1})
    expect_refused(it, fmi2DeSerializeFMUstate(it.component, bytes.data(), length, &made),
                   "serialised state");
  for (const size_t place :
       {size_t{0}, size_t{8}, size_t{16}, size_t{24}, size_t{32}, size_t{50}, size - 1}) {
    std::vector<char> broken = bytes;
    broken[place] = static_cast<char>(broken[place] ^ 0x21);
    expect_refused(it, fmi2DeSerializeFMUstate(it.component, broken.data(), size, &made), "serialised state");
  }
  expect_refused(it, fmi2DeSerializeFMUstate(it.component, nullptr, size, &made), "NULL");
  EXPECT_EQ(made, nullptr);
  const Resources others(numbers_of(test::gear_model()));
  Instance2 gears(others);
  expect_refused(gears, fmi2DeSerializeFMUstate(gears.component, bytes.data(), size, &made), "another model");
}

TEST_F(Fmi2Refusals, LogCategories) {
  Instance2 it(*resources, true);
  const fmi2String known[] = {"logStatusDiscard"}, unknown[] = {"logNothing"}, null[] = {nullptr};
  expect_refused(it, fmi2SetDebugLogging(it.component, fmi2True, 1, unknown), "logNothing");
  expect_refused(it, fmi2SetDebugLogging(it.component, fmi2True, 1, null), "NULL");
  EXPECT_EQ(fmi2SetDebugLogging(it.component, fmi2True, 1, known), fmi2OK);
  EXPECT_EQ(it.step(0.0, 1e-5), fmi2Error);
  EXPECT_TRUE(it.messages.list.empty()) << "an error is not among the chosen categories";
  EXPECT_EQ(fmi2SetDebugLogging(it.component, fmi2False, 0, nullptr), fmi2OK);
  expect_refused(it, it.step(0.0, 1e-5), "step mode");
}

}  // namespace
}  // namespace orbearing::fmu::fmi2_refusals_test
