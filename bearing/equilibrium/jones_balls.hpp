// A rotating row of balls: each ball has a centrifugal load and a gyroscopic moment, and so touches both
// races at different angles under different loads [Jones1960], [Harris2006].
//
// At rest the row is that of balls.hpp.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bearing/equilibrium/ball_forces.hpp"
#include "bearing/equilibrium/ball_motion.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "mechanics/described.hpp"
#include "mechanics/root_search.hpp"

namespace orbearing::bearing::equilibrium {

/// Effects of the motion of balls on their equilibrium.
struct BallInertia {
  bool enabled = true;
  BallAttitude attitude = BallAttitude::minimum_friction;
  GyroscopicMoment gyroscopic_moment = GyroscopicMoment::balanced;
};

template <class Visitor>
void describe(Visitor& visit, BallInertia& m) {
  using namespace described;
  members(visit, m,
          input(m.enabled, "equilibrium.ball_inertia", "centrifugal force and gyroscopic moment of the balls",
                {.reason = "nothing left out"}),
          input(m.attitude, "equilibrium.ball_attitude",
                "condition for the directions of the balls' axes and for the race that holds their "
                "gyroscopic moment",
                {.reason = "traction that grows with slip, as that of an oil film",
                 .where = {"equilibrium.ball_inertia", "true"}}),
          input(m.gyroscopic_moment, "equilibrium.gyroscopic_moment",
                "gyroscopic moment of the balls: rate of their angular momentum, opposite sign as published "
                "in textbooks, or none",
                {.reason = "the rate of angular momentum", .where = {"equilibrium.ball_inertia", "true"}}));
}

/// Motion of a row, and film in its contacts.
struct RowMotion {
  RingSpeeds speeds;
  BallInertia inertia;
  std::optional<Lubricant> film{};  // whose film replaces Hertz's approach, film/spin_film.hpp

  /// Whether it acts on balls. Else their row is that at rest.
  bool moves_balls() const { return !speeds.at_rest() && (inertia.enabled || film.has_value()); }
};

/// One ball in equilibrium.
struct JonesBall {
  ContactNormal<double> inner;
  ContactNormal<double> outer;
  double inner_load = 0.0;         // [N]
  double outer_load = 0.0;         // [N]
  double inner_traction = 0.0;     // [N]  on the ball along t, which holds its gyroscopic moment
  double outer_traction = 0.0;     // [N]
  double centrifugal_force = 0.0;  // [N]
  double gyroscopic_moment = 0.0;  // [N m]  of the races on the ball
  BallMotion<double> motion{};
};

/// Common constants of the balls of a row in motion. Throws std::invalid_argument as BallRow does.
BallLaw<double> ball_law(const Bearing& bearing, const RowMotion& motion, const BallRow& at_rest);

class JonesRow : public RingRow {
 public:
  /// Throws std::invalid_argument as BallRow does.
  JonesRow(const Bearing& bearing, const RowMotion& motion);
  /// The same, of a bearing whose row at rest is there.
  JonesRow(const Bearing& bearing, const RowMotion& motion, const BallRow& at_rest);

  bool follows_motion() const override { return !frozen_; }
  double lever() const override { return geometry_.lever(); }
  double reach(double load) const override;
  /// Derivatives of a ball's forces and moment by the coordinates of the ring.
  using RingActs = Eigen::Matrix<double, 5, 3>;
  RingActs acts_of(Eigen::Index ball) const;
  /// Stores the equilibria of the balls as the start of the next search.
  void add_forces(const RingPosition& position, RingImbalance& sum) const override;
  void put_loads(const RingPosition& position, RingState& state) const override;
  /// Whether the equilibria of all balls were found the last time.
  bool settled() const { return settled_; }
  /// Race control only: gives each ball the race that resists its spin more, by its loads of the last time.
  /// Whether a ball changed.
  bool choose_control();
  /// While frozen, on balls acts a centrifugal force of their orbit at the nominal contact angle and nothing
  /// else of their motion: what is left has a convex energy.
  void freeze(bool frozen);
  /// Centrifugal forces of the frozen row, unlike by a pattern that hangs on `path`; alike for 0. Forgets
  /// where the balls were.
  void push_unlike(int path);
  /// Whether the ring, at the position of the stored loads, has a defined stiffness. If a ball neither rolls
  /// on the inner race nor has left it, the equilibrium can be at the end of a law: there the ring deflects
  /// under no force, or under any.
  bool has_stiffness() const;
  /// Balls that are loaded, at the position of the stored loads, where the groove is vertical and has ended.
  int beyond_grooves() const;
  /// Positions of the balls (2 each, from their outer groove centre) [m].
  Eigen::VectorXd ball_positions() const;
  /// Takes such positions over, with that of the ring.
  void put_positions(const RingPosition& ring, const Eigen::VectorXd& balls);
  /// Forces on ring (5) and balls, without the outer load; their scale is the sum of the contact loads.
  mechanics::Imbalance<Eigen::Dynamic> all_forces(const RingPosition& ring,
                                                  const Eigen::VectorXd& balls) const;

  const BallRow& geometry() const { return geometry_; }
  const std::vector<JonesBall>& balls() const { return balls_; }  // where the loads were put

 private:
  struct BallMemory {
    Eigen::Vector2d grooves = Eigen::Vector2d::Zero();   // [m]  where it was found
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]  from the outer groove centre
    Eigen::Matrix2d follows = Eigen::Matrix2d::Zero();   // how the ball follows the groove centres
    Eigen::Vector3d ring = Eigen::Vector3d::Zero();      // [N], [N], [N m]  on the ring
    Eigen::Matrix<double, 3, 2> slope = Eigen::Matrix<double, 3, 2>::Zero();  // of it by the groove centres
    double push = 0.0;                                                        // [N]  outward, while frozen
    double load = 0.0;                                                        // [N]  on the inner race
    bool found = false;
    SpinControl control = SpinControl::outer;
    bool changed_before = false;
  };
  struct BallForces;
  template <class T, class Outer, class Inner>
  BallForcesOf<T> forces_of(const Outer& outer_r, const Outer& outer_z, const Inner& inner_r,
                            const Inner& inner_z, const BallMemory& ball) const;
  void settle(const Eigen::Vector2d& grooves, BallMemory& ball) const;
  void remember(BallForces& at, BallMemory& ball) const;
  void settle_from(const Eigen::Vector2d& start, const Eigen::Vector2d& grooves, BallMemory& ball) const;
  Eigen::Vector2d default_position(const Eigen::Vector2d& grooves) const;
  Eigen::Vector2d grooves_at(Eigen::Index ball, const RingPosition& position) const;
  JonesBall ball_at(const BallMemory& ball) const;

  BallRow geometry_;
  BallLaw<double> law_;
  double default_centrifugal_ = 0.0;  // [N]  at the nominal contact angle
  bool frozen_ = false;
  mutable bool settled_ = true;
  mutable std::optional<RingPosition> known_;  // where the memory holds the forces
  mutable std::vector<BallMemory> memory_;
  mutable std::vector<JonesBall> balls_;
};

}  // namespace orbearing::bearing::equilibrium
