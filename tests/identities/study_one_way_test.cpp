// One way: what the gears drive a bearing with is exact for a bearing that is linear, and a real one then
// lives as in one system with the gears, where the scheme of one pass does not.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "coupling/analysis/gear_dynamics.hpp"
#include "coupling/analysis/mesh_excitation.hpp"
#include "coupling/analysis/one_way.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "coupling/analysis/planet_stiffness.hpp"
#include "tests/coupled_reducer.hpp"

namespace orbearing::analysis {
namespace {

using Eigen::Vector2d;
using gearset::dynamics::AffineBearing;

// The reducer with its real meshes, dry; runs shorter than those of the case.
PlanetaryDrivetrain dry_reducer_at(double speed) {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.drive.speed = speed;
  drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  const gearset::dynamics::SetParameters gears = example::reducer_gears(drivetrain);
  drivetrain.gear_set = [gears] { return gears; };
  return drivetrain;
}

// A law far from that of a real bearing, stiffer one way than the other and not symmetric.
AffineBearing lopsided() {
  AffineBearing law{.force = {300.0, -100.0}};
  law.stiffness << 3e8, 3e7, -1e7, 5e8;
  law.damping << 900.0, 100.0, -50.0, 700.0;
  return law;
}

GearRunResult gear_run_on(const PlanetaryDrivetrain& drivetrain, const AffineBearing& law) {
  gearset::dynamics::SetParameters set = drivetrain.gear_set();
  set.planet.affine_bearing = law;
  return run_gears(
      gearset::dynamics::set_model(set, gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive)),
      {});
}

// A bore on half the law, driven by the excitation, integrated by small steps until its start is forgotten;
// then the harmonics of the force of the law on the planet.
Eigen::Matrix<double, 2, 2> driven_harmonic(const bearing::motion::MeshExcitation& excitation,
                                            const AffineBearing& law, double mass,
                                            const bearing::CarrierFrame& frame, int wanted) {
  const int steps = 400, settle = 150, kept = 10;  // [per mesh period], [mesh periods]
  const double h = 2.0 * M_PI / excitation.angular_frequency / steps;
  Vector2d x = Vector2d::Zero(), v = Vector2d::Zero();
  Eigen::Matrix2d sums = Eigen::Matrix2d::Zero();
  const auto acceleration = [&](double time, const Vector2d& at, const Vector2d& speed) -> Vector2d {
    Vector2d load = -0.5 * (law.stiffness * at + law.damping * speed);
    for (const bearing::motion::LoadHarmonic& one : excitation.harmonics) {
      const double angle = one.order * excitation.angular_frequency * time;
      load += one.cosine * std::cos(angle) + one.sine * std::sin(angle);
    }
    return load / mass + bearing::inertial_acceleration(frame, at, speed);
  };
  for (int i = 0; i < (settle + kept) * steps; ++i) {
    const double t = i * h;
    if (i >= settle * steps) {
      const Vector2d force = -law.stiffness * x - law.damping * v;
      const double angle = wanted * excitation.angular_frequency * t, weight = 2.0 / (kept * steps);
      sums.col(0) += weight * std::cos(angle) * force;
      sums.col(1) += weight * std::sin(angle) * force;
    }
    // Runge and Kutta's classical steps
    const Vector2d a1 = acceleration(t, x, v), v2 = v + 0.5 * h * a1,
                   a2 = acceleration(t + 0.5 * h, x + 0.5 * h * v, v2), v3 = v + 0.5 * h * a2,
                   a3 = acceleration(t + 0.5 * h, x + 0.5 * h * v2, v3), v4 = v + h * a3,
                   a4 = acceleration(t + h, x + h * v3, v4);
    x += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
    v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }
  return sums;
}

// With a linear bearing the bore moves as the planet did, in one pass and whatever its mass.
TEST(OneWay, IsExactForALinearBearing) {
  const PlanetaryDrivetrain drivetrain = dry_reducer_at(6000.0 * example::rpm);
  const DrivetrainGeometry geometry = derive(drivetrain);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const PlanetStatistics planet = gear_run_on(drivetrain, lopsided()).planets.front();
  bearing::CarrierFrame frame = bearing::carrier_frame(duty.point.carrier, drivetrain.dynamics.inertia);
  frame.orbit_radius = 0.0;
  for (const double mass : {0.5 * geometry.planet_mass, geometry.bearing.outer_ring_mass}) {
    const bearing::motion::MeshExcitation excitation =
        excitation_of(GearsOnLaw(drivetrain, geometry, lopsided()).run(), drivetrain, duty, lopsided(), mass);
    for (const int order : {1, 2}) {
      const auto i = static_cast<std::size_t>(order) - 1;
      Eigen::Matrix2d gears;
      gears << planet.radial_force.cosines[i], planet.radial_force.sines[i],
          planet.tangential_force.cosines[i], planet.tangential_force.sines[i];
      const Eigen::Matrix2d driven = driven_harmonic(excitation, lopsided(), mass, frame, order);
      // Steps of 1/400 period are good to 1e-7; what is left of the start falls by e^(-c t / 2m), 1e-5 or
      // less.
      EXPECT_LT((driven - gears).norm(), 1e-4 * gears.norm()) << "order " << order << ", mass " << mass;
    }
  }
}

// For a bore with its share of the planet's mass the load is that of both meshes, where the carrier is too
// heavy to shake: Eqs. (19) and (20) of gearset/README.md in time.
TEST(OneWay, DrivesThePlanetsMassWithTheMeshForces) {
  PlanetaryDrivetrain drivetrain = dry_reducer_at(6000.0 * example::rpm);
  gearset::dynamics::SetParameters gears = drivetrain.gear_set();
  gears.carrier.mass *= 1e4;
  gears.carrier.inertia *= 1e4;
  drivetrain.gear_set = [gears] { return gears; };
  const DrivetrainGeometry geometry = derive(drivetrain);
  const PlanetStatistics planet = gear_run_on(drivetrain, lopsided()).planets.front();
  const auto& sun = planet.sun_mesh_force;
  const auto& ring = planet.ring_mesh_force;
  const double a_s = geometry.gears.sun_mesh.working_pressure_angle,
               a_r = geometry.gears.ring_mesh.working_pressure_angle;
  const bearing::motion::MeshExcitation excitation = excitation_of(
      GearsOnLaw(drivetrain, geometry, lopsided()).run(), drivetrain, bearing_duty(drivetrain, geometry),
      lopsided(), gears.planet.mass / drivetrain.bearings_per_planet);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto load = [&](double of_sun, double of_ring) -> Vector2d {
      return Vector2d(std::sin(a_s) * of_sun - std::sin(a_r) * of_ring,
                      std::cos(a_s) * of_sun + std::cos(a_r) * of_ring) /
             drivetrain.bearings_per_planet;
    };
    ASSERT_EQ(excitation.harmonics[i].order, static_cast<int>(i) + 1);
    const Vector2d cosine = load(sun.cosines[i], ring.cosines[i]), sine = load(sun.sines[i], ring.sines[i]);
    // The gears are integrated to 1e-4 of a mesh's deflection, and their harmonics are means over 12,800
    // samples of forces that jump.
    const double allowed = 5e-3 * std::hypot(cosine.norm(), sine.norm());
    EXPECT_LT((excitation.harmonics[i].cosine - cosine).norm(), allowed);
    EXPECT_LT((excitation.harmonics[i].sine - sine).norm(), allowed);
  }
}

// At the speed where the second mesh harmonic meets the mode in which planets swing on their bearings, one
// pass on the tangent is off by a fifth or more of the life.
TEST(OneWay, LivesAsInOneSystemInTheDip) {
  const PlanetaryDrivetrain drivetrain = dry_reducer_at(6000.0 * example::rpm);
  const DrivetrainGeometry geometry = derive(drivetrain);
  const PointResult one_way = evaluate(drivetrain, geometry, Fidelity::dynamic);
  const PointResult one_system = evaluate(drivetrain, geometry, Fidelity::monolithic);
  ASSERT_TRUE(one_way.dynamic && one_way.dynamic->one_way);
  EXPECT_TRUE(one_way.dynamic->one_way->accepted);
  EXPECT_GE(one_way.dynamic->one_way->runs, 2);
  // The scheme is good to 3 % and each of both means over three cage revolutions scatters by 1 to 2 %.
  EXPECT_NEAR(one_way.life_hours / one_system.life_hours, 1.0, 0.07);
}

// Rollers in the planet's own bore. The round-off between race and seat is no ring, and would be shaken
// without bound ("no step was small enough").
TEST(OneWay, WithoutAnOuterRingThePlanetMoves) {
  PlanetaryDrivetrain drivetrain = dry_reducer_at(6000.0 * example::rpm);
  drivetrain.steady_state.observed_windows = 1;
  const double race = 2.0 * bearing::geometry_of(drivetrain.bearing).outer_radius;
  std::vector<double> lives;
  for (const double round_off : {0.0, 1e-12}) {
    drivetrain.bearing.outer.seat_diameter = race * (1.0 + round_off);
    const PointResult point = evaluate(drivetrain, derive(drivetrain), Fidelity::dynamic);
    ASSERT_EQ(point.status, "ok");
    lives.push_back(point.life_hours);
  }
  EXPECT_NEAR(lives[1] / lives[0], 1.0, 0.05);  // motion scatters
}

// Stiffness, damping and the mean load must all be within the allowed change.
TEST(OneWay, IsAcceptedWhereAllChangesAreAllowed) {
  constexpr double any = 1e9;
  PlanetaryDrivetrain drivetrain = dry_reducer_at(6000.0 * example::rpm);
  drivetrain.steady_state.observed_windows = 1;
  const DrivetrainGeometry geometry = derive(drivetrain);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const GearsOnTangent gears = gears_on_tangent(drivetrain, geometry);
  const auto accepted = [&](double stiffness, double damping, double load) {
    const OneWayRun run = run_one_way(
        drivetrain, geometry, duty, gears, std::nullopt,
        {.stiffness_change = stiffness, .damping_change = damping, .load_difference = load, .most_runs = 1});
    EXPECT_EQ(run.fit.value().runs, 1);
    return run.fit.value().accepted;
  };
  EXPECT_TRUE(accepted(any, any, any));
  EXPECT_FALSE(accepted(0.0, any, any));
  EXPECT_FALSE(accepted(any, 0.0, any));
  EXPECT_FALSE(accepted(any, any, 0.0));
}

// At 300 rpm a roller of the reducer passes in three times as many steps as at 850 rpm.
TEST(OneWay, IsNotAskedForTheDampersOfSlowMotion) {
  constexpr double any = 1e9;
  PlanetaryDrivetrain drivetrain = dry_reducer_at(300.0 * example::rpm);
  drivetrain.steady_state.integration.method = integration::Method::linearly_implicit;
  drivetrain.steady_state.observed_windows = 1;
  const DrivetrainGeometry geometry = derive(drivetrain);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const GearsOnTangent gears = gears_on_tangent(drivetrain, geometry);
  const auto accepted = [&](double stiffness, double damping) {
    return run_one_way(drivetrain, geometry, duty, gears, std::nullopt,
                       {.stiffness_change = stiffness,
                        .damping_change = damping,
                        .load_difference = any,
                        .most_runs = 1})
        .fit.value()
        .accepted;
  };
  EXPECT_TRUE(accepted(any, 0.0));
  EXPECT_FALSE(accepted(0.0, any));
}

// Without backlash the centrifugal load of planets presses their back flanks on the ring: the gears carry
// another mean load than by the torques, the bearing is driven with that of the torques, and the point is not
// accepted.
TEST(OneWay, SaysWhereDisplacedPlanetsUseUpTheBacklash) {
  for (const bool tight : {false, true}) {
    PlanetaryDrivetrain drivetrain = dry_reducer_at(6000.0 * example::rpm);
    drivetrain.steady_state.observed_windows = 1;
    gearset::dynamics::SetParameters gears = drivetrain.gear_set();
    gears.sun_mesh.backlash = gears.ring_mesh.backlash = tight ? 0.0 : 100e-6;
    drivetrain.gear_set = [gears] { return gears; };
    const PointResult point = evaluate(drivetrain, derive(drivetrain), Fidelity::dynamic);
    ASSERT_TRUE(point.dynamic && point.dynamic->one_way);
    const OneWayRecord& record = *point.dynamic->one_way;
    if (tight) {
      EXPECT_GT(record.load_difference, 0.02);
      EXPECT_FALSE(record.accepted);
    } else {
      EXPECT_LT(record.load_difference, 5e-4);
    }
  }
}

}  // namespace
}  // namespace orbearing::analysis
