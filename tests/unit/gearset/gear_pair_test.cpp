#include "gearset/gear_pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "gearset/involute.hpp"

namespace orbearing::gearset::gear_pair_test {
namespace {

GearPair pair_of(int first, int second) {
  return {{first, second}, {0.0, 0.0}, 2e-3, 20e-3, 10e-3, {}};
}

TEST(PairGeometry, WithoutShiftsHasTheReferenceDistance) {
  const PairGeometry geometry = pair_geometry(pair_of(30, 20));
  EXPECT_NEAR(geometry.centre_distance, 50e-3, 1e-15);
  EXPECT_NEAR(geometry.working_pressure_angle, BasicRack{}.pressure_angle, 1e-14);
}

// Teeth and spaces fill the working circles: no backlash.
TEST(PairGeometry, LeavesNoBacklash) {
  GearPair pair = pair_of(20, 41);
  pair.shift = {0.4, -0.15};
  const PairGeometry g = pair_geometry(pair);
  const double first = g.centre_distance * 20.0 / 61.0, second = g.centre_distance * 41.0 / 61.0;
  const double thickness = 2.0 * first * half_thickness_angle(g.gears[0], first) +
                           2.0 * second * half_thickness_angle(g.gears[1], second);
  EXPECT_NEAR(thickness, 2.0 * std::numbers::pi * first / 20.0, 1e-14);
}

struct Mistake {
  std::string position, text;
  std::function<void(GearPair&)> make;
};

TEST(PairProblems, NameThePositionAndWhatIsRequired) {
  const std::vector<Mistake> mistakes{
      {"pair.profile_shift", "no involute is left",
       [](GearPair& p) {
         p.teeth = {5, 60}, p.shift = {-0.9, 0.0};
       }},
      {"pair.profile_shift", "larger sum",
       [](GearPair& p) {
         p.shift = {-1.0, -1.0};
       }},
      {"pair.profile_shift", "smaller sum",
       [](GearPair& p) {
         p.teeth = {5, 5}, p.shift = {2.0, 2.0};
       }},
      {"pair.profile_shift", "flanks that cross",
       [](GearPair& p) {
         p.shift = {2.0, 0.0};
       }},
      {"pair.bore", "root diameter of the second gear", [](GearPair& p) { p.bore = 36e-3; }},
      {"pair.bore", "more than zero", [](GearPair& p) { p.bore = 0.0; }},
      {"pair.driven_bore", "root diameter of the second gear", [](GearPair& p) { p.kind = ExternalPair{36e-3}; }},
      {"pair.root_fillet_radius", "fits on the rack's tip",
       [](GearPair& p) { p.rack.root_fillet_radius = 0.5; }},
      {"pair.addendum", "point", [](GearPair& p) { p.rack.addendum = 2.0; }},
  };
  for (const Mistake& mistake : mistakes) {
    GearPair pair = pair_of(30, 20);
    mistake.make(pair);
    std::string found;
    for (const Warning& problem : pair_problems(pair)) found += problem.key + ": " + problem.text + "\n";
    SCOPED_TRACE(mistake.text + " in\n" + found);
    EXPECT_NE(found.find(mistake.position + ": "), std::string::npos);
    EXPECT_NE(found.find(mistake.text), std::string::npos);
  }
}

TEST(PairProblems, AreNoneForSoundPairs) {
  for (const auto& [first, second] : {std::pair{62, 62}, {30, 20}, {25, 70}, {12, 100}, {2000, 2000}})
    EXPECT_TRUE(pair_problems(pair_of(first, second)).empty()) << first << "/" << second;
}

// A wheel takes a bore that its pinion could not; a gear inside a ring has the one bore there is.
TEST(PairProblems, AreNoneForAWideBoreOfTheWheelAlone) {
  GearPair pair = pair_of(30, 90);
  pair.kind = ExternalPair{100e-3};
  EXPECT_TRUE(pair_problems(pair).empty());
  EXPECT_EQ(pair.bore_of(0), 10e-3);
  EXPECT_EQ(pair.bore_of(1), 100e-3);
  pair.kind = InternalPair{};
  EXPECT_EQ(pair.bore_of(0), 10e-3);
  EXPECT_EQ(pair.bore_of(1), 10e-3);
}

TEST(PairWarnings, TellOfUndercutAndOfShortContact) {
  GearPair pair = pair_of(10, 40);
  const Warnings undercut = pair_warnings(pair_geometry(pair));
  ASSERT_FALSE(undercut.empty());
  EXPECT_NE(undercut[0].text.find("the first gear is undercut"), std::string::npos);
  pair = pair_of(30, 30);
  pair.rack = {.addendum = 0.5, .root_fillet_radius = 0.2};
  const Warnings shorter = pair_warnings(pair_geometry(pair));
  ASSERT_EQ(shorter.size(), 1U);
  EXPECT_NE(shorter[0].text.find("contact ratio of the pair"), std::string::npos);
}

TEST(PairWarnings, AreNoneForTheStandardPair) {
  EXPECT_TRUE(pair_warnings(pair_geometry(pair_of(62, 62))).empty());
}

}  // namespace
}  // namespace orbearing::gearset::gear_pair_test
