// A ball bearing in motion: its equations by the widest vector instructions that can run here, and what can be
// read off a state.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/motion/balls/engine.hpp"
#include "bearing/motion/balls/numbers.hpp"
#include "bearing/motion/balls/parameters.hpp"
#include "mechanics/packs/instruction_set.hpp"

namespace orbearing::bearing::balls {

/// From what a user states to the constants of a motion. Throws std::invalid_argument for rollers, for
/// grooves no wider than balls, and where masses, clearances or oil that the motion needs are missing.
BallNumbers ball_numbers(const Bearing& bearing, const MotionParameters& parameters);

/// Rotation of one ring: at `speed` [rad/s], which grows by `acceleration` [rad/s^2] until it is
/// `final_speed`.
struct RingDrive {
  double speed = 0.0;
  double acceleration = 0.0;
  double final_speed = 0.0;

  static RingDrive steady(double speed) { return {speed, 0.0, speed}; }
  double duration() const { return acceleration == 0.0 ? 0.0 : (final_speed - speed) / acceleration; }  // [s]
  double speed_at(double time) const;  // [rad/s]
  double angle_at(double time) const;  // [rad]
  double acceleration_at(double time) const { return time < duration() ? acceleration : 0.0; }
};

/// Drives and loads of both rings; a radial load points along x.
struct BallDuty {
  RingDrive inner;
  RingDrive outer;
  RingLoad on_inner;
  RingLoad on_outer;
};

/// One contact of one ball at an instant.
struct ContactSnapshot {
  double load = 0.0;           // [N]
  double approach = 0.0;       // [m]  negative where they part
  double contact_angle = 0.0;  // [rad]  of n to the bearing's middle plane
  double sliding = 0.0;        // [m/s]  in the middle, along the direction of rolling: race less ball
  double spin = 0.0;           // [rad/s]  race less ball about n
  double entrainment = 0.0;    // [m/s]
  double central_film = 0.0;   // [m]
};

/// Power lost by cause [W]. Friction over the ellipses falls into its first three parts by the motion that
/// does the work: their sum is >= 0, a single one may be slightly less. All others are >= 0.
struct BallPowerLoss {
  double sliding = 0.0;       // of the ellipses' middles
  double differential = 0.0;  // because ellipses are curved
  double spin = 0.0;
  double rolling = 0.0;
  double damping = 0.0;       // of the race contacts
  double cage = 0.0;          // pockets and lands
  double churning = 0.0;  // drag and churning of balls and cage, and what turning rings pay to stir the oil

  double total() const { return sliding + differential + spin + rolling + damping + cage + churning; }
};

struct BallSnapshot {
  std::vector<ContactSnapshot> inner;    // (balls)
  std::vector<ContactSnapshot> outer;    // (balls)
  std::vector<double> pocket_load;       // [N]  (balls)
  double cage_speed = 0.0;               // [rad/s]
  Eigen::Vector3d cage_position;         // [m]
  double inner_torque = 0.0;             // [N m]  of the drive against the bearing's friction only
  double outer_torque = 0.0;             // [N m]
  BallPowerLoss loss;
};

/// Energy of a state [J]; the rings' own rotations are prescribed and left out, the cage's is in.
struct BallEnergy {
  double kinetic = 0.0;
  double races = 0.0;
  double pockets = 0.0;
  double lands = 0.0;

  double total() const { return kinetic + races + pockets + lands; }
};

class BallBearing {
 public:
  /// Oil that is carried round has its share of the cage's speed as at the final speeds of the rings.
  BallBearing(const BallNumbers& numbers, const BallDuty& duty,
              mechanics::InstructionSet set = mechanics::best_instruction_set());

  const BallNumbers& numbers() const { return numbers_; }
  const BallDuty& duty() const { return duty_; }
  const StateLayout& layout() const { return layout_; }

  void derivative(double time, const double* x, double* dx);
  void linearise(double time, const double* x, double* dx);
  /// Slope of the rate by time only, at the state of the last linearisation.
  void time_slope(double time, double* rate);
  bool factor(double g) { return engine_->factor(g); }
  void solve(const double* rhs, double* k) const { engine_->solve(rhs, k); }
  ContactLoads loads() const { return engine_->loads(); }

  Surroundings surroundings(double time) const;
  BallSnapshot snapshot(double time, const double* x) const;
  /// `time` [s] gives the rotation of the rings with their scratches.
  BallEnergy energy(const double* x, double time = 0.0) const;
  /// Power that loads, and drives against friction, put in at `time` in the state `x` [W].
  double power_input(double time, const double* x) const;

 private:
  BallNumbers numbers_;
  BallDuty duty_;
  StateLayout layout_;
  std::unique_ptr<Engine> engine_;
  std::vector<double> last_x_, last_rate_;
};

/// Start of a run: the inner ring is displaced as in the static equilibrium under its load, the outer one is
/// not displaced (the other way round where the inner ring is held and the outer one free). Balls are between
/// them, the first at the angle `first` [rad]. Balls and cage turn as at pure rolling, times `share` of it.
/// Throws std::invalid_argument as balance_bearing().
std::vector<double> start_state(const Bearing& bearing, const BallBearing& model, double first,
                                double share = 1.0);

}  // namespace orbearing::bearing::balls
