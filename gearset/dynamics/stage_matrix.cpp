#include "gearset/dynamics/stage_matrix.hpp"

#include <Eigen/LU>
#include <cmath>

#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/frame_force.hpp"
#include "gearset/dynamics/mesh_force.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

// A spring or damper of the given stiffness: a force along `pushed` that opposes the deflection `resisted`.
void add_spring(const DeflectionVector& pushed, const DeflectionVector& resisted, Index central, Index planet,
                double stiffness, MatrixXd& slopes) {
  const Vector3d on_central = stiffness * pushed.central, on_planet = stiffness * pushed.planet;
  slopes.block<3, 3>(central, central) -= on_central * resisted.central.transpose();
  slopes.block<3, 3>(central, planet) -= on_central * resisted.planet.transpose();
  slopes.block<3, 3>(planet, central) -= on_planet * resisted.central.transpose();
  slopes.block<3, 3>(planet, planet) -= on_planet * resisted.planet.transpose();
}

// Slopes of flank_force() by approach and approach rate.
struct FlankSlopes {
  double stiffness = 0.0;  // [N/m]
  double damping = 0.0;    // [N s/m]
};

FlankSlopes flank_slopes(const Mesh& mesh, bool separation, const FlankForce& force) {
  const bool parted = separation && force.total() <= 0.0;
  return parted ? FlankSlopes{} : FlankSlopes{force.stiffness, mesh.damping};
}

void add_flank(const PlanetMesh& mesh, const DeflectionVector& along, const FlankSlopes& flank,
               ForceSlopes& slopes) {
  if (flank.stiffness == 0.0 && flank.damping == 0.0) return;
  add_spring(along, along, mesh.central, mesh.planet_index, flank.stiffness, slopes.by_position);
  add_spring(along, along, mesh.central, mesh.planet_index, flank.damping, slopes.by_velocity);
}

void add_meshes(const SetModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& q,
                const Eigen::Ref<const Eigen::VectorXd>& v, ForceSlopes& slopes) {
  const MeshClock clock = mesh_clock(model.operation, time);
  const bool separation = model.parameters.separation;
  for (const PlanetMesh& mesh : model.meshes) {
    const Mesh& law = model.mesh(mesh.kind);
    const MeshExcitation now = excitation(law, mesh.phase, clock);
    const MeshForce both = mesh_force(model, mesh, now, q, v);
    add_flank(mesh, mesh.loaded, flank_slopes(law, separation, both.loaded), slopes);
    if (separation) add_flank(mesh, mesh.back, flank_slopes(law, separation, both.back), slopes);
  }
}

void add_planet_bearings(const SetModel& model, ForceSlopes& slopes) {
  if (model.parameters.planet.coupled_bearing) return;
  const AffineBearing law = bearing_law(model.parameters.planet);
  for (const PlanetBearing& bearing : model.bearings) {
    const DeflectionVector* along[] = {&bearing.radial, &bearing.tangential};
    for (Index i = 0; i < 2; ++i)
      for (Index j = 0; j < 2; ++j) {
        const auto add = [&](double stiffness, MatrixXd& by) {
          add_spring(*along[i], *along[j], SetLayout::carrier(), bearing.planet_index, stiffness, by);
        };
        add(law.stiffness(i, j), slopes.by_position);
        add(law.damping(i, j), slopes.by_velocity);
      }
  }
}

// The force is `value` times the component y on x, and its opposite times x on y.
void add_turn_slope(Index index, double value, MatrixXd& slopes) {
  slopes(index, index + 1) += value;
  slopes(index + 1, index) -= value;
}

void add_support(const Support& support, const CarrierTurn& turn, Index index, ForceSlopes& slopes) {
  slopes.by_position.diagonal().segment<3>(index) -=
      Vector3d(support.stiffness, support.stiffness, support.torsional_stiffness);
  slopes.by_velocity.diagonal().segment<3>(index) -=
      Vector3d(support.damping, support.damping, support.torsional_damping);
  add_turn_slope(index, support.damping * turn.speed, slopes.by_position);
}

// Eqs. (8) and (9) of gearset/dynamics/README.md.
void add_frame(const SetModel& model, const CarrierTurn& turn, ForceSlopes& slopes) {
  for (Index index = 0; index < model.layout.freedoms(); index += 3) {
    const double mass = model.mass[index];
    const bool central = index < SetLayout::planet(0);
    slopes.by_position(index, index) += mass * turn.centrifugal;
    if (central) {
      slopes.by_position(index + 1, index + 1) += mass * turn.centrifugal;
      add_turn_slope(index, mass * turn.euler, slopes.by_position);
    } else {
      slopes.by_position(index + 1, index) -= 2.0 * mass * turn.euler;
    }
    add_turn_slope(index, 2.0 * mass * turn.coriolis, slopes.by_velocity);
  }
}

// Constant power: the driving torque falls as the driven member gains speed.
void add_drive(const SetModel& model, const SpeedState& speed, const Eigen::Ref<const Eigen::VectorXd>& v,
               ForceSlopes& slopes) {
  const Operation& operation = model.operation;
  if (operation.power <= 0.0) return;
  const SetParameters& set = model.parameters;
  const Index index = SetLayout::central(operation.driven) + 2;
  const CentralMember& driven = operation.driven == Member::sun    ? set.sun
                                : operation.driven == Member::ring ? set.ring
                                                                   : set.carrier;
  const double nominal = operation.driven == Member::sun    ? operation.speeds.sun
                         : operation.driven == Member::ring ? operation.speeds.ring
                                                            : operation.speeds.carrier;
  const double circumferential = nominal * speed.factor * driven.radius + v[index];
  slopes.by_velocity(index, index) -= operation.power / (circumferential * circumferential);
}

}  // namespace

void force_slopes(const SetModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                  ForceSlopes& slopes) {
  const Index n = model.layout.freedoms();
  slopes.by_position.setZero(n, n);
  slopes.by_velocity.setZero(n, n);
  const SpeedState speed = speed_at(model.operation, time);
  const CarrierTurn turn = carrier_turn(model, speed);
  add_meshes(model, time, x.head(n), x.tail(n), slopes);
  add_planet_bearings(model, slopes);
  add_support(model.parameters.sun.support, turn, SetLayout::sun(), slopes);
  add_support(model.parameters.ring.support, turn, SetLayout::ring(), slopes);
  add_support(model.parameters.carrier.support, turn, SetLayout::carrier(), slopes);
  add_frame(model, turn, slopes);
  add_drive(model, speed, x.tail(n), slopes);
}

void StageMatrix::assemble(const SetModel& model, const ForceSlopes& slopes, double g) {
  const double square = g * g;
  const auto take = [&](Eigen::Index row, Eigen::Index column, auto& block) {
    constexpr int rows = std::remove_reference_t<decltype(block)>::RowsAtCompileTime,
                  columns = std::remove_reference_t<decltype(block)>::ColsAtCompileTime;
    block = -g * slopes.by_velocity.block<rows, columns>(row, column) -
            square * slopes.by_position.block<rows, columns>(row, column);
  };
  planets_.resize(static_cast<std::size_t>(model.layout.planets));
  take(0, 0, centre_);
  centre_.diagonal() += model.mass.head<kCentre>();
  for (std::size_t n = 0; n < planets_.size(); ++n) {
    const Eigen::Index index = SetLayout::planet(static_cast<Eigen::Index>(n));
    take(index, index, planets_[n].own);
    take(index, 0, planets_[n].by_centre);
    take(0, index, planets_[n].centre_by);
    planets_[n].own.diagonal() += model.mass.segment<3>(index);
  }
}

void StageMatrix::add_port(const SetModel& model, Eigen::Index planet, const Eigen::Matrix3d& of_carrier,
                           const Eigen::Matrix3d& of_planet, const Eigen::Matrix3d& matrix) {
  constexpr Eigen::Index carrier = SetLayout::carrier();
  const Eigen::Matrix3d by_carrier = matrix * of_carrier, by_planet = matrix * of_planet;
  Planet& at = planets_[static_cast<std::size_t>(planet)];
  centre_.block<3, 3>(carrier, carrier) += of_carrier.transpose() * by_carrier;
  at.centre_by.middleRows<3>(carrier) += of_carrier.transpose() * by_planet;
  at.by_centre.middleCols<3>(carrier) += of_planet.transpose() * by_carrier;
  at.own += of_planet.transpose() * by_planet;
  if (model.load_index < 0) return;
  centre_.row(model.load_index).segment<3>(carrier) += model.load_share * by_carrier.row(2);
  at.centre_by.row(model.load_index) += model.load_share * by_planet.row(2);
}

bool StageMatrix::factor(const SetModel& model) {
  for (int i = 0; i < kCentre; ++i) {
    if (model.mobility[i] != 0.0) continue;
    centre_.row(i).setZero();
    centre_(i, i) = 1.0;
    for (Planet& planet : planets_) planet.centre_by.row(i).setZero();
  }
  for (Planet& planet : planets_) {
    const Eigen::Matrix3d inverse = planet.own.inverse();
    if (!inverse.allFinite()) return false;
    planet.own = inverse;
    planet.by_centre = inverse.lazyProduct(planet.by_centre).eval();
    centre_ -= planet.centre_by.lazyProduct(planet.by_centre);
  }
  return factor_centre();
}

bool StageMatrix::factor_centre() {
  for (int p = 0; p < kCentre; ++p) {
    const double inverse = 1.0 / centre_(p, p);
    if (!std::isfinite(inverse)) return false;
    centre_(p, p) = inverse;
    for (int i = p + 1; i < kCentre; ++i) {
      const double share = centre_(i, p) * inverse;
      centre_(i, p) = share;
      for (int k = p + 1; k < kCentre; ++k) centre_(i, k) -= share * centre_(p, k);
    }
  }
  return true;
}

void StageMatrix::solve(Eigen::Ref<Eigen::VectorXd> b) const {
  Eigen::Matrix<double, kCentre, 1> centre = b.head<kCentre>();
  for (std::size_t n = 0; n < planets_.size(); ++n) {
    auto own = b.segment<3>(SetLayout::planet(static_cast<Eigen::Index>(n)));
    own = (planets_[n].own * own).eval();
    centre.noalias() -= planets_[n].centre_by * own;
  }
  for (int i = 1; i < kCentre; ++i)
    for (int k = 0; k < i; ++k) centre[i] -= centre_(i, k) * centre[k];
  for (int i = kCentre - 1; i >= 0; --i) {
    for (int k = i + 1; k < kCentre; ++k) centre[i] -= centre_(i, k) * centre[k];
    centre[i] *= centre_(i, i);
  }
  b.head<kCentre>() = centre;
  for (std::size_t n = 0; n < planets_.size(); ++n)
    b.segment<3>(SetLayout::planet(static_cast<Eigen::Index>(n))) -= planets_[n].by_centre * centre;
}

}  // namespace orbearing::gearset::dynamics
