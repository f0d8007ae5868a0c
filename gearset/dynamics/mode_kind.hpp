// Sorts shapes of one frequency by their symmetry under an exchange of planets.
#pragma once

#include <vector>

#include "gearset/dynamics/modes.hpp"

namespace orbearing::gearset::dynamics {

/// Part of a space of shapes that is of one kind.
struct KindShapes {
  ModeKind kind = ModeKind::rotational;
  Eigen::MatrixXcd shapes;  // (freedoms, number)  orthonormal
};

/// Splits the space that the columns of `shapes` span, which share one frequency, into parts of one kind.
/// Where by unequal planets a shape belongs to no kind alone, the largest part names it. Eq. (13) of
/// gearset/dynamics/README.md.
/// @param shapes (freedoms, number) in the coordinates sqrt(mass) x position
std::vector<KindShapes> by_kind(const SetLayout& layout, const Eigen::MatrixXcd& shapes);

}  // namespace orbearing::gearset::dynamics
