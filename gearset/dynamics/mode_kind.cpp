#include "gearset/dynamics/mode_kind.hpp"

#include <Eigen/QR>
#include <complex>

#include "mechanics/linear_algebra.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

// Motions of the planets one against another, by kind; Eq. (13): each column a pattern over their angles,
// orthonormal. Rotational: all alike; translational: with the cosine and sine of their angle; planet: the
// rest.
MatrixXd patterns(const std::vector<double>& angles, ModeKind kind) {
  const Eigen::Map<const Eigen::ArrayXd> angle(angles.data(), static_cast<Index>(angles.size()));
  constexpr double none = 1e-9;  // of a pattern that is one of those before
  MatrixXd columns(angle.size(), 3), basis(angle.size(), 0);
  columns << Eigen::VectorXd::Ones(angle.size()), angle.cos(), angle.sin();
  Index first_of_shifts = 0;
  for (Index k = 0; k < columns.cols(); ++k) {
    Eigen::VectorXd next = columns.col(k).normalized();
    for (int twice = 0; twice < 2; ++twice) next -= basis * (basis.transpose() * next);
    if (k == 1) first_of_shifts = basis.cols();
    if (next.norm() < none) continue;
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = next.normalized();
  }
  if (kind == ModeKind::rotational) return basis.leftCols(first_of_shifts);
  if (kind == ModeKind::translational) return basis.rightCols(basis.cols() - first_of_shifts);
  return Eigen::HouseholderQR<MatrixXd>(basis).householderQ() *
         MatrixXd::Identity(angle.size(), angle.size()).rightCols(angle.size() - basis.cols());
}

// The share of each column that belongs to `kind`.
MatrixXcd projected(const SetModel& model, const MatrixXcd& shapes, ModeKind kind) {
  MatrixXcd part = MatrixXcd::Zero(shapes.rows(), shapes.cols());
  for (Index index = 0; index < SetLayout::planet(0); index += 3) {
    if (kind == ModeKind::translational) part.middleRows(index, 2) = shapes.middleRows(index, 2);
    if (kind == ModeKind::rotational) part.row(index + 2) = shapes.row(index + 2);
  }
  const MatrixXd own = patterns(model.planet_angles, kind);
  for (Index pattern = 0; pattern < own.cols(); ++pattern) {
    MatrixXcd amplitude = MatrixXcd::Zero(3, shapes.cols());
    for (Index n = 0; n < own.rows(); ++n)
      amplitude += own(n, pattern) * shapes.middleRows(SetLayout::planet(n), 3);
    for (Index n = 0; n < own.rows(); ++n)
      part.middleRows(SetLayout::planet(n), 3) += own(n, pattern) * amplitude;
  }
  return part;
}

// `count` orthonormal vectors of the space that the columns span: Gram and Schmidt's method, the column that
// is left longest first, and twice, so that round-off leaves no share of the earlier ones.
MatrixXcd orthonormal(MatrixXcd columns, Index count) {
  MatrixXcd basis(columns.rows(), count);
  for (Index k = 0; k < count; ++k) {
    Index longest = 0;
    columns.colwise().squaredNorm().maxCoeff(&longest);
    Eigen::VectorXcd next = columns.col(longest).normalized();
    next -= basis.leftCols(k) * (basis.leftCols(k).adjoint() * next);
    basis.col(k) = next.normalized();
    columns -= basis.col(k) * (basis.col(k).adjoint() * columns);
  }
  return basis;
}

// Shapes of a Hermitian matrix whose eigenvalue is above a half, orthonormal. As a real matrix of twice the
// size it is symmetric, and has each eigenvalue twice; the projector on a space is the same either way.
MatrixXcd shapes_above_half(const MatrixXcd& hermitian) {
  const Index n = hermitian.rows();
  Eigen::MatrixXd doubled(2 * n, 2 * n);
  doubled << hermitian.real(), -hermitian.imag(), hermitian.imag(), hermitian.real();
  const mechanics::SymmetricModes modes = mechanics::symmetric_modes(doubled);
  const Index own = (modes.values.array() > 0.5).count();
  const Eigen::MatrixXd vectors = modes.vectors.rightCols(own);
  MatrixXcd projector(n, n);
  projector.real() = vectors.topRows(n) * vectors.topRows(n).transpose();
  projector.imag() = vectors.bottomRows(n) * vectors.topRows(n).transpose();
  return orthonormal(projector, own / 2);
}

}  // namespace

KindShares kind_shares(const SetModel& model, const Eigen::VectorXcd& shape) {
  const auto share = [&](ModeKind kind) {
    return projected(model, shape, kind).squaredNorm() / shape.squaredNorm();
  };
  return {share(ModeKind::rotational), share(ModeKind::translational), share(ModeKind::planet)};
}

std::vector<KindShapes> by_kind(const SetModel& model, const MatrixXcd& shapes) {
  const MatrixXcd basis = orthonormal(shapes, shapes.cols());
  std::vector<KindShapes> parts;
  for (const ModeKind kind : {ModeKind::rotational, ModeKind::translational, ModeKind::planet}) {
    // In the space spanned, the shapes of this kind are those that its projector leaves alone.
    const MatrixXcd own = shapes_above_half(basis.adjoint() * projected(model, basis, kind));
    if (own.cols() > 0) parts.push_back({kind, basis * own});
  }
  return parts;
}

bool excites(const std::vector<double>& angles, int teeth, ModeKind kind) {
  constexpr double none = 1e-9;  // [-]  of forces that cancel
  const auto planets = static_cast<Index>(angles.size());
  Eigen::VectorXcd force(planets);  // of the meshes on the planets, one after the other
  for (Index n = 0; n < planets; ++n) force[n] = std::polar(1.0, teeth * angles[static_cast<std::size_t>(n)]);
  if (kind == ModeKind::planet)
    return (patterns(angles, kind).transpose() * force).norm() > none * force.norm();
  const auto total = [&](int turn) {  // on a central member: its moment, or its force seen from one side
    std::complex<double> sum = 0.0;
    for (Index n = 0; n < planets; ++n)
      sum += force[n] * std::polar(1.0, turn * angles[static_cast<std::size_t>(n)]);
    return std::abs(sum) / static_cast<double>(planets);
  };
  return kind == ModeKind::rotational ? total(0) > none : total(1) > none || total(-1) > none;
}

}  // namespace orbearing::gearset::dynamics
