#include "bearing/duplex/identification.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/checks.hpp"

namespace orbearing::bearing::duplex {

namespace {

using Vector = Eigen::VectorXd;
// A shaft by the logarithms of the unknowns, which keeps them positive.
using ShaftBy = std::function<Shaft(const Vector&)>;

struct FrequencyFit {
  const std::vector<Observation>& observations;
  const std::optional<Housing>& housing;
  TiltPlanes planes;
  ShaftBy shaft_by;

  Vector residuals(const Vector& logarithms) const {
    const Shaft shaft = shaft_by(logarithms);
    Vector all(static_cast<Eigen::Index>(5 * observations.size()));
    Eigen::Index row = 0;
    for (const Observation& one : observations) {
      const PairModes modes = modes_of(one.stiffness(shaft.levers), shaft, housing, planes);
      for (std::size_t i = 0; i < modes.size(); ++i)
        all[row++] = std::log(std::max(modes[i].frequency, 1e-6) / one.frequency[i]);
    }
    return all;
  }
};

struct Fit {
  Vector at;
  double squares = std::numeric_limits<double>::infinity();
  bool converged = false;
  int iterations = 0;
};

// Levenberg's method with slopes by differences; `least` bounds the unknowns from below.
Fit least_squares(const FrequencyFit& problem, const Vector& start, const Vector& least) {
  constexpr int most_iterations = 300;
  constexpr double step = 1e-6, nothing = 1e-13;  // of the squares, that a step gains
  Fit fit{.at = start.cwiseMax(least)};
  Vector residuals = problem.residuals(fit.at);
  fit.squares = residuals.squaredNorm();
  double damping = 1e-3;
  for (; fit.iterations < most_iterations; ++fit.iterations) {
    Eigen::MatrixXd slopes(residuals.size(), fit.at.size());
    for (Eigen::Index k = 0; k < fit.at.size(); ++k) {
      Vector above = fit.at, below = fit.at;
      above[k] += step;
      below[k] -= step;
      slopes.col(k) = (problem.residuals(above) - problem.residuals(below)) / (2.0 * step);
    }
    Vector downhill = -slopes.transpose() * residuals;
    // A parameter at its bound stays there if it would cross it.
    for (Eigen::Index k = 0; k < fit.at.size(); ++k)
      if (fit.at[k] <= least[k] && downhill[k] < 0.0) {
        downhill[k] = 0.0;
        slopes.col(k).setZero();
      }
    bool better = false;
    double gain = 0.0;
    while (!better && damping < 1e12) {
      Eigen::MatrixXd normal = slopes.transpose() * slopes;
      normal.diagonal().array() += damping;
      const Vector next = (fit.at + Vector(normal.ldlt().solve(downhill))).cwiseMax(least);
      const Vector trial = problem.residuals(next);
      better = trial.squaredNorm() < fit.squares;
      if (!better) {
        damping *= 4.0;
        continue;
      }
      gain = fit.squares - trial.squaredNorm();
      fit.at = next;
      residuals = trial;
      fit.squares = trial.squaredNorm();
      damping = std::max(1e-12, damping / 8.0);
    }
    if (!better || gain <= nothing * (fit.squares + nothing)) {
      fit.converged = true;
      break;
    }
  }
  return fit;
}

void require_sound(const std::vector<Observation>& observations) {
  mechanics::require(!observations.empty(), "number of observed pairs", 0.0, "at least 1");
  for (const Observation& one : observations)
    for (const double frequency : one.frequency)
      mechanics::require(frequency > 0.0, "measured frequency [Hz]", frequency, "greater than 0");
}

Identified identified(const FrequencyFit& problem, const Fit& fit) {
  const double count = static_cast<double>(5 * problem.observations.size());
  return {.shaft = problem.shaft_by(fit.at),
          .converged = fit.converged,
          .iterations = fit.iterations,
          .root_mean_square = std::sqrt(fit.squares / count)};
}

Fit best_of(const FrequencyFit& problem, const std::vector<Vector>& starts, const Vector& least) {
  Fit best;
  for (const Vector& start : starts) {
    const Fit fit = least_squares(problem, start, least);
    if (fit.squares < best.squares) best = fit;
  }
  return best;
}

}  // namespace

// The residuals have a valley on each side of the lever at which the contact lines meet: starts on both.
Identified identify_cylinder(const std::vector<Observation>& observations, const Cylinder& cylinder,
                             double least_lever, const std::optional<Housing>& housing) {
  require_sound(observations);
  mechanics::require(least_lever > 0.0, "least lever [m]", least_lever, "greater than 0");
  const FrequencyFit problem{observations, housing, TiltPlanes::physical, [&](const Vector& logarithms) {
                               const double mass = std::exp(logarithms[0]), lever = std::exp(logarithms[1]);
                               const double inertia =
                                   cylinder_inertia(mass, cylinder.diameter, cylinder.density);
                               return Shaft{mass, {lever, lever}, inertia, inertia};
                             }};
  std::vector<Vector> starts;
  for (const double mass : {1.0, 10.0, 100.0})
    for (const double lever : {1.05, 1.5, 2.0, 2.5, 3.0, 4.0, 6.0, 10.0})
      starts.push_back(Eigen::Vector2d(std::log(mass), std::log(lever * least_lever)));
  const Eigen::Vector2d least(std::log(1e-6), std::log(least_lever));
  return identified(problem, best_of(problem, starts, least));
}

Identified identify_all(const std::vector<Observation>& observations, const Shaft& start, TiltPlanes planes,
                        const std::optional<Housing>& housing) {
  require_sound(observations);
  constexpr Eigen::Index unknowns = 5;
  const FrequencyFit problem{observations, housing, planes, [](const Vector& logarithms) {
                               const Vector value = logarithms.array().exp();
                               return Shaft{value[0], {value[1], value[2]}, value[3], value[4]};
                             }};
  std::vector<Vector> starts;
  for (const double lever : {1.0, 2.5})
    for (const double other : {1.0, 0.02}) {
      Vector one(unknowns);
      one << start.mass, lever * start.levers.first, other * start.levers.second, lever * start.inertia_x,
          lever * start.inertia_y;
      starts.push_back(one.array().log());
    }
  return identified(problem, best_of(problem, starts, Vector::Constant(unknowns, std::log(1e-6))));
}

}  // namespace orbearing::bearing::duplex
