#include "gearset/dynamics/static_state.hpp"

#include <stdexcept>
#include <utility>

#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/equations.hpp"
#include "gearset/dynamics/matrices.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using Eigen::Index;
using Eigen::Matrix2Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct FlankPosition {
  const PlanetMesh& mesh;
  const DeflectionVector& along;
  double stiffness;  // [N/m]
  double offset;     // [m]  half the backlash, the mean error and gaps of loaded teeth: what the deflection
                     // needs before it carries
};

FlankPosition flank_position(const SetModel& model, const PlanetMesh& mesh, bool loaded) {
  const Mesh& law = model.mesh(mesh.kind);
  const double gap = model.parameters.separation ? 0.5 * law.backlash : 0.0;
  return {mesh, loaded ? mesh.loaded : mesh.back, law.stiffness.mean(),
          gap + law.free_approach + (loaded ? law.error.mean() : 0.0)};
}

ContactState contact_at(const SetModel& model, const VectorXd& q) {
  ContactState contact;
  const auto touches = [&](const FlankPosition& flank) {
    return flank.along.of(q, flank.mesh.central, flank.mesh.planet_index) > flank.offset;
  };
  const bool separation = model.parameters.separation;
  for (const PlanetMesh& mesh : model.meshes) {
    contact.loaded.push_back(!separation || touches(flank_position(model, mesh, true)));
    contact.back.push_back(separation && touches(flank_position(model, mesh, false)));
  }
  return contact;
}

// Loads on the set in its nominal position, with the given flanks in contact.
VectorXd loads_with(const SetModel& model, const ContactState& contact) {
  SetModel toothless = model;
  toothless.meshes.clear();
  VectorXd force = VectorXd::Zero(model.layout.freedoms());
  add_forces(toothless, model.operation.run_up.duration, VectorXd::Zero(model.layout.size()), force);
  const auto add = [&](const FlankPosition& flank) {
    const double preload = flank.stiffness * flank.offset;
    force.segment<3>(flank.mesh.central) += preload * flank.along.central;
    force.segment<3>(flank.mesh.planet_index) += preload * flank.along.planet;
  };
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    if (contact.loaded[i]) add(flank_position(model, model.meshes[i], true));
    if (contact.back[i]) add(flank_position(model, model.meshes[i], false));
  }
  return force;
}

// The shortest solution, since rotations as a rigid body have no stiffness. Held freedoms are left out.
// One column for each load.
MatrixXd solve(const SetModel& model, MatrixXd stiffness, MatrixXd force) {
  for (Index i = 0; i < force.rows(); ++i) {
    if (model.mobility[i] > 0.0) continue;
    stiffness.row(i).setZero();
    stiffness.col(i).setZero();
    force.row(i).setZero();
  }
  constexpr double kRigid = 1e-10;  // between the rigid body's round-off and the softest support
  return mechanics::least_squares(stiffness, force, kRigid);
}

// Unbalanced forces, where the teeth that touch are those that touch at `q`. Held freedoms have none.
VectorXd imbalance(const SetModel& model, const MatrixXd& centrifugal, const VectorXd& q) {
  const ContactState contact = contact_at(model, q);
  const VectorXd force = loads_with(model, contact) - (stiffness_with(model, contact) + centrifugal) * q;
  return (model.mobility.array() > 0.0).select(force, 0.0);
}

// The share of a step at which the force along it vanishes, at most all of it: the energy of teeth that only
// push is convex, so the force falls on the way.
double share_of_step(const SetModel& model, const MatrixXd& centrifugal, const VectorXd& from,
                     const VectorXd& step) {
  const auto force = [&](double share) {
    return imbalance(model, centrifugal, from + share * step).dot(step);
  };
  constexpr double kRoundOff = 1e-12;  // of the loads' work, which is all that is left at the equilibrium
  const double work = loads_with(model, contact_at(model, from)).cwiseAbs().dot(step.cwiseAbs());
  if (force(1.0) >= -kRoundOff * work) return 1.0;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (force(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Positions at rest, and the flanks in contact there.
struct Rest {
  VectorXd positions;
  ContactState contact;
};

// Newton's method from the state with all loaded flanks in contact. Steps from one state to the next leave
// alone what has no stiffness there, such as the rotation of a planet whose teeth have parted.
Rest found_rest(const SetModel& model, const MatrixXd& centrifugal) {
  constexpr int most_steps = 100;
  ContactState contact{std::vector<bool>(model.meshes.size(), true),
                       std::vector<bool>(model.meshes.size(), false)};
  VectorXd q = solve(model, stiffness_with(model, contact) + centrifugal, loads_with(model, contact));
  double share = 1.0;
  for (int step = 0; step < most_steps; ++step) {
    const ContactState found = contact_at(model, q);
    if (found == contact && share == 1.0) return {std::move(q), std::move(contact)};
    contact = found;
    const VectorXd move =
        solve(model, stiffness_with(model, contact) + centrifugal, imbalance(model, centrifugal, q));
    share = share_of_step(model, centrifugal, q, move);
    q += share * move;
  }
  throw std::runtime_error(
      "no static equilibrium of the gear set was found; its supports or its teeth do not hold it under load");
}

VectorXd at_rest(const SetModel& model, const VectorXd& positions) {
  VectorXd x = VectorXd::Zero(model.layout.size());
  x.head(positions.size()) = positions;
  return x;
}

// Loads by displacements of the pins: minus the slope of the energy of each bearing's springs.
MatrixXd loads_of_pins(const SetModel& model) {
  const Eigen::Matrix2d stiffness = bearing_law(model.parameters.planet).stiffness;
  MatrixXd loads = MatrixXd::Zero(model.layout.freedoms(), 2 * static_cast<Index>(model.bearings.size()));
  Index column = 0;
  for (const PlanetBearing& bearing : model.bearings) {
    const auto along = [&](Index index, const Eigen::Vector3d& radial, const Eigen::Vector3d& tangential) {
      loads.block<3, 1>(index, column) = -(radial * stiffness(0, 0) + tangential * stiffness(1, 0));
      loads.block<3, 1>(index, column + 1) = -(radial * stiffness(0, 1) + tangential * stiffness(1, 1));
    };
    const Index carrier = SetLayout::carrier();
    along(carrier, bearing.radial.central, bearing.tangential.central);
    along(bearing.planet_index, bearing.radial.planet, bearing.tangential.planet);
    column += 2;
  }
  return loads;
}

}  // namespace

VectorXd static_state(const SetModel& model) {
  return at_rest(model, found_rest(model, centrifugal_stiffness(model)).positions);
}

StaticSet::StaticSet(SetModel model) : model_(std::move(model)), centrifugal_(centrifugal_stiffness(model_)) {
  rest(Matrix2Xd::Zero(2, static_cast<Index>(model_.bearings.size())));
}

void StaticSet::rest(const Matrix2Xd& offset) {
  SetModel displaced = model_;
  for (Index i = 0; i < offset.cols(); ++i)
    displaced.bearings[static_cast<std::size_t>(i)].pin_error += offset.col(i);
  Rest found = found_rest(displaced, centrifugal_);
  by_offset_ = solve(model_, stiffness_with(model_, found.contact) + centrifugal_, loads_of_pins(model_));
  const VectorXd still = VectorXd::Zero(model_.layout.size());
  const Matrix2Xd none = Matrix2Xd::Zero(2, offset.cols()), unmoved = bearing_forces(still, none);
  forces_by_offset_.resize(by_offset_.cols(), by_offset_.cols());
  for (Index i = 0; i < by_offset_.cols(); ++i) {
    Matrix2Xd unit = none;
    unit.reshaped()[i] = 1.0;
    forces_by_offset_.col(i) =
        (bearing_forces(at_rest(model_, by_offset_.col(i)), unit) - unmoved).reshaped();
  }
  contact_ = std::move(found.contact);
  positions_ = std::move(found.positions);
  offset_ = offset;
}

VectorXd StaticSet::at(const Matrix2Xd& offset) {
  const VectorXd followed = positions_ + by_offset_ * (offset - offset_).reshaped();
  if (contact_at(model_, followed) == contact_) return at_rest(model_, followed);
  rest(offset);
  return at_rest(model_, positions_);
}

Matrix2Xd StaticSet::bearing_forces(const VectorXd& state, const Matrix2Xd& offset) const {
  const VectorXd q = state.head(model_.layout.freedoms()), still = VectorXd::Zero(q.size());
  const Eigen::Matrix2d stiffness = bearing_law(model_.parameters.planet).stiffness;
  Matrix2Xd forces(2, offset.cols());
  for (Index i = 0; i < forces.cols(); ++i)
    forces.col(i) =
        bearing_force(model_.parameters.planet, model_.bearings[static_cast<std::size_t>(i)], q, still) +
        stiffness * offset.col(i);
  return forces;
}

}  // namespace orbearing::gearset::dynamics
