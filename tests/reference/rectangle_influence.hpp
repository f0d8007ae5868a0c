// Displacement of a half-space under pressure on a grid graded along the roller and even across it.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "bearing/pressure/contact.hpp"

namespace orbearing::bearing::half_space {

/// Rows across at y = 0, h, 2 h, ...; those at -y carry the same and are not stored.
struct RowGrid {
  int rows = 0;          // [-]  stored ones: 0 to (rows - 1) h
  double spacing = 0.0;  // [m]  h

  /// 1 for the middle row, 2 for the others, which count twice.
  double count(Eigen::Index row) const { return row == 0 ? 1.0 : 2.0; }
};

/// Full matrix along the roller, where elements differ; convolution across by cosine transforms, padded with
/// as many empty rows so that it is not periodic.
class RectangleInfluence {
 public:
  RectangleInfluence(const LengthGrid& grid, const RowGrid& rows, double mirror_factor);

  /// For pressure (elements, rows): integral over each element of the integral of p/r [N], without 1/(pi E*).
  Eigen::ArrayXXd apply(const Eigen::ArrayXXd& pressure) const;

  /// Influence of each element on itself, by unit pressure [m^3]  (elements).
  const Eigen::ArrayXd& own() const { return own_; }

 private:
  Eigen::MatrixXd forward_;               // (rows, waves)
  Eigen::MatrixXd backward_;              // (waves, rows)
  std::vector<Eigen::MatrixXd> of_wave_;  // (waves) of (elements, elements)
  Eigen::ArrayXd own_;
};

}  // namespace orbearing::bearing::half_space
