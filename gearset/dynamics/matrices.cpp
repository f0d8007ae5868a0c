#include "gearset/dynamics/matrices.hpp"

#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/frame_force.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd whole(const SetModel& model, const DeflectionVector& along, Index central, Index planet) {
  VectorXd vector = VectorXd::Zero(model.layout.freedoms());
  vector.segment<3>(central) = along.central;
  vector.segment<3>(planet) = along.planet;
  return vector;
}

void add_spring(const VectorXd& along, double stiffness, MatrixXd& matrix) {
  matrix += stiffness * along * along.transpose();
}

void add_bearings(const SetModel& model, const Eigen::Matrix2d& stiffness, MatrixXd& matrix) {
  if (model.parameters.planet.coupled_bearing) return;
  for (const PlanetBearing& bearing : model.bearings) {
    MatrixXd along(model.layout.freedoms(), 2);
    along << whole(model, bearing.radial, SetLayout::carrier(), bearing.planet_index),
        whole(model, bearing.tangential, SetLayout::carrier(), bearing.planet_index);
    matrix += along * stiffness * along.transpose();
  }
}

// Meshes and bearings of each planet whose rim links them, all teeth in contact.
void add_linked_planets(const SetModel& model, const Eigen::Matrix4d& stiffness, MatrixXd& matrix) {
  for (const PlanetBearing& bearing : model.bearings) {
    MatrixXd along(model.layout.freedoms(), 4);
    for (const PlanetMesh& mesh : model.meshes)
      if (mesh.planet_index == bearing.planet_index)
        along.col(mesh.kind == MeshKind::sun ? 0 : 1) =
            whole(model, mesh.loaded, mesh.central, mesh.planet_index);
    along.col(2) = whole(model, bearing.radial, SetLayout::carrier(), bearing.planet_index);
    along.col(3) = whole(model, bearing.tangential, SetLayout::carrier(), bearing.planet_index);
    matrix += along * stiffness * along.transpose();
  }
}

void add_support(Index index, double planar, double torsional, MatrixXd& matrix) {
  matrix.diagonal().segment<3>(index) += Eigen::Vector3d(planar, planar, torsional);
}

void add_support_stiffness(const SetModel& model, MatrixXd& matrix) {
  const SetParameters& set = model.parameters;
  const auto add = [&](Index index, const Support& support) {
    add_support(index, support.stiffness, support.torsional_stiffness, matrix);
  };
  add(SetLayout::sun(), set.sun.support);
  add(SetLayout::ring(), set.ring.support);
  add(SetLayout::carrier(), set.carrier.support);
}

// Without speed, all teeth in contact.
MatrixXd mean_stiffness(const SetModel& model) {
  const std::size_t meshes = model.meshes.size();
  const auto& linked = model.parameters.planet.linked;
  if (!linked)
    return stiffness_with(model, {std::vector<bool>(meshes, true), std::vector<bool>(meshes, false)});
  MatrixXd stiffness = MatrixXd::Zero(model.layout.freedoms(), model.layout.freedoms());
  add_linked_planets(model, linked->stiffness, stiffness);
  add_support_stiffness(model, stiffness);
  return stiffness;
}

MatrixXd damping_matrix(const SetModel& model) {
  const SetParameters& set = model.parameters;
  MatrixXd damping = MatrixXd::Zero(model.layout.freedoms(), model.layout.freedoms());
  for (const PlanetMesh& mesh : model.meshes)
    add_spring(whole(model, mesh.loaded, mesh.central, mesh.planet_index), model.mesh(mesh.kind).damping,
               damping);
  add_bearings(model, bearing_law(set.planet).damping, damping);
  const auto add = [&](Index index, const Support& support) {
    add_support(index, support.damping, support.torsional_damping, damping);
  };
  add(SetLayout::sun(), set.sun.support);
  add(SetLayout::ring(), set.ring.support);
  add(SetLayout::carrier(), set.carrier.support);
  return damping;
}

// Force = -matrix * (positions or velocities): +c on (x, y) of each body against -c on (y, x).
void add_turn(Index index, double value, MatrixXd& matrix) {
  matrix(index, index + 1) -= value;
  matrix(index + 1, index) += value;
}

}  // namespace

MatrixXd stiffness_with(const SetModel& model, const ContactState& contact) {
  MatrixXd stiffness = MatrixXd::Zero(model.layout.freedoms(), model.layout.freedoms());
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    const PlanetMesh& mesh = model.meshes[i];
    const double mean = model.mesh(mesh.kind).stiffness.mean();
    if (contact.loaded[i])
      add_spring(whole(model, mesh.loaded, mesh.central, mesh.planet_index), mean, stiffness);
    if (contact.back[i])
      add_spring(whole(model, mesh.back, mesh.central, mesh.planet_index), mean, stiffness);
  }
  add_bearings(model, bearing_law(model.parameters.planet).stiffness, stiffness);
  add_support_stiffness(model, stiffness);
  return stiffness;
}

MatrixXd centrifugal_stiffness(const SetModel& model) {
  const Index n = model.layout.freedoms();
  const double centrifugal = carrier_turn(model, {}).centrifugal;
  MatrixXd stiffness = MatrixXd::Zero(n, n);
  for (Index index = 0; index < n; index += 3) {
    stiffness(index, index) -= model.mass[index] * centrifugal;
    if (index < SetLayout::planet(0)) stiffness(index + 1, index + 1) -= model.mass[index] * centrifugal;
  }
  return stiffness;
}

SetMatrices set_matrices(const SetModel& model) {
  const Index n = model.layout.freedoms();
  SetMatrices matrices{.mass = model.mass,
                       .stiffness = mean_stiffness(model),
                       .centrifugal = centrifugal_stiffness(model),
                       .gyroscopic = MatrixXd::Zero(n, n),
                       .damping = damping_matrix(model),
                       .circulatory = MatrixXd::Zero(n, n)};
  const CarrierTurn turn = carrier_turn(model, {});
  for (Index index = 0; index < n; index += 3)
    add_turn(index, 2.0 * model.mass[index] * turn.coriolis, matrices.gyroscopic);
  add_turn(SetLayout::sun(), model.parameters.sun.support.damping * turn.speed, matrices.circulatory);
  add_turn(SetLayout::ring(), model.parameters.ring.support.damping * turn.speed, matrices.circulatory);
  add_turn(SetLayout::carrier(), model.parameters.carrier.support.damping * turn.speed, matrices.circulatory);
  return matrices;
}

}  // namespace orbearing::gearset::dynamics
