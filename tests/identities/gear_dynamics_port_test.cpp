// The port of a gear set's planets: what forces and moments of coupled bearings do there.
#include <gtest/gtest.h>

#include "gearset/dynamics/equations.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::gearset::dynamics::gear_dynamics_port_test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kStates = 20;
constexpr double kDisplacement =
    3e-5;                           // [m]    teeth touch, part, and touch on their backs (backlash 100 um)
constexpr double kVelocity = 0.05;  // [m/s]

// A coupled bearing with the spring's own force through the port is the spring.
TEST(GearDynamicsPort, CarriesTheSpringsForce) {
  SetParameters parameters = test::full_set();
  const Operation operation = test::reducer_operation(628.0);
  const SetModel sprung = set_model(parameters, operation);
  parameters.planet.coupled_bearing = true;
  const PlanetarySetEquations coupled(set_model(parameters, operation));
  test::Random random;
  const Index n = sprung.layout.freedoms();
  VectorXd x(2 * n), dx(2 * n), dx_coupled(2 * n);
  x << kDisplacement * random.vector(n), kVelocity * random.vector(n);
  BearingPorts ports;
  coupled.motion_at_ports(x, ports);
  const PortLoads loads{-parameters.planet.bearing_stiffness * ports.displacement -
                            parameters.planet.bearing_damping * ports.velocity,
                        VectorXd::Zero(parameters.planets)};
  PlanetarySetEquations(sprung).derivative(1e-3, x, dx);
  coupled.derivative(1e-3, x, loads, dx_coupled);
  EXPECT_LT((dx - dx_coupled).norm(), 1e-12 * dx.norm());
}

// So is one with an affine bearing's, in its general form: an offset, and matrices that are not symmetric.
TEST(GearDynamicsPort, CarriesTheAffineBearingsForce) {
  SetParameters parameters = test::full_set();
  AffineBearing law{.force = {300.0, -500.0}};
  law.stiffness << 3e8, 2e7, -1e7, 4e8;
  law.damping << 700.0, 50.0, -20.0, 900.0;
  parameters.planet.affine_bearing = law;
  const Operation operation = test::reducer_operation(628.0);
  const SetModel affine = set_model(parameters, operation);
  parameters.planet.coupled_bearing = true;
  const PlanetarySetEquations coupled(set_model(parameters, operation));
  test::Random random;
  const Index n = affine.layout.freedoms();
  VectorXd x(2 * n), dx(2 * n), dx_coupled(2 * n);
  x << kDisplacement * random.vector(n), kVelocity * random.vector(n);
  BearingPorts ports;
  coupled.motion_at_ports(x, ports);
  Eigen::Matrix2Xd force = -law.stiffness * ports.displacement - law.damping * ports.velocity;
  force.colwise() += law.force;
  PlanetarySetEquations(affine).derivative(1e-3, x, dx);
  coupled.derivative(1e-3, x, {force, VectorXd::Zero(parameters.planets)}, dx_coupled);
  EXPECT_LT((dx - dx_coupled).norm(), 1e-12 * dx.norm());
}

// The port adds force times velocity and moment times speed to the power balance, in any state.
TEST(GearDynamicsPort, PowerIsThatOfForceAndMoment) {
  SetParameters parameters = test::full_set();
  parameters.planet.coupled_bearing = true;
  Operation operation = test::reducer_operation(628.0);
  operation.load_yields = false;
  const PlanetarySetEquations equations(set_model(parameters, operation));
  test::Random random;
  const Index n = equations.model().layout.freedoms(), planets = parameters.planets;
  for (int k = 0; k < kStates; ++k) {
    VectorXd x(2 * n), free(2 * n), loaded(2 * n);
    x << kDisplacement * random.vector(n), kVelocity * random.vector(n);
    const PortLoads loads{1e4 * Eigen::Matrix2Xd::NullaryExpr(2, planets, [&] { return random(); }),
                          50.0 * random.vector(planets)};
    BearingPorts ports;
    equations.motion_at_ports(x, ports);
    equations.derivative(1e-3, x, free);
    equations.derivative(1e-3, x, loads, loaded);
    const VectorXd force = equations.model().mass.cwiseProduct(loaded.tail(n) - free.tail(n));
    const double power = loads.force.cwiseProduct(ports.velocity).sum() + loads.moment.dot(ports.speed);
    // Ring and pin hold: what they would do there is no power, since their mobility is zero.
    EXPECT_NEAR(force.dot(x.tail(n)), power, 1e-10 * force.norm() * x.tail(n).norm());
  }
}

// If the load yields, moments of the bearings do no work on the set as it rotates as a whole, whichever
// member delivers; if it does not, their work is that at the nominal rotation.
TEST(GearDynamicsPort, FrictionDoesNotSlowASetWhoseLoadYields) {
  SetParameters parameters = test::reducer_dynamics();
  parameters.planet.coupled_bearing = true;
  for (const Member driven : {Member::sun, Member::carrier})
    for (const bool yields : {true, false}) {
      Operation operation = operation_of(reducer(), {driven, 150e3, 200.0});
      operation.load_yields = yields;
      const PlanetarySetEquations equations(set_model(parameters, operation));
      const Index n = equations.model().layout.freedoms();
      const Speeds& speed = operation.speeds;
      VectorXd rigid = VectorXd::Zero(n), x = VectorXd::Zero(2 * n), free(2 * n), loaded(2 * n);
      rigid[SetLayout::sun() + 2] = speed.sun * parameters.sun.radius;
      rigid[SetLayout::carrier() + 2] = speed.carrier * parameters.carrier.radius;
      for (Index i = 0; i < parameters.planets; ++i)
        rigid[SetLayout::planet(i) + 2] = (speed.planet_relative + speed.carrier) * parameters.planet.radius;
      const PortLoads loads{Eigen::Matrix2Xd::Zero(2, parameters.planets),
                            Eigen::VectorXd::LinSpaced(parameters.planets, 0.2, 0.5)};
      equations.derivative(1e-3, x, free);
      equations.derivative(1e-3, x, loads, loaded);
      const double work = equations.model().mass.cwiseProduct(loaded.tail(n) - free.tail(n)).dot(rigid);
      const double friction = loads.moment.sum() * speed.planet_relative;
      EXPECT_NEAR(work, yields ? 0.0 : friction, 1e-10 * std::abs(friction));
    }
}

// Willis: with the ring held the planet turns by -z_r/z_p times the carrier, relative to it.
TEST(GearDynamicsPort, RotationOfThePlanetFollowsWillis) {
  const SetParameters parameters = test::reducer_dynamics();
  const PlanetarySetEquations equations(set_model(parameters, test::reducer_operation(628.0)));
  const double cos_ring = std::cos(working_geometry(reducer()).ring_mesh.working_pressure_angle);
  VectorXd x = VectorXd::Zero(equations.model().layout.size());
  const double radius = parameters.carrier.radius, turn = 1e-3;  // [m], [rad]
  x[SetLayout::carrier() + 2] = turn * radius;
  for (Index i = 0; i < 4; ++i)
    x.segment<3>(SetLayout::planet(i)) << 0.0, turn * radius, -turn * radius * cos_ring;
  BearingPorts ports;
  equations.motion_at_ports(x, ports);
  // The root finder's error of the centre distance.
  EXPECT_LT((ports.angle.array() + turn * 79.0 / 22.0).abs().maxCoeff(), 1e-9 * turn);
  EXPECT_LT(ports.displacement.cwiseAbs().maxCoeff(), 1e-12 * radius);
}

}  // namespace
}  // namespace orbearing::gearset::dynamics::gear_dynamics_port_test
