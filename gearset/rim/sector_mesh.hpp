// One tooth with its share of the rim and of the bearing's outer ring, cut into finite elements.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "gearset/tooth_form.hpp"

namespace orbearing::gearset::rim {

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

}  // namespace orbearing::gearset::rim
