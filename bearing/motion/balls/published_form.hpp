// The ball bearing in the form of [Chen2026], the rung below the complete one: what is stiff has no inertia.
//
// Radial and axial positions of the balls and the five of a free ring follow at each instant from the
// equilibrium of loads, pockets and inertia, Eqs. (31) and (32); angles, turning rates of the balls and four
// freedoms of the cage (it does not tilt) move by their rates, Eqs. (33) and (34). Laws are those of the
// complete form, without damping in the races, since nothing closes in on them. Friction of the races is no
// part of Eq. (31): with it a ball that rolls would be steered, which is no equilibrium. It is left out of
// Eq. (32) likewise.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

#include "bearing/motion/balls/ball_bearing.hpp"

namespace orbearing::bearing::balls {

class PublishedForm {
 public:
  /// Keeps `bearing`, whose equations it uses.
  explicit PublishedForm(BallBearing& bearing);

  /// Order of the state: angle, orbital speed, three turning rates of each ball [balls at a time], then x, y,
  /// z, angle of the cage and their rates.
  int size() const { return 5 * balls_ + 8; }
  /// From a state of the complete form, whose positions are the start.
  std::vector<double> reduced(const std::vector<double>& complete);
  /// The complete form's state for `y` at `time` [s], positions by equilibrium; their velocities are zero.
  /// Throws std::runtime_error where no equilibrium is found.
  const std::vector<double>& complete(double time, const double* y);
  /// The last of them.
  const std::vector<double>& complete() const { return x_; }
  /// Rate `dy` of the state `y`; complete() is that at `y` then.
  void derivative(double time, const double* y, double* dy);

 private:
  Eigen::VectorXd unbalanced(double time);
  void differentiate(double time);
  void move(Eigen::Index i, double by);

  BallBearing& bearing_;
  BallBearing smooth_;  // without friction on the races
  int balls_;
  int ring_ = -1;  // first position of the ring that is free; none: -1
  std::vector<double> x_, rate_;
  Eigen::VectorXd inertia_;  // of each position: accelerations times it are forces, moments over a radius
  Eigen::PartialPivLU<Eigen::MatrixXd> slope_;
  bool differentiated_ = false;
};

}  // namespace orbearing::bearing::balls
