#include "coupling/study/affine_fit.hpp"

#include <cmath>
#include <stdexcept>

#include "mechanics/linear_algebra.hpp"

namespace orbearing::study {

namespace {

constexpr double kKept = 0.5;  // [-]  of the weight of earlier motions

using Eigen::Index;
using Eigen::MatrixXd;
using gearset::dynamics::AffineBearing;
using Unknowns =
    Eigen::Matrix<double, 4, 2>;  // stiffness over damping, transposed: force = -motion x unknowns

Unknowns unknowns_of(const AffineBearing& law) {
  Unknowns unknowns;
  unknowns << law.stiffness.transpose(), law.damping.transpose();
  return unknowns;
}

// The shortest of the least squares, so that what no motion shows stays zero. Departure from what is
// expected, in units of `known`: first as if nothing were known, for the scatter of the forces; then drawn to
// zero by as much as that scatter leaves open. `weight`: of all rows, of which those of the last motion have
// one each.
MatrixXd departure(const MatrixXd& motion, const MatrixXd& unexplained, double weight) {
  const MatrixXd free = mechanics::least_squares(motion, unexplained);
  const double scatter =
      (unexplained - motion * free).norm() / std::sqrt(static_cast<double>(unexplained.cols()) * weight);
  MatrixXd matrix(motion.rows() + 4, 4), right = MatrixXd::Zero(motion.rows() + 4, 2);
  matrix << motion, scatter * Eigen::Matrix4d::Identity();
  right.topRows(motion.rows()) = unexplained;
  return mechanics::least_squares(matrix, right);
}

// Dampers that give energy are chance, of a motion too short or too small: their symmetric part becomes the
// nearest one that gives none.
void take_energy(Unknowns& law) {
  const Eigen::Matrix2d damping = law.bottomRows<2>(), even = 0.5 * (damping + damping.transpose());
  const mechanics::SymmetricModes modes = mechanics::symmetric_modes(even);
  law.bottomRows<2>() +=
      modes.vectors * modes.values.cwiseMin(0.0).cwiseAbs().asDiagonal() * modes.vectors.transpose();
}

}  // namespace

AffineFit::AffineFit(double angular_frequency, int orders)
    : angular_frequency_(angular_frequency), orders_(static_cast<std::size_t>(orders)) {
  if (orders < 1) throw std::invalid_argument("orders of a fit: found none; required: at least 1");
}

void AffineFit::add(const system::BoreSample& sample) {
  Row row;
  row << sample.position.transpose(), sample.velocity.transpose(), sample.force.transpose();
  weight_ += sample.weight;
  sum_ += sample.weight * row;
  const double angle = std::fmod(angular_frequency_ * sample.time, 2.0 * M_PI);
  const double c = std::cos(angle), s = std::sin(angle);
  double cosine = sample.weight, sine = 0.0;
  for (Order& order : orders_) {
    const double turned = cosine * c - sine * s;
    sine = cosine * s + sine * c;
    cosine = turned;
    order.cosine += cosine * row;
    order.sine += sine * row;
    order.cosine_weight += cosine;
    order.sine_weight += sine;
  }
}

MatrixXd AffineFit::harmonics() const {
  const Row mean = sum_ / weight_;
  MatrixXd rows(2 * static_cast<Index>(orders_.size()), 6);
  for (Index k = 0; k < rows.rows() / 2; ++k) {
    const Order& order = orders_[static_cast<std::size_t>(k)];
    rows.row(2 * k) = 2.0 / weight_ * (order.cosine - order.cosine_weight * mean);
    rows.row(2 * k + 1) = 2.0 / weight_ * (order.sine - order.sine_weight * mean);
  }
  return rows;
}

void AffineFit::begin_motion() {
  const MatrixXd rows = std::sqrt(weight_) * harmonics();
  before_.conservativeResize(before_.rows() + rows.rows(), Eigen::NoChange);
  before_.bottomRows(rows.rows()) = rows;
  before_ *= std::sqrt(kKept);
  before_weight_ = kKept * (before_weight_ + weight_ * static_cast<double>(rows.rows()));
  orders_.assign(orders_.size(), {});
  sum_.setZero();
  weight_ = 0.0;
}

FittedBearing AffineFit::law(const AffineBearing& expected, const AffineBearing& before) const {
  const double stiffness = kExpectedStiffness * expected.stiffness.norm(), damping = expected.damping.norm();
  const Eigen::Vector4d known(stiffness, stiffness, damping, damping);
  const Unknowns prior = unknowns_of(expected);
  const auto fitted_to = [&](const MatrixXd& rows, double weight) {
    Unknowns found =
        prior + known.asDiagonal() * departure(rows.leftCols<4>() * known.asDiagonal(),
                                               -rows.rightCols<2>() - rows.leftCols<4>() * prior, weight);
    take_energy(found);
    return found;
  };
  const MatrixXd last = harmonics();
  MatrixXd all(before_.rows() + last.rows(), 6);
  all << before_ / std::sqrt(weight_), last;
  const double of_last = static_cast<double>(last.rows());
  const Unknowns found = fitted_to(all, of_last + before_weight_ / weight_);
  const MatrixXd motion = last.leftCols<4>(), force = last.rightCols<2>();
  const Row mean = sum_ / weight_;
  FittedBearing result;
  result.bearing.stiffness = found.topRows<2>().transpose();
  result.bearing.damping = found.bottomRows<2>().transpose();
  result.bearing.force = (mean.tail<2>() + mean.head<4>() * found).transpose();
  result.residual = (force + motion * found).norm() / force.norm();
  const Unknowns own = fitted_to(last, of_last), change = own - unknowns_of(before);
  const auto share = [&](const Unknowns& part, Index from) {
    return (motion.middleCols<2>(from) * part.middleRows<2>(from)).norm() /
           (motion.middleCols<2>(from) * own.middleRows<2>(from)).norm();
  };
  result.stiffness_change = share(change, 0);
  result.damping_change = share(change, 2);
  return result;
}

}  // namespace orbearing::study
