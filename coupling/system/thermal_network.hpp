// A few bodies of one temperature each, which take in heat and pass it on: C T' = W - G (T - T_0).
#pragma once

#include <Eigen/Core>

namespace orbearing::system {

class ThermalNetwork {
 public:
  /// `capacity` [J/K] of each body; `between` [W/K], symmetric, of which the diagonal is not read; `outward` [W/K]
  /// to what has the temperature `outside` [degC] beside that body. Throws std::invalid_argument where a capacity is
  /// not positive, a conductance negative, or a body has no way outward for its heat.
  ThermalNetwork(const Eigen::VectorXd& capacity, const Eigen::MatrixXd& between, const Eigen::VectorXd& outward,
                 const Eigen::VectorXd& outside);

  Eigen::Index size() const { return capacity_.size(); }
  /// Temperatures [degC] at which as much leaves as comes in: `heat` [W] of each body.
  Eigen::VectorXd steady(const Eigen::VectorXd& heat) const;
  /// Temperatures [degC] after `time` [s] of steady `heat` from `temperature` on: exact.
  Eigen::VectorXd after(const Eigen::VectorXd& temperature, const Eigen::VectorXd& heat, double time) const;
  /// What leaves to the outside [W].
  double leaving(const Eigen::VectorXd& temperature) const;
  /// Longest and shortest time in which a difference falls to 1/e [s].
  double longest_time() const;
  double shortest_time() const;

 private:
  Eigen::VectorXd capacity_, outward_, outside_;
  Eigen::MatrixXd conductance_;  // [W/K]
  Eigen::VectorXd rates_;        // [1/s]  of the modes
  Eigen::MatrixXd modes_;        // of C^(-1/2) G C^(-1/2)
};

}  // namespace orbearing::system
