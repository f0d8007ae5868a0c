#include "gearset/working_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tests/messages.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::working_geometry_test {
namespace {

constexpr double round_off =
    1e-10;  // relative; the working involute amplifies round-off near the rack's angle

TEST(WorkingGeometry, OfAStandardSetIsThatOfItsRack) {
  const WorkingGeometry geometry = working_geometry(standard_set());
  EXPECT_NEAR(geometry.centre_distance, 60e-3, round_off * 60e-3);
  EXPECT_NEAR(geometry.planet_shift, 0.0, round_off);
  EXPECT_NEAR(geometry.sun_mesh.working_pressure_angle, geometry.sun.pressure_angle, round_off);
  EXPECT_NEAR(geometry.ring_mesh.working_pressure_angle, geometry.sun.pressure_angle, round_off);
}

TEST(WorkingGeometry, KeepsEqualAndOppositeShiftsAtTheStandardCentreDistance) {
  PlanetarySet set = standard_set();
  set.sun_shift = 0.3;
  set.ring_shift = -0.3;
  const WorkingGeometry geometry = working_geometry(set);
  EXPECT_NEAR(geometry.centre_distance, 60e-3, round_off * 60e-3);
  EXPECT_NEAR(geometry.planet_shift, -0.3, round_off);
}

TEST(WorkingGeometry, RefusesTeethWithoutCommonCentreDistance) {
  PlanetarySet set = standard_set();
  set.ring_teeth = 60;
  EXPECT_REFUSED(std::domain_error, "working_geometry 1", working_geometry(set));
  set.ring_teeth = 25;
  EXPECT_REFUSED(std::domain_error, "working_geometry 2", working_geometry(set));
  set.ring_teeth = 200;
  EXPECT_REFUSED(std::domain_error, "working_geometry 3", working_geometry(set));
}

TEST(WorkingGeometry, RefusesShiftsWithoutCommonCentreDistance) {
  PlanetarySet set = standard_set();
  set.ring_shift = -5.0;
  EXPECT_REFUSED(std::domain_error, "working_geometry 4", working_geometry(set));
}

// Both sides: no distance is short enough, none is long enough; the message names the input to change, not a
// search without a bracket.
TEST(WorkingGeometry, SaysWhichShiftsHaveNoCommonCentreDistance) {
  const auto said = [](double ring_shift) -> std::string {
    PlanetarySet set = standard_set();
    set.ring_shift = ring_shift;
    try {
      working_geometry(set);
    } catch (const std::domain_error& refused) {
      return refused.what();
    }
    return "accepted";
  };
  EXPECT_EQ(said(0.2), "accepted");
  for (const double shift : {-5.0, 50.0})
    EXPECT_EQ(said(shift).rfind("no planet shift gives", 0), 0u) << said(shift);
}

TEST(ContactPath, OfAnUndercutPlanetEndsWhereItsInvoluteDoes) {
  const WorkingGeometry geometry = working_geometry(reducer());
  ASSERT_TRUE(geometry.planet.undercut);
  const double foot =
      std::sqrt(std::pow(geometry.planet.form_radius, 2) - std::pow(geometry.planet.base_radius, 2));
  EXPECT_NEAR(geometry.sun_mesh.path.begin, foot, round_off * foot);
  EXPECT_NEAR(geometry.ring_mesh.path.begin, foot, round_off * foot);
}

TEST(ContactPath, OfAStandardPairFollowsTheTextbookFormula) {
  const ExternalTooth a = make_external_tooth(50, 0.0, 2e-3, {});
  const ExternalTooth b = make_external_tooth(70, 0.0, 2e-3, {});
  const double distance = a.pitch_radius + b.pitch_radius;
  const auto reach = [](const ExternalTooth& tooth) {
    return std::sqrt(std::pow(tooth.tip_radius, 2) - std::pow(tooth.base_radius, 2));
  };
  const double pitch = std::numbers::pi * 2e-3 * std::cos(a.pressure_angle);
  const double expected = (reach(a) + reach(b) - distance * std::sin(a.pressure_angle)) / pitch;
  EXPECT_NEAR(contact_ratio(external_contact_path(a, b, distance), b), expected, round_off);
}

TEST(ContactPath, IsNegativeWhereGearsDoNotReachEachOther) {
  const ExternalTooth gear = make_external_tooth(50, 0.0, 2e-3, {});
  EXPECT_LT(external_contact_path(gear, gear, 106e-3).length(), 0.0);
}

}  // namespace
}  // namespace orbearing::gearset::working_geometry_test
