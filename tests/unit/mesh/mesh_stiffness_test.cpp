#include "gearset/mesh/mesh_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/messages.hpp"
#include "tests/unit/mesh/example_gears.hpp"

namespace orbearing::gearset::mesh_stiffness_test {
namespace {

constexpr double round_off = 1e-12;
constexpr double of_the_table = 1e-7;  // fourth power of 1/96, with derivatives of the order of the value

std::vector<MeshingGears> example_meshes() {
  std::vector<MeshingGears> all;
  for (const auto& [first, second] : {std::pair{62, 62}, {30, 20}, {25, 70}, {12, 100}, {200, 300}})
    all.push_back(meshing(example_pair(first, second)));
  all.push_back(meshing(example_pair(20, 41, 0.4, -0.2), false));
  for (const PlanetarySet& set : all_sets()) {
    all.push_back(meshes_of(set).sun_gears);
    all.push_back(meshes_of(set).ring_gears);
  }
  return all;
}

TEST(PairCompliance, IsItsPartsInSeries) {
  for (const MeshingGears& gears : example_meshes()) {
    const PairCompliance pair = pair_compliance(gears, pitch_point(gears));
    double sum = pair.hertz;
    for (const GearCompliance& gear : {pair.first, pair.second}) {
      for (const double part : {gear.tooth.bending, gear.tooth.shear, gear.tooth.axial, gear.foundation}) {
        EXPECT_GT(part, 0.0);
        sum += part;
      }
    }
    EXPECT_NEAR(pair.sum(), sum, round_off * sum);
  }
}

TEST(MeshStiffness, IsTheSumOverThePairsThatTouch) {
  const MeshingGears gears = meshing(example_pair(62, 62));
  const double begin = gears.path.end;  // the tip of the driven gear
  const auto one = [&](double progress) {
    return 1.0 / pair_compliance(gears, begin - progress * gears.base_pitch).sum();
  };
  EXPECT_NEAR(mesh_stiffness_at(gears, 0.3), one(0.3) + one(1.3), round_off * 4e8);
  EXPECT_NEAR(mesh_stiffness_at(gears, 0.9), one(0.9), round_off * 4e8);
}

TEST(MeshStiffness, TableFollowsTheDirectEvaluation) {
  for (const MeshingGears& gears : example_meshes()) {
    const MeshStiffness mesh = mesh_stiffness(gears);
    for (int i = 0; i < 500; ++i) {
      const double fraction = (i + 0.37) / 500.0;
      const double direct = mesh_stiffness_at(gears, fraction);
      EXPECT_NEAR(mesh.curve.value(fraction), direct, of_the_table * direct);
    }
  }
}

TEST(MeshStiffness, JumpsWhereAPairComesAndWhereOneLeaves) {
  for (const MeshingGears& gears : example_meshes()) {
    const MeshStiffness mesh = mesh_stiffness(gears);
    ASSERT_EQ(mesh.curve.jumps().size(), 2U);
    EXPECT_EQ(mesh.curve.jumps()[0], 0.0);
    EXPECT_NEAR(mesh.curve.jumps()[1], mesh.contact_ratio - std::floor(mesh.contact_ratio), round_off);
    const double leaves = mesh.curve.jumps()[1];
    EXPECT_GT(mesh.curve.value(0.0), mesh.curve.value(std::nextafter(1.0, 0.0)));
    EXPECT_LT(mesh.curve.value(leaves), mesh.curve.value(std::nextafter(leaves, 0.0)));
  }
}

TEST(MeshStiffness, DoesNotDependOnWhichGearIsNamedFirst) {
  const GearPair pair = example_pair(20, 41, 0.4, -0.2);
  const GearPair swapped = example_pair(41, 20, -0.2, 0.4);
  const MeshStiffness a = mesh_stiffness(meshing(pair, true));
  const MeshStiffness b = mesh_stiffness(meshing(swapped, false));
  for (double fraction = 0.03; fraction < 1.0; fraction += 0.05)
    EXPECT_NEAR(a.curve.value(fraction), b.curve.value(fraction), 1e-9 * a.curve.mean());
  EXPECT_NEAR(a.at_pitch_point.first.sum(), b.at_pitch_point.second.sum(),
              1e-9 * a.at_pitch_point.first.sum());
}

TEST(MeshStiffness, RunsBackwardsWhereTheOtherGearDrives) {
  const GearPair pair = example_pair(20, 41, 0.4, -0.2);
  const MeshStiffness forth = mesh_stiffness(meshing(pair, true));
  const MeshStiffness back = mesh_stiffness(meshing(pair, false));
  for (double fraction = 0.03; fraction < 1.0; fraction += 0.05)
    EXPECT_NEAR(forth.curve.value(fraction), back.curve.value(forth.contact_ratio - fraction),
                of_the_table * forth.curve.mean());
}

TEST(MeshStiffness, GrowsWithModulusAndWidthAndNotWithSize) {
  GearPair pair = example_pair(30, 45, 0.2, 0.1);
  const double reference = mesh_stiffness(meshing(pair)).curve.mean();
  EXPECT_NEAR(mesh_stiffness(meshing(pair, true, {103e9, 0.3})).curve.mean(), reference / 2.0,
              round_off * reference);
  pair.face_width *= 3.0;
  EXPECT_NEAR(mesh_stiffness(meshing(pair)).curve.mean(), 3.0 * reference, 1e-9 * reference);
  pair.face_width /= 3.0;
  pair.module *= 7.0;
  pair.bore *= 7.0;
  EXPECT_NEAR(mesh_stiffness(meshing(pair)).curve.mean(), reference, 1e-9 * reference);
}

TEST(MeshStiffness, VanishesWhereNoPairTouches) {
  GearPair pair = example_pair(30, 30);
  pair.rack = {.addendum = 0.5, .root_fillet_radius = 0.2};
  const MeshStiffness mesh = mesh_stiffness(meshing(pair));
  ASSERT_LT(mesh.contact_ratio, 1.0);
  EXPECT_GT(mesh.curve.value(0.5 * mesh.contact_ratio), 0.0);
  EXPECT_EQ(mesh.curve.value(0.5 * (1.0 + mesh.contact_ratio)), 0.0);
}

TEST(MeshStiffness, CountsThreePairsOfLongTeeth) {
  GearPair pair = example_pair(60, 60);
  pair.rack = {.addendum = 1.3, .root_fillet_radius = 0.2};
  const MeshStiffness mesh = mesh_stiffness(meshing(pair));
  ASSERT_GT(mesh.contact_ratio, 2.0);
  const double single = 1.0 / mesh.at_pitch_point.sum();
  EXPECT_GT(mesh.curve.value(0.5 * (mesh.contact_ratio - 2.0)), 2.2 * single);
}

TEST(PitchPoint, DividesTheCentreDistanceAsTheTeethDo) {
  const GearPair pair = example_pair(20, 41, 0.4, -0.2);
  const PairGeometry geometry = pair_geometry(pair);
  const MeshingGears gears = meshing(pair);
  const double radius = std::hypot(geometry.gears[1].base_radius, pitch_point(gears));
  EXPECT_NEAR(radius, geometry.centre_distance * 41.0 / 61.0, 1e-12);
}

TEST(PitchPoint, OfARingMeshLiesOnThePlanetsWorkingCircle) {
  const PlanetarySet set = standard_set();
  const WorkingGeometry geometry = working_geometry(set);
  const double radius = std::hypot(geometry.planet.base_radius, pitch_point(meshes_of(set).ring_gears));
  EXPECT_NEAR(radius, geometry.centre_distance * set.planet_teeth / (set.ring_teeth - set.planet_teeth),
              1e-12);
}

TEST(MeshGear, MayStandOnAShaftOfItsRootDiameter) {
  const ExternalTooth gear = make_external_tooth(20, 0.0, 2e-3, {});
  EXPECT_GT(gear_compliance(make_mesh_gear(gear, 17.5e-3, 20e-3, {}), 7e-3).foundation, 0.0);
}

// Two thousand teeth on a 35 mm shaft: the polynomials give a negative compliance.
TEST(MeshGear, TakesTheElasticRingWhereThePolynomialsAreOfNoUse) {
  const ExternalTooth gear = make_external_tooth(2000, 0.0, 2e-3, {});
  const MeshGear mesh_gear = make_mesh_gear(gear, 100e-3, 20e-3, {});
  EXPECT_LT(sainsot_coefficients(mesh_gear.body.half_angle, 20.0).moment, 0.0);
  EXPECT_NEAR(mesh_gear.foundation.moment, 6.95, 0.01);
}

TEST(MeshGear, RefusesABodyOfNoThickness) {
  const ExternalTooth gear = make_external_tooth(30, 0.0, 2e-3, {});
  const RingTooth ring = make_ring_tooth(90, 0.0, 2e-3, {});
  EXPECT_REFUSED(std::domain_error, "mesh_stiffness 1",
                 make_mesh_gear(gear, 1.001 * gear.root_radius, 20e-3, {}));
  EXPECT_REFUSED(std::domain_error, "mesh_stiffness 2", make_mesh_gear(gear, 0.0, 20e-3, {}));
  EXPECT_REFUSED(std::domain_error, "mesh_stiffness 3", make_mesh_gear(ring, ring.root_radius, 20e-3, {}));
}

}  // namespace
}  // namespace orbearing::gearset::mesh_stiffness_test
