// A planetary set in three dimensions without rotation: its forces are those of its energy; symmetry, free
// bodies and closed forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "gearset/spatial/spatial_balance.hpp"

namespace orbearing::gearset::spatial::spatial_set_test {
namespace {

using Eigen::Matrix2Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr int kSlices = 40;
constexpr double kRoundOff = 1e-8;  // of forces of one equilibrium, found to 1e-12 of the largest
constexpr double kGravity = 9.81;   // [m/s2]

// 21/39/99 of module 10 mm at 7.5 degrees; stiffnesses and masses as such a stage has them.
SpatialSet wind_stage(double helix = 7.5 * pi / 180.0) {
  const double module = 0.010 / std::cos(helix);
  const double pressure = std::atan(std::tan(20.0 * pi / 180.0) / std::cos(helix));
  const auto base_radius = [&](int teeth) { return 0.5 * teeth * module * std::cos(pressure); };
  constexpr double centre_distance = 0.308;
  const double base_helix = std::asin(std::sin(helix) * std::cos(20.0 * pi / 180.0));
  SpatialSet set{
      .centre_distance = centre_distance, .face_width = 0.22, .planet_base_radius = base_radius(39)};
  for (int n = 0; n < 3; ++n) set.angles.push_back(2.0 * pi * n / 3.0);
  set.sun = {1.6e10, std::acos((base_radius(21) + base_radius(39)) / centre_distance), base_helix};
  set.ring = {2.0e10, std::acos((base_radius(99) - base_radius(39)) / centre_distance), base_helix};
  set.planet_bearings = {{-0.06, 3e9, 0.0}, {0.06, 3e9, 0.0}};
  set.planet_axial_stiffness = set.sun_axial_stiffness = 1e9;
  set.carrier_bearings = {{-0.25, 3e9, 1e9, 0.0}, {0.25, 3e9, 0.0, 0.0}};
  set.planet_mass = 105.0;
  set.sun_mass = 180.0;
  set.carrier_mass = 900.0;
  return set;
}

SpatialLoad rated() {
  return {.torque = 325e3};
}

double sun_base_radius(const SpatialSet& set) {
  return set.centre_distance * std::cos(set.sun.pressure_angle) - set.planet_base_radius;
}

// Compliance of a pin that links its rows: a force on the sleeve moves it by `radial`, a moment inclines it
// by `angular`.
Eigen::MatrixXd sleeve(const SpatialSet& set, double radial, double angular) {
  Eigen::VectorXd position(static_cast<Eigen::Index>(set.planet_bearings.size()));
  for (std::size_t r = 0; r < set.planet_bearings.size(); ++r)
    position[static_cast<Eigen::Index>(r)] = set.planet_bearings[r].position;
  return radial * Eigen::MatrixXd::Ones(position.size(), position.size()) +
         angular * position * position.transpose();
}

class SpatialForces : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(OfRowsAloneAndOnASleeve, SpatialForces, testing::Bool());

TEST_P(SpatialForces, HaveAnEnergyAndTheStiffnessIsTheirSlope) {
  SpatialSet set = wind_stage();
  set.carrier_bearings[0].clearance = 2e-4;
  set.sun_tilt_stiffness = 3e6;
  if (GetParam())
    set.pin_compliance = sleeve(set, 5e-10, 4e-7);
  else
    set.planet_bearings[1].clearance = 3e-5;
  set.sun.backlash = 6e-5;
  set.ring.backlash = 4e-5;
  set.pin_errors = Matrix2Xd::Random(2, 3) * 2e-5;
  SpatialLoad load = rated();
  load.gravity = kGravity;
  load.rotor = {{1e4, -2e4, 3e3}, {5e4, 2e4, 0.0}};
  std::mt19937 random(48);
  std::normal_distribution<double> anywhere(0.0, 1e-4);
  constexpr double step = 1e-8, tolerance = 1e-6;  // of central differences on kinks a step away
  for (int trial = 0; trial < 10; ++trial) {
    VectorXd position(30);
    for (double& x : position) x = anywhere(random);
    const auto here = imbalance(set, load, 0.3, kSlices, position);
    for (int i = 0; i < position.size(); ++i) {
      SCOPED_TRACE(i);
      VectorXd ahead = position, behind = position;
      ahead[i] += step;
      behind[i] -= step;
      const VectorXd column = (imbalance(set, load, 0.3, kSlices, ahead).force -
                               imbalance(set, load, 0.3, kSlices, behind).force) /
                              (-2 * step);
      EXPECT_LT((here.stiffness.col(i) - column).norm(), tolerance * here.stiffness.norm());
    }
    EXPECT_LT((here.stiffness - here.stiffness.transpose()).norm(),
              1e-14 * here.stiffness.norm());  // so that the forces have an energy
  }
}

TEST(SpatialSet, PlanetsCarryAlikeWithoutWeightAndAsTheTorqueSays) {
  for (const double sense : {1.0, -1.0}) {
    const SpatialSet set = wind_stage();
    SpatialLoad load = rated();
    load.torque *= sense;
    const SpatialBalance at = balance(set, load, 1.1, kSlices);
    const double sun_torque = load.torque * sun_base_radius(set) /
                              (sun_base_radius(set) + set.planet_base_radius +
                               set.centre_distance * std::cos(set.ring.pressure_angle));
    EXPECT_NEAR(at.sun_torque / -sun_torque, 1.0, kRoundOff);
    const double normal = std::abs(sun_torque) / (3 * sun_base_radius(set) * std::cos(set.sun.base_helix));
    for (int p = 0; p < 3; ++p) {
      EXPECT_NEAR(at.sun_mesh.force[p] / normal, 1.0, kRoundOff);
      EXPECT_NEAR(at.ring_mesh.force[p] / normal, 1.0, kRoundOff);
      EXPECT_NEAR(at.bearing_tangential.col(p).sum() / (load.torque / (3 * set.centre_distance)), 1.0,
                  kRoundOff);
      for (int row = 0; row < 2; ++row)
        EXPECT_NEAR(at.bearing_load(row, p) / at.bearing_load(row, 0), 1.0, 1e-6);
    }
    EXPECT_LT(at.carrier_bearing.maxCoeff(), 1e-6 * load.torque * sense);
  }
}

// On a sleeve rows act as springs in series with the pin: its part of a load displaces a planet by
// 1/(2 k) + c, the couple of its helical teeth tilts it by 1/(2 k z^2) + c_t.
TEST(SpatialSet, PinOfASleeveIsInSeriesWithItsRows) {
  SpatialSet set = wind_stage();
  set.sun.stiffness = set.ring.stiffness = 1e7;  // [N/m2]  so soft that they hold no tilt
  const double radial = 8e-10, angular = 5e-7, k = 3e9, z = 0.06;
  const SpatialBalance rows = balance(set, rated(), 0.0, kSlices);
  set.pin_compliance = sleeve(set, radial, angular);
  const SpatialBalance pinned = balance(set, rated(), 0.0, kSlices);
  for (int p = 0; p < 3; ++p) {
    EXPECT_NEAR(pinned.bearing_tangential.col(p).sum() / rows.bearing_tangential.col(p).sum(), 1.0,
                kRoundOff);
    EXPECT_NEAR(pinned.planet_tilt.col(p).norm() / rows.planet_tilt.col(p).norm(),
                (1.0 / (2.0 * k * z * z) + angular) / (1.0 / (2.0 * k * z * z)), 0.02);
  }
}

// The axial forces of a planet's helical teeth overturn it: its bearings hold against that by a couple along
// the radius, F_a (r_s + r_r)/distance.
TEST(SpatialSet, BearingsHoldAPlanetAgainstTheCoupleOfItsHelicalTeeth) {
  SpatialSet set = wind_stage();
  set.sun.stiffness = set.ring.stiffness = 1e7;  // [N/m2]  so soft that they hold no tilt
  const SpatialBalance at = balance(set, rated(), 0.0, kSlices);
  const double axial = at.sun_mesh.force[0] * std::sin(set.sun.base_helix);
  const double radii =
      set.planet_base_radius * (1 / std::cos(set.sun.pressure_angle) + 1 / std::cos(set.ring.pressure_angle));
  EXPECT_NEAR(std::abs(at.bearing_radial(1, 0) - at.bearing_radial(0, 0)) / 2.0 / (axial * radii / 0.12), 1.0,
              0.02);
}

// Free bodies: pins and meshes hold the weight of a planet, and all that holds the set holds all its weight.
TEST(SpatialSet, WhatHoldsAPlanetHoldsItsWeight) {
  SpatialSet set = wind_stage();
  for (CarrierBearing& bearing : set.carrier_bearings) bearing.clearance = 1e-4;
  SpatialLoad load = rated();
  load.gravity = kGravity;
  load.axis_tilt = 0.1;
  load.speed = 3.0;
  for (const double angle : {0.0, 0.7, 2.9}) {
    const SpatialBalance at = balance(set, load, angle, kSlices);
    for (int p = 0; p < 3; ++p) {
      const double along = set.angles[static_cast<std::size_t>(p)] + angle;  // in the housing
      const double down = set.planet_mass * kGravity * std::cos(load.axis_tilt);
      const double cosine = std::cos(set.sun.base_helix);
      const double radial = at.bearing_radial.col(p).sum() +
                            cosine * (at.sun_mesh.force[p] * std::sin(set.sun.pressure_angle) -
                                      at.ring_mesh.force[p] * std::sin(set.ring.pressure_angle)) -
                            down * std::sin(along) + set.planet_mass * 9.0 * set.centre_distance;
      const double tangential = at.bearing_tangential.col(p).sum() -
                                cosine * (at.sun_mesh.force[p] * std::cos(set.sun.pressure_angle) +
                                          at.ring_mesh.force[p] * std::cos(set.ring.pressure_angle)) -
                                down * std::cos(along);
      EXPECT_NEAR(radial, 0.0, kRoundOff * at.sun_mesh.force[p]);
      EXPECT_NEAR(tangential, 0.0, kRoundOff * at.sun_mesh.force[p]);
    }
  }
}

// On stiff pins the weight of a planet rotates in its bearings once a revolution, and does not affect the
// meshes.
TEST(SpatialSet, GravityIsALoadOnceARevolution) {
  SpatialSet set = wind_stage(0.0);
  for (PlanetBearing& bearing : set.planet_bearings) bearing.radial_stiffness = 1e13;
  for (CarrierBearing& bearing : set.carrier_bearings) bearing.radial_stiffness = 1e13;
  set.sun_mass = 0.0;
  SpatialLoad light = rated(), heavy = rated();
  heavy.gravity = kGravity;
  const double half = 0.5 * set.planet_mass * kGravity;  // of two bearings each
  for (const double angle : {0.2, 1.4, 3.3, 5.1}) {
    const SpatialBalance without = balance(set, light, angle, kSlices),
                         with = balance(set, heavy, angle, kSlices);
    for (int p = 0; p < 3; ++p) {
      const double along = set.angles[static_cast<std::size_t>(p)] + angle;
      EXPECT_NEAR(with.bearing_radial(0, p) - without.bearing_radial(0, p), half * std::sin(along),
                  1e-3 * half);
      EXPECT_NEAR(with.bearing_tangential(0, p) - without.bearing_tangential(0, p), half * std::cos(along),
                  1e-3 * half);
    }
  }
}

// Two bearings of the carrier hold a moment of the rotor by a couple where the meshes are too soft to help.
TEST(SpatialSet, BearingsOfTheCarrierHoldAMomentOfTheRotor) {
  SpatialSet set = wind_stage();
  set.sun.stiffness = set.ring.stiffness = 1e7;
  SpatialLoad load = rated();
  load.rotor.moment = {5e4, 0.0, 0.0};
  const SpatialBalance at = balance(set, load, 0.4, kSlices);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(at.carrier_bearing[i] / (5e4 / 0.5), 1.0, 0.02);
}

// A carrier with clearance sags by it, and its bearings then bear its weight.
TEST(SpatialSet, ACarrierWithClearanceSags) {
  SpatialSet set = wind_stage();
  set.sun.stiffness = set.ring.stiffness = 1e6;
  for (CarrierBearing& bearing : set.carrier_bearings) bearing.clearance = 3e-4;
  set.sun_mass = 0.0;
  const SpatialLoad load{.torque = 5e3, .gravity = kGravity};
  const SpatialBalance at = balance(set, load, 0.0, kSlices);
  EXPECT_NEAR(at.carrier_shift[1], -3e-4, 1e-5);
  EXPECT_NEAR(at.carrier_shift[0], 0.0, 1e-5);
  EXPECT_NEAR(at.carrier_bearing.sum() / (kGravity * (900.0 + 3 * 105.0)), 1.0, 0.05);
}

TEST(SpatialSet, ASunThatFallsOffItsFlanksIsTold) {
  SpatialLoad load{.torque = 1.0, .gravity = kGravity};
  EXPECT_THAT(
      [&] { balance(wind_stage(), load, 0.0, kSlices); },
      testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("lift gears off their driving flanks")));
}

// Forces of the flanks of all planets on the sun, in the carrier's frame.
Vector3d on_sun(const SpatialSet& set, const SpatialBalance& at) {
  Vector3d sum = Vector3d::Zero();
  const double alpha = set.sun.pressure_angle, cosine = std::cos(set.sun.base_helix);
  for (Eigen::Index p = 0; p < at.sun_mesh.force.size(); ++p) {
    const double angle = set.angles[static_cast<std::size_t>(p)];
    const Vector3d outward(std::cos(angle), std::sin(angle), 0.0),
        ahead(-std::sin(angle), std::cos(angle), 0.0);
    const double driving = at.sun_mesh.force[p], back = at.sun_mesh.back[p];
    sum +=
        cosine * ((driving - back) * std::cos(alpha) * ahead - (driving + back) * std::sin(alpha) * outward);
  }
  return sum;
}

// Under next to no torque the sun falls through its backlash and rests on both flanks of its teeth.
TEST(SpatialSet, ASunThatFallsRestsOnItsBackFlanks) {
  for (const double helix : {0.0, 7.5 * pi / 180.0})
    for (const double angle : {0.0, 0.4, 2.0}) {
      SpatialSet set = wind_stage(helix);
      set.sun.backlash = set.ring.backlash = 2e-4;
      const SpatialLoad load{.torque = 1.0, .gravity = kGravity};
      const SpatialBalance at = balance(set, load, angle, kSlices);
      EXPECT_GT(at.sun_mesh.back.maxCoeff(), 100.0);
      const Vector3d down = Eigen::AngleAxisd(-angle, Vector3d::UnitZ()) * Vector3d(0.0, -kGravity, 0.0);
      const Vector3d left = on_sun(set, at) + set.sun_mass * down;
      EXPECT_LT(left.head<2>().norm(), 1e-6 * set.sun_mass * kGravity);
    }
}

// Play of both flanks: moved from its driving flanks by the backlash over its cosines, a planet touches its
// back flanks. Carrier, sun and pins are as good as fixed.
TEST(SpatialSet, BackFlanksTouchAfterTheBacklash) {
  SpatialSet set = wind_stage();
  constexpr double backlash = 1e-4, beyond = 1e-6;
  set.sun.backlash = backlash;
  const double travel = backlash / std::cos(set.sun.pressure_angle);
  VectorXd position = VectorXd::Zero(30);
  const auto force_at = [&](double tangential) {
    position[12 + 1] = tangential;  // of the first planet, which is at angle 0
    SpatialSet alone = set;
    alone.ring.stiffness = 0.0;
    for (PlanetBearing& bearing : alone.planet_bearings) bearing.radial_stiffness = 0.0;
    return imbalance(alone, rated(), 0.0, kSlices, position).force[12 + 1];
  };
  EXPECT_EQ(force_at(-travel + beyond), 0.0);
  const double cosine = std::cos(set.sun.base_helix) * std::cos(set.sun.pressure_angle);
  const double stiffness = set.sun.stiffness * set.face_width * cosine * cosine;
  EXPECT_NEAR(force_at(-travel - beyond) / (stiffness * beyond), 1.0, 1e-6);
  EXPECT_NEAR(force_at(beyond) / (-stiffness * beyond), 1.0, 1e-6);
}

TEST(SpatialSet, BackFlanksChangeNothingUnderLoad) {
  SpatialSet set = wind_stage();
  SpatialLoad load = rated();
  load.gravity = kGravity;
  load.rotor.moment = {2e4, 0.0, 0.0};
  const SpatialBalance without = balance(set, load, 0.3, kSlices);
  set.sun.backlash = set.ring.backlash = 5e-4;
  const SpatialBalance with = balance(set, load, 0.3, kSlices);
  EXPECT_EQ(with.sun_mesh.back.maxCoeff(), 0.0);
  EXPECT_TRUE((with.bearing_load.array() == without.bearing_load.array()).all());
}

// Load of a mesh over its face: the sum is the force, the largest over the mean is K_Hbeta.
TEST(SpatialSet, LoadOverTheFaceIsThatOfTheMesh) {
  const SpatialSet set = wind_stage();
  SpatialLoad load = rated();
  load.rotor.moment = {4e4, 0.0, 0.0};
  const SpatialBalance at = balance(set, load, 0.5, kSlices);
  for (const MeshForces* mesh : {&at.sun_mesh, &at.ring_mesh})
    for (Eigen::Index p = 0; p < 3; ++p) {
      const Eigen::ArrayXd over = mesh->by_width.col(p);
      EXPECT_NEAR(over.mean() * set.face_width / mesh->force[p], 1.0, kRoundOff);
      EXPECT_NEAR(over.maxCoeff() / over.mean() / mesh->face_load[p], 1.0, kRoundOff);
      EXPECT_GT(mesh->face_load[p], 1.01);
      // Rigid bodies on like slices: the load is linear over the face where all of it carries.
      if (over.minCoeff() > 0.0) {
        EXPECT_NEAR(over[0] - 2 * over[20] + over[39], over[19] - over[20], 1e-6 * over.mean());
      }
    }
}

// A moment of the rotor tilts the carrier, and planets follow it: the tilt between bore and pin is that which
// the meshes hold. The axis is inclined as the rows carry unequal loads.
TEST(SpatialSet, TiltOfABoreIsThatOfItsRows) {
  const SpatialSet set = wind_stage();
  SpatialLoad load = rated();
  load.rotor.moment = {4e4, 1e4, 0.0};
  const SpatialBalance at = balance(set, load, 0.5, kSlices);
  for (Eigen::Index p = 0; p < 3; ++p) {
    // Rows on springs, 0.12 m apart: the pin pushes the planet back where it leans outward.
    const double radial = (at.bearing_radial(0, p) - at.bearing_radial(1, p)) / (3e9 * 0.12);
    const double tangential = (at.bearing_tangential(0, p) - at.bearing_tangential(1, p)) / (3e9 * 0.12);
    EXPECT_NEAR(at.planet_tilt(0, p), radial, 1e-6 * at.planet_tilt.norm());
    EXPECT_NEAR(at.planet_tilt(1, p), tangential, 1e-6 * at.planet_tilt.norm());
  }
  EXPECT_GT(at.planet_tilt.norm(), 1e-5);
}

TEST(SpatialSet, ThreePlanetsOnAFloatingSunShareWhereverThePinsStand) {
  SpatialSet set = wind_stage(0.0);
  set.pin_errors = Matrix2Xd::Zero(2, 3);
  set.pin_errors(1, 0) = 5e-5;
  const SpatialBalance three = balance(set, rated(), 0.0, kSlices);
  EXPECT_NEAR(three.sun_mesh.force.maxCoeff() / three.sun_mesh.force.mean(), 1.0, 0.01);
  set.angles = {0.0, 0.5 * pi, pi, 1.5 * pi};
  set.pin_errors = Matrix2Xd::Zero(2, 4);
  set.pin_errors(1, 0) = 5e-5;
  const SpatialBalance four = balance(set, rated(), 0.0, kSlices);  // which a sun that floats cannot even out
  EXPECT_GT(four.sun_mesh.force.maxCoeff() / four.sun_mesh.force.mean(), 1.05);
}

TEST(SpatialSet, HoldsOnFinerSlicesAndFromAnotherStart) {
  SpatialSet set = wind_stage();
  for (CarrierBearing& bearing : set.carrier_bearings) bearing.clearance = 2e-4;
  SpatialLoad load = rated();
  load.gravity = kGravity;
  load.rotor.moment = {4e4, 0.0, 0.0};
  const SpatialBalance coarse = balance(set, load, 0.5, kSlices), fine = balance(set, load, 0.5, 4 * kSlices);
  EXPECT_LT((coarse.bearing_load - fine.bearing_load).cwiseAbs().maxCoeff(),
            2e-4 * fine.bearing_load.maxCoeff());
  const SpatialBalance again = balance(set, load, 0.5, kSlices, VectorXd::Constant(30, 1e-3));
  EXPECT_LT((coarse.bearing_load - again.bearing_load).cwiseAbs().maxCoeff(),
            kRoundOff * again.bearing_load.maxCoeff());
}

}  // namespace
}  // namespace orbearing::gearset::spatial::spatial_set_test
