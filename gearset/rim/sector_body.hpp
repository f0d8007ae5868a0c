// A planet's body as an elastic one of equal sectors: how it gives way under loads that go around it in
// waves.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <vector>

#include "gearset/rim/sector_mesh.hpp"
#include "mechanics/material.hpp"

namespace orbearing::gearset::rim {

/// Loads of one sector that may go on from sector to sector with a phase. Nodes feel them along the radius
/// and along the circumference at their own place.
using NodalLoad = Eigen::VectorXcd;  // (2 nodes)  radial, circumferential of each node

/// How the race is held.
enum class Held {
  on_average,  // on the whole it neither turns nor shifts; free else
  rigidly,     // it does not move at all
};

/// The sector with all freedoms eliminated but those of its cuts and of the race; plane strain. A body of
/// equal sectors bears each wave of loads by itself [Thomas1979], so one sector is enough.
class SectorBody {
 public:
  SectorBody(SectorMesh mesh, const mechanics::Material& material, int sectors);

  const SectorMesh& mesh() const { return mesh_; }
  int sectors() const { return sectors_; }

  /// A radial traction exp(i n phi) on the race, per radian [N/rad].
  NodalLoad race_wave(int order) const;
  /// A traction exp(i n phi) along the circumference of the race, per radian [N/rad].
  NodalLoad race_shear(int order) const;
  /// A force of 1 N on a flank (0: clockwise of the tooth, 1: the other) at `radius` [m]: into the tooth and
  /// towards the gear's axis, inclined by `pressure_angle` [rad] to the circumference.
  NodalLoad flank_force(int flank, double radius, double pressure_angle) const;

  /// What the displacement under each load does along each other one, in one sector [N m]: loads^H K^-1
  /// loads, where loads and displacements in the next sector are ahead by `order` times its angle. The force
  /// that holds the race takes what is out of balance.
  Eigen::MatrixXcd works(int order, const std::vector<NodalLoad>& loads, Held held) const;

 private:
  struct Factors;
  // Loads on the freedoms that are kept, and what they do within while those rest; columns as given.
  struct Reduced {
    Eigen::MatrixXcd kept;
    Eigen::MatrixXcd inner;   // loads
    Eigen::MatrixXcd within;  // displacements
  };
  Reduced reduced(const std::vector<NodalLoad>& loads) const;
  NodalLoad race_traction(int order, int component) const;
  Eigen::MatrixXcd displacements(int order, const Eigen::MatrixXcd& loads, Held held) const;
  Eigen::VectorXcd average(int order) const;

  SectorMesh mesh_;
  int sectors_;
  std::vector<int> kept_;      // freedoms: of the first cut, of the last cut, of the race between them
  std::vector<int> inner_;     // all others
  Eigen::MatrixXd stiffness_;  // [N/m]  (kept, kept)
  Eigen::MatrixXd following_;  // [-]    (inner, kept)  inner displacements by those of the kept freedoms
  std::shared_ptr<const Factors> factors_;  // of the inner freedoms
};

}  // namespace orbearing::gearset::rim
