// Elements along the roller, finer towards the ends.
#pragma once

#include <Eigen/Dense>

#include "bearing/pressure/contact.hpp"

namespace orbearing::bearing::half_space {

/// Elements of the length, from -l/2 to l/2, symmetric to the middle.
struct LengthGrid {
  Eigen::ArrayXd edge;    // [m]  (elements + 1)
  Eigen::ArrayXd middle;  // [m]
  Eigen::ArrayXd size;    // [m]
};

/// `elements` of them at x = l/2 [(1 - g) s + g sin(pi s/2)], s even from -1 to 1. With `grading` g = 0 all
/// are equal; the default makes those at the ends about a twelfth of those in the middle.
LengthGrid graded_grid(double length, int elements, double grading = 0.92);

/// Means of `relief` over the elements [m], by Gauss' rule with five points.
Eigen::ArrayXd mean_relief(const LengthGrid& grid, const Relief& relief);

}  // namespace orbearing::bearing::half_space
