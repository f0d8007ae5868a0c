#include "gearset/dynamics/mode_kind.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <complex>

#include "mechanics/linear_algebra.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using boost::math::double_constants::two_pi;
using Eigen::Index;
using Eigen::MatrixXcd;

// How often a motion of the planets goes round with their place: its discrete Fourier component. Components
// beyond half the number of planets go round the other way.
ModeKind kind_of_component(Index component, Index planets) {
  const Index rounds = std::min(component, planets - component);
  return rounds == 0 ? ModeKind::rotational : rounds == 1 ? ModeKind::translational : ModeKind::planet;
}

// The share of each column that belongs to `kind`.
MatrixXcd projected(const SetLayout& layout, const MatrixXcd& shapes, ModeKind kind) {
  MatrixXcd part = MatrixXcd::Zero(shapes.rows(), shapes.cols());
  for (Index place = 0; place < SetLayout::planet(0); place += 3) {
    if (kind == ModeKind::translational) part.middleRows(place, 2) = shapes.middleRows(place, 2);
    if (kind == ModeKind::rotational) part.row(place + 2) = shapes.row(place + 2);
  }
  const double planets = static_cast<double>(layout.planets);
  for (Index component = 0; component < layout.planets; ++component) {
    if (kind_of_component(component, layout.planets) != kind) continue;
    const auto turn = [&](Index n) {
      return std::polar(1.0, two_pi * static_cast<double>(component * n) / planets);
    };
    MatrixXcd amplitude = MatrixXcd::Zero(3, shapes.cols());
    for (Index n = 0; n < layout.planets; ++n)
      amplitude += std::conj(turn(n)) / planets * shapes.middleRows(SetLayout::planet(n), 3);
    for (Index n = 0; n < layout.planets; ++n)
      part.middleRows(SetLayout::planet(n), 3) += turn(n) * amplitude;
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

KindShares kind_shares(const SetLayout& layout, const Eigen::VectorXcd& shape) {
  const auto share = [&](ModeKind kind) {
    return projected(layout, shape, kind).squaredNorm() / shape.squaredNorm();
  };
  return {share(ModeKind::rotational), share(ModeKind::translational), share(ModeKind::planet)};
}

std::vector<KindShapes> by_kind(const SetLayout& layout, const MatrixXcd& shapes) {
  const MatrixXcd basis = orthonormal(shapes, shapes.cols());
  std::vector<KindShapes> parts;
  for (const ModeKind kind : {ModeKind::rotational, ModeKind::translational, ModeKind::planet}) {
    // In the space spanned, the shapes of this kind are those that its projector leaves alone.
    const MatrixXcd own = shapes_above_half(basis.adjoint() * projected(layout, basis, kind));
    if (own.cols() > 0) parts.push_back({kind, basis * own});
  }
  return parts;
}

}  // namespace orbearing::gearset::dynamics
