// A smooth function of the drop, through its values at few drops.
#pragma once

#include <Eigen/Core>

namespace orbearing::study::crowning {

/// Drops [m] from 0 to `greatest` at which a function is to be known: `intervals` + 1 nodes of Chebyshev,
/// dense at both ends. Every second one of twice as many is one of these.
Eigen::ArrayXd curve_nodes(double greatest, int intervals);

/// The polynomial through values at curve_nodes(), by the barycentric formula [Berrut2004].
class DropCurve {
 public:
  DropCurve(double greatest, Eigen::ArrayXd values);

  /// At a drop [m]; beyond the nodes the value at the end.
  double operator()(double drop) const;

 private:
  Eigen::ArrayXd nodes_;  // [m]
  Eigen::ArrayXd values_;
};

}  // namespace orbearing::study::crowning
