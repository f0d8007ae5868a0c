#include "gearset/dynamics/modes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gearset/dynamics/matrices.hpp"
#include "gearset/dynamics/mode_kind.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using constants::two_pi;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double same_frequency = 1e-6;  // [-]  of the largest: closer ones are one, by symmetry or by chance
constexpr double nothing = 1e-6;  // [-]  of the largest frequency: round-off of a zero eigenvalue's root

std::vector<Index> free_freedoms(const SetModel& model) {
  std::vector<Index> free;
  for (Index i = 0; i < model.layout.freedoms(); ++i)
    if (model.mobility[i] > 0.0) free.push_back(i);
  return free;
}

// Single modes, not yet grouped: shapes in the coordinates sqrt(mass) q, of all freedoms.
struct RawModes {
  VectorXd frequency;  // [rad/s]
  VectorXd growth;     // [1/s]
  MatrixXcd shapes;    // (freedoms, modes)
};

MatrixXd weighted(const MatrixXd& matrix, const SetModel& model, const std::vector<Index>& free) {
  MatrixXd out(free.size(), free.size());
  for (Index i = 0; i < out.rows(); ++i)
    for (Index j = 0; j < out.cols(); ++j) {
      const Index a = free[static_cast<std::size_t>(i)], b = free[static_cast<std::size_t>(j)];
      out(i, j) = matrix(a, b) / std::sqrt(model.mass[a] * model.mass[b]);
    }
  return out;
}

MatrixXcd to_all_freedoms(const MatrixXcd& shapes, const SetModel& model, const std::vector<Index>& free) {
  MatrixXcd all = MatrixXcd::Zero(model.layout.freedoms(), shapes.cols());
  for (std::size_t i = 0; i < free.size(); ++i) all.row(free[i]) = shapes.row(static_cast<Index>(i));
  return all;
}

RawModes raw_modes_at_rest(const SetModel& model) {
  const std::vector<Index> free = free_freedoms(model);
  const mechanics::SymmetricModes modes =
      mechanics::symmetric_modes(weighted(set_matrices(model).stiffness, model, free));
  RawModes raw;
  raw.frequency = modes.values.cwiseMax(0.0).cwiseSqrt();
  raw.growth = VectorXd::Zero(raw.frequency.size());
  raw.shapes = to_all_freedoms(modes.vectors.cast<std::complex<double>>(), model, free);
  return raw;
}

// One of each conjugate pair; a pair of real roots +-s is one mode that grows at s.
std::vector<Index> one_of_each_pair(const Eigen::VectorXcd& roots) {
  const double zero = nothing * roots.cwiseAbs().maxCoeff();
  std::vector<Index> chosen, still;
  for (Index i = 0; i < roots.size(); ++i) {
    if (std::abs(roots[i]) <= zero)
      still.push_back(i);
    else if (roots[i].imag() > zero || (std::abs(roots[i].imag()) <= zero && roots[i].real() > 0.0))
      chosen.push_back(i);
  }
  chosen.insert(chosen.end(), still.begin(), still.begin() + static_cast<std::ptrdiff_t>(still.size() / 2));
  return chosen;
}

RawModes raw_modes_at_speed(const SetModel& model) {
  const std::vector<Index> free = free_freedoms(model);
  const Index n = static_cast<Index>(free.size());
  const SetMatrices matrices = set_matrices(model);
  MatrixXd companion = MatrixXd::Zero(2 * n, 2 * n);
  companion.topRightCorner(n, n).setIdentity();
  companion.bottomLeftCorner(n, n) = -weighted(matrices.stiffness + matrices.centrifugal, model, free);
  companion.bottomRightCorner(n, n) = -weighted(matrices.gyroscopic, model, free);
  // Velocities in units in which both blocks are of one size, or the small roots drown.
  const double scale = std::sqrt(companion.bottomLeftCorner(n, n).cwiseAbs().maxCoeff());
  companion.topRightCorner(n, n) *= scale;
  companion.bottomLeftCorner(n, n) /= scale;
  MatrixXcd vectors;
  const Eigen::VectorXcd values = mechanics::eigenvalues(companion, &vectors);
  const std::vector<Index> chosen = one_of_each_pair(values);
  RawModes raw{VectorXd(chosen.size()), VectorXd(chosen.size()), MatrixXcd(n, chosen.size())};
  for (Index k = 0; k < raw.frequency.size(); ++k) {
    const Index i = chosen[static_cast<std::size_t>(k)];
    raw.frequency[k] = std::abs(values[i].imag());
    raw.growth[k] = values[i].real();
    raw.shapes.col(k) = vectors.col(i).head(n).normalized();
  }
  raw.shapes = to_all_freedoms(raw.shapes, model, free);
  return raw;
}

std::vector<Index> ascending(const VectorXd& frequency) {
  std::vector<Index> order(static_cast<std::size_t>(frequency.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return frequency[a] < frequency[b]; });
  return order;
}

Mode mode_of(const SetModel& model, double frequency, double growth, const KindShapes& part, double largest) {
  Mode mode{.kind = part.kind, .multiplicity = static_cast<int>(part.shapes.cols())};
  mode.frequency = frequency > nothing * largest ? frequency / two_pi : 0.0;
  mode.growth = growth > nothing * largest ? growth : 0.0;
  mode.shapes = model.mass.cwiseSqrt().cwiseInverse().asDiagonal() * part.shapes;
  return mode;
}

std::vector<Mode> grouped(const SetModel& model, const RawModes& raw) {
  const std::vector<Index> order = ascending(raw.frequency);
  const double largest = raw.frequency.size() == 0 ? 0.0 : raw.frequency.maxCoeff();
  std::vector<Mode> modes;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    double mean = 0.0, growth = 0.0;
    while (end < order.size() &&
           raw.frequency[order[end]] - raw.frequency[order[begin]] <= same_frequency * largest) {
      mean += raw.frequency[order[end]];
      growth = std::max(growth, raw.growth[order[end++]]);
    }
    mean /= static_cast<double>(end - begin);
    MatrixXcd shapes(raw.shapes.rows(), static_cast<Index>(end - begin));
    for (std::size_t i = begin; i < end; ++i)
      shapes.col(static_cast<Index>(i - begin)) = raw.shapes.col(order[i]);
    for (const KindShapes& part : by_kind(model, shapes))
      modes.push_back(mode_of(model, mean, growth, part, largest));
  }
  return modes;
}

}  // namespace

std::vector<Mode> modes_at_rest(const SetModel& model) {
  return grouped(model, raw_modes_at_rest(model));
}

std::vector<Mode> modes_at_speed(const SetModel& model) {
  return grouped(model, raw_modes_at_speed(model));
}

MatrixXd campbell_frequencies(const SetModel& model, const std::vector<double>& factors) {
  const Index rows = static_cast<Index>(free_freedoms(model).size());
  MatrixXd frequencies = MatrixXd::Zero(rows, static_cast<Index>(factors.size()));
  SetModel rotating = model;
  for (Index k = 0; k < frequencies.cols(); ++k) {
    rotating.operation.speeds.carrier = model.operation.speeds.carrier * factors[static_cast<std::size_t>(k)];
    VectorXd found = raw_modes_at_speed(rotating).frequency / two_pi;
    std::sort(found.begin(), found.end());
    const Index count = std::min(rows, found.size());
    frequencies.col(k).tail(count) = found.tail(count);
  }
  return frequencies;
}

}  // namespace orbearing::gearset::dynamics
