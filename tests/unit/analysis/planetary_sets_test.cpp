// Planetary sets from structures of inputs, without a case.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "coupling/analysis/drivetrain_warnings.hpp"
#include "coupling/analysis/plausible_values.hpp"
#include "coupling/analysis/set_gears.hpp"
#include "coupling/analysis/set_quantities.hpp"
#include "tests/coupled_reducer.hpp"

namespace orbearing::analysis::planetary_sets_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr double round_off = 1e-12;

analysis::NamedSet reducer() {
  analysis::NamedSet set{"", example::reducer(), {}};
  set.geometry = analysis::derive(set.drivetrain);
  return set;
}

analysis::SetGears gears() {
  analysis::SetGears gears;
  gears.choice.mesh_damping_ratio = gears.choice.bearing_damping_ratio = 0.05;
  gears.choice.support_damping_ratio = 0.05;
  gears.choice.backlash = 100e-6;
  for (analysis::GearMemberChoice* member : {&gears.choice.sun, &gears.choice.ring, &gears.choice.carrier})
    member->support_stiffness = 1e8;
  return gears;
}

std::map<std::string, double> values_of(const SetQuantities& quantities) {
  described::Record record;
  describe(record, quantities);
  std::map<std::string, double> values;
  for (const described::Entry& entry : record.entries())
    values[entry.name] = std::get<described::Numbers>(entry.content).values.front();
  return values;
}

TEST(SetGears, AreThoseThatAreAssembledByHand) {
  const analysis::NamedSet set = reducer();
  const gearset::dynamics::SetParameters by_hand = example::reducer_gears(set.drivetrain);
  const gearset::dynamics::SetParameters found =
      analysis::gear_model(set.drivetrain, set.geometry, gears()).parameters;
  EXPECT_EQ(found.sun_mesh.stiffness.mean(), by_hand.sun_mesh.stiffness.mean());
  EXPECT_EQ(found.ring_mesh.damping, by_hand.ring_mesh.damping);
  EXPECT_EQ(found.planet.mass, by_hand.planet.mass);
  EXPECT_EQ(found.planet.bearing_stiffness, by_hand.planet.bearing_stiffness);
}

// Meshes that were computed before are found again: only where all that they follow from is equal.
TEST(SetGears, MeshesFollowFromTeethBodiesAndMaterial) {
  const auto mean = [](const analysis::PlanetaryDrivetrain& drivetrain, const analysis::SetGears& of) {
    return analysis::set_meshes(drivetrain, gearset::working_geometry(drivetrain.set), of).sun.curve.mean();
  };
  const analysis::PlanetaryDrivetrain drivetrain = example::reducer();
  const double first = mean(drivetrain, gears());
  analysis::PlanetaryDrivetrain shifted = drivetrain, bored = drivetrain, tall = drivetrain;
  shifted.set.sun_shift += 0.01;
  bored.set.planet_bore *= 0.9;
  tall.set.sun_heights.addendum = 1.01;
  analysis::SetGears hollow = gears(), soft = gears();
  hollow.choice.bodies.sun_bore = 0.7;
  soft.material.youngs_modulus *= 0.5;
  EXPECT_NE(mean(shifted, gears()), first);
  EXPECT_NE(mean(bored, gears()), first);
  EXPECT_NE(mean(tall, gears()), first);
  EXPECT_NE(mean(drivetrain, hollow), first);
  EXPECT_NEAR(mean(drivetrain, soft) / first, 0.5, 0.01);
  EXPECT_EQ(mean(drivetrain, gears()), first);
}

TEST(SetQuantities, AreThoseOfTheSet) {
  analysis::NamedSet set = reducer();
  const auto values = values_of(quantities_of(set, gears()));
  const double sun = set.drivetrain.drive.speed;
  EXPECT_NEAR(values.at("operation.carrier_speed_rpm"), sun * 37.0 / (37.0 + 79.0), round_off * sun);
  EXPECT_EQ(values.at("gearset.centre_distance_mm"), set.geometry.gears.centre_distance);
  EXPECT_GT(values.at("one_pin_off.load_share"), 1.0);
  EXPECT_GT(values.at("one_pin_off.shortest_life_h"), 0.0);
  EXPECT_FALSE(values.contains("bearing.clearance.operating_um"));
}

// Unequal loads have no reference in planets that are stated as unequal.
TEST(SetQuantities, OnePinIsOffWherePlanetsCarryAlike) {
  analysis::NamedSet set = reducer();
  set.drivetrain.uneven_planets = true;
  EXPECT_FALSE(quantities_of(set, gears()).one_pin_off.value);
  set.drivetrain.uneven_planets = false;
  set.name = "first";
  EXPECT_FALSE(quantities_of(set, gears()).one_pin_off.value);
}

TEST(SetQuantities, StateWhyTheyAreNotComputed) {
  analysis::NamedSet set = reducer();
  set.drivetrain.drive.power = 0.0;
  const SetQuantities quantities = quantities_of(set, gears());
  EXPECT_FALSE(quantities.duty.failure.empty());
  EXPECT_TRUE(std::isnan(values_of(quantities).at("operation")));
}

TEST(SetQuantities, ClearanceOfMountedBearingsAtEachSpeed) {
  analysis::NamedSet set = reducer();
  set.drivetrain.mounting.state = bearing::ClearanceState::unmounted;
  set.drivetrain.mounting.unmounted_clearance = 37e-6;
  set.drivetrain.bearing.inner.seat_diameter = 25e-3;
  set.drivetrain.bearing.outer.seat_diameter = 47e-3;
  analysis::mount(set.drivetrain);
  const SetQuantities quantities =
      quantities_of(set, gears(), {{"slow", 0.1 * set.drivetrain.drive.speed}, {"fast", 2e3}});
  ASSERT_TRUE(quantities.clearance.value) << quantities.clearance.failure;
  const auto& at = quantities.clearance.value->at_speeds;
  ASSERT_EQ(at.size(), 2U);
  EXPECT_EQ(at.front().first, "slow");
  EXPECT_LT(at.front().second, at.back().second);  // a fast planet opens
}

TEST(DrivetrainWarnings, BeginWithTheKeyOfTheirSet) {
  analysis::NamedSet set = reducer();
  set.drivetrain.dynamics.cage.guide_diameter = 0.0;
  set.drivetrain.mounting.state = bearing::ClearanceState::unmounted;
  EXPECT_THAT(cage_warnings({set}), ElementsAre(StartsWith("bearing.cage.guide_land_diameter: 0;")));
  EXPECT_THAT(clearance_warnings({set}),
              ElementsAre(StartsWith("bearing.fit: "), StartsWith("bearing.temperature: ")));
  set.name = "second";
  EXPECT_THAT(cage_warnings({set}), ElementsAre(StartsWith("sets.second.bearing.cage.")));
  set.drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  set.drivetrain.mounting.outer_interference = 0.0;
  set.drivetrain.mounting.planet_temperature = 20.0;
  EXPECT_THAT(cage_warnings({set}), IsEmpty());
  EXPECT_THAT(clearance_warnings({set}), IsEmpty());
}

TEST(DrivetrainWarnings, FewLaminaeResolveNoTilt) {
  analysis::NamedSet set = reducer();
  set.drivetrain.bearing.rollers().laminae = 9;
  const auto few = HasSubstr("9 resolve a profile or a tilt coarsely");
  const auto rated = HasSubstr("9 laminae of straight rollers");
  EXPECT_THAT(lamina_warnings({set}), ElementsAre(rated));
  set.drivetrain.misalignment.planet_tilt = 1e-3;
  EXPECT_THAT(lamina_warnings({set}), ElementsAre(few, rated));
  set.drivetrain.bearing.rollers().laminae = 30;
  EXPECT_THAT(lamina_warnings({set}), IsEmpty());
}

TEST(DrivetrainWarnings, SlopesBesideAComputedTilt) {
  analysis::PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.set.flanks.ring_slope = 10e-6;
  EXPECT_THAT(slope_warnings(drivetrain), IsEmpty());
  drivetrain.seats.tilt = analysis::TiltState::computed;
  ASSERT_EQ(slope_warnings(drivetrain).size(), 1U);
  EXPECT_EQ(slope_warnings(drivetrain).front().key, "gearset.lead_slope.ring");
}

TEST(PlausibleValues, OfASetAreThoseOfItsSpeedsAndLoads) {
  const analysis::NamedSet set = reducer();
  const gearset::MeanLoads loads = analysis::bearing_duty(set.drivetrain, set.geometry).gears;
  for (const Observation& one : observations({set}))
    if (one.key == "n_dm") {
      EXPECT_NEAR(one.value, std::abs(loads.planet_speed_relative) / example::rpm * 35.64, 1e-6);
    }
  EXPECT_EQ(judge(observations({set})).status, "ok");
  EXPECT_THAT(judge({{"unit_load_MPa", 3000.0}}).status, StartsWith("implausible: "));
}

}  // namespace
}  // namespace orbearing::analysis::planetary_sets_test
