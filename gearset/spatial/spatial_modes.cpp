#include "gearset/spatial/spatial_modes.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "gearset/spatial/spatial_balance.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::gearset::spatial {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr int kSlices = 200;             // of the face: they resist a tilt by 1/40000 less than a whole
constexpr double kSameFrequency = 1e-6;  // [-]  of the largest: closer ones are one
constexpr double kNoFrequency = 1e-6;    // [-]  of the largest: round-off of a zero eigenvalue's root

// Mass matrix at the middle of a body, rotations times the lever: eccentric mass couples displacement and
// tilt.
Matrix6d mass_of(const RoundBody& body, double lever) {
  const double arm = body.centre / lever, square = 1.0 / (lever * lever);
  const double tilt = body.transverse * square + body.mass * arm * arm;
  Matrix6d mass = Matrix6d::Zero();
  mass.diagonal() << body.mass, body.mass, body.mass, tilt, tilt, body.polar * square;
  // A rotation r moves the centre by r x (arm z): (r_y, -r_x, 0) arm.
  mass(0, 4) = mass(4, 0) = body.mass * arm;
  mass(1, 3) = mass(3, 1) = -body.mass * arm;
  return mass;
}

Matrix6d stiffness_of(const BodySupport& support, double lever) {
  const double square = 1.0 / (lever * lever);
  Matrix6d stiffness = Matrix6d::Zero();
  stiffness.diagonal() << support.radial, support.radial, support.axial, support.tilt * square,
      support.tilt * square, support.torsion * square;
  return stiffness;
}

// Bodies in the order of their coordinates.
struct Members {
  std::vector<const RoundBody*> body;
  std::vector<const BodySupport*> support;
};

Members members_of(const MovingSet& moving) {
  static const BodySupport none;
  Members all{{&moving.carrier, &moving.sun}, {&moving.carrier_support, &moving.sun_support}};
  for (std::size_t p = 0; p < moving.set.angles.size(); ++p) {
    all.body.push_back(&moving.planet);
    all.support.push_back(&none);
  }
  if (moving.ring.mass > 0.0) {
    all.body.push_back(&moving.ring);
    all.support.push_back(&moving.ring_support);
  }
  return all;
}

std::vector<Index> free_freedoms(const Members& members) {
  std::vector<Index> free;
  for (std::size_t i = 0; i < members.body.size(); ++i)
    for (Index direction = 0; direction < 6; ++direction)
      if (direction < 5 || !members.support[i]->held_in_rotation)
        free.push_back(6 * static_cast<Index>(i) + direction);
  return free;
}

// Energies of single motions of the shapes in the columns, over the whole and their number.
VectorXd energy_shares(const MatrixXd& shapes, const MatrixXd& mass) {
  return (shapes.array() * (mass * shapes).array()).rowwise().sum() / static_cast<double>(shapes.cols());
}

SpatialMode mode_of(const MatrixXd& shapes, const MatrixXd& mass, double frequency, std::size_t planets) {
  SpatialMode mode;
  mode.frequency = frequency;
  mode.multiplicity = static_cast<int>(shapes.cols());
  const VectorXd share = energy_shares(shapes, mass);
  for (Index i = 0; i < share.size(); ++i) {
    const Index direction = i % 6, body = i / 6;
    (direction == 2                     ? mode.axial
     : direction == 3 || direction == 4 ? mode.tilting
                                        : mode.in_plane) += share[i];
    (body == 0                                ? mode.carrier
     : body == 1                              ? mode.sun
     : body < 2 + static_cast<Index>(planets) ? mode.planets
                                              : mode.ring) += share[i];
  }
  const VectorXd first = shapes.col(0) / shapes.col(0).cwiseAbs().maxCoeff();
  mode.shape = first.reshaped<Eigen::RowMajor>(first.size() / 6, 6);
  return mode;
}

}  // namespace

std::vector<SpatialMode> modes_at_rest(const MovingSet& moving) {
  const Members members = members_of(moving);
  const double lever = moving.set.centre_distance;
  MatrixXd stiffness = closed_stiffness(moving.set, kSlices, moving.ring.mass > 0.0);
  MatrixXd mass = MatrixXd::Zero(stiffness.rows(), stiffness.cols());
  for (std::size_t i = 0; i < members.body.size(); ++i) {
    const Index at = 6 * static_cast<Index>(i);
    mass.block<6, 6>(at, at) = mass_of(*members.body[i], lever);
    stiffness.block<6, 6>(at, at) += stiffness_of(*members.support[i], lever);
  }
  const std::vector<Index> free = free_freedoms(members);
  const Eigen::LLT<MatrixXd> root(MatrixXd(mass(free, free)));  // mass = L L^T
  const MatrixXd half = root.matrixL().solve(MatrixXd(stiffness(free, free)));
  const mechanics::SymmetricModes found = mechanics::symmetric_modes(root.matrixL().solve(half.transpose()));
  MatrixXd shapes = MatrixXd::Zero(mass.rows(), static_cast<Index>(free.size()));
  shapes(free, Eigen::all) = MatrixXd(root.matrixU().solve(found.vectors));
  const VectorXd frequency = found.values.cwiseMax(0.0).cwiseSqrt() / constants::two_pi;
  const double largest = frequency.maxCoeff();
  std::vector<SpatialMode> modes;
  for (Index begin = 0, end = 0; begin < frequency.size(); begin = end) {
    while (end < frequency.size() && frequency[end] - frequency[begin] <= kSameFrequency * largest) ++end;
    const double mean = frequency.segment(begin, end - begin).mean();
    modes.push_back(mode_of(shapes.middleCols(begin, end - begin), mass,
                            mean > kNoFrequency * largest ? mean : 0.0, moving.set.angles.size()));
  }
  return modes;
}

}  // namespace orbearing::gearset::spatial
