#include "coupling/analysis/stated_drivetrain.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "coupling/analysis/derived_defaults.hpp"
#include "coupling/analysis/set_problems.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis::stated_drivetrain_test {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;

StatedSet stated_reducer() {
  const analysis::PlanetaryDrivetrain reducer = example::reducer();
  StatedSet set{.teeth = reducer.set, .planets = reducer};
  set.planets.bearing.material.density = 7800.0;
  set.teeth.planet_bore = set.teeth.density = 0.0;  // which follow
  return set;
}
StatedDrivetrain single(const StatedSet& set) {
  return {.sets = {{"", set}}, .drive = example::reducer().drive};
}

// Two sets in a row: the first one's carrier drives the second one's sun, both rings are held.
StatedDrivetrain in_a_row() {
  using gearset::Member;
  StatedSet first = stated_reducer(), second = stated_reducer();
  second.planets.bearing.rollers().count = 0;
  return {.sets = {{"first", first}, {"second", second}},
          .shafts = {{.name = "in", .members = {{0, Member::sun}}, .motor = true},
                     {.name = "between", .members = {{0, Member::carrier}, {1, Member::sun}}},
                     {.name = "out", .members = {{1, Member::carrier}}, .load = true},
                     {.name = "housing", .members = {{0, Member::ring}, {1, Member::ring}}, .ground = true}},
          .drive = example::reducer().drive};
}

std::vector<std::string> keys(const mechanics::Problems& problems) {
  std::vector<std::string> keys;
  for (const mechanics::Problem& problem : problems) keys.push_back(problem.key);
  return keys;
}

TEST(StatedSets, HaveTheBoreThatTheirBearingsFill) {
  StatedSet set = stated_reducer();
  EXPECT_EQ(with_bore(set).planet_bore, 47e-3);
  EXPECT_EQ(with_bore(set).density, 7800.0);
  set.planets.bearing.outer.seat_diameter = 0.0;
  set.planet_bore_ratio = 0.6;
  EXPECT_THAT(with_bore(set).planet_bore, DoubleEq(0.6 * 3e-3 * (22 - 2.5)));
  EXPECT_EQ(key_in_case(set, "bearing.outside_diameter"), "gearset.planet_bore_ratio");
  EXPECT_EQ(key_in_case(set, "gearset.module"), "gearset.module");
}

TEST(StatedSets, SayWhatMakesPlanetsCarryUnequalLoads) {
  StatedSet set = stated_reducer();
  EXPECT_EQ(unequal_loads_by(set), "");
  set.teeth.planet_angles = {0.0, 1.5, 3.2, 4.7};
  EXPECT_EQ(unequal_loads_by(set), "gearset.planet_angles");
  set.gears.choice.pin_error_tangential = {0.0, 0.0, 0.0, 0.0};
  EXPECT_EQ(unequal_loads_by(set), "gearset.planet_angles");
  set.gears.choice.pin_error_tangential = {0.0, 1e-6, 0.0, 0.0};
  EXPECT_EQ(unequal_loads_by(set), "gearset.dynamics.pin_error.tangential");
}

TEST(StatedSets, HaveRollersOfTheStatedProfile) {
  using namespace bearing::profile;
  StatedSet set = stated_reducer();
  set.planets.bearing.rollers().profile = CircularCrown{5.7e-3, 3e-6};
  const auto profile = [&] { return drivetrain_of(set, {}).bearing.rollers().profile; };
  EXPECT_EQ(profile(), Profile(CircularCrown{5.7e-3, 3e-6}));  // where none is stated
  set.profile.kind = Kind::straight;
  EXPECT_EQ(profile(), Profile(Straight{}));
}

TEST(StatedSets, WithoutACageHaveNone) {
  StatedSet set = stated_reducer();
  EXPECT_TRUE(drivetrain_of(set, {}).bearing.has_cage());
  set.complement = Complement::full;
  EXPECT_FALSE(drivetrain_of(set, {}).bearing.has_cage());
}

// Willis: the carrier turns z_s/(z_s + z_r) times as fast as the sun, here 37/116.
TEST(StatedDrivetrains, FollowTheSpeedOfTheMemberThatIsStated) {
  StatedDrivetrain in = single(stated_reducer());
  EXPECT_EQ(drive_of(in).motor_ratio, 1.0);
  in.drive.speed_of = gearset::SpeedOf::carrier;
  EXPECT_THAT(stated_speed_ratio(in), DoubleEq(37.0 / 116.0));
  EXPECT_THAT(drive_of(in).motor_ratio, DoubleEq(116.0 / 37.0));
  EXPECT_THAT(speed_problems(in, ""), IsEmpty());
  in.drive.speed_of = gearset::SpeedOf::ring;  // which is held
  EXPECT_THAT(keys(speed_problems(in, "")), ElementsAre("input.speed_of"));
  in.drive.speed_of = gearset::SpeedOf::planet;
  EXPECT_THAT(speed_problems(in, ""), IsEmpty());
  EXPECT_THAT(keys(speed_problems(in, "input.torque")), ElementsAre("input.speed_of"));
}

TEST(StatedDrivetrains, OfSeveralSetsShareWhatEnters) {
  const StatedDrivetrain in = in_a_row();
  EXPECT_THAT(bearing_set_names(in), ElementsAre("first"));
  const std::vector<analysis::NamedSet> with = bearing_sets(in), without = sets_without_bearing(in);
  ASSERT_EQ(with.size(), 1U);
  ASSERT_EQ(without.size(), 1U);
  const double ratio = 37.0 / 116.0;
  EXPECT_THAT(with[0].drivetrain.in_arrangement->speed.carrier, DoubleEq(ratio));
  EXPECT_NEAR(without[0].drivetrain.in_arrangement->speed.carrier, ratio * ratio, 1e-15);
  EXPECT_FALSE(with[0].drivetrain.mesh_variation);
  EXPECT_EQ(held_member_of(in, "second"), gearset::Member::ring);
  EXPECT_EQ(held_member_of(in, "third"), std::nullopt);
  EXPECT_EQ(stated_sets(in).size(), 2U);
}

TEST(StatedDrivetrains, HaveACarrierInThreeDimensionsWhereItsModelHolds) {
  StatedSet set = stated_reducer();
  EXPECT_FALSE(carrier_is_body(single(set)));
  set.carrier.positions = {-0.1, 0.1};
  set.carrier.radial_stiffness = {1e9, 1e9};
  EXPECT_TRUE(carrier_is_body(single(set)));
  for (const auto& change : std::vector<void (*)(StatedSet&)>{
           [](StatedSet& m) { m.teeth.fixed_member = gearset::Member::sun; },
           [](StatedSet& m) { m.planets.rim = analysis::PlanetRim::elastic; },
           [](StatedSet& m) { m.teeth.stepped.teeth = 18; }, [](StatedSet& m) { m.second_planet.teeth = 18; },
           [](StatedSet& m) { m.planets.bearing.rollers().count = 0; },
           [](StatedSet& m) { m.bearing_type = bearing::PlanetBearingType::tapered_roller; }}) {
    StatedSet other = set;
    change(other);
    EXPECT_FALSE(carrier_is_body(single(other)));
  }
}

// Each change, and where the objection goes.
struct Objection {
  const char* key;
  void (*change)(StatedSet&);
};

TEST(SetProblems, AreNoneOfASoundSet) {
  EXPECT_THAT(problems(stated_reducer()), IsEmpty());
  EXPECT_THAT(problems(StatedSet{}), IsEmpty());  // nothing is stated
}

TEST(SetProblems, AreThoseOfTheMemberThatDoesNotFit) {
  for (const auto& [key, change] : std::vector<Objection>{
           {"gearset.planets", [](StatedSet& m) { m.teeth.planets = 5; }},
           {"gearset.centre_distance", [](StatedSet& m) { m.geometry.centre_distance = 90e-3; }},
           {"traction.law",
            [](StatedSet& m) { m.planets.dynamics.race.traction = bearing::TractionLaw::ree_eyring; }},
           {"gearset.dynamics.pin_error.radial",
            [](StatedSet& m) {
              m.gears.choice.pin_error_radial = {1e-6, 0.0};
            }},
           {"gearset.dynamics.transmission_error.ring",
            [](StatedSet& m) {
              m.gears.choice.ring_error = {1e-6, 0.0};
            }},
           {"gearset.carrier.bearing_positions", [](StatedSet& m) { m.carrier.positions = {0.1}; }},
           {"gearset.carrier.rotor_moment",
            [](StatedSet& m) {
              m.carrier.positions = {-0.1, 0.1};
              m.carrier.rotor_moment = {1.0, 2.0, 3.0};
            }},
           {"bearing.inner_race.waviness.phase",
            [](StatedSet& m) {
              m.forms.inner.waviness = {{3.0}, {1e-6}, {0.0, 1.0}};
            }},
           {"bearing.outer_race.out_of_roundness.amplitude",
            [](StatedSet& m) { m.forms.outer.out_of_roundness.amplitudes = {1e-6}; }},
           {"bearing.per_planet", [](StatedSet& m) { m.planets.bearings_per_planet = 3; }},
           {"bearing.balls", [](StatedSet& m) { m.planets.rows.balls = 8; }},
           {"gearset.planet_rim",
            [](StatedSet& m) {
              m.planets.rim = analysis::PlanetRim::elastic;
              m.gears.choice.bearing_stiffness = 1e8;
            }},
           {"gearset.tooth_contact",
            [](StatedSet& m) {
              m.teeth.flanks.contact = gearset::ToothContact::loaded;
              m.gears.choice.separation = false;
            }},
           {"bearing.tilt_state", [](StatedSet& m) { m.planets.seats.tilt = analysis::TiltState::computed; }},
           {"bearing.axial_places",
            [](StatedSet& m) {
              m.planets.seats = {.tilt = analysis::TiltState::computed, .axial_positions = {-2e-3, 2e-3}};
              m.planets.bearing.rollers().laminae = 30;
            }},
           {"support.pin_span",
            [](StatedSet& m) {
              m.planets.seats = {.tilt = analysis::TiltState::computed, .span = 20e-3};
              m.planets.bearing.rollers().laminae = 30;
            }},
           {"bearing.roller_diameter_deviation",
            [](StatedSet& m) { m.planets.bearing.rollers().diameter_deviation.assign(16, 0.0); }}}) {
    StatedSet set = stated_reducer();
    change(set);
    EXPECT_THAT(keys(problems(set)), ElementsAre(key)) << key;
  }
}

TEST(SetProblems, OfOtherBearingsAreTheRefinementsOfCylindricalOnes) {
  StatedSet set = stated_reducer();
  set.bearing_type = bearing::PlanetBearingType::tapered_roller;
  EXPECT_THAT(problems(set), IsEmpty());
  set.complement = Complement::full;
  set.planets.misalignment.planet_tilt = 1e-3;
  set.planets.rows.preload = 100.0;
  set.planets.bearing.radial_clearance = 1e-5;
  set.planets.rows.distance = 5e-3;  // less than the width of a bearing
  EXPECT_THAT(keys(problems(set)), ElementsAre("bearing.complement", "bearing.misalignment.planet_tilt",
                                               "bearing.radial_clearance", "bearing.rows.distance"));
  set = stated_reducer();
  set.bearing_type = bearing::PlanetBearingType::spherical_roller;
  set.planets.bearings_per_planet = 1;
  set.teeth.helix_angle = 0.2;
  EXPECT_THAT(keys(problems(set)), ElementsAre("bearing.per_planet"));
}

TEST(SetProblems, OfTwoGearsOnAPlanetAreTheirCoupleAndTheirPlaces) {
  StatedSet set = stated_reducer();
  set.teeth.stepped = {.teeth = 22, .shift = 0.2618, .offset = 20e-3};
  EXPECT_THAT(keys(problems(set)), testing::Contains("gearset.stepped_planet.teeth"));
  EXPECT_THAT(keys(problems(set)), testing::Contains("gearset.stepped_planet.offset"));  // at least 28 mm
  set.teeth.stepped.offset = 28e-3;
  EXPECT_THAT(keys(problems(set)), testing::Not(testing::Contains("gearset.stepped_planet.offset")));
}

TEST(StageProblems, AreTeethAndRatiosOutOfRange) {
  EXPECT_THAT(problems(gearset::ParallelStages{}), IsEmpty());
  EXPECT_THAT(keys(problems({.behind = {{4, 40}}})), ElementsAre("parallel_stage.behind"));
  EXPECT_THAT(problems(gearset::ParallelStages{.front = {{10, 1000}}, .behind = {{1000, 10}}}), IsEmpty());
  EXPECT_THAT(keys(problems({.front = {{10, 1000}, {10, 1000}}, .behind = {{10, 1001}}})),
              ElementsAre("parallel_stage.behind"));  // beyond 1e6 in all
}

// A pin that fills the bore, between walls of half the face together: twice the bearings share it.
TEST(DerivedDefaults, OfThePinAreSharedByItsBearings) {
  StatedSet set = stated_reducer();
  const double of_two = defaults::PinStiffness::derive(set)->value;
  set.planets.bearings_per_planet = 1;
  EXPECT_THAT(defaults::PinStiffness::derive(set)->value, DoubleEq(2.0 * of_two));
  set.planets.seats = {.tilt = analysis::TiltState::stated, .ends = bearing::PinEnds::one};
  EXPECT_THAT(defaults::PinStiffness::derive(set)->value,
              DoubleEq(2.0 * of_two));  // not where tilts are stated
  set.planets.seats.tilt = analysis::TiltState::computed;
  EXPECT_LT(defaults::PinStiffness::derive(set)->value, of_two);
  set.planets.bearing.inner.seat_diameter = 0.0;
  EXPECT_FALSE(defaults::PinStiffness::derive(set).has_value());
}

TEST(DerivedDefaults, HaveTheKeysOfTheirInputs) {
  using namespace defaults;
  EXPECT_THAT(
      (std::vector<std::string>{PocketClearance::key(), PocketStiffness::key(), TouchDownStiffness::key(),
                                GuideLand::key(), PocketDamping::key(), SunSupport::key(), RingSupport::key(),
                                CarrierSupport::key(), Backlash::key(), SunTilt::key(), SunAxial::key(),
                                FlexpinDiameter::key(), PinStiffness::key()}),
      ElementsAre("bearing.cage.pocket_clearance", "bearing.cage.pocket_stiffness",
                  "bearing.cage.touch_down_stiffness", "bearing.cage.guide_land_diameter",
                  "bearing.cage.pocket_damping", "gearset.dynamics.sun.support_stiffness",
                  "gearset.dynamics.ring.support_stiffness", "gearset.dynamics.carrier.support_stiffness",
                  "gearset.dynamics.backlash", "gearset.dynamics.sun.tilt_stiffness",
                  "gearset.dynamics.sun.axial_stiffness", "support.pin_diameter", "support.stiffness"));
}

}  // namespace
}  // namespace orbearing::analysis::stated_drivetrain_test
