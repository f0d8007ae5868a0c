// Features of a planet that are computed together: computed tilt, elastic rim, helical teeth, pins off their
// places, several sets. What one of them leaves alone stays; what both decide agrees with each alone at its
// limit.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numeric>

#include "bearing/equilibrium/quasi_static.hpp"
#include "coupling/analysis/load_sharing.hpp"
#include "coupling/analysis/multi_stage.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "gearset/drivetrain/power_flow.hpp"
#include "gearset/rim/rim_influence.hpp"
#include "tests/coupled_reducer.hpp"
#include "tests/unit/gearset/arrangements.hpp"

namespace orbearing::analysis::study_together_test {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

// The search for the shares ends at 1e-9 of the largest force; lives take the power 10/3 of it.
constexpr double kShared = 1e-7;
// Searches for a planet's equilibrium by different methods.
constexpr double kSearched = 1e-8;

struct Parts {
  bool tilt = false, rim = false;
  double helix = 0.0;  // [rad]
};

PlanetaryDrivetrain reducer_with(const Parts& parts, const Eigen::Matrix2Xd& pin_error = {}) {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.set.helix_angle = parts.helix;
  drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  drivetrain.bearing.rollers().laminae = 10;
  drivetrain.cage_positions = 4;
  if (parts.tilt) {
    drivetrain.seats.tilt = TiltState::computed;
    drivetrain.seats.clearance_differences = {4e-6, 0.0};
  }
  if (parts.rim) drivetrain.rim = PlanetRim::elastic;
  gearset::dynamics::SetParameters gears = example::reducer_gears(drivetrain);
  gears.pin_error = pin_error;
  drivetrain.gear_set = [gears] { return gears; };
  drivetrain.uneven_planets = pin_error.cols() > 0;
  return drivetrain;
}

Eigen::Matrix2Xd ahead(const std::array<double, 4>& errors) {
  Eigen::Matrix2Xd pins = Eigen::Matrix2Xd::Zero(2, 4);
  for (Eigen::Index i = 0; i < 4; ++i) pins(1, i) = errors[static_cast<std::size_t>(i)];
  return pins;
}

PointResult point_of(const PlanetaryDrivetrain& drivetrain) {
  return evaluate(drivetrain, derive(drivetrain));
}

void expect_near(double a, double b, double within, const char* what) {
  EXPECT_NEAR(a, b, within * std::abs(b)) << what;
}

constexpr Parts kPairs[] = {{.tilt = true},
                            {.rim = true},
                            {.tilt = true, .rim = true},
                            {.rim = true, .helix = 0.2},
                            {.tilt = true, .rim = true, .helix = 0.2}};

TEST(Together, PinsInTheirPlacesLeavePlanetsAlike) {
  for (const Parts& parts : kPairs) {
    SCOPED_TRACE(testing::Message() << parts.tilt << parts.rim << parts.helix);
    const PointResult even = point_of(reducer_with(parts));
    const PointResult found = point_of(reducer_with(parts, ahead({0.0, 0.0, 0.0, 0.0})));
    ASSERT_EQ(found.planets.size(), 4u);
    expect_near(found.life_hours, even.life_hours, kShared, "life");
    expect_near(found.system_life_hours, even.system_life_hours, kShared, "life of all");
    expect_near(found.inner.load_max, even.inner.load_max, kShared, "largest load");
    for (const PlanetResult& planet : found.planets) expect_near(planet.load_share, 1.0, kShared, "share");
    ASSERT_EQ(found.seats.size(), 4 * even.seats.size());
    for (std::size_t k = 0; k < found.seats.size(); ++k) {
      const SeatResult& alike = even.seats[k % even.seats.size()];
      expect_near(found.seats[k].load, alike.load, kShared, "load of a bearing");
      expect_near(found.seats[k].life_hours, alike.life_hours, kShared, "life of a bearing");
      EXPECT_LT((found.seats[k].tilt - alike.tilt).norm(), 1e-6 * alike.tilt.norm());
    }
  }
}

// Which planet is counted first decides nothing where all mesh in phase on the average.
TEST(Together, PinsThatChangePlacesTakeTheirPlanetsAlong) {
  for (const Parts& parts : kPairs) {
    SCOPED_TRACE(testing::Message() << parts.tilt << parts.rim << parts.helix);
    const PointResult here = point_of(reducer_with(parts, ahead({4e-6, 0.0, -2e-6, 1e-6})));
    const PointResult there = point_of(reducer_with(parts, ahead({1e-6, 4e-6, 0.0, -2e-6})));
    const std::size_t per_planet = here.seats.size() / 4;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      expect_near(there.planets[j].load_share, here.planets[i].load_share, kShared, "share");
      expect_near(there.planets[j].life_hours, here.planets[i].life_hours, kShared, "life");
      for (std::size_t k = 0; k < per_planet; ++k)
        expect_near(there.seats[per_planet * j + k].life_hours, here.seats[per_planet * i + k].life_hours,
                    1e-6, "life of a bearing");
    }
    EXPECT_GT(std::abs(here.planets[0].load_share - here.planets[2].load_share), 0.05);
    double together = 0.0;  // Eq. (4) of coupling/README.md
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 2; ++k)
        together += std::pow(per_planet > 0 ? here.seats[2 * i + k].life_hours : here.planets[i].life_hours,
                             -9.0 / 8.0);
    expect_near(std::pow(together, -8.0 / 9.0), here.system_life_hours, kSearched, "life of all");
  }
}

// One bearing in the middle of a straight face does not tilt: unequal planets share as with a stated tilt of
// zero, whatever the pin, whose displacement is the support's.
TEST(Together, PlanetsThatDoNotTiltShareAsLevelOnes) {
  for (const bool rim : {false, true}) {
    PlanetaryDrivetrain drivetrain =
        reducer_with({.tilt = true, .rim = rim}, ahead({4e-6, 0.0, -2e-6, 1e-6}));
    drivetrain.bearings_per_planet = 1;
    drivetrain.seats.clearance_differences.clear();
    PlanetaryDrivetrain level = drivetrain;
    level.seats.tilt = TiltState::stated;
    const std::vector<double> found = planet_balance(drivetrain, derive(drivetrain)).shares;
    const std::vector<double> expected = planet_balance(level, derive(level)).shares;
    for (std::size_t i = 0; i < 4; ++i) expect_near(found[i], expected[i], kSearched, "share");
  }
}

// Both bearings press on one form of the race: each of two equal ones has the same results as a single one.
TEST(Together, LikeBearingsOnAnElasticPlanetCarryAsOneDoes) {
  PlanetaryDrivetrain drivetrain = reducer_with({.tilt = true, .rim = true});
  drivetrain.seats.clearance_differences.clear();
  drivetrain.seats.span = 0.0281;
  const DrivetrainGeometry geometry = derive(drivetrain);
  drivetrain.bearing.material.youngs_modulus = 206e16;  // of the pin: the rim is derived
  const PointResult found = evaluate(drivetrain, geometry);
  drivetrain.seats.tilt = TiltState::stated;
  const PointResult level = evaluate(drivetrain, geometry);
  expect_near(found.life_hours, level.life_hours, 1e-6, "life");
  expect_near(found.inner.load_max, level.inner.load_max, 1e-6, "largest load");
  ASSERT_FALSE(found.distribution.race_form.empty());
  for (std::size_t i = 0; i < found.distribution.race_form.size(); ++i)
    EXPECT_NEAR(found.distribution.race_form[i], level.distribution.race_form[i], 1e-11);
}

DrivetrainGeometry stiff_rim(const PlanetaryDrivetrain& drivetrain, double part) {
  DrivetrainGeometry geometry = derive(drivetrain);
  gearset::rim::RimInfluence rim = *geometry.rim;
  rim.race *= part;
  rim.meshes *= part;
  for (gearset::rim::RaceForm* form : {&rim.by_sun, &rim.by_ring}) {
    form->cosine *= part;
    form->sine *= part;
  }
  geometry.rim = std::make_shared<const gearset::rim::RimInfluence>(rim);
  return geometry;
}

TEST(Together, StiffRimSharesAndTiltsAsARigidOne) {
  for (const Parts& parts : {Parts{.rim = true, .helix = 0.2}, Parts{.tilt = true, .rim = true}}) {
    const Eigen::Matrix2Xd pins = ahead({4e-6, 0.0, -2e-6, 1e-6});
    const PlanetaryDrivetrain elastic = reducer_with(parts, pins);
    PlanetaryDrivetrain rigid = elastic;
    rigid.rim = PlanetRim::rigid;
    const PointResult expected = point_of(rigid), found = evaluate(elastic, stiff_rim(elastic, 1e-7));
    expect_near(found.life_hours, expected.life_hours, 1e-5, "life");
    for (std::size_t i = 0; i < 4; ++i)
      expect_near(found.planets[i].load_share, expected.planets[i].load_share, 1e-5, "share");
    EXPECT_GT(std::abs(point_of(elastic).planets[0].load_share / expected.planets[0].load_share - 1.0), 1e-3);
  }
}

// The teeth's forces in the transverse plane bend the rim; the axial ones tilt the planet as they tilt a
// rigid one. At the same transverse section, face and power a helix changes the former by nothing.
TEST(Together, HelixBendsTheRimByItsTransverseForces) {
  const PlanetaryDrivetrain drivetrain = reducer_with({.rim = true, .helix = 0.2});
  const DrivetrainGeometry geometry = derive(drivetrain);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  EXPECT_LT(duty.gears.normal_force, 0.99 * duty.gears.tooth_force);
  const gearset::rim::RimInfluence& rim = *geometry.rim;
  const Eigen::ArrayXd expected = duty.gears.normal_force * (rim.by_sun.cosine + rim.by_ring.cosine);
  EXPECT_TRUE(duty.point.outer_race.cosine.isApprox(expected, 1e-12));
  for (const double helix : {0.2, -0.2}) {
    const PointResult one = point_of(reducer_with({.tilt = true, .rim = true, .helix = helix}));
    const PointResult plain = point_of(reducer_with({.tilt = true, .rim = true}));
    // The couple tilts about the tangent, one way or the other.
    EXPECT_GT(std::abs(one.seats[0].tilt.x() - plain.seats[0].tilt.x()), 1e-5);
  }
}

// Load and moment on a planet against its displacement and tilt by differences, on a rigid rim and an elastic
// one: the slope that determines the load sharing of unequal planets.
TEST(Together, ComplianceOfAPlanetIsTheSlopeOfItsBalance) {
  for (const bool rim : {false, true}) {
    const PlanetaryDrivetrain drivetrain = reducer_with({.tilt = true, .rim = rim});
    const DrivetrainGeometry geometry = derive(drivetrain);
    const bearing::OperatingPoint point = bearing_duty(drivetrain, geometry).point;
    const bearing::laminae::PlanetOnPin planet = planet_on(planet_seat(drivetrain), drivetrain.bearing);
    const bearing::QuasiStaticOptions options = quasi_static_options(drivetrain);
    const auto moved = [&](int i, double by) {
      bearing::OperatingPoint other = point;
      Vector2d moment = Vector2d::Zero();
      (i < 2 ? other.bore_load[i] : moment[i - 2]) += by;
      const bearing::laminae::PlanetOnPinState state = planet_on_pin(planet, other, moment, options, 0.1);
      return (Vector4d() << shift_on_seats(planet, state), state.tilt).finished();
    };
    const Matrix4d compliance = planet_on_pin(planet, point, Vector2d::Zero(), options, 0.1).compliance;
    for (int i = 0; i < 4; ++i) {
      const double step = i < 2 ? 1e-4 * point.bore_load.norm() : 1e-6 * point.bore_load.norm();
      const Vector4d slope = (moved(i, step) - moved(i, -step)) / (2.0 * step);
      EXPECT_LT((slope - compliance.col(i)).norm(), 1e-4 * compliance.col(i).norm()) << i;
    }
  }
}

// Members that keep their axes, so that a pin with an error is between sun and ring alone: the change of its
// mesh forces from the planet's spring of natural frequencies, which is independent of the search for shares.
TEST(Together, ElasticPlanetsShareAsTheirSpringsSay) {
  for (const bool rim : {false, true}) {
    PlanetaryDrivetrain drivetrain = reducer_with({.rim = rim});
    drivetrain.bearing.rollers().laminae = 0;
    drivetrain.dynamics.inertia.carrier_centrifugal = false;  // as of the gears below
    gearset::dynamics::SetParameters gears = drivetrain.gear_set();
    for (gearset::dynamics::CentralMember* member : {&gears.sun, &gears.ring, &gears.carrier})
      member->support.held = true;
    gears.frame.centrifugal = false;
    const DrivetrainGeometry geometry = derive(drivetrain);
    const BearingDuty duty = bearing_duty(drivetrain, geometry);
    Matrix4d spring = Matrix4d::Zero();
    const double sun = gears.sun_mesh.stiffness.mean(), ring = gears.ring_mesh.stiffness.mean();
    if (rim) {
      spring = planet_stiffness(drivetrain, geometry, sun, ring);
    } else {
      spring.diagonal().head<2>() << sun, ring;
      spring.bottomRightCorner<2, 2>() = bearing_tangent(drivetrain, geometry).stiffness;
    }
    // Deflections of sun mesh, ring mesh and bearing by x, y and rotation of the planet, then by the sun's
    // teeth and by the pin ahead.
    const double a = geometry.gears.sun_mesh.working_pressure_angle,
                 b = geometry.gears.ring_mesh.working_pressure_angle;
    Eigen::Matrix<double, 4, 5> deflections;
    deflections << -std::sin(a), -std::cos(a), 1.0, 1.0, 0.0,  //
        std::sin(b), -std::cos(b), -1.0, 0.0, 0.0,             //
        -1.0, 0.0, 0.0, 0.0, 0.0,                              //
        0.0, -1.0, 0.0, 0.0, 1.0;
    const Eigen::Matrix<double, 5, 5> all = deflections.transpose() * spring * deflections;
    const Eigen::Matrix2d left = all.bottomRightCorner<2, 2>() - all.bottomLeftCorner<2, 3>() *
                                                                     all.topLeftCorner<3, 3>().inverse() *
                                                                     all.topRightCorner<3, 2>();
    constexpr double error = 0.02e-6;  // [m]  small: rollers come and go
    const auto share_of_first = [&](double first) {
      gears.pin_error = ahead({first, 0.0, 0.0, 0.0});
      drivetrain.gear_set = [gears] { return gears; };
      drivetrain.uneven_planets = true;
      return planet_balance(drivetrain, geometry).shares[0];
    };
    const double by_search = (share_of_first(error) - share_of_first(-error)) / 2.0 * duty.gears.normal_force;
    // The four forces keep their sum: the sun turns until they do.
    const double by_spring = left(0, 1) * error * (1.0 - 0.25);
    EXPECT_NEAR(by_search / by_spring, 1.0, 1e-5) << (rim ? "elastic" : "rigid");
  }
}

// The walls of the carrier twist by what all planets press on them.
TEST(Together, TwistOfTheCarrierIsThatOfAllPlanets) {
  PlanetaryDrivetrain even = reducer_with({.tilt = true});
  even.seats.carrier_twist = 1e6;
  PlanetaryDrivetrain found = reducer_with({.tilt = true}, ahead({0.0, 0.0, 0.0, 0.0}));
  found.seats.carrier_twist = 1e6;
  const PointResult alike = point_of(even), uneven = point_of(found);
  // Mean over the cage angles, of all planets instead of this one.
  expect_near(uneven.life_hours, alike.life_hours, 2e-3, "life");
  EXPECT_LT((uneven.seats[0].tilt - alike.seats[0].tilt).norm(), 2e-3 * alike.seats[0].tilt.norm());
}

// In front of another set a set with pins off their places has what it has as a single one.
TEST(Together, OneOfSeveralSetsSharesAndTiltsAsASingleOne) {
  using namespace gearset::example_sets;
  const gearset::Arrangement arrangement{{arranged("first", 37, 22, 79), arranged("second", 37, 22, 79)},
                                         {motor({{0, sun}}), ground({{0, ring}, {1, ring}}),
                                          shaft("middle", {{0, carrier}, {1, sun}}), load({{1, carrier}})}};
  const gearset::PowerFlow flow = gearset::power_flow(arrangement);
  const PlanetaryDrivetrain single = reducer_with({.tilt = true}, ahead({4e-6, 0.0, -2e-6, 1e-6}));
  PlanetaryDrivetrain first = single, second = reducer_with({});
  first.in_arrangement = flow.sets[0];
  second.in_arrangement = flow.sets[1];
  first.mesh_variation = second.mesh_variation = false;
  const PointResult expected = point_of(single);
  const PointResult found = evaluate(first, derive(first));
  for (std::size_t i = 0; i < 4; ++i)
    expect_near(found.planets[i].load_share, expected.planets[i].load_share, kShared, "share");
  expect_near(found.system_life_hours, expected.system_life_hours, kShared, "life of all");
  const PointResult both = evaluate({{"first", first, derive(first)}, {"second", second, derive(second)}});
  expect_near(both.sets[0].life_hours, expected.life_hours, kShared, "life in the chain");
}

// In motion each bearing keeps the quasi-static load, tilt and form of its race.
TEST(Together, SeatedBearingsHaveTheFormOfTheirPlanet) {
  const PlanetaryDrivetrain drivetrain = reducer_with({.tilt = true, .rim = true});
  const DrivetrainGeometry geometry = derive(drivetrain);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const PlanetSeat seat = planet_seat(drivetrain);
  const bearing::laminae::PlanetOnPinResult planet = tilting_planet(seat, drivetrain, duty);
  for (const SeatedBearing& one : seated_bearings(seat, drivetrain, geometry, duty)) {
    const std::size_t k =
        one.drivetrain.bearing.radial_clearance > drivetrain.bearing.radial_clearance ? 0 : 1;
    const bearing::QuasiStaticResult alone =
        bearing::quasi_static_bearing(bearing::laminae::LaminaBearing(one.drivetrain.bearing), one.duty.point,
                                      quasi_static_options(one.drivetrain));
    const Eigen::ArrayXd difference = alone.race_form - planet.bearings[k].race_form;
    EXPECT_LT(difference.abs().maxCoeff(), 0.02 * planet.bearings[k].race_form.abs().maxCoeff()) << k;
    EXPECT_NEAR(alone.outer_load.maxCoeff() / planet.bearings[k].outer_load.maxCoeff(), 1.0, 0.02) << k;
  }
}

}  // namespace
}  // namespace orbearing::analysis::study_together_test
