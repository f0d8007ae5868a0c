// Mistakes of FMI 2.0 callers: a status and a logged reason, and the instance continues.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "coupling/fmu/guard.hpp"
#include "tests/unit/fmu/fmu_model.hpp"

namespace orbearing::fmu::fmi2_refusals_test {
namespace {

using test::Instance2;
using test::Resources;
using test::said;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Fmi2Refusals : public testing::Test {
 protected:
  static void SetUpTestSuite() { resources = new Resources(numbers_of(test::bearing_model())); }
  static void TearDownTestSuite() { delete resources; }

  static Resources* resources;
};
Resources* Fmi2Refusals::resources = nullptr;

TEST_F(Fmi2Refusals, Instantiation) {
  test::Messages log;
  const fmi2CallbackFunctions callbacks{&test::Messages::take, nullptr, nullptr, nullptr, &log};
  const std::string token = resources->token(), uri = resources->uri();
  const auto made = [&](const char* name, fmi2Type type, const char* guid, const char* position) {
    const fmi2Component one = fmi2Instantiate(name, type, guid, position, &callbacks, fmi2False, fmi2False);
    const fmi2Status status = one == nullptr ? fmi2Error : fmi2OK;
    fmi2FreeInstance(one);
    return with_names(said(log, status), *resources);
  };
  const fmi2Type cosim = fmi2CoSimulation;
  EXPECT_EQ(made("a", cosim, token.c_str(), uri.c_str()), "ok");
  EXPECT_SAID("fmi2 no name", made(nullptr, cosim, token.c_str(), uri.c_str()));
  EXPECT_SAID("fmi2 empty name", made("", cosim, token.c_str(), uri.c_str()));
  EXPECT_SAID("fmi2 exchange", made("a", fmi2ModelExchange, token.c_str(), uri.c_str()));
  EXPECT_SAID("fmi2 no token", made("a", cosim, nullptr, uri.c_str()));
  EXPECT_SAID("fmi2 token", made("a", cosim, "{00000000-0000-0000-0000-000000000000}", uri.c_str()));
  EXPECT_SAID("fmi2 no resources", made("a", cosim, token.c_str(), nullptr));
  EXPECT_SAID("fmi2 resources", made("a", cosim, token.c_str(), "file:///nowhere"));
  EXPECT_EQ(fmi2Instantiate("a", cosim, token.c_str(), nullptr, nullptr, fmi2False, fmi2False), nullptr);
  const fmi2Component silent =
      fmi2Instantiate("a", cosim, token.c_str(), uri.c_str(), nullptr, fmi2False, fmi2True);
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
  EXPECT_SAID("fmi2 order 1", said(it, fmi2ExitInitializationMode(it.component)));
  EXPECT_SAID("fmi2 order 2", said(it, fmi2EnterInitializationMode(it.component)));
  EXPECT_SAID("fmi2 order 3", said(it, fmi2Terminate(it.component)));
  EXPECT_SAID("fmi2 order 4", said(it, it.step(0.0, 1e-5)));
  const fmi2ValueReference force = it.reference("force.x");
  double value = 0.0;
  EXPECT_SAID("fmi2 order 5", said(it, fmi2GetReal(it.component, &force, 1, &value)));
  ASSERT_EQ(it.begin(), fmi2OK);
  EXPECT_SAID("fmi2 order 6",
              said(it, fmi2SetupExperiment(it.component, fmi2False, 0.0, 0.0, fmi2False, 0.0)));
  EXPECT_SAID("fmi2 order 7", said(it, fmi2EnterInitializationMode(it.component)));
  EXPECT_SAID("fmi2 order 8", said(it, it.set("bearing.width", 0.012)));
  EXPECT_SAID("fmi2 order 9", said(it, fmi2CancelStep(it.component)));
  ASSERT_EQ(fmi2Terminate(it.component), fmi2OK);
  EXPECT_SAID("fmi2 order 10", said(it, it.set("planet.speed", 1.0)));
  EXPECT_SAID("fmi2 order 11", said(it, it.step(0.0, 1e-5)));
  EXPECT_EQ(fmi2GetReal(it.component, &force, 1, &value), fmi2OK);
}

TEST_F(Fmi2Refusals, StepsThatAreNone) {
  Instance2 it(*resources);
  ASSERT_EQ(it.begin(1.0), fmi2OK);
  for (const double size : {0.0, -1e-5, kNaN, kInfinity, -kInfinity})
    EXPECT_SAID("fmi2 step 1", said(it, it.step(1.0, size)));
  // A step that would never end.
  for (const double size : {1.1e4, 1e300}) EXPECT_SAID("fmi2 step 2", said(it, it.step(1.0, size)));
  for (const double time : {0.0, 1.0 - 1e-5, 1.1, kNaN, kInfinity})
    EXPECT_SAID("fmi2 step 3", said(it, it.step(time, 1e-5)));
  EXPECT_SAID("fmi2 step 4", said(it, it.step(1.0, 1e-17)));
  EXPECT_EQ(it.get("time"), 1.0);
  EXPECT_EQ(it.step(1.0, 1e-5), fmi2OK) << it.messages.last();
  fmi2Real last = 0.0;
  EXPECT_EQ(fmi2GetRealStatus(it.component, fmi2LastSuccessfulTime, &last), fmi2OK);
  EXPECT_EQ(last, 1.0 + 1e-5);
}

TEST_F(Fmi2Refusals, ExperimentsThatAreNone) {
  Instance2 it(*resources);
  EXPECT_SAID("fmi2 experiment 1",
              said(it, fmi2SetupExperiment(it.component, fmi2False, 0.0, kNaN, fmi2False, 0.0)));
  EXPECT_SAID("fmi2 experiment 2",
              said(it, fmi2SetupExperiment(it.component, fmi2False, 0.0, 1.0, fmi2True, 0.5)));
  EXPECT_SAID("fmi2 experiment 3",
              said(it, fmi2SetupExperiment(it.component, fmi2False, 0.0, 1.0, fmi2True, kNaN)));
  ASSERT_EQ(fmi2SetupExperiment(it.component, fmi2False, 0.0, 0.0, fmi2True, 1e-5), fmi2OK);
  ASSERT_EQ(fmi2EnterInitializationMode(it.component), fmi2OK);
  ASSERT_EQ(fmi2ExitInitializationMode(it.component), fmi2OK);
  EXPECT_SAID("fmi2 experiment 4", said(it, it.step(0.0, 1.1e-5)));
  EXPECT_EQ(it.step(0.0, 1e-5), fmi2OK);
  EXPECT_SAID("fmi2 experiment 5", said(it, it.step(1e-5, 1e-5)));
}

TEST_F(Fmi2Refusals, ValuesAndReferences) {
  Instance2 it(*resources);
  EXPECT_SAID("fmi2 value 1", said(it, it.set("planet.speed", kNaN)));
  EXPECT_SAID("fmi2 value 2", said(it, it.set("planet.displacement.x", kInfinity)));
  EXPECT_SAID("fmi2 value 3", said(it, it.set("bearing.width", -1.0)));
  EXPECT_SAID("fmi2 value 4", said(it, it.set("material.poisson_ratio", 0.5)));
  EXPECT_SAID("fmi2 value 5", said(it, it.set("force.x", 1.0)));
  EXPECT_SAID("fmi2 value 6", said(it, it.set("time", 1.0)));
  double value = 0.0;
  for (const fmi2ValueReference unknown : {9999u, 0xffffffffu}) {
    EXPECT_SAID("fmi2 value 7", said(it, fmi2GetReal(it.component, &unknown, 1, &value)));
    EXPECT_SAID("fmi2 value 8", said(it, fmi2SetReal(it.component, &unknown, 1, &value)));
  }
  const fmi2ValueReference speed = it.reference("planet.speed"), rollers = it.reference("bearing.rollers");
  EXPECT_SAID("fmi2 value 9", said(it, fmi2GetReal(it.component, nullptr, 1, &value)));
  EXPECT_SAID("fmi2 value 10", said(it, fmi2GetReal(it.component, &speed, 1, nullptr)));
  EXPECT_SAID("fmi2 value 11", said(it, fmi2SetReal(it.component, &speed, 1, nullptr)));
  EXPECT_SAID("fmi2 value 12", said(it, fmi2GetReal(it.component, &rollers, 1, &value)));
  int number = 0;
  EXPECT_SAID("fmi2 value 13", said(it, fmi2GetInteger(it.component, &speed, 1, &number)));
  EXPECT_EQ(fmi2GetInteger(it.component, &rollers, 1, &number), fmi2OK);
  EXPECT_EQ(number, 15);
  EXPECT_SAID("fmi2 value 14", said(it, fmi2SetInteger(it.component, &rollers, 1, &number)));
  EXPECT_SAID("fmi2 value 15", said(it, fmi2GetBoolean(it.component, &speed, 1, &number)));
  fmi2String text = nullptr;
  EXPECT_SAID("fmi2 value 16", said(it, fmi2GetString(it.component, &speed, 1, &text)));
  EXPECT_SAID("fmi2 value 17", said(it, fmi2GetInteger(it.component, &rollers, 1, nullptr)));
  EXPECT_EQ(fmi2GetReal(it.component, nullptr, 0, nullptr), fmi2OK);
  EXPECT_SAID("fmi2 status 1", said(it, fmi2GetStatus(it.component, fmi2DoStepStatus, nullptr)));
  EXPECT_SAID("fmi2 status 2", said(it, fmi2GetRealStatus(it.component, fmi2LastSuccessfulTime, nullptr)));
}

TEST_F(Fmi2Refusals, OneWrongValueSetsNone) {
  Instance2 it(*resources);
  const double before = it.get("planet.speed");
  const fmi2ValueReference both[] = {it.reference("planet.speed"), it.reference("carrier.speed")};
  const double values[] = {7.0, kNaN};
  EXPECT_SAID("fmi2 of two 1", said(it, fmi2SetReal(it.component, both, 2, values)));
  EXPECT_EQ(it.get("planet.speed"), before);
}

TEST_F(Fmi2Refusals, ParametersThatMakeNoBearing) {
  Instance2 it(*resources);
  it.set("bearing.pitch_diameter", 1.0);
  it.set("bearing.roller_diameter", 2.0);
  ASSERT_EQ(fmi2SetupExperiment(it.component, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
  ASSERT_EQ(fmi2EnterInitializationMode(it.component), fmi2OK);
  EXPECT_SAID("fmi2 no bearing 1", said(it, fmi2ExitInitializationMode(it.component)));
  EXPECT_EQ(fmi2Reset(it.component), fmi2OK);
  EXPECT_EQ(it.begin(), fmi2OK) << it.messages.last();
}

TEST_F(Fmi2Refusals, DerivativesOfInputs) {
  Instance2 it(*resources);
  const fmi2ValueReference speed = it.reference("planet.speed"), force = it.reference("force.x");
  const int first = 1, zeroth = 0, third = 3;
  const double one = 1.0;
  EXPECT_SAID("fmi2 slope 1", said(it, fmi2SetRealInputDerivatives(it.component, &speed, 1, &first, &one)));
  ASSERT_EQ(it.begin(), fmi2OK);
  EXPECT_SAID("fmi2 slope 2", said(it, fmi2SetRealInputDerivatives(it.component, &force, 1, &first, &one)));
  EXPECT_SAID("fmi2 slope 3", said(it, fmi2SetRealInputDerivatives(it.component, &speed, 1, &zeroth, &one)));
  EXPECT_SAID("fmi2 slope 4", said(it, fmi2SetRealInputDerivatives(it.component, &speed, 1, &third, &one)));
  EXPECT_SAID("fmi2 slope 5", said(it, fmi2SetRealInputDerivatives(it.component, &speed, 1, &first, &kNaN)));
  EXPECT_SAID("fmi2 slope 6", said(it, fmi2SetRealInputDerivatives(it.component, &speed, 1, nullptr, &one)));
  double value = 0.0;
  EXPECT_SAID("fmi2 slope 7",
              said(it, fmi2GetRealOutputDerivatives(it.component, &force, 1, &first, &value)));
  EXPECT_SAID("fmi2 slope 8",
              said(it, fmi2GetDirectionalDerivative(it.component, &speed, 1, &speed, 1, &one, &value)));
  EXPECT_SAID("fmi2 slope 9",
              said(it, fmi2GetDirectionalDerivative(it.component, &force, 1, &force, 1, &one, &value)));
  EXPECT_SAID("fmi2 slope 10",
              said(it, fmi2GetDirectionalDerivative(it.component, &force, 1, &speed, 1, nullptr, &value)));
}

TEST_F(Fmi2Refusals, InputsBeyondAllMeasure) {
  Instance2 it(*resources);
  ASSERT_EQ(it.begin(), fmi2OK);
  const fmi2ValueReference force = it.reference("force.x");
  double value = 0.0;
  it.set("planet.displacement.x", 1e308);
  EXPECT_SAID("fmi2 beyond 1", said(it, fmi2GetReal(it.component, &force, 1, &value)));
  it.set("planet.velocity.x", 1e308);
  EXPECT_SAID("fmi2 beyond 2", said(it, it.step(0.0, 1e3)));
}

TEST_F(Fmi2Refusals, MoreStepsThanAllowed) {
  system::DrivenBearingSetup setup = test::bearing_model();
  setup.most_steps = 20;
  const Resources few(numbers_of(setup));
  Instance2 it(few);
  ASSERT_EQ(it.begin(), fmi2OK);
  EXPECT_SAID("fmi2 most steps", said(it, it.step(0.0, 1.0)));
}

TEST_F(Fmi2Refusals, NoMemory) {
  Instance2 it(*resources);
  const Status status = guarded(it.component, "fmi2DoStep", [](Instance&) { throw std::bad_alloc(); });
  EXPECT_SAID("fmi2 memory", said(it, static_cast<fmi2Status>(status)));
}

TEST_F(Fmi2Refusals, States) {
  Instance2 it(*resources), other(*resources);
  fmi2FMUstate state = nullptr, none = nullptr;
  int stranger = 0;
  size_t size = 0;
  ASSERT_EQ(fmi2GetFMUstate(it.component, &state), fmi2OK);
  EXPECT_SAID("fmi2 state 1", said(it, fmi2SetFMUstate(it.component, nullptr)));
  EXPECT_SAID("fmi2 state 2", said(it, fmi2SetFMUstate(it.component, &stranger)));
  EXPECT_SAID("fmi2 state 3", said(other, fmi2SetFMUstate(other.component, state)));
  EXPECT_SAID("fmi2 state 4", said(it, fmi2GetFMUstate(it.component, nullptr)));
  EXPECT_SAID("fmi2 state 5", said(it, fmi2SerializedFMUstateSize(it.component, none, &size)));
  EXPECT_SAID("fmi2 state 6", said(it, fmi2SerializedFMUstateSize(it.component, state, nullptr)));
  EXPECT_EQ(fmi2FreeFMUstate(it.component, nullptr), fmi2OK);
  EXPECT_EQ(fmi2FreeFMUstate(it.component, &none), fmi2OK);
  fmi2FMUstate copy = state;
  ASSERT_EQ(fmi2FreeFMUstate(it.component, &state), fmi2OK);
  EXPECT_SAID("fmi2 state 7", said(it, fmi2SetFMUstate(it.component, copy)));
  EXPECT_SAID("fmi2 state 8", said(it, fmi2FreeFMUstate(it.component, &copy)));
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
  EXPECT_SAID("fmi2 bytes 1", said(it, fmi2SerializeFMUstate(it.component, state, bytes.data(), size - 1)));
  ASSERT_EQ(fmi2SerializeFMUstate(it.component, state, bytes.data(), size), fmi2OK);
  for (const size_t length : {size_t{0}, size_t{7}, size_t{40}, size / 2, size - 8, size - 1})
    EXPECT_SAID("fmi2 bytes 2", said(it, fmi2DeSerializeFMUstate(it.component, bytes.data(), length, &made)));
  for (const size_t position :
       {size_t{0}, size_t{8}, size_t{16}, size_t{24}, size_t{32}, size_t{50}, size - 1}) {
    std::vector<char> broken = bytes;
    broken[position] = static_cast<char>(broken[position] ^ 0x21);
    EXPECT_SAID("fmi2 bytes 3", said(it, fmi2DeSerializeFMUstate(it.component, broken.data(), size, &made)));
  }
  EXPECT_SAID("fmi2 bytes 4", said(it, fmi2DeSerializeFMUstate(it.component, nullptr, size, &made)));
  EXPECT_EQ(made, nullptr);
  const StateSizes sizes{.parameters = 0, .inputs = 0};
  const auto crafted = [&](const InstanceState& wrong) {
    const std::string written = bytes_of(wrong, 7);
    return messages::refusal<Refused>([&] { state_from(written.data(), written.size(), 7, sizes); });
  };
  EXPECT_SAID("fmi2 bytes without number", crafted({.time = kNaN}));
  EXPECT_SAID("fmi2 bytes without phase", crafted({.phase = static_cast<Phase>(5)}));
  const std::string written = bytes_of({}, 7);
  EXPECT_REFUSED(Refused, "fmi2 bytes of fewer",
                 state_from(written.data(), written.size(), 7, {.parameters = 1, .inputs = 0}));
  const Resources others(numbers_of(test::gear_model()));
  Instance2 gears(others);
  EXPECT_SAID("fmi2 bytes 5",
              said(gears, fmi2DeSerializeFMUstate(gears.component, bytes.data(), size, &made)));
}

TEST_F(Fmi2Refusals, LogCategories) {
  Instance2 it(*resources, true);
  const fmi2String known[] = {"logStatusDiscard"}, unknown[] = {"logNothing"}, null[] = {nullptr};
  EXPECT_SAID("fmi2 category 1", said(it, fmi2SetDebugLogging(it.component, fmi2True, 1, unknown)));
  EXPECT_SAID("fmi2 category 2", said(it, fmi2SetDebugLogging(it.component, fmi2True, 1, null)));
  EXPECT_EQ(fmi2SetDebugLogging(it.component, fmi2True, 1, known), fmi2OK);
  EXPECT_EQ(it.step(0.0, 1e-5), fmi2Error);
  EXPECT_TRUE(it.messages.list.empty()) << "an error is not among the chosen categories";
  EXPECT_EQ(fmi2SetDebugLogging(it.component, fmi2False, 0, nullptr), fmi2OK);
  EXPECT_SAID("fmi2 category 3", said(it, it.step(0.0, 1e-5)));
}

}  // namespace
}  // namespace orbearing::fmu::fmi2_refusals_test
