#include "gearset/dynamics/energy.hpp"

#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/equations.hpp"
#include "gearset/dynamics/frame_force.hpp"
#include "gearset/dynamics/mesh_force.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using State = Eigen::Ref<const Eigen::VectorXd>;

double square(double value) {
  return value * value;
}

// -1/2 m Omega^2 distance^2 from the axis, less its value in the nominal position.
double centrifugal_energy(const SetModel& model, const CarrierTurn& turn, const State& q) {
  double squares = 0.0;  // [kg m^2]
  for (Eigen::Index index = 0; index < SetLayout::planet(0); index += 3)
    squares += model.mass[index] * q.segment<2>(index).squaredNorm();
  const double radius = model.parameters.carrier.radius;
  for (Eigen::Index index = SetLayout::planet(0); index < model.layout.freedoms(); index += 3)
    squares += model.mass[index] * q[index] * (q[index] + 2.0 * radius);
  return -0.5 * turn.centrifugal * squares;
}

// Energy of the symmetric part of the stiffness; the rest stores nothing.
double bearing_energy(const SetModel& model, const State& q) {
  if (model.parameters.planet.coupled_bearing) return 0.0;
  const AffineBearing law = bearing_law(model.parameters.planet);
  double sum = 0.0;
  for (const PlanetBearing& bearing : model.bearings) {
    const Eigen::Vector2d along = bearing_deflection(bearing, q) + bearing.pin_error;
    sum += along.dot(law.force + 0.5 * (law.stiffness * along));
  }
  return sum;
}

template <typename Function>
void for_each_support(const SetModel& model, const Function& function) {
  function(SetLayout::sun(), model.parameters.sun.support);
  function(SetLayout::ring(), model.parameters.ring.support);
  function(SetLayout::carrier(), model.parameters.carrier.support);
}

void add_mesh_powers(const SetModel& model, double time, const State& q, const State& v, PowerFlow& flow) {
  const MeshClock clock = mesh_clock(model.operation, time);
  for (const PlanetMesh& mesh : model.meshes) {
    const MeshExcitation now = excitation(model.mesh(mesh.kind), mesh.phase, clock);
    const MeshForce both = mesh_force(model, mesh, now, q, v);
    for (const FlankForce& flank : {both.loaded, both.back}) {
      flow.stiffness += flank.energy_rate;
      flow.mesh_loss += flank.damping * flank.approach_rate;
    }
    flow.error -= both.loaded.total() * now.error_rate;
  }
}

void add_bearing_loss(const SetModel& model, const State& q, const State& v, PowerFlow& flow) {
  if (model.parameters.planet.coupled_bearing) return;
  const AffineBearing law = bearing_law(model.parameters.planet);
  const Eigen::Matrix2d circulatory = 0.5 * (law.stiffness - law.stiffness.transpose());
  for (const PlanetBearing& bearing : model.bearings) {
    const Eigen::Vector2d rate = bearing_deflection(bearing, v);
    flow.bearing_loss +=
        rate.dot(law.damping * rate + circulatory * (bearing_deflection(bearing, q) + bearing.pin_error));
  }
}

void add_support_powers(const SetModel& model, const CarrierTurn& turn, const State& q, const State& v,
                        PowerFlow& flow) {
  for_each_support(model, [&](Eigen::Index index, const Support& support) {
    const Eigen::Vector2d own = v.segment<2>(index);
    const Eigen::Vector2d in_housing = velocity_in_housing(turn, q.segment<2>(index), own);
    flow.support_loss +=
        support.damping * in_housing.squaredNorm() + support.torsional_damping * square(v[index + 2]);
    flow.frame += support.damping * in_housing.dot(in_housing - own);
  });
}

void add_frame_powers(const SetModel& model, const SpeedState& speed, const CarrierTurn& turn, const State& q,
                      const State& v, PowerFlow& flow) {
  if (speed.rate == 0.0) return;
  const CarrierTurn euler{.euler = turn.euler};
  Eigen::VectorXd force = Eigen::VectorXd::Zero(model.layout.freedoms());
  add_frame_forces(model, euler, q, v, force);
  add_run_up_forces(model, speed, force);
  flow.frame += force.dot(v);
  // The centrifugal potential is Omega^2 times a function of the positions.
  const double rate_of_share = 2.0 * speed.rate / speed.factor;
  flow.frame += rate_of_share * centrifugal_energy(model, turn, q);
}

}  // namespace

Energy energy(const SetModel& model, double time, const State& x) {
  const Eigen::Index n = model.layout.freedoms();
  const auto q = x.head(n);
  const auto v = x.tail(n);
  Energy result;
  result.kinetic = 0.5 * (model.mass.array() * v.array().square()).sum();
  const MeshClock clock = mesh_clock(model.operation, time);
  for (const PlanetMesh& mesh : model.meshes) {
    const MeshExcitation now = excitation(model.mesh(mesh.kind), mesh.phase, clock);
    const MeshForce both = mesh_force(model, mesh, now, q, v);
    for (const FlankForce& flank : {both.loaded, both.back}) result.meshes += flank.energy;
  }
  result.bearings = bearing_energy(model, q);
  for_each_support(model, [&](Eigen::Index index, const Support& support) {
    result.supports += 0.5 * support.stiffness * q.segment<2>(index).squaredNorm() +
                       0.5 * support.torsional_stiffness * square(q[index + 2]);
  });
  const SpeedState speed = speed_at(model.operation, time);
  result.centrifugal = centrifugal_energy(model, carrier_turn(model, speed), q);
  return result;
}

PowerFlow power_flow(const SetModel& model, double time, const State& x) {
  const Eigen::Index n = model.layout.freedoms();
  const auto q = x.head(n);
  const auto v = x.tail(n);
  const SpeedState speed = speed_at(model.operation, time);
  const CarrierTurn turn = carrier_turn(model, speed);
  PowerFlow flow;
  const Eigen::Vector3d torque =
      drive_forces(model, speed, v[SetLayout::central(model.operation.driven) + 2]);
  for (Eigen::Index i = 0; i < 3; ++i) flow.drive += torque[i] * v[3 * i + 2];
  add_mesh_powers(model, time, q, v, flow);
  add_bearing_loss(model, q, v, flow);
  add_support_powers(model, turn, q, v, flow);
  add_frame_powers(model, speed, turn, q, v, flow);
  if (model.parameters.gravity != 0.0) {
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(n);
    add_weights(model, time, weight);
    flow.frame += weight.dot(v);
  }
  return flow;
}

}  // namespace orbearing::gearset::dynamics
