#include "gearset/dynamics/equations.hpp"

#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/frame_force.hpp"
#include "gearset/dynamics/mesh_force.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using Positions = Eigen::Ref<const Eigen::VectorXd>;
using Forces = Eigen::Ref<Eigen::VectorXd>;

void add_meshes(const SetModel& model, double time, const Positions& q, const Positions& v, Forces force) {
  const MeshClock clock = mesh_clock(model.operation, time);
  for (const PlanetMesh& mesh : model.meshes) {
    const MeshExcitation now = excitation(model.mesh(mesh.kind), mesh.phase, clock);
    const MeshForce both = mesh_force(model, mesh, now, q, v);
    const double loaded = both.loaded.total(), back = both.back.total();
    force.segment<3>(mesh.central) -= loaded * mesh.loaded.central + back * mesh.back.central;
    force.segment<3>(mesh.planet_index) -= loaded * mesh.loaded.planet + back * mesh.back.planet;
  }
}

// A force on the planet outward is a pull on the pin inward: the deflection vectors hold both signs.
void add_bearing(const PlanetBearing& bearing, const Eigen::Vector2d& on_planet, Forces force) {
  force.segment<3>(SetLayout::carrier()) -=
      on_planet.x() * bearing.radial.central + on_planet.y() * bearing.tangential.central;
  force.segment<3>(bearing.planet_index) -=
      on_planet.x() * bearing.radial.planet + on_planet.y() * bearing.tangential.planet;
}

void add_moment(const PlanetBearing& bearing, double on_planet, Forces force) {
  force.segment<3>(SetLayout::carrier()) += on_planet * bearing.rotation.central;
  force.segment<3>(bearing.planet_index) += on_planet * bearing.rotation.planet;
}

void add_planet_bearings(const SetModel& model, const Positions& q, const Positions& v, Forces force) {
  const PlanetMember& planet = model.parameters.planet;
  if (planet.coupled_bearing) return;
  for (const PlanetBearing& bearing : model.bearings)
    add_bearing(bearing, bearing_force(planet, bearing, q, v), force);
}

void add_supports(const SetModel& model, const CarrierTurn& turn, const Positions& q, const Positions& v,
                  Forces force) {
  const auto add = [&](Eigen::Index index, const Support& support) {
    // The housing's damper acts on the velocity in the housing, not on that in the carrier's frame.
    const Eigen::Vector2d velocity = velocity_in_housing(turn, q.segment<2>(index), v.segment<2>(index));
    force.segment<2>(index) -= support.stiffness * q.segment<2>(index) + support.damping * velocity;
    force[index + 2] -= support.torsional_stiffness * q[index + 2] + support.torsional_damping * v[index + 2];
  };
  add(SetLayout::sun(), model.parameters.sun.support);
  add(SetLayout::ring(), model.parameters.ring.support);
  add(SetLayout::carrier(), model.parameters.carrier.support);
}

void add_drive(const SetModel& model, const SpeedState& speed, const Positions& v, Forces force) {
  const Eigen::Vector3d along = drive_forces(model, speed, v[SetLayout::central(model.operation.driven) + 2]);
  force[SetLayout::sun() + 2] += along[0];
  force[SetLayout::ring() + 2] += along[1];
  force[SetLayout::carrier() + 2] += along[2];
}

}  // namespace

Eigen::Vector3d drive_forces(const SetModel& model, const SpeedState& speed_state, double speed) {
  const SetParameters& set = model.parameters;
  const Operation& operation = model.operation;
  const Eigen::Vector3d torque(operation.torques.sun, operation.torques.ring, operation.torques.carrier);
  const Eigen::Vector3d nominal(operation.speeds.sun, operation.speeds.ring, operation.speeds.carrier);
  const Eigen::Vector3d radius(set.sun.radius, set.ring.radius, set.carrier.radius);
  const Eigen::Index driven = SetLayout::central(operation.driven) / 3;
  Eigen::Vector3d force = (torque.array() / (speed_state.factor * radius.array())).matrix();
  if (operation.power > 0.0) {
    const double true_speed = nominal[driven] * speed_state.factor + speed / radius[driven];
    force[driven] = operation.power / true_speed / radius[driven];
  }
  if (speed_state.rate != 0.0)
    force[driven] +=
        run_up_power(model, speed_state) / (nominal[driven] * speed_state.factor * radius[driven]);
  return force;
}

void add_forces(const SetModel& model, double time, const Positions& x, Forces force) {
  const Eigen::Index n = model.layout.freedoms();
  const auto q = x.head(n);
  const auto v = x.tail(n);
  const SpeedState speed = speed_at(model.operation, time);
  const CarrierTurn turn = carrier_turn(model, speed);
  add_meshes(model, time, q, v, force);
  add_planet_bearings(model, q, v, force);
  add_supports(model, turn, q, v, force);
  add_drive(model, speed, v, force);
  add_frame_forces(model, turn, q, v, force);
  if (model.parameters.gravity != 0.0) add_weights(model, time, force);
  if (speed.rate != 0.0) add_run_up_forces(model, speed, force);
}

void add_port_loads(const SetModel& model, const PortLoads& loads, Forces force) {
  for (Eigen::Index i = 0; i < model.layout.planets; ++i) {
    const PlanetBearing& bearing = model.bearings[static_cast<std::size_t>(i)];
    add_bearing(bearing, loads.force.col(i), force);
    add_moment(bearing, loads.moment[i], force);
  }
  if (model.load_index >= 0) force[model.load_index] += model.load_share * loads.moment.sum();
}

void PlanetarySetEquations::derivative(double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                                       Eigen::Ref<Eigen::VectorXd> dx) const {
  const Eigen::Index n = model_.layout.freedoms();
  dx.head(n) = x.tail(n);
  auto force = dx.tail(n);
  force.setZero();
  add_forces(model_, time, x, force);
  force.array() *= model_.mobility.array();
}

void PlanetarySetEquations::derivative(double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                                       const PortLoads& loads, Eigen::Ref<Eigen::VectorXd> dx) const {
  const Eigen::Index n = model_.layout.freedoms();
  dx.head(n) = x.tail(n);
  auto force = dx.tail(n);
  force.setZero();
  add_forces(model_, time, x, force);
  add_port_loads(model_, loads, force);
  force.array() *= model_.mobility.array();
}

void PlanetarySetEquations::motion_at_ports(const Eigen::Ref<const Eigen::VectorXd>& x,
                                            BearingPorts& ports) const {
  const Eigen::Index n = model_.layout.freedoms();
  const auto q = x.head(n);
  const auto v = x.tail(n);
  ports.displacement.resize(2, model_.layout.planets);
  ports.velocity.resize(2, model_.layout.planets);
  ports.angle.resize(model_.layout.planets);
  ports.speed.resize(model_.layout.planets);
  for (Eigen::Index i = 0; i < model_.layout.planets; ++i) {
    const PlanetBearing& bearing = model_.bearings[static_cast<std::size_t>(i)];
    const auto along = [&](const DeflectionVector& vector, const auto& motion) {
      return -vector.of(motion, SetLayout::carrier(), bearing.planet_index);
    };
    ports.displacement.col(i) << along(bearing.radial, q) - bearing.pin_error.x(),
        along(bearing.tangential, q) - bearing.pin_error.y();
    ports.velocity.col(i) << along(bearing.radial, v), along(bearing.tangential, v);
    ports.angle[i] = bearing.rotation.of(q, SetLayout::carrier(), bearing.planet_index);
    ports.speed[i] = bearing.rotation.of(v, SetLayout::carrier(), bearing.planet_index);
  }
}

}  // namespace orbearing::gearset::dynamics
