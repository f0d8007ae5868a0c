// A row of balls between two grooved races under a static load, without inertia, [ISO16281].
#pragma once

#include <Eigen/Core>
#include <utility>

#include "bearing/contact/point_contact.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::bearing::equilibrium {

/// Data of the row that are independent of the load.
class BallRow : public RingRow {
 public:
  /// Throws std::invalid_argument where the elements are no balls, grooves are no wider than balls or the
  /// clearance leaves no contact.
  explicit BallRow(const Bearing& bearing);

  double lever() const override { return lever_; }
  double reach(double load) const override;
  void add_forces(const RingPosition& position, RingImbalance& sum) const override;
  void put_loads(const RingPosition& position, RingState& state) const override;

  double groove_distance() const { return groove_distance_; }  // [m]  of the centres, just touching: A
  double radial_distance() const { return radial_distance_; }  // [m]  concentric: A cos(alpha) - s/2
  double axial_distance() const { return axial_distance_; }    // [m]  concentric: A sin(alpha)
  double free_angle() const;                                   // [rad]  concentric, play taken up; 0: no play
  double constant() const { return constant_; }                // [N/m^1.5]  of both contacts in series
  /// Relative position of the groove centres of one ball.
  struct BallPosition {
    double radial;    // [m]
    double axial;     // [m]
    double length;    // [m]
    double approach;  // [m]  positive in contact
  };
  BallPosition position_of(Eigen::Index ball, const RingPosition& position) const;
  /// Radial and axial distance of the groove centres of one ball [m], and their derivatives by the position
  /// of the ring.
  Eigen::Vector2d coordinates(Eigen::Index ball, const RingPosition& position) const;
  Eigen::Matrix<double, 5, 2> moves(Eigen::Index ball) const;
  /// Cosine and sine of a ball's angle from the radial load.
  std::pair<double, double> direction(Eigen::Index ball) const { return {cosine_[ball], sine_[ball]}; }
  Eigen::Index count() const { return cosine_.size(); }

  const PointContact& contact(Race race) const { return race == Race::inner ? inner_ : outer_; }

 private:
  double groove_distance_ = 0.0;
  double radial_distance_ = 0.0;
  double axial_distance_ = 0.0;
  double lever_ = 0.0;
  double constant_ = 0.0;
  PointContact inner_;
  PointContact outer_;
  Eigen::ArrayXd cosine_;  // (balls)  of their angles
  Eigen::ArrayXd sine_;
};

}  // namespace orbearing::bearing::equilibrium
