// A planet's body as an elastic one of equal sectors: its deflection under loads that vary around it as
// waves.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <memory>
#include <vector>

#include "gearset/tooth_form.hpp"
#include "mechanics/material.hpp"

namespace orbearing::gearset::rim {

// One tooth with its share of the rim and of the bearing's outer ring, cut into finite elements.

/// Cross-section of a planet from the race of its bearings' outer rings to the tips of its teeth.
struct RimSection {
  ExternalTooth tooth;
  double race_radius = 0.0;  // [m]  where the rollers press
  double seat_radius = 0.0;  // [m]  of the outer rings in the planet; the race radius where there is no ring
  double ring_width = 0.0;   // [m]  of all outer rings together
  double face_width = 0.0;   // [m]  of the planet
};

/// Elements across each part of a sector.
struct Fineness {
  int below_half_tooth = 4;  // around, below half a tooth
  int below_half_gap = 4;    // around, below half a tooth space
  int through_ring = 2;      // along the radius
  int through_rim = 4;
  int along_tooth = 8;
};

/// Each number of elements `times` as large.
Fineness operator*(int times, const Fineness& fineness);

/// Nodes and elements of one sector, between the middles of two neighbouring tooth spaces. Elements are
/// quadrilaterals of eight nodes: corners anticlockwise, then the middles of the sides that follow them.
struct SectorMesh {
  std::vector<Eigen::Vector2d> node;  // [m]  tooth along x
  std::vector<std::array<int, 8>> element;
  std::vector<double> width;    // [m]  (elements)  along the gear's axis
  std::vector<int> first_side;  // nodes on the clockwise cut, from the race outward
  std::vector<int> last_side;   // those on the other cut, which are the first ones of the next sector
  std::vector<int> race;        // nodes along the race, anticlockwise
  std::array<std::vector<int>, 2> flank;  // nodes along either flank, root to tip: clockwise one, the other
};

/// @throws std::invalid_argument where race, seat and root circle do not lie in this order
SectorMesh sector_mesh(const RimSection& section, const Fineness& fineness);

/// Loads of one sector that may go on from sector to sector with a phase. They act on nodes along the radius
/// and along the circumference at their own position.
using NodalLoad = Eigen::VectorXcd;  // (2 nodes)  radial, circumferential of each node

/// How the race is held.
enum class RaceConstraint {
  on_average,  // on the whole it neither turns nor shifts; free else
  rigidly,     // it does not move at all
};

/// The sector with all freedoms eliminated but those of its cuts and of the race; plane strain. In a body of
/// equal sectors each wave of loads acts independently of the others [Thomas1979], so one sector is enough.
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

  /// Work of each load on the displacement under each other load, in one sector [N m]: loads^H K^-1 loads,
  /// where loads and displacements in the next sector are ahead by `order` times its angle. The force that
  /// holds the race balances the rest.
  Eigen::MatrixXcd works(int order, const std::vector<NodalLoad>& loads, RaceConstraint constraint) const;

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
  Eigen::MatrixXcd displacements(int order, const Eigen::MatrixXcd& loads, RaceConstraint constraint) const;
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
