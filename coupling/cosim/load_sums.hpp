// Loads of one bearing by place on its races, summed over time, and the life that they use up.
#pragma once

#include <Eigen/Core>

#include "bearing/dynamics/statistics.hpp"
#include "coupling/cosim/participant.hpp"

namespace orbearing::cosim {

/// Sums since the start. The pin's race stands relative to the load, that of the bore turns.
struct LoadSums {
  Eigen::ArrayXd passages;  // [s]      (places)  time that rollers spent there
  Eigen::ArrayXd inner;     // [N^4 s]  (places)
  Eigen::ArrayXd outer;     // [N^4 s]  (places)

  explicit LoadSums(Eigen::Index places)
      : passages(Eigen::ArrayXd::Zero(places)), inner(passages), outer(passages) {}

  /// Loads [N] of `rollers` rollers at `angle` [rad], which last for `time` [s].
  void add(double time, Eigen::Index rollers, const double* angle, const double* inner_load,
           const double* outer_load) {
    for (Eigen::Index j = 0; j < rollers; ++j) {
      const Eigen::Index place = bearing::dynamics::place_of(angle[j], passages.size());
      const double inner_square = inner_load[j] * inner_load[j], outer_square = outer_load[j] * outer_load[j];
      passages[place] += time;
      inner[place] += time * inner_square * inner_square;
      outer[place] += time * outer_square * outer_square;
    }
  }

  /// Life [rev] under the mean of the loads so far; infinite where there are none.
  bearing::BearingLife life(const bearing::CylindricalRollerBearing& bearing, double lambda) const {
    const Eigen::ArrayXd time = (passages > 0.0).select(passages, 1.0);
    bearing::dynamics::WindowStatistics means;
    means.inner.mean_fourth_power = inner / time;
    means.outer.mean_fourth_power = outer / time;
    return bearing::dynamics::dynamic_life(bearing, lambda, bearing::Race::inner, means);
  }
};

}  // namespace orbearing::cosim
