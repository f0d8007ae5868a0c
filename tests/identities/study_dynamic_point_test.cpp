// The dynamic operating point of the reducer against the rung below it, and what the mesh excitation does.
#include <gtest/gtest.h>

#include "bearing/life/lundberg_palmgren.hpp"
#include "coupling/analysis/gear_dynamics.hpp"
#include "coupling/analysis/gear_model.hpp"
#include "coupling/analysis/mesh_excitation.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "coupling/analysis/planet_stiffness.hpp"
#include "tests/reducer.hpp"

namespace orbearing::analysis::study_dynamic_point_test {
namespace {

using example::reducer;

// Rollers in motion carry what the quasi-static bearing carries, but for what traction takes past the bore.
constexpr double kSameLoads = 0.02;

PlanetaryDrivetrain short_run() {
  PlanetaryDrivetrain drivetrain = reducer();
  drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  drivetrain.steady_state.observed_windows = 2;
  return drivetrain;
}

PointResult dynamic_point(const PlanetaryDrivetrain& drivetrain) {
  return evaluate(drivetrain, derive(drivetrain), Fidelity::dynamic);
}

TEST(StudyDynamicPoint, CarriesTheQuasiStaticLoads) {
  const PlanetaryDrivetrain drivetrain = short_run();
  const PointResult still = evaluate(drivetrain, derive(drivetrain));
  const PointResult moving = dynamic_point(drivetrain);
  ASSERT_TRUE(moving.dynamic.has_value());
  EXPECT_TRUE(moving.dynamic->steady);
  EXPECT_NEAR(moving.inner.load_rms / still.inner.load_rms, 1.0, kSameLoads);
  EXPECT_NEAR(moving.outer.load_rms / still.outer.load_rms, 1.0, kSameLoads);
  EXPECT_EQ(moving.planet_load, still.planet_load);
  EXPECT_GT(moving.dynamic->loss.total(), 0.0);
}

// The same on laminae, with crowned rollers and a bore that is tilted on its pin.
TEST(StudyDynamicPoint, CarriesTheQuasiStaticLoadsOnLaminae) {
  PlanetaryDrivetrain drivetrain = short_run();
  drivetrain.bearing.rollers().laminae = 8;
  drivetrain.bearing.rollers().profile =
      bearing::profile::CircularCrown{drivetrain.bearing.rollers().length, 8e-6};
  const PointResult level = dynamic_point(drivetrain);
  drivetrain.misalignment.planet_tilt = 1e-3;
  const PointResult still = evaluate(drivetrain, derive(drivetrain));
  const PointResult moving = dynamic_point(drivetrain);
  EXPECT_NEAR(moving.inner.load_rms / still.inner.load_rms, 1.0, kSameLoads);
  EXPECT_NEAR(moving.outer.load_rms / still.outer.load_rms, 1.0, kSameLoads);
  EXPECT_NE(moving.inner.load_rms, level.inner.load_rms);
}

// Bodies and meshes of the reducer, as its case states them by default.
gearset::dynamics::SetParameters gears_of(const PlanetaryDrivetrain& drivetrain) {
  const DrivetrainGeometry geometry = derive(drivetrain);
  const gearset::MeanLoads loads = gearset::mean_loads(drivetrain.set, geometry.gears, drivetrain.drive);
  const gearset::PlanetaryMeshes meshes = gearset::planetary_meshes(
      drivetrain.set, geometry.gears, {}, {},
      gearset::mesh_motion(loads.sun_torque, loads.sun_speed - loads.carrier_speed));
  GearDynamicsChoice choice;
  choice.mesh_damping_ratio = choice.bearing_damping_ratio = 0.05;
  choice.sun.support_stiffness = choice.ring.support_stiffness = choice.carrier.support_stiffness = 1e8;
  return geometric_set(choice, drivetrain.set, geometry.gears, meshes, 0.0, 3e8);
}

// Gears whose mesh stiffness stays the same give the mean loads alone; teeth that pass shake the bearing,
// which shows in the largest load and hardly in the mean that gives the life.
TEST(StudyDynamicPoint, MeshStiffnessRaisesTheLargestLoad) {
  PlanetaryDrivetrain drivetrain = short_run();
  const PointResult calm = dynamic_point(drivetrain);
  const gearset::dynamics::SetParameters gears = gears_of(drivetrain);
  gearset::dynamics::SetParameters constant = gears;
  constant.sun_mesh.stiffness = gearset::PeriodicCurve::constant(gears.sun_mesh.stiffness.mean());
  constant.ring_mesh.stiffness = gearset::PeriodicCurve::constant(gears.ring_mesh.stiffness.mean());
  drivetrain.gear_set = [=] { return constant; };
  EXPECT_NEAR(dynamic_point(drivetrain).inner.load_max, calm.inner.load_max, 1e-3 * calm.inner.load_max);
  drivetrain.gear_set = [=] { return gears; };
  const PointResult shaken = dynamic_point(drivetrain);
  EXPECT_GT(shaken.inner.load_max, 1.01 * calm.inner.load_max);
  EXPECT_NEAR(shaken.life_hours / calm.life_hours, 1.0, 0.2);
}

// A planet's mass times its acceleration is what its meshes and its bearings push it with: the load on a bore
// with its share of that mass is the meshes' part, shared by the bearings of the planet. Without the forces
// of the turning frame, and with so much backlash that the motion repeats. Sine, cosine, sign, number of
// bearings and both meshes are in it.
TEST(StudyDynamicPoint, LoadOfTheGearsIsWhatAcceleratesThePlanetLessItsBearings) {
  PlanetaryDrivetrain drivetrain = short_run();
  drivetrain.dynamics.inertia = {
      .own_orbit = false, .coriolis = false, .carrier_centrifugal = false, .euler = false};
  gearset::dynamics::SetParameters gears = gears_of(drivetrain);
  gears.frame = {.coriolis = false, .centrifugal = false, .euler = false};
  gears.sun_mesh.backlash = gears.ring_mesh.backlash = 1e-3;  // [m]  teeth that strike back do not repeat
  gears.carrier.mass *= 1e6;  // a carrier that shakes would carry its pins along
  gears.carrier.inertia *= 1e6;
  drivetrain.gear_set = [=] { return gears; };
  const DrivetrainGeometry geometry = derive(drivetrain);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const gearset::dynamics::AffineBearing law = bearing_tangent(drivetrain, geometry);
  const double bore = gears.planet.mass / drivetrain.bearings_per_planet;
  const bearing::motion::MeshExcitation excitation =
      excitation_of(GearsOnLaw(drivetrain, geometry, law).run(), drivetrain, duty, law, bore);
  gears.planet.affine_bearing = law;
  const gearset::dynamics::SetModel model =
      set_model(gears, gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive));
  GearRunOptions options;
  options.harmonics = excitation_orders(drivetrain, geometry, law);
  const PlanetStatistics planet = run_gears(model, options).planets.front();
  ASSERT_GT(excitation.harmonics.size(), 4u);
  double largest = 0.0;  // [N]
  for (const bearing::motion::LoadHarmonic& harmonic : excitation.harmonics)
    largest = std::max({largest, harmonic.cosine.norm(), harmonic.sine.norm()});
  EXPECT_GT(largest, 1.0);
  constexpr double kJumps =
      0.02;  // of the largest: accelerations jump with the mesh stiffness, and are sampled
  const auto expect_part = [&](const bearing::motion::LoadHarmonic& harmonic, Eigen::Index axis,
                               const SignalStatistics& acceleration, const SignalStatistics& force) {
    const auto i = static_cast<std::size_t>(harmonic.order) - 1;
    const double number = drivetrain.bearings_per_planet, mass = gears.planet.mass;
    EXPECT_NEAR(harmonic.cosine[axis], (mass * acceleration.cosines[i] - force.cosines[i]) / number,
                kJumps * largest);
    EXPECT_NEAR(harmonic.sine[axis], (mass * acceleration.sines[i] - force.sines[i]) / number,
                kJumps * largest);
  };
  for (const bearing::motion::LoadHarmonic& harmonic : excitation.harmonics) {
    expect_part(harmonic, 0, planet.radial_acceleration, planet.radial_force);
    expect_part(harmonic, 1, planet.tangential_acceleration, planet.tangential_force);
  }
}

// All bearings of a planet together move its gear and their own rings, whatever their number.
TEST(StudyDynamicPoint, BearingsOfAPlanetShareItsMass) {
  for (const int bearings : {1, 2, 3}) {
    PlanetaryDrivetrain drivetrain = reducer();
    drivetrain.bearings_per_planet = bearings;
    const DrivetrainGeometry geometry = derive(drivetrain);
    const double mass = geometry.planet_gear.mass + bearings * geometry.bearing.outer_ring_mass;
    EXPECT_NEAR(bearing_dynamics(drivetrain, geometry).bore_mass * bearings, mass, 1e-12 * mass);
  }
}

// Life of a run-up over the speeds that it passes: each contributes damage by the passages at it and by its
// own load.
TEST(StudyDynamicPoint, RunUpLivesAsTheSpeedsThatItPasses) {
  PlanetaryDrivetrain drivetrain = short_run();
  drivetrain.dynamics.inertia.euler = false;  // what the quasi-static bearing has not
  drivetrain.steady_state.least_windows = drivetrain.steady_state.most_windows = 1;
  constexpr double kGrowth = 20.0, kDuration = 0.02;  // [1/s], [s]  to 1.4 of the first speed
  drivetrain.run_up = {.acceleration = kGrowth * drivetrain.drive.speed, .duration = kDuration};
  const PointResult moving = dynamic_point(drivetrain);
  double inner = 0.0, outer = 0.0, ratios = 0.0;
  constexpr int kSpeeds = 9;
  for (int i = 0; i < kSpeeds; ++i) {
    const double ratio = 1.0 + kGrowth * kDuration * (i + 0.5) / kSpeeds;
    PlanetaryDrivetrain there = drivetrain;
    there.drive.speed *= ratio;
    const PointResult still = evaluate(there, derive(there));
    inner += ratio / still.inner.life;
    outer += ratio / still.outer.life;
    ratios += ratio;
  }
  // 2 % of a load are 8 % of a life; the run-up holds but one and a half turns of the cage.
  constexpr double kSameLife = 0.1;
  EXPECT_NEAR(moving.inner.life * inner / ratios, 1.0, kSameLife);
  EXPECT_NEAR(moving.outer.life * outer / ratios, 1.0, kSameLife);
  const double mean_speed =
      (1.0 + 0.5 * kGrowth * kDuration) * bearing_duty(drivetrain, derive(drivetrain)).point.outer_speed;
  const double revolutions = bearing::combined_life(moving.inner.life, moving.outer.life);
  EXPECT_NEAR(moving.life_hours, bearing::hours(revolutions, mean_speed), 1e-12 * moving.life_hours);
}

// Rollers slip where they lag behind pure rolling, in a steady state and in a run-up; slip is a share of
// that.
TEST(StudyDynamicPoint, RollerSlipIsTheShareThatIsMissing) {
  PlanetaryDrivetrain drivetrain = short_run();
  drivetrain.drive.power = 5e3;
  drivetrain.bearing.radial_clearance = 20e-6;
  drivetrain.steady_state.observed_windows = 1;  // of which the series is
  const DrivetrainGeometry geometry = derive(drivetrain);
  const double outer_speed = bearing_duty(drivetrain, geometry).point.outer_speed;
  const double rolling = bearing::kinematic_roller_spin(geometry.bearing, 0.0, outer_speed);
  for (const double growth : {0.0, 20.0}) {
    constexpr double kDuration = 0.02;  // [s]
    drivetrain.run_up = {.acceleration = growth * drivetrain.drive.speed, .duration = kDuration};
    const PointResult point = dynamic_point(drivetrain);
    const double mean = point.dynamic->series.spin.mean(),
                 wanted = rolling * (1.0 + 0.5 * growth * kDuration);
    EXPECT_GT(point.dynamic->roller_slip, 0.02) << "too little to tell from its inverse";
    // The means are over a fifth of the states, the series over a fifth or all of them.
    EXPECT_NEAR(point.dynamic->roller_slip, 1.0 - mean / wanted, 5e-3);
  }
}

}  // namespace
}  // namespace orbearing::analysis::study_dynamic_point_test
