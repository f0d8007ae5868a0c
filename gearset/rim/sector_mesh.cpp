#include "gearset/rim/sector_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::gearset::rim {

namespace {

using constants::pi;

// A point of the outline above the rim, by its angle from the middle of the tooth.
struct OutlinePoint {
  double angle = 0.0;   // [rad]
  double radius = 0.0;  // [m]
};

// Places on the lattice of half elements. The rim reaches over all columns, from -half_columns to
// half_columns; the tooth stands on those between -tooth_columns and tooth_columns. Tooth and rim meet on the
// arc at which the normal of the fillet has turned halfway: its corners are wide on either side.
class Lattice {
 public:
  Lattice(const RimSection& section, const Fineness& fineness)
      : section_(section),
        fineness_(fineness),
        half_turn_(0.5 * trochoid_normal_angle(section.tooth, section.tooth.form_radius)),
        foot_(trochoid_point(section.tooth, half_turn_)) {}

  int tooth_columns() const { return 2 * fineness_.below_half_tooth; }
  int half_columns() const { return tooth_columns() + 2 * fineness_.below_half_gap; }
  int ring_rows() const { return has_ring() ? 2 * fineness_.through_ring : 0; }
  int rim_rows() const { return ring_rows() + 2 * fineness_.through_rim; }
  int rows() const { return rim_rows() + 2 * fineness_.along_tooth; }

  Eigen::Vector2d position(int column, int row) const {
    const OutlinePoint point =
        row <= rim_rows() ? in_rim(std::abs(column), row) : in_tooth(std::abs(column), row);
    const double angle = column < 0 ? -point.angle : point.angle;
    return {point.radius * std::cos(angle), point.radius * std::sin(angle)};
  }

 private:
  bool has_ring() const { return section_.seat_radius > section_.race_radius; }

  // Where the column leaves the rim: under the tooth, along the lower half of the fillet, along the root
  // circle.
  OutlinePoint top_of_rim(int column) const {
    if (column <= tooth_columns()) return {foot_.half_angle * column / tooth_columns(), foot_.radius};
    const double share = static_cast<double>(column - tooth_columns()) / (half_columns() - tooth_columns());
    const double end = pi / section_.tooth.teeth;
    const TrochoidPoint bottom = trochoid_point(section_.tooth, 0.0);
    const double land = std::max(end - bottom.half_angle, 0.0), fillet = bottom.half_angle - foot_.half_angle;
    const double gone = share * (land + fillet);  // angle from the foot
    if (gone >= fillet) return {std::min(foot_.half_angle + gone, end), section_.tooth.root_radius};
    const double angle = foot_.half_angle + gone;
    return {angle, section_.tooth.root_radius + fillet_height(angle)};
  }

  // The fillet falls with the angle from the middle of the tooth: by bisection on its normal.
  double fillet_height(double angle) const {
    double low = 0.0, high = half_turn_;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (trochoid_point(section_.tooth, middle).half_angle > angle ? low : high) = middle;
    }
    return trochoid_point(section_.tooth, 0.5 * (low + high)).radius - section_.tooth.root_radius;
  }

  OutlinePoint in_rim(int column, int row) const {
    const OutlinePoint top = top_of_rim(column);
    if (row < ring_rows()) {
      const double share = static_cast<double>(row) / ring_rows();
      return {top.angle, section_.race_radius + share * (section_.seat_radius - section_.race_radius)};
    }
    const double share = static_cast<double>(row - ring_rows()) / (rim_rows() - ring_rows());
    return {top.angle, section_.seat_radius + share * (top.radius - section_.seat_radius)};
  }

  OutlinePoint in_tooth(int column, int row) const {
    const double share = static_cast<double>(row - rim_rows()) / (rows() - rim_rows());
    const double radius = foot_.radius + share * (section_.tooth.tip_radius - foot_.radius);
    const double flank = std::max(half_thickness_angle(section_.tooth, radius), 1e-3 * foot_.half_angle);
    return {flank * column / tooth_columns(), radius};
  }

  const RimSection& section_;
  const Fineness& fineness_;
  double half_turn_;    // [rad]
  TrochoidPoint foot_;  // of the tooth on the rim
};

// Numbers the places of the lattice as elements ask for them.
class Numbering {
 public:
  Numbering(const Lattice& lattice, SectorMesh& mesh) : lattice_(lattice), mesh_(mesh) {}

  int operator()(int column, int row) {
    const auto [entry, is_new] = number_.try_emplace({column, row}, static_cast<int>(mesh_.node.size()));
    if (is_new) mesh_.node.push_back(lattice_.position(column, row));
    return entry->second;
  }

 private:
  const Lattice& lattice_;
  SectorMesh& mesh_;
  std::map<std::pair<int, int>, int> number_;
};

}  // namespace

Fineness operator*(int times, const Fineness& f) {
  return {times * f.below_half_tooth, times * f.below_half_gap, times * f.through_ring, times * f.through_rim,
          times * f.along_tooth};
}

SectorMesh sector_mesh(const RimSection& section, const Fineness& fineness) {
  mechanics::require(section.race_radius > 0.0 && section.race_radius <= section.seat_radius,
                     "radius of the race", section.race_radius,
                     "positive and at most that of the ring's seat");
  mechanics::require(section.seat_radius < section.tooth.root_radius, "radius of the ring's seat",
                     section.seat_radius, "less than that of the root circle");
  const Lattice lattice(section, fineness);
  SectorMesh mesh;
  Numbering node(lattice, mesh);
  // Radius grows with the row, angle with the column: (row, column) is a right-handed pair.
  const auto add = [&](int column, int row, double width) {
    mesh.element.push_back({node(column, row), node(column, row + 2), node(column + 2, row + 2),
                            node(column + 2, row), node(column, row + 1), node(column + 1, row + 2),
                            node(column + 2, row + 1), node(column + 1, row)});
    mesh.width.push_back(width);
  };
  const int all = lattice.half_columns(), tooth = lattice.tooth_columns();
  for (int row = 0; row < lattice.rim_rows(); row += 2)
    for (int column = -all; column < all; column += 2)
      add(column, row, row < lattice.ring_rows() ? section.ring_width : section.face_width);
  for (int row = lattice.rim_rows(); row < lattice.rows(); row += 2)
    for (int column = -tooth; column < tooth; column += 2) add(column, row, section.face_width);
  for (int row = 0; row <= lattice.rim_rows(); ++row) {
    mesh.first_side.push_back(node(-all, row));
    mesh.last_side.push_back(node(all, row));
  }
  for (int column = -all; column <= all; ++column) mesh.race.push_back(node(column, 0));
  for (int row = lattice.rim_rows(); row <= lattice.rows(); ++row) {
    mesh.flank[0].push_back(node(-tooth, row));
    mesh.flank[1].push_back(node(tooth, row));
  }
  return mesh;
}

}  // namespace orbearing::gearset::rim
