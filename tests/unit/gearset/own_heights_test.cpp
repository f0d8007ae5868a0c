// Addendum and clearance for each gear, and the web factor of thin discs.
#include <gtest/gtest.h>

#include <cmath>

#include "gearset/checks.hpp"
#include "gearset/mesh/iso6336.hpp"
#include "tests/unit/mesh/example_gears.hpp"

namespace orbearing::gearset::own_heights_test {
namespace {

constexpr double round_off = 1e-12;

TEST(OwnHeights, ChangeTipAndRootOfTheirGearAlone) {
  PlanetarySet set = reducer();
  const WorkingGeometry before = working_geometry(set);
  set.sun_heights = {.addendum = 0.9, .clearance = 0.35};
  set.planet_heights = {.clearance = 0.3};
  set.ring_heights = {.addendum = 0.95};
  const WorkingGeometry after = working_geometry(set);
  const double m = set.module;
  EXPECT_EQ(after.centre_distance, before.centre_distance);
  EXPECT_NEAR(after.sun.tip_radius, before.sun.tip_radius - 0.1 * m, round_off);
  EXPECT_NEAR(after.sun.root_radius, before.sun.root_radius, round_off);  // 0.9 + 0.35
  EXPECT_NEAR(after.planet.tip_radius, before.planet.tip_radius, round_off);
  EXPECT_NEAR(after.planet.root_radius, before.planet.root_radius - 0.05 * m, round_off);
  EXPECT_NEAR(after.ring.tip_radius, before.ring.tip_radius + 0.05 * m, round_off);
  EXPECT_NEAR(after.ring.root_radius, before.ring.root_radius - 0.05 * m, round_off);
  // A tip that is shorter leaves contact earlier: by the tangent length, over the base pitch.
  EXPECT_LT(after.sun_mesh.contact_ratio, before.sun_mesh.contact_ratio);
}

TEST(OwnHeights, AreCheckedAgainstTheFillet) {
  PlanetarySet set = reducer();
  set.planet_heights.addendum = 1.5;  // a rack that ends in a point
  ASSERT_FALSE(assembly_problems(set).empty());
  EXPECT_EQ(assembly_problems(reducer()).size(), 0u);
}

// C_B of both gears is the mean of their racks' [ISO6336].
TEST(OwnHeights, CountHalfEachInTheStandard) {
  BasicRack deep;
  deep.clearance = 0.45;
  const auto stiffness = [](const BasicRack& first, const BasicRack& second) {
    return iso6336_stiffness({.first_teeth = 30,
                              .second_teeth = 45,
                              .rack = first,
                              .contact_ratio = 1.6,
                              .second_rack = second})
        .mesh;
  };
  const double both = stiffness(deep, deep), none = stiffness({}, {});
  EXPECT_NEAR(stiffness({}, deep), 0.5 * (both + none), round_off * none);
  EXPECT_NEAR(both / none, (1.0 + 0.5 * (1.2 - 1.45)) / (1.0 + 0.5 * (1.2 - 1.25)), round_off);
}

// By hand; beside the factor that a commercial program prints for webs of a quarter of the face
// [Reboucas2021].
TEST(WebFactor, IsThatOfTheStandard) {
  EXPECT_EQ(web_factor({}), 1.0);
  EXPECT_NEAR(web_factor({.thickness = 0.25, .rim = 5.0}), 1.0 + std::log(0.25) / (5.0 * std::exp(1.0)),
              round_off);
  EXPECT_NEAR(web_factor({.thickness = 0.25, .rim = 3.5}), 0.862, 0.5e-3);
  EXPECT_EQ(web_factor({.thickness = 0.1, .rim = 0.5}), web_factor({.thickness = 0.2, .rim = 1.0}));
  EXPECT_GT(web_factor({.thickness = 1.2, .rim = 3.5}), 1.0);
}

TEST(WebFactor, SoftensTheMeshesOfASet) {
  PlanetarySet set = reducer();
  const PlanetaryMeshes whole = meshes_of(set);
  set.web = {.thickness = 0.3, .rim = 3.0};
  const PlanetaryMeshes webbed = meshes_of(set);
  for (const double fraction : {0.1, 0.9}) {
    EXPECT_NEAR(webbed.sun.curve.value(fraction) / whole.sun.curve.value(fraction), web_factor(set.web),
                round_off);
    EXPECT_NEAR(webbed.ring.curve.value(fraction) / whole.ring.curve.value(fraction), web_factor(set.web),
                round_off);
  }
  EXPECT_NEAR(webbed.sun.curve.mean() / whole.sun.curve.mean(), web_factor(set.web), round_off);
}

}  // namespace
}  // namespace orbearing::gearset::own_heights_test
