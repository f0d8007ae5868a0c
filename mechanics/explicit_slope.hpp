// Slope of a smooth explicit map, by central differences that are extrapolated to no step at all. For what only
// prepares a computation: where a search or a contact that begins to carry lies between, slopes come by forward
// differentiation (sparse_dual.hpp) and the implicit function theorem.
#pragma once

#include <Eigen/Core>

namespace orbearing::mechanics {

/// A slope and what the last extrapolation changed of it: an estimate of its error, of the same unit.
struct ExplicitSlope {
  Eigen::VectorXd slope;
  Eigen::VectorXd last_change;
  /// By how much the slopes to both sides differ, from the whole step and from a quarter of it. Of a smooth map the
  /// second is a quarter of the first; where the map has a kink they are alike. Empty from one side alone.
  Eigen::VectorXd bend, bend_near;
};

/// Of `map(offset)`, an Eigen::VectorXd that is `here` at offset zero, there, from steps `step`, half and a quarter of
/// it to either side: of order step^6.
template <class Map>
ExplicitSlope central_slope(Map&& map, const Eigen::VectorXd& here, double step) {
  Eigen::VectorXd bend;  // of the step last taken
  const auto across = [&](double h) -> Eigen::VectorXd {
    const Eigen::VectorXd ahead = map(h), behind = map(-h);
    bend = (ahead - here + (behind - here)) / h;
    return (ahead - behind) / (2.0 * h);
  };
  const Eigen::VectorXd whole = across(step), bend_far = bend;
  const Eigen::VectorXd half = across(0.5 * step), quarter = across(0.25 * step);
  const Eigen::VectorXd coarse = half + (half - whole) / 3.0, fine = quarter + (quarter - half) / 3.0;
  const Eigen::VectorXd last_change = (fine - coarse) / 15.0;
  return {fine + last_change, last_change, bend_far, bend};
}

/// The same to one side alone, towards the sign of `step`, from `here`, the map at offset zero: of order step^4.
template <class Map>
ExplicitSlope one_sided_slope(Map&& map, const Eigen::VectorXd& here, double step) {
  const auto ahead = [&](double h) -> Eigen::VectorXd { return (map(h) - here) / h; };
  Eigen::VectorXd slope[4];
  for (int i = 0; i < 4; ++i) slope[i] = ahead(step / (1 << i));
  Eigen::VectorXd last_change;
  for (int level = 1; level < 4; ++level)
    for (int i = 3; i >= level; --i) {
      last_change = (slope[i] - slope[i - 1]) / ((1 << level) - 1);
      slope[i] += last_change;
    }
  return {slope[3], last_change, {}, {}};
}

}  // namespace orbearing::mechanics
