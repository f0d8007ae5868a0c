// Slope of a smooth explicit map, by central differences that are extrapolated to no step at all. For what
// only prepares a computation: where a search or a contact that begins to carry lies between, slopes come by
// forward differentiation (sparse_dual.hpp) and the implicit function theorem.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace orbearing::mechanics {

/// A slope and what the last extrapolation changed of it: an estimate of its error, of the same unit.
struct ExplicitSlope {
  Eigen::VectorXd slope;
  Eigen::VectorXd last_change;
  /// By how much the slopes to both sides differ, from the longest step and from the shortest, 0.36 of it. Of
  /// a smooth map they go with the step; where the map has a kink they are alike. Empty from one side alone.
  Eigen::VectorXd bend, bend_near;
};

namespace detail {

/// Each step over the one before. No whole ratio, under which a rounded map would look smooth.
inline constexpr double kShorter = 0.6;

/// Slopes from steps that shorten so, whose errors go with the powers `power`, 2 `power`, ... of the step.
template <int count>
ExplicitSlope extrapolated(Eigen::VectorXd (&slope)[count], double power) {
  Eigen::VectorXd last_change;
  for (int level = 1; level < count; ++level)
    for (int i = count - 1; i >= level; --i) {
      last_change = (slope[i] - slope[i - 1]) / (std::pow(kShorter, -power * level) - 1.0);
      slope[i] += last_change;
    }
  return {slope[count - 1], last_change, {}, {}};
}

}  // namespace detail

/// Of `map(offset)`, an Eigen::VectorXd that is `here` at offset zero, there, from three steps to either
/// side, the longest of them `step`: of order step^6.
template <class Map>
ExplicitSlope central_slope(Map&& map, const Eigen::VectorXd& here, double step) {
  Eigen::VectorXd across[3], bend[3];
  for (int i = 0; i < 3; ++i, step *= detail::kShorter) {
    const Eigen::VectorXd ahead = map(step), behind = map(-step);
    across[i] = (ahead - behind) / (2.0 * step);
    bend[i] = (ahead - here + (behind - here)) / step;
  }
  ExplicitSlope result = detail::extrapolated(across, 2.0);
  result.bend = bend[0];
  result.bend_near = bend[2];
  return result;
}

/// The same to one side alone, towards the sign of `step`, from four steps: of order step^4.
template <class Map>
ExplicitSlope one_sided_slope(Map&& map, const Eigen::VectorXd& here, double step) {
  Eigen::VectorXd ahead[4];
  for (Eigen::VectorXd& slope : ahead) {
    slope = (map(step) - here) / step;
    step *= detail::kShorter;
  }
  return detail::extrapolated(ahead, 1.0);
}

}  // namespace orbearing::mechanics
