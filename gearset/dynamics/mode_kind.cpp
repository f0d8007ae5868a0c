#include "gearset/dynamics/mode_kind.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <complex>

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

MatrixXcd orthonormal(const MatrixXcd& shapes) {
  return Eigen::HouseholderQR<MatrixXcd>(shapes).householderQ() *
         MatrixXcd::Identity(shapes.rows(), shapes.cols());
}

}  // namespace

KindShares kind_shares(const SetLayout& layout, const Eigen::VectorXcd& shape) {
  const auto share = [&](ModeKind kind) {
    return projected(layout, shape, kind).squaredNorm() / shape.squaredNorm();
  };
  return {share(ModeKind::rotational), share(ModeKind::translational), share(ModeKind::planet)};
}

std::vector<KindShapes> by_kind(const SetLayout& layout, const MatrixXcd& shapes) {
  const MatrixXcd basis = orthonormal(shapes);
  std::vector<KindShapes> parts;
  std::vector<bool> taken(static_cast<std::size_t>(basis.cols()), false);
  for (const ModeKind kind : {ModeKind::rotational, ModeKind::translational, ModeKind::planet}) {
    // In the space spanned, the shapes of this kind are those that its projector leaves alone.
    const MatrixXcd share = basis.adjoint() * projected(layout, basis, kind);
    const Eigen::SelfAdjointEigenSolver<MatrixXcd> solver(share);
    const Index own = (solver.eigenvalues().array() > 0.5).count();
    if (own > 0) parts.push_back({kind, basis * solver.eigenvectors().rightCols(own)});
  }
  return parts;
}

}  // namespace orbearing::gearset::dynamics
