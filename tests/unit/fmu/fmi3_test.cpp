// The C interface of FMI 3.0: the same model as through FMI 2.0, and its additional requirements.
#include "coupling/fmu/fmi3.hpp"

#include <gtest/gtest.h>

#include "tests/unit/fmu/fmu_model.hpp"

namespace orbearing::fmu::fmi3_test {
namespace {

using test::Instance2;
using test::Resources;

constexpr double kStep = 1e-5;  // [s]

const Resources& resources() {
  static const Resources resources(numbers_of(test::bearing_model()));
  return resources;
}

void take(fmi3InstanceEnvironment to, fmi3Status status, fmi3String, fmi3String text) {
  static_cast<test::Messages*>(to)->list.emplace_back(status, text);
}

class Instance3 {
 public:
  Instance3() {
    component =
        fmi3InstantiateCoSimulation("one", resources().token().c_str(), (resources().folder() + "/").c_str(),
                                    false, false, false, false, nullptr, 0, &messages, &take, nullptr);
  }
  ~Instance3() { fmi3FreeInstance(component); }
  Instance3(const Instance3&) = delete;
  Instance3& operator=(const Instance3&) = delete;

  fmi3Status set(const char* name, double value) {
    const fmi3ValueReference vr = resources().reference(name);
    return fmi3SetFloat64(component, &vr, 1, &value, 1);
  }
  double get(const char* name) {
    const fmi3ValueReference vr = resources().reference(name);
    double value = std::nan("");
    EXPECT_EQ(fmi3GetFloat64(component, &vr, 1, &value, 1), fmi3OK) << messages.last();
    return value;
  }
  fmi3Status begin() {
    const fmi3Status entered = fmi3EnterInitializationMode(component, false, 0.0, 0.0, false, 0.0);
    return std::max(entered, fmi3ExitInitializationMode(component));
  }
  fmi3Status step(double time) {
    bool event = true, terminate = true, early = true;
    const fmi3Status status =
        fmi3DoStep(component, time, kStep, true, &event, &terminate, &early, &successful);
    EXPECT_FALSE(event || terminate || early);
    return status;
  }

  fmi3Instance component = nullptr;
  test::Messages messages;
  double successful = -1.0;
};

std::string said(Instance3& it, fmi3Status status) {
  return test::said(it.messages, status);
}

void press(Instance3& it) {
  it.set("planet.displacement.x", 2e-6);
  it.set("planet.displacement.y", 25e-6);
}

// Start load and steps that are too long, as through FMI 2.0 (start_load_test.cpp).
TEST(Fmi3Bearing, BeginsUnderItsStartLoadAndSaysWhichStepIsTooLong) {
  Instance3 it;
  it.set("start_load.x", 250.0);
  it.set("start_load.y", 1060.0);
  ASSERT_EQ(it.begin(), fmi3OK) << it.messages.last();
  EXPECT_NEAR(it.get("force.x"), -250.0, 1e-5);
  EXPECT_NEAR(it.get("force.y"), -1060.0, 1e-5);
  EXPECT_EQ(it.get("planet.displacement.y"), it.get("planet.start_displacement.y"));
  it.set("planet.velocity.y", 5e5);  // [m/s]  metres in one step
  EXPECT_SAID("fmi3 too long", said(it, it.step(0.0)));
  EXPECT_EQ(it.get("time"), 0.0);
}

TEST(Fmi3Bearing, RunsAsThroughFmi2) {
  Instance3 three;
  Instance2 two(resources());
  ASSERT_NE(three.component, nullptr) << three.messages.last();
  press(three);
  test::press(two);
  ASSERT_EQ(three.begin(), fmi3OK) << three.messages.last();
  ASSERT_EQ(two.begin(), fmi2OK);
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(three.step(i * kStep), fmi3OK) << three.messages.last();
    ASSERT_EQ(two.step(i * kStep, kStep), fmi2OK);
  }
  for (const char* name : {"force.x", "force.y", "moment", "cage.speed", "roller[7].outer_load"})
    EXPECT_EQ(three.get(name), two.get(name)) << name;
  EXPECT_DOUBLE_EQ(three.successful, 10 * kStep);
  EXPECT_EQ(three.step(0.0), fmi3Error);
  EXPECT_DOUBLE_EQ(three.successful, 10 * kStep);
}

TEST(Fmi3Bearing, AdjointIsTheTransposeOfTheDirectionalDerivative) {
  Instance3 it;
  press(it);
  ASSERT_EQ(it.begin(), fmi3OK);
  for (int i = 0; i < 10; ++i) ASSERT_EQ(it.step(i * kStep), fmi3OK);
  const fmi3ValueReference unknowns[] = {resources().reference("force.x"), resources().reference("force.y")};
  const fmi3ValueReference knowns[] = {resources().reference("planet.displacement.x"),
                                       resources().reference("planet.displacement.y"),
                                       resources().reference("planet.velocity.x")};
  for (std::size_t k = 0; k < 3; ++k) {
    double seed[3] = {}, column[2] = {};
    seed[k] = 1.0;
    ASSERT_EQ(fmi3GetDirectionalDerivative(it.component, unknowns, 2, knowns, 3, seed, 3, column, 2), fmi3OK)
        << it.messages.last();
    for (std::size_t u = 0; u < 2; ++u) {
      double weight[2] = {}, row[3] = {};
      weight[u] = 1.0;
      ASSERT_EQ(fmi3GetAdjointDerivative(it.component, unknowns, 2, knowns, 3, weight, 2, row, 3), fmi3OK)
          << it.messages.last();
      EXPECT_EQ(row[k], column[u]);
    }
    if (k < 2) {
      EXPECT_LT(column[k], -1e6) << "a pressed bearing pushes back";
    }
  }
}

TEST(Fmi3Bearing, StatesGoThroughBytes) {
  Instance3 it, other;
  press(it);
  ASSERT_EQ(it.begin(), fmi3OK);
  for (int i = 0; i < 4; ++i) ASSERT_EQ(it.step(i * kStep), fmi3OK);
  fmi3FMUState state = nullptr, moved = nullptr;
  ASSERT_EQ(fmi3GetFMUState(it.component, &state), fmi3OK);
  size_t size = 0;
  ASSERT_EQ(fmi3SerializedFMUStateSize(it.component, state, &size), fmi3OK);
  std::vector<fmi3Byte> bytes(size);
  ASSERT_EQ(fmi3SerializeFMUState(it.component, state, bytes.data(), size), fmi3OK);
  ASSERT_EQ(fmi3DeserializeFMUState(other.component, bytes.data(), size, &moved), fmi3OK)
      << other.messages.last();
  ASSERT_EQ(fmi3SetFMUState(other.component, moved), fmi3OK);
  for (int i = 4; i < 8; ++i) {
    ASSERT_EQ(it.step(i * kStep), fmi3OK);
    ASSERT_EQ(other.step(i * kStep), fmi3OK);
  }
  EXPECT_EQ(it.get("force.y"), other.get("force.y"));
  EXPECT_EQ(fmi3FreeFMUState(it.component, &state), fmi3OK);
}

TEST(Fmi3Bearing, DependenciesAreThoseOfTheTable) {
  Instance3 it;
  size_t number = 0;
  ASSERT_EQ(fmi3GetNumberOfVariableDependencies(it.component, resources().reference("force.x"), &number),
            fmi3OK);
  ASSERT_EQ(number, 5u);
  size_t of_dependent[5], of_independents[5];
  fmi3ValueReference independents[5];
  fmi3DependencyKind kinds[5];
  ASSERT_EQ(fmi3GetVariableDependencies(it.component, resources().reference("force.x"), of_dependent,
                                        independents, of_independents, kinds, 5),
            fmi3OK);
  EXPECT_EQ(independents[0], resources().reference("planet.displacement.x"));
  EXPECT_EQ(independents[4], resources().reference("planet.speed"));
  EXPECT_EQ(kinds[4], fmi3Dependent);
  const fmi3ValueReference time = resources().reference("time");
  EXPECT_SAID("fmi3 dependent", said(it, fmi3GetNumberOfVariableDependencies(it.component, time, &number)));
  EXPECT_SAID("fmi3 no kinds",
              said(it, fmi3GetVariableDependencies(it.component, resources().reference("force.x"),
                                                   of_dependent, independents, of_independents, nullptr, 5)));
}

TEST(Fmi3Bearing, RefusesWithAReason) {
  Instance3 it;
  const fmi3Instance one = it.component;
  const fmi3ValueReference force = resources().reference("force.x");
  double value = 0.0;
  float single = 0.0f;
  EXPECT_SAID("fmi3 step", said(it, it.step(0.0)));
  EXPECT_SAID("fmi3 events", said(it, fmi3EnterEventMode(one)));
  EXPECT_SAID("fmi3 step mode", said(it, fmi3EnterStepMode(one)));
  EXPECT_SAID("fmi3 configuration", said(it, fmi3EnterConfigurationMode(one)));
  EXPECT_SAID("fmi3 discrete", said(it, fmi3EvaluateDiscreteStates(one)));
  EXPECT_SAID("fmi3 set time", said(it, fmi3SetTime(one, 0.0)));
  EXPECT_SAID("fmi3 partition", said(it, fmi3ActivateModelPartition(one, 0, 0.0)));
  EXPECT_SAID("fmi3 single", said(it, fmi3GetFloat32(one, &force, 1, &single, 1)));
  EXPECT_EQ(fmi3GetFloat32(one, nullptr, 0, nullptr, 0), fmi3OK);
  ASSERT_EQ(it.begin(), fmi3OK);
  EXPECT_SAID("fmi3 two values", said(it, fmi3GetFloat64(one, &force, 1, &value, 2)));
  EXPECT_SAID("fmi3 entered", said(it, fmi3EnterInitializationMode(one, false, 0.0, 0.0, false, 0.0)));
  EXPECT_EQ(fmi3DoStep(one, 0.0, kStep, true, nullptr, nullptr, nullptr, nullptr), fmi3OK);
  std::int32_t rollers = 0;
  const fmi3ValueReference number = resources().reference("bearing.rollers");
  EXPECT_EQ(fmi3GetInt32(one, &number, 1, &rollers, 1), fmi3OK);
  EXPECT_EQ(rollers, 15);
}

TEST(Fmi3Bearing, InstancesThatAreNone) {
  test::Messages log;
  const std::string token = resources().token(), folder = resources().folder();
  const fmi3ValueReference force = resources().reference("force.x");
  const auto said_of = [&](fmi3Instance made) {
    EXPECT_EQ(made, nullptr);
    return with_names(test::said(log, fmi3Error), resources());
  };
  const auto cosim = [&](const char* name, const char* position, std::size_t intermediate) {
    return said_of(fmi3InstantiateCoSimulation(name, token.c_str(), position, false, false, false, false,
                                               &force, intermediate, &log, &take, nullptr));
  };
  EXPECT_SAID("fmi3 no resources", cosim("a", nullptr, 0));
  EXPECT_SAID("fmi3 no name", cosim("", folder.c_str(), 0));
  EXPECT_SAID("fmi3 intermediate", cosim("a", folder.c_str(), 1));
  EXPECT_SAID("fmi3 exchange", said_of(fmi3InstantiateModelExchange("a", token.c_str(), folder.c_str(), false,
                                                                    false, &log, &take)));
  EXPECT_SAID("fmi3 scheduled",
              said_of(fmi3InstantiateScheduledExecution("a", token.c_str(), folder.c_str(), false, false,
                                                        &log, &take, nullptr, nullptr, nullptr)));
}

}  // namespace
}  // namespace orbearing::fmu::fmi3_test
