#include "coupling/system/thermal_network.hpp"

#include <Eigen/Cholesky>

#include "mechanics/checks.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::system {

ThermalNetwork::ThermalNetwork(const Eigen::VectorXd& capacity, const Eigen::MatrixXd& between,
                               const Eigen::VectorXd& outward, const Eigen::VectorXd& outside)
    : capacity_(capacity), outward_(outward), outside_(outside) {
  using mechanics::require;
  const Eigen::Index n = capacity.size();
  require(capacity.minCoeff() > 0.0, "heat capacity [J/K]", capacity.minCoeff(), "more than 0");
  require(between.minCoeff() >= 0.0, "thermal conductance [W/K]", between.minCoeff(), "0 or more");
  require(outward.minCoeff() >= 0.0, "thermal conductance to the outside [W/K]", outward.minCoeff(),
          "0 or more");
  conductance_ = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    conductance_(i, i) = outward[i];
    for (Eigen::Index k = 0; k < n; ++k) {
      if (k == i) continue;
      conductance_(i, k) = -between(i, k);
      conductance_(i, i) += between(i, k);
    }
  }
  const Eigen::VectorXd scale = capacity.cwiseSqrt().cwiseInverse();
  const mechanics::SymmetricModes decay =
      mechanics::symmetric_modes(scale.asDiagonal() * conductance_ * scale.asDiagonal());
  rates_ = decay.values;
  modes_ = decay.vectors;
  require(rates_.minCoeff() > 1e-12 * rates_.maxCoeff(), "slowest rate of the thermal network [1/s]",
          rates_.minCoeff(), "more than 0: every body needs a way outward for its heat");
}

Eigen::VectorXd ThermalNetwork::steady(const Eigen::VectorXd& heat) const {
  return conductance_.ldlt().solve(heat + outward_.cwiseProduct(outside_));
}

Eigen::VectorXd ThermalNetwork::after(const Eigen::VectorXd& temperature, const Eigen::VectorXd& heat,
                                      double time) const {
  const Eigen::VectorXd end = steady(heat), root = capacity_.cwiseSqrt();
  const Eigen::VectorXd part = modes_.transpose() * root.cwiseProduct(temperature - end);
  const Eigen::VectorXd left = (-time * rates_).array().exp() * part.array();
  return end + (modes_ * left).cwiseQuotient(root);
}

double ThermalNetwork::leaving(const Eigen::VectorXd& temperature) const {
  return outward_.dot(temperature - outside_);
}

double ThermalNetwork::longest_time() const {
  return 1.0 / rates_.minCoeff();
}

double ThermalNetwork::shortest_time() const {
  return 1.0 / rates_.maxCoeff();
}

}  // namespace orbearing::system
