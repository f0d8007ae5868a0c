// Natural frequencies of a planetary set in three dimensions: a body on its bearings by closed form, and the
// set in its plane compared with the model of the plane.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "gearset/dynamics/modes.hpp"
#include "gearset/spatial/spatial_modes.hpp"

namespace orbearing::gearset::spatial::spatial_modes_test {
namespace {

using std::numbers::pi;

constexpr double kBase = 0.09, kPlanetBase = 0.17, kCentre = 0.29, kHelix = 0.13;

SpatialSet springs(double base_helix) {
  const double sun = std::acos((kBase + kPlanetBase) / kCentre),
               ring = std::acos((0.44 - kPlanetBase) / kCentre);
  SpatialSet set{.centre_distance = kCentre, .face_width = 0.2, .planet_base_radius = kPlanetBase};
  for (int n = 0; n < 4; ++n) set.angles.push_back(0.5 * pi * n);
  set.sun = {1.5e10, sun, base_helix};
  set.ring = {1.9e10, ring, base_helix};
  set.planet_bearings = {{-0.05, 1.1e9, 2e-5}, {0.05, 1.1e9, 2e-5}};
  set.planet_axial_stiffness = 1e9;
  set.sun_axial_stiffness = 4e8;
  set.sun_radial_stiffness = 2e8;
  set.carrier_bearings = {{-0.2, 1.3e9, 1e9, 1e-4}, {0.2, 1.3e9, 0.0, 1e-4}};
  return set;
}

MovingSet moving(double base_helix) {
  MovingSet all{.set = springs(base_helix)};
  all.carrier = {300.0, 14.0, 11.0, 0.0};
  all.sun = {40.0, 0.2, 0.25, 0.0};
  all.planet = {90.0, 1.3, 1.0, 0.0};
  all.ring = {200.0, 45.0, 24.0, 0.0};
  all.ring_support = {1e9, 2e9, 1e8, 0.0, true};
  return all;
}

// The same set as its plane has it.
dynamics::SetModel plane_of(const MovingSet& all) {
  const auto member = [](const RoundBody& body, double radius, double stiffness, double torsion, bool held) {
    dynamics::CentralMember central{body.mass, body.polar / (radius * radius), radius, {}};
    central.support.stiffness = stiffness;
    central.support.torsional_stiffness = torsion / (radius * radius);
    central.support.held_in_rotation = held;
    return central;
  };
  const auto mesh = [&](const SpatialMesh& of) {
    const double cosine = std::cos(of.base_helix);
    return dynamics::Mesh{
        .pressure_angle = of.pressure_angle,
        .stiffness = PeriodicCurve::constant(of.stiffness * all.set.face_width * cosine * cosine)};
  };
  dynamics::SetParameters set{.planets = 4};
  set.sun = member(all.sun, kBase, all.set.sun_radial_stiffness, all.sun_support.torsion, false);
  set.ring = member(all.ring, 0.44, all.ring_support.radial, 0.0, all.ring_support.held_in_rotation);
  set.carrier = member(all.carrier, kCentre, 2.6e9, all.carrier_support.torsion, false);
  set.planet = {.mass = all.planet.mass,
                .inertia = all.planet.polar / (kPlanetBase * kPlanetBase),
                .radius = kPlanetBase,
                .bearing_stiffness = 2.2e9};
  set.sun_mesh = mesh(all.set.sun);
  set.ring_mesh = mesh(all.set.ring);
  set.sun_phase = set.ring_phase = {0.0, 0.0, 0.0, 0.0};
  return dynamics::set_model(std::move(set), {});
}

std::vector<double> with_multiplicity(const std::vector<SpatialMode>& modes, double least_share) {
  std::vector<double> all;
  for (const SpatialMode& mode : modes)
    if (mode.in_plane > least_share)
      all.insert(all.end(), static_cast<std::size_t>(mode.multiplicity), mode.frequency);
  return all;
}

void expect_like_the_plane(const MovingSet& all, double least_share) {
  std::vector<double> plane;
  for (const dynamics::Mode& mode : dynamics::modes_at_rest(plane_of(all)))
    plane.insert(plane.end(), static_cast<std::size_t>(mode.multiplicity), mode.frequency);
  std::ranges::sort(plane);
  const std::vector<double> space = with_multiplicity(modes_at_rest(all), least_share);
  ASSERT_EQ(space.size(), plane.size());
  for (std::size_t i = 0; i < plane.size(); ++i) {
    if (plane[i] == 0.0) {
      EXPECT_EQ(space[i], 0.0);
    } else {
      EXPECT_NEAR(space[i] / plane[i], 1.0, 1e-6) << plane[i];
    }
  }
}

// Spur gears on bearings that are alike on both sides: motion in the plane is decoupled from the rest.
TEST(SpatialModes, SpurGearsSwingInTheirPlaneAsTheModelOfThePlaneHasIt) {
  MovingSet all = moving(0.0);
  expect_like_the_plane(all, 1.0 - 1e-9);
  all.sun_support.torsion = 3e6;
  all.carrier_support.torsion = 5e6;
  expect_like_the_plane(all, 1.0 - 1e-9);
}

// Helical gears do too where nothing moves along the axis or tilts.
TEST(SpatialModes, HelicalGearsHeldAlongTheirAxesSwingAsTheModelOfThePlaneHasIt) {
  MovingSet all = moving(kHelix);
  constexpr double stiff = 1e15;  // [N/m]  beside meshes of some 1e9
  all.set.planet_axial_stiffness = all.set.sun_axial_stiffness = stiff;
  all.set.carrier_bearings[0].axial_stiffness = all.ring_support.axial = stiff;
  for (RoundBody* body : {&all.carrier, &all.sun, &all.planet, &all.ring}) body->transverse = 1e12;
  // Else the rotation that costs nothing hides among tilts that are as slow.
  all.sun_support.torsion = 3e6;
  all.carrier_support.torsion = 5e6;
  expect_like_the_plane(all, 0.9);
}

// A single carrier on different bearings, its centre of mass beside the middle of the face.
TEST(SpatialModes, ACarrierAloneSwingsOnItsBearingsByClosedForm) {
  MovingSet all = moving(kHelix);
  all.set.sun.stiffness = all.set.ring.stiffness = 0.0;
  all.set.sun_radial_stiffness = all.set.sun_axial_stiffness = all.set.planet_axial_stiffness = 0.0;
  for (PlanetBearing& bearing : all.set.planet_bearings) bearing.radial_stiffness = 0.0;
  all.ring.mass = 0.0;
  all.carrier.centre = 0.07;
  all.set.carrier_bearings[1] = {0.3, 0.8e9, 0.0, 1e-4};
  const double mass = all.carrier.mass, arm = all.carrier.centre;
  Eigen::Matrix2d inertia, stiffness = Eigen::Matrix2d::Zero();
  inertia << mass, mass * arm, mass * arm, all.carrier.transverse + mass * arm * arm;
  for (const CarrierBearing& bearing : all.set.carrier_bearings) {
    const Eigen::Vector2d there(1.0, bearing.position);
    stiffness += bearing.radial_stiffness * there * there.transpose();
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> both(stiffness, inertia);
  std::vector<double> expected{std::sqrt(1e9 / mass) / (2 * pi)};
  for (int i = 0; i < 2; ++i) expected.insert(expected.end(), 2, std::sqrt(both.eigenvalues()[i]) / (2 * pi));
  std::ranges::sort(expected);
  std::vector<double> found;
  for (const SpatialMode& mode : modes_at_rest(all)) {
    if (mode.frequency == 0.0) continue;
    EXPECT_NEAR(mode.carrier, 1.0, 1e-9);
    found.insert(found.end(), static_cast<std::size_t>(mode.multiplicity), mode.frequency);
  }
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-9);
}

// A sun by itself on its shaft: radially and by tilting, two of each.
TEST(SpatialModes, ASunAloneSwingsOnItsShaftByClosedForm) {
  MovingSet all = moving(0.0);
  all.set.sun.stiffness = all.set.ring.stiffness = 0.0;
  all.set.sun_axial_stiffness = all.ring.mass = 0.0;
  all.set.sun_tilt_stiffness = 4e5;
  std::vector<double> found;
  for (const SpatialMode& mode : modes_at_rest(all))
    if (mode.frequency > 0.0 && mode.sun > 0.5)
      found.insert(found.end(), static_cast<std::size_t>(mode.multiplicity), mode.frequency);
  const double radial = std::sqrt(2e8 / all.sun.mass) / (2 * pi),
               tilting = std::sqrt(4e5 / all.sun.transverse) / (2 * pi);
  ASSERT_THAT(found, testing::SizeIs(4)) << testing::PrintToString(found);
  EXPECT_NEAR(found[0] / std::min(radial, tilting), 1.0, 1e-9);
  EXPECT_NEAR(found[3] / std::max(radial, tilting), 1.0, 1e-9);
}

// Spur gears that nothing holds along the axis have no axial vibration: their axial motions cost nothing.
TEST(SpatialModes, SpurGearsThatSlideAxiallyHaveNoAxialFrequency) {
  MovingSet all = moving(0.0);
  all.set.planet_axial_stiffness = all.set.sun_axial_stiffness = 0.0;
  for (const SpatialMode& mode : modes_at_rest(all)) {
    if (mode.axial < 0.5 || mode.frequency == 0.0) continue;
    EXPECT_LT(mode.sun + mode.planets, 1e-9) << mode.frequency;  // carrier and ring are held
  }
}

// Shares are of one energy, and helical teeth mix what spur gears keep apart.
TEST(SpatialModes, SharesOfTheEnergyAreWhole) {
  for (const double helix : {0.0, kHelix}) {
    double mixed = 0.0;
    for (const SpatialMode& mode : modes_at_rest(moving(helix))) {
      EXPECT_NEAR(mode.in_plane + mode.axial + mode.tilting, 1.0, 1e-9);
      EXPECT_NEAR(mode.carrier + mode.sun + mode.ring + mode.planets, 1.0, 1e-9);
      EXPECT_NEAR(mode.shape.cwiseAbs().maxCoeff(), 1.0, 1e-12);
      mixed = std::max(mixed, std::min(mode.in_plane, mode.axial + mode.tilting));
    }
    if (helix == 0.0) {
      EXPECT_LT(mixed, 1e-9);
    } else {
      EXPECT_GT(mixed, 0.01);
    }
  }
}

}  // namespace
}  // namespace orbearing::gearset::spatial::spatial_modes_test
