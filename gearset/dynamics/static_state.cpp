#include "gearset/dynamics/static_state.hpp"

#include <Eigen/QR>
#include <stdexcept>

#include "gearset/dynamics/equations.hpp"
#include "gearset/dynamics/matrices.hpp"
#include "gearset/dynamics/mesh_force.hpp"

namespace orbearing::gearset::dynamics {

namespace {

ContactState contact_state(const SetModel& model, const Eigen::VectorXd& x) {
  const Eigen::Index n = model.layout.freedoms();
  ContactState contact;
  for (const PlanetMesh& mesh : model.meshes) {
    const MeshExcitation now = excitation(model.mesh(mesh.kind), mesh.phase, {});
    const MeshForce force = mesh_force(model, mesh, now, x.head(n), x.tail(n));
    contact.loaded.push_back(!model.parameters.separation || force.loaded.approach > 0.0);
    contact.back.push_back(model.parameters.separation && force.back.approach > 0.0);
  }
  return contact;
}

// The shortest step, since rotations as a rigid body have no stiffness. Held freedoms are left out.
Eigen::VectorXd newton_step(const SetModel& model, const ContactState& contact,
                            const Eigen::VectorXd& centrifugal_diagonal, const Eigen::VectorXd& force) {
  Eigen::MatrixXd stiffness = stiffness_with(model, contact);
  stiffness.diagonal() += centrifugal_diagonal;
  Eigen::VectorXd free_force = force;
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    if (model.mobility[i] > 0.0) continue;
    stiffness.row(i).setZero();
    stiffness.col(i).setZero();
    free_force[i] = 0.0;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
  factors.setThreshold(1e-10);  // between the rigid body's round-off and the softest support
  factors.compute(stiffness);
  return factors.solve(free_force);
}

}  // namespace

Eigen::VectorXd static_state(const SetModel& model) {
  constexpr int most_steps = 60;
  const SetModel mean = averaged(model);
  const Eigen::Index n = mean.layout.freedoms();
  const double late = mean.operation.run_up.duration;
  const Eigen::VectorXd centrifugal = set_matrices(mean).centrifugal.diagonal();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(mean.layout.size());
  ContactState contact{std::vector<bool>(mean.meshes.size(), true),
                       std::vector<bool>(mean.meshes.size(), false)};
  for (int step = 0; step < most_steps; ++step) {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
    add_forces(mean, late, x, force);
    const Eigen::VectorXd move = newton_step(mean, contact, centrifugal, force);
    x.head(n) += move;
    contact = contact_state(mean, x);
    if (move.norm() <= 1e-12 * x.head(n).norm()) return x;
  }
  throw std::runtime_error(
      "no static equilibrium of the gear set was found; its supports or its teeth do not hold it under load");
}

}  // namespace orbearing::gearset::dynamics
