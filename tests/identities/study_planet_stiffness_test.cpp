// Stiffness in the set's modes: meshes and bearings of a planet as one spring, against the equilibrium itself
// and against its limits.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "coupling/analysis/planet_stiffness.hpp"
#include "gearset/rim/rim_influence.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis::study_planet_stiffness_test {
namespace {

constexpr double kSun = 5.5e8, kRing = 6.5e8;  // [N/m]

PlanetaryDrivetrain elastic_reducer() {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.rim = PlanetRim::elastic;
  drivetrain.cage_positions = 4;
  return drivetrain;
}

// As a rim that is a million times stiffer.
DrivetrainGeometry stiff_rim(const PlanetaryDrivetrain& drivetrain) {
  DrivetrainGeometry geometry = derive(drivetrain);
  gearset::rim::RimInfluence rim = *geometry.rim;
  rim.race *= 1e-6;
  rim.meshes *= 1e-6;
  for (gearset::rim::RaceForm* form : {&rim.by_sun, &rim.by_ring}) {
    form->cosine *= 1e-6;
    form->sine *= 1e-6;
  }
  geometry.rim = std::make_shared<const gearset::rim::RimInfluence>(rim);
  return geometry;
}

// The outer rings of both bearings, 11.9 mm each, stiffen the rim.
TEST(PlanetRim, HasTheRingsOfAllItsBearings) {
  PlanetaryDrivetrain two = elastic_reducer(), one = two;
  ASSERT_EQ(two.bearings_per_planet, 2);
  const DrivetrainGeometry geometry = derive(two);
  const gearset::rim::RimSection section =
      gearset::rim::rim_section(two.set, geometry.gears, geometry.bearing.outer_radius, 2 * 11.9e-3);
  const Eigen::ArrayXd race = gearset::rim::rim_influence(section, geometry.gears, two.bearing.material).race;
  EXPECT_TRUE(geometry.rim->race.isApprox(race, 1e-12));
  one.bearings_per_planet = 1;
  EXPECT_GT(derive(one).rim->race[2], 1.05 * race[2]);  // half of the rings: bends more
}

TEST(PlanetStiffness, OfAStiffRimIsThatOfItsParts) {
  const PlanetaryDrivetrain drivetrain = elastic_reducer();
  const DrivetrainGeometry geometry = stiff_rim(drivetrain);
  Eigen::Matrix4d parts = Eigen::Matrix4d::Zero();
  parts.diagonal().head<2>() << kSun, kRing;
  parts.bottomRightCorner<2, 2>() = bearing_tangent(drivetrain, geometry).stiffness;
  EXPECT_LT((planet_stiffness(drivetrain, geometry, kSun, kRing) - parts).norm(), 1e-4 * parts.norm());
}

// Over positions that lie within a pitch, whatever the number of rollers: 15 times 15 positions of 1/4 or
// 1/16 would be the same ones.
TEST(PlanetStiffness, IsThatOfItsPartsWithOtherNumbersOfRollers) {
  for (const int rollers : {12, 13, 14}) {
    PlanetaryDrivetrain drivetrain = elastic_reducer();
    drivetrain.bearing.rollers().count = rollers;
    const DrivetrainGeometry geometry = stiff_rim(drivetrain);
    Eigen::Matrix4d parts = Eigen::Matrix4d::Zero();
    parts.diagonal().head<2>() << kSun, kRing;
    parts.bottomRightCorner<2, 2>() = bearing_tangent(drivetrain, geometry).stiffness;
    EXPECT_LT((planet_stiffness(drivetrain, geometry, kSun, kRing) - parts).norm(), 1e-4 * parts.norm())
        << rollers;
  }
}

TEST(PlanetStiffness, IsSymmetricAndSofterThanItsParts) {
  const PlanetaryDrivetrain drivetrain = elastic_reducer();
  const Eigen::Matrix4d soft = planet_stiffness(drivetrain, derive(drivetrain), kSun, kRing);
  const Eigen::Matrix4d stiff = planet_stiffness(drivetrain, stiff_rim(drivetrain), kSun, kRing);
  EXPECT_LT((soft - soft.transpose()).norm(), 1e-10 * soft.norm());
  EXPECT_LT(soft(0, 0), 0.95 * stiff(0, 0));
  EXPECT_LT(soft(1, 1), 0.95 * stiff(1, 1));
}

// A thick rim, on a single narrow bearing: no direction has a negative compliance, and all of it is nearly
// rigid.
TEST(PlanetStiffness, OfAThickRimIsNearlyThatOfItsParts) {
  PlanetaryDrivetrain drivetrain = elastic_reducer();
  drivetrain.set.module *= 2.0;
  drivetrain.bearings_per_planet = 1;
  const DrivetrainGeometry geometry = derive(drivetrain);
  Eigen::Matrix4d parts = Eigen::Matrix4d::Zero();
  parts.diagonal().head<2>() << kSun, kRing;
  PlanetaryDrivetrain rigid = drivetrain;
  rigid.rim = PlanetRim::rigid;
  parts.bottomRightCorner<2, 2>() = bearing_tangent(rigid, derive(rigid)).stiffness;
  const Eigen::Matrix4d found = planet_stiffness(drivetrain, geometry, kSun, kRing);
  EXPECT_EQ(Eigen::LLT<Eigen::Matrix4d>(found).info(), Eigen::Success);
  EXPECT_LT((found - parts).norm(), 0.1 * parts.norm());
}

// With the meshes' forces given, the displacement of the planet under a load of its own is that of its
// bearings.
TEST(PlanetStiffness, UnderGivenMeshForcesIsThatOfTheBearing) {
  const PlanetaryDrivetrain drivetrain = elastic_reducer();
  const DrivetrainGeometry geometry = derive(drivetrain);
  const Eigen::Matrix4d compliance = planet_stiffness(drivetrain, geometry, kSun, kRing).inverse();
  const Eigen::Matrix2d alone = bearing_tangent(drivetrain, geometry).stiffness.inverse();
  EXPECT_LT((compliance.bottomRightCorner<2, 2>() - alone).norm(), 1e-6 * alone.norm());
}

}  // namespace
}  // namespace orbearing::analysis::study_planet_stiffness_test
