// The C interface of FMI 2.0: restored states, and slopes of outputs.
#include <gtest/gtest.h>

#include "tests/unit/fmu/fmu_model.hpp"

namespace orbearing::fmu::fmi2_states_test {
namespace {

using test::bearing_model;
using test::forces;
using test::Instance2;
using test::kStep;
using test::press;
using test::Resources;
using test::run;

const Resources& bearing_resources() {
  static const Resources resources(numbers_of(bearing_model()));
  return resources;
}

TEST(Fmi2Bearing, SaveAdvanceRestoreAdvanceGivesTheSameBits) {
  Instance2 instance(bearing_resources());
  press(instance);
  ASSERT_EQ(instance.begin(), fmi2OK);
  run(instance, 0, 5);
  instance.set("planet.velocity.x", 1e-3);
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2GetFMUstate(instance.component, &state), fmi2OK);
  run(instance, 5, 12);
  const std::vector<double> first = forces(instance);
  ASSERT_EQ(fmi2SetFMUstate(instance.component, state), fmi2OK);
  EXPECT_EQ(instance.get("time"), 5 * kStep);
  run(instance, 5, 12);
  EXPECT_EQ(forces(instance), first);

  size_t size = 0;
  ASSERT_EQ(fmi2SerializedFMUstateSize(instance.component, state, &size), fmi2OK);
  std::vector<char> bytes(size);
  ASSERT_EQ(fmi2SerializeFMUstate(instance.component, state, bytes.data(), size), fmi2OK);
  Instance2 other(bearing_resources());
  fmi2FMUstate moved = nullptr;
  ASSERT_EQ(fmi2DeSerializeFMUstate(other.component, bytes.data(), size, &moved), fmi2OK)
      << other.messages.last();
  ASSERT_EQ(fmi2SetFMUstate(other.component, moved), fmi2OK) << other.messages.last();
  run(other, 5, 12);
  EXPECT_EQ(forces(other), first);
  ASSERT_EQ(fmi2FreeFMUstate(instance.component, &state), fmi2OK);
  EXPECT_EQ(state, nullptr);
}

TEST(Fmi2Bearing, AStateBringsItsParametersBack) {
  Instance2 instance(bearing_resources());
  fmi2FMUstate fresh = nullptr;
  ASSERT_EQ(fmi2GetFMUstate(instance.component, &fresh), fmi2OK);
  press(instance);
  instance.set("bearing.radial_clearance", 30e-6);
  ASSERT_EQ(instance.begin(), fmi2OK);
  run(instance, 0, 3);
  ASSERT_EQ(fmi2SetFMUstate(instance.component, fresh), fmi2OK);
  EXPECT_EQ(instance.get("bearing.radial_clearance"), bearing_model().bearing.radial_clearance);
  press(instance);
  ASSERT_EQ(instance.begin(), fmi2OK) << instance.messages.last();
  run(instance, 0, 3);
  Instance2 other(bearing_resources());
  press(other);
  ASSERT_EQ(other.begin(), fmi2OK);
  run(other, 0, 3);
  EXPECT_EQ(forces(instance), forces(other));
}

TEST(Fmi2Bearing, DirectionalDerivativesAreSlopesOfTheOutputs) {
  Instance2 instance(bearing_resources());
  press(instance);
  ASSERT_EQ(instance.begin(), fmi2OK);
  run(instance, 0, 10);
  const fmi2ValueReference unknowns[] = {instance.reference("force.x"), instance.reference("force.y"),
                                         instance.reference("moment")};
  const std::pair<const char*, double> knowns[] = {{"planet.displacement.x", 1e-10},
                                                   {"planet.displacement.y", 1e-10},
                                                   {"planet.velocity.y", 1e-6},
                                                   {"planet.speed", 1e-4}};
  for (const auto& [name, step] : knowns) {
    const fmi2ValueReference known = instance.reference(name);
    const double seed = 2.0, middle = instance.get(name);
    double found[3];
    ASSERT_EQ(fmi2GetDirectionalDerivative(instance.component, unknowns, 3, &known, 1, &seed, found), fmi2OK)
        << instance.messages.last();
    std::vector<double> ends[2];
    for (const int sign : {-1, 1}) {
      instance.set(name, middle + sign * step);
      ends[sign > 0] = forces(instance);
    }
    instance.set(name, middle);
    for (std::size_t i = 0; i < 3; ++i) {
      const double slope = seed * (ends[1][i] - ends[0][i]) / (2.0 * step);
      // Round-off of forces of 1e4 N over the step, and curvature of the contacts.
      EXPECT_NEAR(found[i], slope, 1e-4 * std::fabs(slope) + 1e-11 * 1e4 / step) << name << " " << i;
    }
  }
}

TEST(Fmi2Bearing, OutputsDependOnTheInputsOfTheTableAndOnNoOthers) {
  Instance2 instance(bearing_resources());
  press(instance);
  ASSERT_EQ(instance.begin(), fmi2OK);
  run(instance, 0, 20);
  const ModelFacts facts = facts_of(bearing_resources().numbers());
  for (std::size_t input = 0; input < facts.inputs.size(); ++input) {
    const std::string& name = facts.inputs[input].name;
    const double middle = instance.get(name);
    std::vector<double> before;
    for (const system::Output& output : facts.outputs) before.push_back(instance.get(output.name));
    instance.set(name, middle + (input < 2 ? 1e-6 : input < 4 ? 1e-2 : 10.0));
    for (std::size_t i = 0; i < facts.outputs.size(); ++i) {
      const system::Output& output = facts.outputs[i];
      const bool listed = std::find(output.inputs.begin(), output.inputs.end(), input) != output.inputs.end();
      if (!listed) {
        EXPECT_EQ(instance.get(output.name), before[i]) << output.name << " by " << name;
      }
      if (listed && i < 3) {
        EXPECT_NE(instance.get(output.name), before[i]) << output.name << " by " << name;
      }
    }
    instance.set(name, middle);
  }
}

}  // namespace
}  // namespace orbearing::fmu::fmi2_states_test
