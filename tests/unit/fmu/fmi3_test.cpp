// The C interface of FMI 3.0: the same model as through FMI 2.0, and what it asks for beyond.
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

class Instance3 {
 public:
  Instance3() {
    component =
        fmi3InstantiateCoSimulation("one", resources().token().c_str(), (resources().folder() + "/").c_str(),
                                    false, false, false, false, nullptr, 0, this, &take, nullptr);
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
    EXPECT_EQ(fmi3GetFloat64(component, &vr, 1, &value, 1), fmi3OK) << last;
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
  std::string last;
  double successful = -1.0;

 private:
  static void take(fmi3InstanceEnvironment to, fmi3Status, fmi3String, fmi3String text) {
    static_cast<Instance3*>(to)->last = text;
  }
};

void press(Instance3& it) {
  it.set("planet.displacement.x", 2e-6);
  it.set("planet.displacement.y", 25e-6);
}

// Issue 18, Build 6: start load and steps that are too long, as through FMI 2.0 (start_load_test.cpp).
TEST(Fmi3Bearing, BeginsUnderItsStartLoadAndSaysWhichStepIsTooLong) {
  Instance3 it;
  it.set("start_load.x", 250.0);
  it.set("start_load.y", 1060.0);
  ASSERT_EQ(it.begin(), fmi3OK) << it.last;
  EXPECT_NEAR(it.get("force.x"), -250.0, 1e-5);
  EXPECT_NEAR(it.get("force.y"), -1060.0, 1e-5);
  EXPECT_EQ(it.get("planet.displacement.y"), it.get("planet.start_displacement.y"));
  it.set("planet.velocity.y", 5e5);  // [m/s]  metres in one step
  EXPECT_EQ(it.step(0.0), fmi3Discard);
  EXPECT_NE(it.last.find("step too long: found 1e-05 s"), std::string::npos) << it.last;
  EXPECT_EQ(it.get("time"), 0.0);
}

TEST(Fmi3Bearing, RunsAsThroughFmi2) {
  Instance3 three;
  Instance2 two(resources());
  ASSERT_NE(three.component, nullptr) << three.last;
  press(three);
  test::press(two);
  ASSERT_EQ(three.begin(), fmi3OK) << three.last;
  ASSERT_EQ(two.begin(), fmi2OK);
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(three.step(i * kStep), fmi3OK) << three.last;
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
        << it.last;
    for (std::size_t u = 0; u < 2; ++u) {
      double weight[2] = {}, row[3] = {};
      weight[u] = 1.0;
      ASSERT_EQ(fmi3GetAdjointDerivative(it.component, unknowns, 2, knowns, 3, weight, 2, row, 3), fmi3OK)
          << it.last;
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
  ASSERT_EQ(fmi3DeserializeFMUState(other.component, bytes.data(), size, &moved), fmi3OK) << other.last;
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
  EXPECT_EQ(fmi3GetNumberOfVariableDependencies(it.component, resources().reference("time"), &number),
            fmi3Error);
}

TEST(Fmi3Bearing, RefusesWithAReason) {
  Instance3 it;
  const auto refused = [&](fmi3Status status) {
    EXPECT_EQ(status, fmi3Error);
    EXPECT_FALSE(it.last.empty());
    it.last.clear();
  };
  const fmi3ValueReference force = resources().reference("force.x");
  double value = 0.0;
  float single = 0.0f;
  refused(it.step(0.0));
  refused(fmi3EnterEventMode(it.component));
  refused(fmi3EnterStepMode(it.component));
  refused(fmi3EnterConfigurationMode(it.component));
  refused(fmi3EvaluateDiscreteStates(it.component));
  refused(fmi3SetTime(it.component, 0.0));
  refused(fmi3ActivateModelPartition(it.component, 0, 0.0));
  refused(fmi3GetFloat32(it.component, &force, 1, &single, 1));
  EXPECT_EQ(fmi3GetFloat32(it.component, nullptr, 0, nullptr, 0), fmi3OK);
  ASSERT_EQ(it.begin(), fmi3OK);
  refused(fmi3GetFloat64(it.component, &force, 1, &value, 2));
  refused(fmi3EnterInitializationMode(it.component, false, 0.0, 0.0, false, 0.0));
  EXPECT_EQ(fmi3DoStep(it.component, 0.0, kStep, true, nullptr, nullptr, nullptr, nullptr), fmi3OK);
  std::int32_t rollers = 0;
  const fmi3ValueReference number = resources().reference("bearing.rollers");
  EXPECT_EQ(fmi3GetInt32(it.component, &number, 1, &rollers, 1), fmi3OK);
  EXPECT_EQ(rollers, 15);
  const char* token = resources().token().c_str();
  const fmi3ValueReference intermediate[] = {force};
  EXPECT_EQ(fmi3InstantiateCoSimulation("a", token, nullptr, false, false, false, false, nullptr, 0, nullptr,
                                        nullptr, nullptr),
            nullptr);
  EXPECT_EQ(fmi3InstantiateCoSimulation("a", token, resources().folder().c_str(), false, false, false, false,
                                        intermediate, 1, nullptr, nullptr, nullptr),
            nullptr);
  EXPECT_EQ(
      fmi3InstantiateModelExchange("a", token, resources().folder().c_str(), false, false, nullptr, nullptr),
      nullptr);
  EXPECT_EQ(fmi3InstantiateScheduledExecution("a", token, resources().folder().c_str(), false, false, nullptr,
                                              nullptr, nullptr, nullptr, nullptr),
            nullptr);
}

}  // namespace
}  // namespace orbearing::fmu::fmi3_test
