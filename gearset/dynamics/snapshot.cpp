#include "gearset/dynamics/snapshot.hpp"

#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/frame_force.hpp"
#include "gearset/dynamics/mesh_force.hpp"

namespace orbearing::gearset::dynamics {

namespace {

void put_mesh_forces(const SetModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                     SetSnapshot& out) {
  const Eigen::Index n = model.layout.freedoms();
  const MeshClock clock = mesh_clock(model.operation, time);
  out.separated = false;
  for (const PlanetMesh& mesh : model.meshes) {
    const MeshExcitation now = excitation(model.mesh(mesh.kind), mesh.phase, clock);
    const MeshForce both = mesh_force(model, mesh, now, x.head(n), x.tail(n));
    (mesh.kind == MeshKind::sun ? out.sun_mesh_force : out.ring_mesh_force)[mesh.planet] =
        both.loaded.total() - both.back.total();
    out.separated = out.separated || both.loaded.elastic <= 0.0;
  }
}

void put_bearing_forces(const SetModel& model, const Eigen::Ref<const Eigen::VectorXd>& x, SetSnapshot& out) {
  const Eigen::Index n = model.layout.freedoms();
  for (Eigen::Index i = 0; i < model.layout.planets; ++i)
    out.bearing_force.col(i) =
        bearing_force(model.parameters.planet, model.bearings[static_cast<std::size_t>(i)], x.head(n),
                      x.tail(n))
            .array();
}

}  // namespace

void take_snapshot(const PlanetarySetEquations& equations, double time,
                   const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::VectorXd& dx, SetSnapshot& out) {
  const SetModel& model = equations.model();
  const Eigen::Index planets = model.layout.planets;
  out.sun_mesh_force.resize(planets);
  out.ring_mesh_force.resize(planets);
  out.bearing_force.resize(2, planets);
  out.acceleration.resize(2, planets);
  out.in_housing.resize(2, planets);
  dx.resize(x.size());
  equations.derivative(time, x, dx);
  put_mesh_forces(model, time, x, out);
  put_bearing_forces(model, x, out);
  const Eigen::Index n = model.layout.freedoms();
  const CarrierTurn turn = carrier_turn(model, speed_at(model.operation, time));
  for (Eigen::Index i = 0; i < planets; ++i) {
    const Eigen::Index index = SetLayout::planet(i);
    out.acceleration.col(i) = dx.segment<2>(n + index).array();
    const Eigen::Vector2d frame =
        planet_frame_acceleration(turn, model.parameters.carrier.radius, x[index], x.segment<2>(n + index));
    out.in_housing.col(i) = out.acceleration.col(i) - frame.array();
  }
}

}  // namespace orbearing::gearset::dynamics
