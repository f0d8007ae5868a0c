// Deflections, speeds over time, refusals and bodies of gearset/dynamics.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "gearset/dynamics/bodies.hpp"
#include "gearset/dynamics/mesh_force.hpp"
#include "gearset/dynamics/modes.hpp"
#include "gearset/planet_body.hpp"
#include "tests/messages.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::gearset::dynamics::gear_dynamics_test {
namespace {

constexpr double kRoundOff = 1e-12;

// Sketch: planet at angle zero; the sun turning by u meets the planet's flank, which the planet's own
// rotation, outward shift and way forward relieve.
TEST(Deflection, OfThePlanetOnTheXAxis) {
  const double alpha = 0.4;
  const DeflectionVector sun = sun_mesh_deflection(0.0, alpha, Flank::driving);
  EXPECT_NEAR(sun.central.x(), std::sin(alpha), kRoundOff);
  EXPECT_NEAR(sun.central.y(), std::cos(alpha), kRoundOff);
  EXPECT_NEAR(sun.planet.x(), -std::sin(alpha), kRoundOff);
  EXPECT_NEAR(sun.planet.y(), -std::cos(alpha), kRoundOff);
  EXPECT_EQ(sun.central.z(), 1.0);
  EXPECT_EQ(sun.planet.z(), 1.0);
  const DeflectionVector ring = ring_mesh_deflection(0.0, alpha, Flank::driving);
  EXPECT_NEAR(ring.central.x(), -std::sin(alpha), kRoundOff);
  EXPECT_NEAR(ring.planet.x(), std::sin(alpha), kRoundOff);
  EXPECT_NEAR(ring.planet.y(), -std::cos(alpha), kRoundOff);
  EXPECT_EQ(ring.planet.z(), -1.0);
}

// An equal shift of all bodies leaves every deflection unchanged; only rotating members press the teeth.
TEST(Deflection, IgnoresACommonShift) {
  for (const double psi : {0.0, 1.1, 4.0})
    for (const Flank flank : {Flank::driving, Flank::back})
      for (const auto& along : {sun_mesh_deflection(psi, 0.3, flank), ring_mesh_deflection(psi, 0.3, flank),
                                radial_bearing_deflection(psi), tangential_bearing_deflection(psi)}) {
        const Eigen::Vector2d shift(0.3, -0.8);
        const Eigen::Vector2d radial(std::cos(psi), std::sin(psi)), tangential(-std::sin(psi), std::cos(psi));
        const double central = along.central.head<2>().dot(shift);
        const double planet = along.planet.x() * radial.dot(shift) + along.planet.y() * tangential.dot(shift);
        EXPECT_NEAR(central + planet, 0.0, kRoundOff);
      }
}

TEST(Deflection, BackFlankIsTheMirrorImage) {
  const DeflectionVector driving = sun_mesh_deflection(0.0, 0.4, Flank::driving);
  const DeflectionVector back = sun_mesh_deflection(0.0, 0.4, Flank::back);
  const Eigen::Vector3d mirror(1.0, -1.0, -1.0);  // about the line of centres
  EXPECT_LT((back.central - driving.central.cwiseProduct(mirror)).norm(), kRoundOff);
  EXPECT_LT((back.planet - driving.planet.cwiseProduct(mirror)).norm(), kRoundOff);
}

TEST(FlankForce, PushesBeyondTheGapAndNeverPulls) {
  const Mesh mesh{.damping = 100.0};
  EXPECT_EQ(flank_force(mesh, true, {.stiffness = 1e8}, -1e-6, 5.0).total(), 0.0);
  EXPECT_NEAR(flank_force(mesh, true, {.stiffness = 1e8}, 2e-6, 0.5).total(), 200.0 + 50.0, 1e-9);
  EXPECT_EQ(flank_force(mesh, true, {.stiffness = 1e8}, 2e-6, -5.0).total(), 0.0);
  EXPECT_NEAR(flank_force(mesh, false, {.stiffness = 1e8}, -2e-6, 0.0).total(), -200.0, 1e-9);
}

TEST(Operation, CountsMeshPeriodsAndBack) {
  Operation operation = test::reducer_operation(628.0);
  EXPECT_NEAR(operation.mesh_frequency, 37.0 * 628.0 * 79.0 / 116.0 / (2.0 * M_PI), 1e-9 * 2500.0);
  operation.run_up = {.from = 0.25, .duration = 2.0};
  for (const double time : {0.0, 0.3, 1.999, 2.0, 7.0}) {
    EXPECT_NEAR(time_of_periods(operation, mesh_periods(operation, time)), time, 1e-12);
    const double h = 1e-5;
    const double rate = (mesh_periods(operation, time + h) - mesh_periods(operation, time)) / h;
    // the rate rises by 0.375 / s times the frequency
    EXPECT_NEAR(rate, operation.mesh_frequency * speed_at(operation, time).factor, 1e-5 * 2519.0);
  }
  operation.run_up = {.from = 1.5, .duration = 2.0};  // a run-down
  EXPECT_NEAR(time_of_periods(operation, mesh_periods(operation, 1.3)), 1.3, 1e-12);
}

TEST(SetModel, FindsTheJumpsOfAllMeshes) {
  SetParameters set = test::reducer_dynamics();
  const std::vector<double> positions = jump_phases(set_model(set, test::reducer_operation(628.0)));
  // Four phases each: 0 and 0.45 of the sun mesh, 0 and 0.6 of the ring mesh 0.3 later; all apart.
  EXPECT_EQ(positions.size(), 16u - 4u);  // 0.45 - n/4 and 0.3 + 0.6 - ... meet: 0.7 = 0.45 + 0.25
  for (std::size_t i = 1; i < positions.size(); ++i) EXPECT_GT(positions[i], positions[i - 1]);
  EXPECT_GE(positions.front(), 0.0);
  EXPECT_LT(positions.back(), 1.0);
}

TEST(SetModel, RefusesWhatHasNoMeaning) {
  const auto refused = [](auto change) {
    SetParameters set = test::reducer_dynamics();
    change(set);
    EXPECT_REFUSED(std::invalid_argument, "gear_dynamics 1", set_model(set, test::reducer_operation(628.0)));
  };
  refused([](SetParameters& set) { set.planets = 0; });
  refused([](SetParameters& set) { set.sun.mass = 0.0; });
  refused([](SetParameters& set) { set.planet.inertia = -1.0; });
  refused([](SetParameters& set) { set.sun_phase.pop_back(); });
  refused([](SetParameters& set) { set.ring_mesh.stiffness = PeriodicCurve::constant(0.0); });
  refused([](SetParameters& set) { set.sun_mesh.backlash = NAN; });
  refused([](SetParameters& set) { set.pin_error.resize(2, 3); });
}

TEST(Bodies, OfThePlanetAreThoseOfItsToothForm) {
  const PlanetarySet set = reducer();
  const WorkingGeometry geometry = working_geometry(set);
  const BodyOutlines outlines{
      .sun_bore = 50e-3, .ring_outside = 280e-3, .planet_bore = 47e-3, .carrier_plates = 14e-3};
  const SetBodies bodies = set_bodies(set, geometry, outlines);
  const PlanetBody body = planet_body(set, geometry);
  EXPECT_NEAR(bodies.planet.mass, body.mass, kRoundOff);
  EXPECT_NEAR(bodies.planet.inertia, body.inertia / std::pow(geometry.planet.base_radius, 2), kRoundOff);
  // Between hoops at the tips' and at the roots' radius.
  const double hoop = set.density * set.face_width * M_PI;
  EXPECT_LT(bodies.ring.mass, hoop * (std::pow(0.14, 2) - std::pow(geometry.ring.tip_radius, 2)));
  EXPECT_GT(bodies.ring.mass, hoop * (std::pow(0.14, 2) - std::pow(geometry.ring.root_radius, 2)));
  EXPECT_REFUSED(std::domain_error, "gear_dynamics 2",
                 set_bodies(set, geometry, {.sun_bore = 0.2, .ring_outside = 0.28, .carrier_plates = 0.01}));
  EXPECT_REFUSED(std::domain_error, "gear_dynamics 3",
                 set_bodies(set, geometry, {.sun_bore = 0.05, .ring_outside = 0.2, .carrier_plates = 0.01}));
}

TEST(Modes, CountAllFreedoms) {
  for (const int planets : {3, 4, 5, 7}) {
    int count = 0;
    for (const Mode& mode : modes_at_rest(test::lin_parker_model(planets))) {
      count += mode.multiplicity;
      EXPECT_EQ(mode.shapes.cols(), mode.multiplicity);
    }
    EXPECT_EQ(count, 9 + 3 * planets);
  }
}

TEST(Modes, LeaveHeldFreedomsOut) {
  SetParameters set = test::lin_parker(3);
  set.ring.support.held_in_rotation = true;
  set.carrier.support.held = true;
  int count = 0;
  for (const Mode& mode : modes_at_rest(set_model(set, {}))) count += mode.multiplicity;
  EXPECT_EQ(count, 18 - 3);
}

// At decreasing speed the frequencies tend to those without rotation; a slow carrier changes them by less
// than its own speed.
TEST(Modes, AtASlowSpeedAreThoseAtRest) {
  Operation operation;
  operation.speeds.carrier = 1.0;
  const SetModel slow = set_model(test::lin_parker(4), operation);
  const Eigen::MatrixXd frequencies = campbell_frequencies(slow, {0.0, 1.0});
  std::vector<double> at_rest;
  for (const Mode& mode : modes_at_rest(slow))
    at_rest.insert(at_rest.end(), static_cast<std::size_t>(mode.multiplicity), mode.frequency);
  for (Eigen::Index i = 1; i < frequencies.rows(); ++i) {
    EXPECT_NEAR(frequencies(i, 0), at_rest[static_cast<std::size_t>(i)], 1e-6 * at_rest.back());
    EXPECT_NEAR(frequencies(i, 1), at_rest[static_cast<std::size_t>(i)], 1.0 / (2.0 * M_PI));
  }
}

}  // namespace
}  // namespace orbearing::gearset::dynamics::gear_dynamics_test
