// The waves of an elastic outer race as coordinates of an equilibrium: that of order 0, then cosine and sine
// of each order from 2 on, all as displacements of the race outward [m]. Eqs. (19) to (21) of
// bearing/README.md.
#pragma once

#include <Eigen/Core>

#include "bearing/operating_point.hpp"
#include "mechanics/convex_search.hpp"

namespace orbearing::bearing {

/// Number of coordinates; 0 of a rigid race.
Eigen::Index wave_count(const ElasticRace& race);

/// Expands values given by order to one value for each wave.
Eigen::VectorXd waves_of_orders(const ElasticRace& race, const Eigen::ArrayXd& stated);

/// Stiffness of the race against each wave [N/m], and its waves without rollers [m].
Eigen::VectorXd wave_stiffness(const ElasticRace& race);
Eigen::VectorXd waves_at_rest(const ElasticRace& race);

/// Outward displacement of the race by each wave at `angle` [rad].
Eigen::VectorXd wave_shapes(const ElasticRace& race, double angle);

/// Adds `share` of the displacement of the race at all `angles` [rad] to `form` [m].
void add_form(const Eigen::VectorXd& waves, double share, const Eigen::ArrayXd& angles, Eigen::ArrayXd& form);

/// Stiffness against the first `kept` coordinates where all that come after them follow without force.
Eigen::MatrixXd without_waves(const Eigen::MatrixXd& stiffness, Eigen::Index kept);

/// [N/m]  of the ring against its displacement, where the waves follow without force.
template <int N>
Eigen::Matrix2d without_waves(const mechanics::Imbalance<N>& balance) {
  if constexpr (N == 2)
    return balance.stiffness;
  else
    return without_waves(balance.stiffness, 2);
}

}  // namespace orbearing::bearing
