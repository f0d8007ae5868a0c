// The balance of the outer ring on its rollers: two force equations for the displacement of the races.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "bearing/contact/race_contact.hpp"
#include "bearing/elastic_race.hpp"
#include "bearing/equilibrium/quasi_static_state.hpp"
#include "bearing/geometry.hpp"
#include "mechanics/convex_search.hpp"

namespace orbearing::bearing {

/// What the races must balance at one cage angle. Arrays are over rollers.
struct RaceEquilibrium {
  RollerContacts contacts;
  double clearance = 0.0;                          // [m]    diametral
  Eigen::Vector2d load = Eigen::Vector2d::Zero();  // [N]  on the outer ring
  Eigen::ArrayXd angle = {};                       // [rad]
  Eigen::ArrayXd inertial_load = {};               // [N]    of each roller, outward positive
  Eigen::ArrayXd extra_approach = {};  // [m]    by unequal rollers and races that are not round; empty: none
  ElasticRace outer_race = {};         // how the outer race bends

  /// Approach of the races at roller `j` [m] when a rigid outer ring is displaced by `displacement` [m].
  double approach(Eigen::Index j, const Eigen::Vector2d& displacement) const;
  /// [N]  the largest of the forces that balance
  double force_scale() const;
  /// Forces on a rigid outer ring at `displacement` [m].
  mechanics::Imbalance<2> imbalance(const Eigen::Vector2d& displacement) const;
};

/// Coordinates of the outer ring in a search: its displacement along x and y [m], then the waves of an
/// elastic race (elastic_waves.hpp). N = 2 where the race is rigid, else Eigen::Dynamic.
template <int N>
class RingCoordinates {
 public:
  using Place = Eigen::Vector<double, N>;

  explicit RingCoordinates(const RaceEquilibrium& problem);

  Eigen::Index size() const { return outward_.rows(); }
  /// How far each coordinate moves the race away from roller `j`.
  auto outward(Eigen::Index j) const { return outward_.col(j); }
  double approach(Eigen::Index j, const Place& place) const {
    return concentric_[j] - place.dot(outward_.col(j));
  }
  /// Forces on the ring at `place` where `bears(j, approach)` says what roller j does: a structure with its
  /// outer_load [N] and stiffness [N/m].
  template <class Rollers>
  mechanics::Imbalance<N> imbalance(const Place& place, Rollers&& bears) const {
    mechanics::Imbalance<N> sum = without_rollers(place);
    for (Eigen::Index j = 0; j < outward_.cols(); ++j) {
      const auto roller = bears(j, approach(j, place));
      sum.force += roller.outer_load * outward_.col(j);
      sum.stiffness += roller.stiffness * outward_.col(j) * outward_.col(j).transpose();
    }
    return sum;
  }
  /// The load, and what the race itself resists at `place`.
  mechanics::Imbalance<N> without_rollers(const Place& place) const;
  /// Where the waves stand without rollers, for a ring displaced by `displacement` [m].
  Place start(const Eigen::Vector2d& displacement) const;

 private:
  Eigen::Matrix<double, N, Eigen::Dynamic> outward_;  // [-]  (coordinates, rollers)
  Eigen::ArrayXd concentric_;                         // [m]  (rollers)
  Eigen::Vector2d load_;                              // [N]
  double scale_ = 0.0;                                // [N]
  Eigen::VectorXd wave_stiffness_;                    // [N/m]  (coordinates beyond the second)
  Eigen::VectorXd wave_at_rest_;                      // [m]
};

extern template class RingCoordinates<2>;
extern template class RingCoordinates<Eigen::Dynamic>;

/// Where a search for the displacement of the races begins, and how far it may go: the rollers under the load
/// in contact, as far as one loaded roller asks.
Eigen::Vector2d first_displacement(const RaceEquilibrium& problem);
mechanics::SearchLimits search_limits(const RaceEquilibrium& problem);

/// Displacement, and waves of the outer race, at which the forces on the outer ring balance. The search starts
/// where the ring stands in `near`, if one is given: the balance of the same bearing under another load or at
/// another cage angle.
QuasiStaticState solve(const RaceEquilibrium& problem, const QuasiStaticState* near = nullptr);

/// Load on the outer race by the approach of the races, of each roller at the balance `state` [N/m].
Eigen::ArrayXd roller_stiffness(const RaceEquilibrium& problem, const QuasiStaticState& state);

/// How stiffly the outer ring resists displacement at the balance `state` [N/m], the waves of its race free
/// to follow.
Eigen::Matrix2d stiffness_at(const RaceEquilibrium& problem, const QuasiStaticState& state);

}  // namespace orbearing::bearing
