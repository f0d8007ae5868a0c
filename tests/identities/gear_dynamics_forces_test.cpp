// Forces of the planetary set follow from its stored energy, powers balance in every state, and planets can
// be renamed.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "gearset/dynamics/energy.hpp"
#include "gearset/dynamics/equations.hpp"
#include "gearset/dynamics/matrices.hpp"
#include "gearset/dynamics/modes.hpp"
#include "gearset/dynamics/stage_matrix.hpp"
#include "tests/gear_sets.hpp"

namespace orbearing::gearset::dynamics::gear_dynamics_forces_test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kStates = 20;
constexpr double kDisplacement =
    3e-5;                           // [m]    teeth touch, part, and touch on their backs (backlash 100 um)
constexpr double kVelocity = 0.05;  // [m/s]

struct Variant {
  const char* name;
  bool separation;
  bool run_up;
  bool back_flank;
  bool affine = false;  // bearings that are stiffer one way than the other, with an offset
  bool loaded = false;  // teeth that touch as deflection closes their gaps
};

class GearDynamicsIdentity : public testing::TestWithParam<Variant> {
 protected:
  GearDynamicsIdentity() {
    parameters.separation = GetParam().separation;
    operation.driven = GetParam().back_flank ? Member::carrier : Member::sun;
    operation = operation_of(reducer(), {operation.driven, 150e3, GetParam().back_flank ? 200.0 : 628.0});
    if (GetParam().loaded) test::load_teeth(parameters);
    if (GetParam().affine) parameters.planet.affine_bearing = affine_bearing();
    if (GetParam().run_up) operation.run_up = {.from = 0.5, .duration = 0.01};
  }

  // A symmetric stiffness, since another one has no energy.
  static AffineBearing affine_bearing() {
    AffineBearing law{.force = {300.0, -500.0}};
    law.stiffness << 1.5e8, 2e7, 2e7, 0.8e8;
    law.damping << 700.0, 50.0, -20.0, 900.0;
    return law;
  }

  VectorXd random_state() {
    const Index n = SetLayout{parameters.planets}.freedoms();
    VectorXd x(2 * n);
    x << kDisplacement * random.vector(n), kVelocity * random.vector(n);
    return x;
  }

  SetParameters parameters = test::full_set();
  Operation operation;
  test::Random random;
};

// At rest, without torque, the forces are the slope of all that is stored.
TEST_P(GearDynamicsIdentity, ForcesAreTheSlopeOfTheEnergy) {
  parameters.sun_mesh.error = PeriodicCurve::constant(3e-6);
  parameters.sun_mesh.damping = parameters.ring_mesh.damping = 0.0;
  for (CentralMember* member : {&parameters.sun, &parameters.ring, &parameters.carrier})
    member->support.damping = member->support.torsional_damping = 0.0;
  operation.run_up = {};
  const SetModel model = set_model(parameters, operation);
  const Index n = model.layout.freedoms();
  for (int k = 0; k < kStates; ++k) {
    VectorXd x = random_state();
    x.tail(n).setZero();
    const double time = 1e-3 * random();
    VectorXd force = VectorXd::Zero(n);
    add_forces(model, time, x, force);
    const Eigen::Vector3d drive = drive_forces(model, {}, 0.0);
    for (Index i = 0; i < 3; ++i) force[3 * i + 2] -= drive[i];
    for (Index i = 0; i < n; ++i) {
      const double step = 1e-9;  // [m]  a ten-thousandth of the approaches
      VectorXd left = x, right = x;
      left[i] -= step;
      right[i] += step;
      const double slope =
          (energy(model, time, right).stored() - energy(model, time, left).stored()) / (2.0 * step);
      // Energies of some joules; contacts that open within the step cost k step / 2.
      EXPECT_NEAR(force[i], -slope, 1e-3 + 1e9 * step) << "freedom " << i;
    }
  }
}

// Slopes for implicit integrators are those of the forces, with whatever flanks touch.
TEST_P(GearDynamicsIdentity, SlopesAreThoseOfTheForces) {
  const SetModel model = set_model(parameters, operation);
  const Index n = model.layout.freedoms();
  for (int k = 0; k < kStates; ++k) {
    const VectorXd x = random_state();
    const double time = 2e-3 + 1e-3 * random();
    ForceSlopes slopes;
    force_slopes(model, time, x, slopes);
    Eigen::MatrixXd exact(n, 2 * n), differences(n, 2 * n);
    exact << slopes.by_position, slopes.by_velocity;
    for (Index i = 0; i < 2 * n; ++i) {
      const double step = i < n ? 1e-11 : 1e-7;  // [m], [m/s]  few contacts open within it
      VectorXd left = x, right = x, at_left = VectorXd::Zero(n), at_right = VectorXd::Zero(n);
      left[i] -= step;
      right[i] += step;
      add_forces(model, time, left, at_left);
      add_forces(model, time, right, at_right);
      differences.col(i) = (at_right - at_left) / (2.0 * step);
    }
    // Round-off of forces of 1e5 N over the step.
    EXPECT_LT((exact - differences).leftCols(n).cwiseAbs().maxCoeff(), 100.0);  // [N/m]
    EXPECT_LT((exact - differences).rightCols(n).cwiseAbs().maxCoeff(), 1e-2);  // [N s/m]
  }
}

// Along the motion the energy changes by what enters less what is lost, in any state whatever.
TEST_P(GearDynamicsIdentity, PowerBalancesInEveryState) {
  parameters.gravity = 2e3;  // [m/s^2]  so that weight shows
  const SetModel model = set_model(parameters, operation);
  const PlanetarySetEquations equations(model);
  const Index n = model.layout.freedoms();
  for (int k = 0; k < kStates; ++k) {
    const VectorXd x = random_state();
    const double time = 2e-3 + 1e-3 * random();
    VectorXd dx(2 * n);
    equations.derivative(time, x, dx);
    const double step = 1e-10;  // [s]
    const double change = (energy(model, time + step, x + step * dx).total() -
                           energy(model, time - step, x - step * dx).total()) /
                          (2.0 * step);
    const PowerFlow flow = power_flow(model, time, x);
    const double turned_over = std::abs(flow.drive) + std::abs(flow.frame) + flow.loss() + std::abs(change);
    EXPECT_NEAR(change, flow.input() - flow.loss(), 1e-4 * turned_over);  // round-off of joules over the step
    for (const double loss : {flow.mesh_loss, flow.bearing_loss, flow.support_loss}) EXPECT_GE(loss, 0.0);
  }
}

// Turning the frame by one planet and renaming the planets changes nothing, phases going with them.
TEST_P(GearDynamicsIdentity, PlanetsCanBeRenamed) {
  const SetModel model = set_model(parameters, operation);
  SetParameters shifted = parameters;
  const Index planets = parameters.planets;
  for (Index i = 0; i < planets; ++i) {
    const auto from = static_cast<std::size_t>((i + 1) % planets), to = static_cast<std::size_t>(i);
    shifted.sun_phase[to] = parameters.sun_phase[from];
    shifted.ring_phase[to] = parameters.ring_phase[from];
    shifted.pin_error.col(i) = parameters.pin_error.col((i + 1) % planets);
  }
  const SetModel renamed = set_model(shifted, operation);
  const Eigen::Rotation2Dd back(-2.0 * M_PI / static_cast<double>(planets));
  const auto rename = [&](const VectorXd& x) {
    VectorXd out = x;
    for (Index half : {Index{0}, model.layout.freedoms()}) {
      for (Index position = 0; position < 9; position += 3)
        out.segment<2>(half + position) = back * x.segment<2>(half + position);
      for (Index i = 0; i < planets; ++i)
        out.segment<3>(half + SetLayout::planet(i)) =
            x.segment<3>(half + SetLayout::planet((i + 1) % planets));
    }
    return out;
  };
  for (int k = 0; k < kStates; ++k) {
    const VectorXd x = random_state();
    const double time = 2e-3 + 1e-3 * random();
    VectorXd dx(x.size()), dx_renamed(x.size());
    PlanetarySetEquations(model).derivative(time, x, dx);
    PlanetarySetEquations(renamed).derivative(time, rename(x), dx_renamed);
    EXPECT_LT((dx_renamed - rename(dx)).norm(), 1e-12 * dx.norm());
    EXPECT_NEAR(energy(renamed, time, rename(x)).total(), energy(model, time, x).total(), 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, GearDynamicsIdentity,
                         testing::Values(Variant{"springs", false, false, false},
                                         Variant{"teeth", true, false, false},
                                         Variant{"run_up", true, true, false},
                                         Variant{"back_flank", true, false, true},
                                         Variant{"affine_bearing", true, false, false, true},
                                         // Teeth under load.
                                         Variant{"loaded_teeth", true, false, false, false, true},
                                         Variant{"loaded_run_up", true, true, true, false, true}),
                         [](const testing::TestParamInfo<Variant>& variant) { return variant.param.name; });

// The matrices are those of the equations: stiffness, gyroscopic terms, damping, all at once.
TEST(GearDynamicsMatrices, AreTheSlopesOfTheForces) {
  SetParameters parameters = test::full_set();
  parameters.separation = false;
  Operation operation = test::reducer_operation(628.0);
  operation.power = 0.0;
  const SetModel model = averaged(set_model(parameters, operation));
  const SetMatrices matrices = set_matrices(model);
  const Index n = model.layout.freedoms();
  test::Random random;
  const VectorXd q = 1e-5 * random.vector(n), v = 1e-2 * random.vector(n);
  VectorXd x(2 * n), at_rest = VectorXd::Zero(n), moved = VectorXd::Zero(n);
  add_forces(model, 0.0, VectorXd::Zero(2 * n), at_rest);
  x << q, v;
  add_forces(model, 0.0, x, moved);
  const VectorXd linear = -(matrices.stiffness + matrices.centrifugal + matrices.circulatory) * q -
                          (matrices.gyroscopic + matrices.damping) * v;
  EXPECT_LT((moved - at_rest - linear).norm(), 1e-12 * moved.norm());
}

// With the drive's torques in equilibrium, the whole set may rotate: no force, at any carrier speed.
TEST(GearDynamicsRigidBody, TurnsFreely) {
  const SetParameters parameters = test::reducer_dynamics();
  const SetModel model = set_model(parameters, test::reducer_operation(628.0));
  const WorkingGeometry geometry = working_geometry(reducer());
  const Index n = model.layout.freedoms();
  VectorXd rigid = VectorXd::Zero(n);
  const double cos_sun = std::cos(geometry.sun_mesh.working_pressure_angle);
  const double cos_ring = std::cos(geometry.ring_mesh.working_pressure_angle);
  rigid[SetLayout::sun() + 2] = cos_sun + cos_ring;
  rigid[SetLayout::carrier() + 2] = 1.0;
  for (Index i = 0; i < 4; ++i) rigid.segment<3>(SetLayout::planet(i)) << 0.0, 1.0, -cos_ring;
  const SetMatrices matrices = set_matrices(model);
  const double scale = matrices.stiffness.norm() * rigid.norm();
  EXPECT_LT((matrices.stiffness * rigid).norm(), 1e-12 * scale);
  EXPECT_EQ((matrices.centrifugal * rigid).norm(), 0.0);
  const Eigen::Vector3d drive = drive_forces(model, {}, 0.0);
  const double work = drive[0] * rigid[2] + drive[2] * rigid[SetLayout::carrier() + 2];
  EXPECT_NEAR(work, 0.0, 1e-9 * std::abs(drive[0]));  // the root finder's error of the centre distance
}

}  // namespace
}  // namespace orbearing::gearset::dynamics::gear_dynamics_forces_test
