// A ring and the gear inside it as a pair of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "gearset/gear_pair.hpp"
#include "gearset/mesh/planetary_meshes.hpp"
#include "gearset/planet_body.hpp"
#include "tests/unit/gearset/reference_sets.hpp"

namespace orbearing::gearset::internal_pair_test {
namespace {

constexpr double round_off = 1e-12;  // relative

GearPair internal_of(int first, int second) {
  GearPair pair{{first, second}, {0.0, 0.0}, 2e-3, 20e-3, 10e-3, {}};
  pair.kind = InternalPair{};
  return pair;
}

/// Ring and planet of a set, the planet first.
GearPair pair_of_set(const PlanetarySet& set, const WorkingGeometry& geometry) {
  GearPair pair{{set.planet_teeth, set.ring_teeth},
                {geometry.planet_shift, set.ring_shift},
                set.module,
                set.face_width,
                set.planet_bore,
                set.rack,
                set.helix_angle};
  pair.kind = InternalPair{};
  return pair;
}

// Printed example of a maker's formulas for internal gears: 16 and 24 teeth of module 3, shift of the ring
// 0.5.
TEST(InternalPair, HasThePrintedGeometry) {
  GearPair pair{{16, 24}, {0.0, 0.5}, 3e-3, 20e-3, 20e-3, {}};
  pair.kind = InternalPair{};
  const InternalMesh mesh = internal_mesh(pair);
  constexpr double printed = 1e-4;  // relative: digits of the source
  EXPECT_NEAR(mesh.mesh.working_pressure_angle * 180.0 / std::numbers::pi / 31.0938, 1.0, printed);
  EXPECT_NEAR(mesh.centre_distance / 13.1683e-3, 1.0, printed);
  EXPECT_NEAR(2.0 * mesh.inside.base_radius / 45.1052e-3, 1.0, printed);
  EXPECT_NEAR(2.0 * mesh.ring.base_radius / 67.6578e-3, 1.0, printed);
}

// Teeth of one gear fill the spaces of the other at the working circles: no backlash.
TEST(InternalPair, LeavesNoBacklash) {
  GearPair pair = internal_of(20, 51);
  pair.shift = {0.3, 0.65};
  const InternalMesh g = internal_mesh(pair);
  const double inside = g.centre_distance * 20.0 / 31.0, ring = g.centre_distance * 51.0 / 31.0;
  const double thickness =
      2.0 * inside * half_thickness_angle(g.inside, inside) + 2.0 * ring * half_thickness_angle(g.ring, ring);
  EXPECT_NEAR(thickness, 2.0 * std::numbers::pi * inside / 20.0, 1e-14);
  pair.shift = {0.3, 0.3};  // equal: the reference distance
  EXPECT_NEAR(internal_mesh(pair).centre_distance, 2e-3 * 31.0 / 2.0, 1e-15);
}

// The ring mesh of a planetary set, alone: geometry and stiffness.
TEST(InternalPair, IsTheRingMeshOfASet) {
  const mechanics::Material steel{.youngs_modulus = 206e9, .poisson_ratio = 0.3};
  for (const PlanetarySet& set : {reducer(), wind_stage()}) {
    const WorkingGeometry geometry = working_geometry(set);
    const GearPair pair = pair_of_set(set, geometry);
    EXPECT_TRUE(pair_problems(pair).empty());
    const InternalMesh alone = internal_mesh(pair);
    EXPECT_NEAR(alone.centre_distance / geometry.centre_distance, 1.0, round_off);
    EXPECT_NEAR(alone.mesh.working_pressure_angle / geometry.ring_mesh.working_pressure_angle, 1.0, 1e-11);
    EXPECT_NEAR(alone.mesh.contact_ratio / geometry.ring_mesh.contact_ratio, 1.0, 1e-10);
    const PlanetaryMeshes in_set = planetary_meshes(set, geometry, {}, steel, {});
    const MeshingGears gears = meshing_gears(
        make_mesh_gear(alone.ring, std::get<InternalPair>(pair.kind).ring_outside * alone.ring.root_radius, pair.face_width, steel),
        make_mesh_gear(alone.inside, 0.5 * pair.bore, pair.face_width, steel), alone.centre_distance, false);
    const MeshStiffness mesh = mesh_stiffness(gears);
    EXPECT_NEAR(mesh.curve.mean() / in_set.ring.curve.mean(), 1.0, 1e-9);
    for (const double fraction : {0.05, 0.3, 0.9})
      EXPECT_NEAR(mesh.curve.value(fraction) / in_set.ring.curve.value(fraction), 1.0, 1e-7);
  }
}

// Whichever is stated first, the gear with more teeth is the ring.
TEST(InternalPair, OrderChangesNoGeometry) {
  GearPair one = internal_of(20, 51), other = internal_of(51, 20);
  one.shift = {0.1, 0.2}, other.shift = {0.2, 0.1};
  EXPECT_EQ(one.ring(), 1u);
  EXPECT_EQ(other.ring(), 0u);
  EXPECT_EQ(internal_mesh(one).centre_distance, internal_mesh(other).centre_distance);
  EXPECT_EQ(internal_mesh(one).mesh.contact_ratio, internal_mesh(other).mesh.contact_ratio);
}

TEST(InternalPair, ProblemsNameThePositionAndWhatIsRequired) {
  const auto text_of = [](const GearPair& pair) {
    std::string text;
    for (const Warning& problem : pair_problems(pair)) text += problem.key + ": " + problem.text + "\n";
    return text;
  };
  EXPECT_NE(text_of(internal_of(30, 30)).find("pair.teeth: found a ring with as many teeth"),
            std::string::npos);
  GearPair wide = internal_of(20, 51);
  wide.bore = 40e-3;
  EXPECT_NE(text_of(wide).find("pair.bore: found a bore of 40"), std::string::npos);
  GearPair apart = internal_of(20, 51);
  apart.shift = {1.9, -1.9};
  EXPECT_NE(text_of(apart).find("pair.profile_shift: "), std::string::npos);
  EXPECT_TRUE(text_of(internal_of(20, 51)).empty());
}

// Few teeth apart, standard tips foul each other outside the path of contact; eq. (25) of gearset/README.md.
TEST(InternalPair, TipsThatFoulAreWarnedOf) {
  const auto fouls = [](int inside) {
    for (const Warning& warning : pair_warnings(internal_mesh(internal_of(inside, 60))))
      if (warning.text.find("tips of inner gear and ring foul") != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(fouls(57));
  EXPECT_FALSE(fouls(30));
}

// Area of the ring: the disc of its outside less the external gear that fills it, but for the tip and root
// circles that both gears have of their own.
TEST(InternalPair, RingIsTheDiscLessWhatFillsIt) {
  const BasicRack rack{.clearance = 0.0, .root_fillet_radius = 0.0};
  const RingTooth ring = make_ring_tooth(60, 0.0, 2e-3, rack);
  const ExternalTooth filling = make_external_tooth(60, 0.0, 2e-3, rack);
  const double outside = 70e-3;
  const double disc = std::numbers::pi * outside * outside;
  // Equal root and tip circles; below the base circle the gear's foot is a trochoid, where the ring has
  // radial flanks.
  EXPECT_NEAR(ring.tip_radius, filling.root_radius, 1e-15);
  const double left = disc - section_moments(ring, outside).area - section_moments(filling, 0.0).area;
  EXPECT_LT(std::abs(left), 2e-3 * section_moments(ring, outside).area);
}

}  // namespace
}  // namespace orbearing::gearset::internal_pair_test
