// The C interface of FMI 2.0: runs of bearing and gear set.
#include <gtest/gtest.h>

#include "coupling/system/driven_gears.hpp"
#include "tests/unit/fmu/fmu_model.hpp"

namespace orbearing::fmu::fmi2_test {
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

// The same run without any interface.
system::DrivenBearing direct(const bearing::motion::BoreMotion& motion, int steps) {
  system::DrivenBearing bearing(bearing_model());
  bearing.initialize(motion);
  const system::BoreInputs inputs = orbearing::test::constant_polynomial(motion);
  double time = 0.0;
  for (int i = 0; i < steps; ++i) {
    bearing.advance({time, time + kStep}, inputs);
    time += kStep;
  }
  return bearing;
}

TEST(Fmi2Bearing, RunsAsWithoutInterface) {
  Instance2 instance(bearing_resources());
  ASSERT_NE(instance.component, nullptr);
  press(instance);
  ASSERT_EQ(instance.begin(), fmi2OK) << instance.messages.last();
  run(instance, 0, 30);
  const bearing::motion::BoreMotion motion = orbearing::test::pressed_motion();
  const system::DrivenBearingOutput now = direct(motion, 30).output(motion);
  EXPECT_EQ(instance.get("force.x"), now.reaction.force.x());
  EXPECT_EQ(instance.get("force.y"), now.reaction.force.y());
  EXPECT_EQ(instance.get("moment"), now.reaction.moment);
  EXPECT_EQ(instance.get("life_used"), now.life_used);
  EXPECT_EQ(instance.get("cage.slip"), now.cage_slip);
  EXPECT_EQ(instance.get("roller[15].outer_load"), now.outer_load[14]);
  EXPECT_LT(instance.get("force.y"), -100.0) << "a planet pushed forward is pushed back";
  EXPECT_TRUE(instance.messages.list.empty());
}

TEST(Fmi2Bearing, AllInputsZeroIsLegal) {
  Instance2 instance(bearing_resources());
  instance.set("planet.speed", 0.0);
  instance.set("carrier.speed", 0.0);
  ASSERT_EQ(instance.begin(), fmi2OK) << instance.messages.last();
  run(instance, 0, 20);
  EXPECT_TRUE(std::isfinite(instance.get("force.x")));
  EXPECT_EQ(instance.get("cage.slip"), 0.0);
  EXPECT_EQ(instance.get("revolutions"), 0.0);
}

TEST(Fmi2Bearing, StepsOfAnySizeLeadTheSameWay) {
  Instance2 coarse(bearing_resources()), fine(bearing_resources());
  for (Instance2* one : {&coarse, &fine}) {
    press(*one);
    one->set("simulation.length_error", 1e-13);
    ASSERT_EQ(one->begin(), fmi2OK);
  }
  ASSERT_EQ(coarse.step(0.0, 5e-5), fmi2OK);
  double time = 0.0;
  for (const double size : {1e-9, 3e-6, 4.6999e-5}) {
    ASSERT_EQ(fine.step(time, size), fmi2OK) << fine.messages.last();
    time += size;
  }
  // Both follow the same path, each with its own internal steps: their error is that of 1e-13 m at a
  // stiffness of the contacts of some 1e8 N/m, many steps long.
  EXPECT_NEAR(coarse.get("force.y"), fine.get("force.y"), 1e-3 * std::fabs(fine.get("force.y")));
}

TEST(Fmi2Bearing, DisplacementGoesOnWithItsVelocity) {
  Instance2 instance(bearing_resources());
  press(instance);
  ASSERT_EQ(instance.begin(), fmi2OK);
  instance.set("planet.velocity.y", 0.01);
  instance.set("carrier.acceleration", 100.0);
  const double speed = instance.get("carrier.speed");
  ASSERT_EQ(instance.step(0.0, kStep), fmi2OK);
  EXPECT_DOUBLE_EQ(instance.get("planet.displacement.y"), 25e-6 + 0.01 * kStep);
  EXPECT_EQ(instance.get("planet.displacement.x"), 2e-6);
  EXPECT_DOUBLE_EQ(instance.get("carrier.speed"), speed + 100.0 * kStep);
}

TEST(Fmi2Bearing, DerivativesOfInputsHoldForOneStep) {
  Instance2 instance(bearing_resources());
  press(instance);
  ASSERT_EQ(instance.begin(), fmi2OK);
  const fmi2ValueReference references[] = {instance.reference("planet.velocity.y"),
                                           instance.reference("planet.velocity.y"),
                                           instance.reference("planet.speed")};
  const int orders[] = {1, 2, 1};
  const double values[] = {3.0, 2e5, 50.0};
  ASSERT_EQ(fmi2SetRealInputDerivatives(instance.component, references, 3, orders, values), fmi2OK);
  const double speed = instance.get("planet.speed"), h = kStep;
  ASSERT_EQ(instance.step(0.0, h), fmi2OK) << instance.messages.last();
  EXPECT_DOUBLE_EQ(instance.get("planet.velocity.y"), 3.0 * h + 1e5 * h * h);
  EXPECT_DOUBLE_EQ(instance.get("planet.displacement.y"), 25e-6 + 1.5 * h * h + 1e5 * h * h * h / 3.0);
  EXPECT_DOUBLE_EQ(instance.get("planet.speed"), speed + 50.0 * h);
  const double velocity = instance.get("planet.velocity.y");
  ASSERT_EQ(instance.step(h, h), fmi2OK);
  EXPECT_EQ(instance.get("planet.velocity.y"), velocity);
}

TEST(Fmi2Bearing, TwoInstancesDoNotFeelEachOther) {
  Instance2 alone(bearing_resources());
  press(alone);
  ASSERT_EQ(alone.begin(), fmi2OK);
  run(alone, 0, 10);
  Instance2 first(bearing_resources()), second(bearing_resources());
  press(first);
  second.set("planet.displacement.x", -20e-6);
  second.set("bearing.radial_clearance", 10e-6);
  ASSERT_EQ(first.begin(), fmi2OK);
  ASSERT_EQ(second.begin(), fmi2OK);
  for (int i = 0; i < 10; ++i) {
    run(first, i, i + 1);
    run(second, i, i + 1);
  }
  EXPECT_EQ(forces(first), forces(alone));
  EXPECT_NE(forces(second), forces(alone));
}

TEST(Fmi2Bearing, ResetAndANewInstanceBeginAfresh) {
  Instance2 instance(bearing_resources());
  std::vector<std::vector<double>> results;
  for (int round = 0; round < 2; ++round) {
    press(instance);
    ASSERT_EQ(instance.begin(), fmi2OK);
    run(instance, 0, 8);
    results.push_back(forces(instance));
    ASSERT_EQ(fmi2Terminate(instance.component), fmi2OK);
    ASSERT_EQ(fmi2Reset(instance.component), fmi2OK);
    EXPECT_EQ(instance.get("planet.displacement.y"), 0.0);
  }
  EXPECT_EQ(results[0], results[1]);
  Instance2 other(bearing_resources());
  press(other);
  ASSERT_EQ(other.begin(), fmi2OK);
  run(other, 0, 8);
  EXPECT_EQ(forces(other), results[0]);
}

TEST(Fmi2Bearing, OutputsDuringInitializationFollowInputsAndParameters) {
  Instance2 instance(bearing_resources());
  ASSERT_EQ(fmi2SetupExperiment(instance.component, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
  ASSERT_EQ(fmi2EnterInitializationMode(instance.component), fmi2OK);
  press(instance);
  const double pressed = instance.get("force.y");
  instance.set("bearing.radial_clearance", 20e-6);
  const double loose = instance.get("force.y");
  EXPECT_LT(pressed, loose);
  press(instance);
  instance.set("bearing.radial_clearance", bearing_model().bearing.radial_clearance);
  EXPECT_EQ(instance.get("force.y"), pressed);
}

TEST(Fmi2Gears, RunsAsWithoutInterface) {
  const Resources resources(numbers_of(test::gear_model()));
  Instance2 instance(resources);
  ASSERT_NE(instance.component, nullptr);
  ASSERT_EQ(instance.begin(), fmi2OK) << instance.messages.last();
  system::DrivenGears gears(test::gear_model());
  gears.initialize(0.0);
  std::vector<system::InputPolynomial> inputs(gears.inputs().size());  // x, y, moment of each planet
  for (std::size_t i = 0; i < inputs.size() / 3; ++i) {
    const std::string planet = "planet[" + std::to_string(i + 1) + "].";
    inputs[3 * i] = system::InputPolynomial::constant(100.0);
    inputs[3 * i + 1] = system::InputPolynomial::constant(-900.0 - 10.0 * double(i));
    instance.set(planet + "force.x", 100.0);
    instance.set(planet + "force.y", -900.0 - 10.0 * double(i));
  }
  double time = 0.0;
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(instance.step(i * kStep, kStep), fmi2OK) << instance.messages.last();
    gears.advance({time, time + kStep}, inputs);
    time += kStep;
  }
  const system::DrivenGearsOutput now = gears.output();
  EXPECT_EQ(instance.get("planet[2].displacement.y"), now.planets[1].displacement.y());
  EXPECT_EQ(instance.get("planet[4].velocity.x"), now.planets[3].velocity.x());
  EXPECT_EQ(instance.get("planet[1].speed"), now.planets[0].speed);
  EXPECT_EQ(instance.get("planet[3].ring_mesh_force"), now.planets[2].ring_mesh_force);
  EXPECT_EQ(instance.get("carrier.speed"), now.carrier_speed);
}

// Phases of meshes, cage and races begin at the start of the experiment, not at zero of the clock, and no
// step has another length by round-off: the same numbers to the last bit.
TEST(Fmi2, ALateStartIsTheSameRun) {
  const Resources gear_resources(numbers_of(test::gear_model()));
  const auto outputs = [&](const Resources& resources, bool gears, double start) {
    Instance2 instance(resources);
    if (!gears) press(instance);
    EXPECT_EQ(instance.begin(start), fmi2OK) << instance.messages.last();
    std::vector<double> values;
    for (int i = 0; i < 30; ++i) {
      EXPECT_EQ(instance.step(start + i * kStep, kStep), fmi2OK) << instance.messages.last();
      if (gears)
        for (const char* name : {"planet[1].velocity.x", "planet[2].velocity.y", "planet[3].sun_mesh_force"})
          values.push_back(instance.get(name));
      else
        for (const double one : forces(instance)) values.push_back(one);
    }
    return values;
  };
  for (const double start : {10.0, 1.0 / 3.0, 1e6}) {
    EXPECT_EQ(outputs(gear_resources, true, start), outputs(gear_resources, true, 0.0)) << start;
    EXPECT_EQ(outputs(bearing_resources(), false, start), outputs(bearing_resources(), false, 0.0)) << start;
  }
}

}  // namespace
}  // namespace orbearing::fmu::fmi2_test
