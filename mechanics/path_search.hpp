// Equilibrium of forces that depend on a load share from 0 to 1, from the known equilibrium at share 0. The
// search follows the equilibrium path by arc length, so the path may turn back on the way.
//
// Newton steps across the path bring each guess along its tangent back onto it [Keller1977]. The path ends at
// share 1 if forces are continuous, resist large displacements, and have a single equilibrium at share 0.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace orbearing::mechanics {

/// Unbalanced forces at one position and share.
struct PathForces {
  Eigen::VectorXd force;      // [N]
  Eigen::MatrixXd stiffness;  // [N/m]  -d(force)/d(position)
  Eigen::VectorXd by_share;   // [N]    d(force)/d(share)
  double scale = 0.0;         // [N]    the largest of the forces in equilibrium
};

/// Result of a path search: `converged` if share 1 was reached.
struct PathReport {
  bool converged = false;
  int steps = 0;
  double share = 0.0;
};

namespace detail {

// Position in units of the path's length, followed by the share.
template <class Function>
class Path {
 public:
  Path(Function& forces_at, double length) : forces_at_(forces_at), length_(length) {}

  /// Brings `point` back onto the path, at right angles to `across`, until no more than the share `near` of
  /// the forces is left. Whether it arrived.
  bool correct(const Eigen::VectorXd& across, Eigen::VectorXd& point, double near, int most) {
    const Eigen::VectorXd from = point;
    double before = 0.0;
    for (int i = 0; i < most; ++i) {
      const PathForces now = evaluate(point, across);
      const double left = now.force.norm() / now.scale;
      if (left < near) return true;
      if (i > 2 && left > 0.9 * before) return false;
      before = left;
      Eigen::VectorXd right(point.size());
      right << now.force, across.dot(from - point);
      const Eigen::VectorXd change = factors_.solve(right);
      if (!change.allFinite()) return false;
      point += change;
    }
    return false;
  }

  /// Direction of the path at `point`, forward as `before` is.
  Eigen::VectorXd tangent(const Eigen::VectorXd& point, const Eigen::VectorXd& before) {
    evaluate(point, before);
    return factors_.solve(Eigen::VectorXd::Unit(point.size(), point.size() - 1)).normalized();
  }

 private:
  PathForces evaluate(const Eigen::VectorXd& point, const Eigen::VectorXd& across) {
    constexpr double kFloor = 1e-12;
    const Eigen::Index n = point.size() - 1;
    PathForces now = forces_at_(length_ * point.head(n), point[n]);
    Eigen::MatrixXd matrix(n + 1, n + 1);
    matrix.topLeftCorner(n, n) = length_ * now.stiffness;
    matrix.topLeftCorner(n, n).diagonal().array() +=
        kFloor * length_ * now.stiffness.diagonal().cwiseAbs().maxCoeff();
    matrix.topRightCorner(n, 1) = -now.by_share;
    matrix.bottomRows(1) = across.transpose();
    factors_.compute(matrix);
    return now;
  }

  Function& forces_at_;
  double length_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace detail

/// Follows the equilibrium of `forces_at(position, share)`, PathForces, from `position` at share 0 to share
/// 1; `position` [m] then is the equilibrium there, or the point where the path was lost. `length` [m] is the
/// length over which forces change.
template <class Function>
PathReport follow_path(Function&& forces_at, double length, Eigen::VectorXd& position) {
  constexpr int kMostSteps = 600, kMostCorrections = 10;
  constexpr double kFirst = 0.05, kShortest = 1e-7, kLongest = 0.5;
  constexpr double kLeastTurn = 0.8;              // cosine between steps
  constexpr double kNear = 1e-7, kAtEnd = 1e-11;  // of the forces in equilibrium
  const Eigen::Index n = position.size();
  detail::Path path(forces_at, length);
  Eigen::VectorXd point(n + 1), across = Eigen::VectorXd::Unit(n + 1, n);
  point << position / length, 0.0;
  PathReport report;
  if (!path.correct(across, point, kNear, 40)) return report;
  Eigen::VectorXd along = path.tangent(point, across);
  double step = kFirst;
  while (report.steps < kMostSteps && step > kShortest) {
    ++report.steps;
    Eigen::VectorXd next = point + step * along;
    const bool last = next[n] >= 1.0;
    if (last) next = point + (1.0 - point[n]) / along[n] * along;
    bool arrived = path.correct(last ? Eigen::VectorXd::Unit(n + 1, n) : along, next, last ? kAtEnd : kNear,
                                kMostCorrections);
    if (arrived && last && (next - point).norm() < 2.0 * step) {
      report.converged = true;
      report.share = 1.0;
      position = length * next.head(n);
      return report;
    }
    if (last) arrived = false;
    const Eigen::VectorXd after = arrived ? path.tangent(next, along) : along;
    if (!arrived || !after.allFinite() || after.dot(along) < kLeastTurn) {
      step *= 0.4;
      continue;
    }
    point = next;
    along = after;
    step = std::min(1.5 * step, kLongest);
  }
  report.share = point[n];
  position = length * point.head(n);
  return report;
}

}  // namespace orbearing::mechanics
