#include "bearing/duplex/shaft.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::bearing::duplex {

namespace {

constexpr double kPi = constants::pi;
constexpr Eigen::Index kFreedoms = 5;
using Freedoms = Eigen::Vector<double, kFreedoms>;

// Order of pair.hpp: x, y, z, tilt in the plane of x, tilt in the plane of y.
Freedoms masses_of(const Shaft& shaft, TiltPlanes planes) {
  const bool physical = planes == TiltPlanes::physical;
  return {shaft.mass, shaft.mass, shaft.mass, physical ? shaft.inertia_y : shaft.inertia_x,
          physical ? shaft.inertia_x : shaft.inertia_y};
}

Freedoms masses_of(const Housing& housing) {
  return {housing.mass, housing.mass, housing.mass, housing.inertia, housing.inertia};
}

// Two free bodies move against each other as one of the harmonic sum of both masses.
Freedoms inverse_masses(const Shaft& shaft, const std::optional<Housing>& housing, TiltPlanes planes) {
  Freedoms inverse = masses_of(shaft, planes).cwiseInverse();
  if (housing) inverse += masses_of(*housing).cwiseInverse();
  return inverse;
}

Eigen::Index freedom_of(ModeKind kind, TiltPlanes planes) {
  const bool physical = planes == TiltPlanes::physical;
  switch (kind) {
    case ModeKind::tilt_x:
      return physical ? 4 : 3;
    case ModeKind::tilt_y:
      return physical ? 3 : 4;
    case ModeKind::axial_z:
      return 2;
    case ModeKind::radial_x:
      return 0;
    case ModeKind::radial_y:
      return 1;
  }
  return 0;
}

// Coupling of freedoms by round-off would mix modes of equal frequency at random.
Stiffness without_round_off(const Stiffness& scaled) {
  constexpr double nothing = 1e-10;
  Stiffness clean = 0.5 * (scaled + scaled.transpose());
  for (Eigen::Index i = 0; i < kFreedoms; ++i)
    for (Eigen::Index j = 0; j < kFreedoms; ++j)
      if (i != j && std::abs(clean(i, j)) <= nothing * std::sqrt(std::abs(clean(i, i) * clean(j, j))))
        clean(i, j) = 0.0;
  return clean;
}

// Freedoms that follow each other through the matrix, from one of them on.
std::vector<Eigen::Index> coupled_with(Eigen::Index from, const Stiffness& matrix,
                                       std::array<bool, kFreedoms>& taken) {
  std::vector<Eigen::Index> found{from};
  taken[static_cast<std::size_t>(from)] = true;
  for (std::size_t k = 0; k < found.size(); ++k)
    for (Eigen::Index j = 0; j < kFreedoms; ++j)
      if (!taken[static_cast<std::size_t>(j)] && matrix(found[k], j) != 0.0) {
        taken[static_cast<std::size_t>(j)] = true;
        found.push_back(j);
      }
  return found;
}

struct Eigenpair {
  double value = 0.0;  // [rad^2/s^2]
  Freedoms vector = Freedoms::Zero();
};

// Each group of coupled freedoms separately.
std::vector<Eigenpair> eigenpairs(const Stiffness& matrix) {
  std::vector<Eigenpair> pairs;
  std::array<bool, kFreedoms> taken{};
  for (Eigen::Index i = 0; i < kFreedoms; ++i) {
    if (taken[static_cast<std::size_t>(i)]) continue;
    const std::vector<Eigen::Index> group = coupled_with(i, matrix, taken);
    const auto size = static_cast<Eigen::Index>(group.size());
    const Eigen::MatrixXd part = matrix(group, group);
    const mechanics::SymmetricModes modes = mechanics::symmetric_modes(part);
    for (Eigen::Index k = 0; k < size; ++k) {
      Eigenpair pair{.value = modes.values[k]};
      pair.vector(group) = modes.vectors.col(k);
      pairs.push_back(pair);
    }
  }
  return pairs;
}

}  // namespace

double cylinder_inertia(double mass, double diameter, double density) {
  const double length = mass / (density * 0.25 * kPi * diameter * diameter);
  return mass * (diameter * diameter / 16.0 + length * length / 12.0);
}

const char* name_of(ModeKind kind) {
  constexpr std::array<const char*, 5> names{"tilt_x", "tilt_y", "axial_z", "radial_x", "radial_y"};
  return names[static_cast<std::size_t>(kind)];
}

PairModes modes_of(const Stiffness& stiffness, const Shaft& shaft, const std::optional<Housing>& housing,
                   TiltPlanes planes) {
  const Freedoms scale = inverse_masses(shaft, housing, planes).cwiseSqrt();
  mechanics::require(scale.allFinite(), "largest inverse mass of a pair", scale.maxCoeff(), "finite");
  std::vector<Eigenpair> left =
      eigenpairs(without_round_off(scale.asDiagonal() * stiffness * scale.asDiagonal()));
  PairModes modes;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const Eigen::Index freedom = freedom_of(mode_kinds[i], planes);
    const auto most = std::max_element(left.begin(), left.end(), [&](const Eigenpair& a, const Eigenpair& b) {
      return std::abs(a.vector[freedom]) < std::abs(b.vector[freedom]);
    });
    modes[i] = {.kind = mode_kinds[i],
                .frequency = std::sqrt(std::max(0.0, most->value)) / (2.0 * kPi),
                .shape = scale.cwiseProduct(most->vector),
                .energy_share = most->vector.cwiseAbs2()};
    if (modes[i].shape[freedom] < 0.0) modes[i].shape *= -1.0;
    left.erase(most);
  }
  return modes;
}

std::array<std::complex<double>, 3> accelerance(const Stiffness& stiffness, const Shaft& shaft,
                                                const std::optional<Housing>& housing, TiltPlanes planes,
                                                const ResponsePoint& point, double frequency) {
  const std::complex<double> loss(1.0, point.loss_factor);
  const double squared = std::pow(2.0 * kPi * frequency, 2);
  const Eigen::Index size = housing ? 2 * kFreedoms : kFreedoms;
  Eigen::MatrixXcd dynamic = Eigen::MatrixXcd::Zero(size, size);
  const Eigen::MatrixXcd springs = loss * stiffness.cast<std::complex<double>>();
  dynamic.topLeftCorner(kFreedoms, kFreedoms) = springs;
  dynamic.diagonal().head(kFreedoms) -= squared * masses_of(shaft, planes).cast<std::complex<double>>();
  if (housing) {
    dynamic.topRightCorner(kFreedoms, kFreedoms) = -springs;
    dynamic.bottomLeftCorner(kFreedoms, kFreedoms) = -springs;
    dynamic.bottomRightCorner(kFreedoms, kFreedoms) = springs;
    dynamic.diagonal().tail(kFreedoms) -= squared * masses_of(*housing).cast<std::complex<double>>();
  }
  const Eigen::PartialPivLU<Eigen::MatrixXcd> factors(dynamic);
  std::array<std::complex<double>, 3> result;
  for (Eigen::Index direction = 0; direction < 3; ++direction) {
    Eigen::VectorXcd along = Eigen::VectorXcd::Zero(size);
    along[direction] = 1.0;
    if (direction < 2) along[direction + 3] = -point.position;
    const Eigen::VectorXcd moved = factors.solve(along);
    result[static_cast<std::size_t>(direction)] = -squared * (along.transpose() * moved)(0);
  }
  return result;
}

}  // namespace orbearing::bearing::duplex
