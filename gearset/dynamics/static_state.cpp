#include "gearset/dynamics/static_state.hpp"

#include <Eigen/QR>
#include <stdexcept>

#include "gearset/dynamics/equations.hpp"
#include "gearset/dynamics/matrices.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct FlankPlace {
  const PlanetMesh& mesh;
  const DeflectionVector& along;
  double stiffness;  // [N/m]
  double offset;     // [m]  half the backlash and the mean error: what the deflection needs before it carries
};

FlankPlace flank_place(const SetModel& model, const PlanetMesh& mesh, bool loaded) {
  const Mesh& law = model.mesh(mesh.kind);
  const double gap = model.parameters.separation ? 0.5 * law.backlash : 0.0;
  return {mesh, loaded ? mesh.loaded : mesh.back, law.stiffness.mean(),
          gap + (loaded ? law.error.mean() : 0.0)};
}

ContactState contact_at(const SetModel& model, const VectorXd& q) {
  ContactState contact;
  const auto touches = [&](const FlankPlace& flank) {
    return flank.along.of(q, flank.mesh.central, flank.mesh.place) > flank.offset;
  };
  const bool separation = model.parameters.separation;
  for (const PlanetMesh& mesh : model.meshes) {
    contact.loaded.push_back(!separation || touches(flank_place(model, mesh, true)));
    contact.back.push_back(separation && touches(flank_place(model, mesh, false)));
  }
  return contact;
}

// Loads on the set in its nominal place, with the given flanks in contact.
VectorXd loads_with(const SetModel& model, const ContactState& contact) {
  SetModel toothless = model;
  toothless.meshes.clear();
  VectorXd force = VectorXd::Zero(model.layout.freedoms());
  add_forces(toothless, model.operation.run_up.duration, VectorXd::Zero(model.layout.size()), force);
  const auto add = [&](const FlankPlace& flank) {
    const double preload = flank.stiffness * flank.offset;
    force.segment<3>(flank.mesh.central) += preload * flank.along.central;
    force.segment<3>(flank.mesh.place) += preload * flank.along.planet;
  };
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    if (contact.loaded[i]) add(flank_place(model, model.meshes[i], true));
    if (contact.back[i]) add(flank_place(model, model.meshes[i], false));
  }
  return force;
}

// The shortest solution, since rotations as a rigid body have no stiffness. Held freedoms are left out.
VectorXd solve(const SetModel& model, Eigen::MatrixXd stiffness, VectorXd force) {
  for (Index i = 0; i < force.size(); ++i) {
    if (model.mobility[i] > 0.0) continue;
    stiffness.row(i).setZero();
    stiffness.col(i).setZero();
    force[i] = 0.0;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
  factors.setThreshold(1e-10);  // between the rigid body's round-off and the softest support
  factors.compute(stiffness);
  return factors.solve(force);
}

}  // namespace

VectorXd static_state(const SetModel& model) {
  constexpr int most_steps = 60;
  const Eigen::MatrixXd centrifugal = set_matrices(model).centrifugal;
  ContactState contact{std::vector<bool>(model.meshes.size(), true),
                       std::vector<bool>(model.meshes.size(), false)};
  for (int step = 0; step < most_steps; ++step) {
    const VectorXd q = solve(model, stiffness_with(model, contact) + centrifugal, loads_with(model, contact));
    const ContactState found = contact_at(model, q);
    if (found == contact) {
      VectorXd x = VectorXd::Zero(model.layout.size());
      x.head(q.size()) = q;
      return x;
    }
    contact = found;
  }
  throw std::runtime_error(
      "no static equilibrium of the gear set was found; its supports or its teeth do not hold it under load");
}

}  // namespace orbearing::gearset::dynamics
