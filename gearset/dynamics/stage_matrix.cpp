#include "gearset/dynamics/stage_matrix.hpp"

#include <Eigen/LU>
#include <cmath>

namespace orbearing::gearset::dynamics {

void StageMatrix::assemble(const SetModel& model, const ForceSlopes& slopes, double g) {
  const double square = g * g;
  const auto take = [&](Eigen::Index row, Eigen::Index column, auto& block) {
    constexpr int rows = std::remove_reference_t<decltype(block)>::RowsAtCompileTime,
                  columns = std::remove_reference_t<decltype(block)>::ColsAtCompileTime;
    block = -g * slopes.by_velocity.block<rows, columns>(row, column) -
            square * slopes.by_position.block<rows, columns>(row, column);
  };
  planets_.resize(static_cast<std::size_t>(model.layout.planets));
  take(0, 0, centre_);
  centre_.diagonal() += model.mass.head<kCentre>();
  for (std::size_t n = 0; n < planets_.size(); ++n) {
    const Eigen::Index index = SetLayout::planet(static_cast<Eigen::Index>(n));
    take(index, index, planets_[n].own);
    take(index, 0, planets_[n].by_centre);
    take(0, index, planets_[n].centre_by);
    planets_[n].own.diagonal() += model.mass.segment<3>(index);
  }
}

void StageMatrix::add_port(const SetModel& model, Eigen::Index planet, const Eigen::Matrix3d& of_carrier,
                           const Eigen::Matrix3d& of_planet, const Eigen::Matrix3d& matrix) {
  constexpr Eigen::Index carrier = SetLayout::carrier();
  const Eigen::Matrix3d by_carrier = matrix * of_carrier, by_planet = matrix * of_planet;
  Planet& at = planets_[static_cast<std::size_t>(planet)];
  centre_.block<3, 3>(carrier, carrier) += of_carrier.transpose() * by_carrier;
  at.centre_by.middleRows<3>(carrier) += of_carrier.transpose() * by_planet;
  at.by_centre.middleCols<3>(carrier) += of_planet.transpose() * by_carrier;
  at.own += of_planet.transpose() * by_planet;
  if (model.load_index < 0) return;
  centre_.row(model.load_index).segment<3>(carrier) += model.load_share * by_carrier.row(2);
  at.centre_by.row(model.load_index) += model.load_share * by_planet.row(2);
}

bool StageMatrix::factor(const SetModel& model) {
  for (int i = 0; i < kCentre; ++i) {
    if (model.mobility[i] != 0.0) continue;
    centre_.row(i).setZero();
    centre_(i, i) = 1.0;
    for (Planet& planet : planets_) planet.centre_by.row(i).setZero();
  }
  for (Planet& planet : planets_) {
    const Eigen::Matrix3d inverse = planet.own.inverse();
    if (!inverse.allFinite()) return false;
    planet.own = inverse;
    planet.by_centre = inverse.lazyProduct(planet.by_centre).eval();
    centre_ -= planet.centre_by.lazyProduct(planet.by_centre);
  }
  return factor_centre();
}

bool StageMatrix::factor_centre() {
  for (int p = 0; p < kCentre; ++p) {
    const double inverse = 1.0 / centre_(p, p);
    if (!std::isfinite(inverse)) return false;
    centre_(p, p) = inverse;
    for (int i = p + 1; i < kCentre; ++i) {
      const double share = centre_(i, p) * inverse;
      centre_(i, p) = share;
      for (int k = p + 1; k < kCentre; ++k) centre_(i, k) -= share * centre_(p, k);
    }
  }
  return true;
}

void StageMatrix::solve(Eigen::Ref<Eigen::VectorXd> b) const {
  Eigen::Matrix<double, kCentre, 1> centre = b.head<kCentre>();
  for (std::size_t n = 0; n < planets_.size(); ++n) {
    auto own = b.segment<3>(SetLayout::planet(static_cast<Eigen::Index>(n)));
    own = (planets_[n].own * own).eval();
    centre.noalias() -= planets_[n].centre_by * own;
  }
  for (int i = 1; i < kCentre; ++i)
    for (int k = 0; k < i; ++k) centre[i] -= centre_(i, k) * centre[k];
  for (int i = kCentre - 1; i >= 0; --i) {
    for (int k = i + 1; k < kCentre; ++k) centre[i] -= centre_(i, k) * centre[k];
    centre[i] *= centre_(i, i);
  }
  b.head<kCentre>() = centre;
  for (std::size_t n = 0; n < planets_.size(); ++n)
    b.segment<3>(SetLayout::planet(static_cast<Eigen::Index>(n))) -= planets_[n].by_centre * centre;
}

}  // namespace orbearing::gearset::dynamics
