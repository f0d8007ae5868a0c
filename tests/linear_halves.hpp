// The least co-simulation that has everything: a mass on a spring gives its motion, a second mass behind a
// spring and a damper answers with a force. Both halves move exactly under any polynomial, so that all that
// is left of an error is the coupling's; the whole has a closed form.
//
//   |--k,c--( mass )--x--kc,cc--( behind )--ks--|        x: the joint; with `behind` = 0 the spring ends
//                                                        in the wall
//
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <unsupported/Eigen/MatrixFunctions>

#include "coupling/cosim/coupled_run.hpp"

namespace orbearing::cosim::linear_halves {

struct LinearPair {
  double mass = 1.0;              // [kg]
  double stiffness = 0.4;         // [N/m]    of the first to the wall
  double damping = 0.0;           // [N s/m]
  double joint_stiffness = 1.0;   // [N/m]
  double joint_damping = 0.3;     // [N s/m]
  double behind = 0.5;            // [kg]     0: the joint's spring ends in the wall
  double behind_stiffness = 2.0;  // [N/m]
};

/// State after `time` [s] under a linear law.
inline Eigen::VectorXd after(const Eigen::MatrixXd& law, double time, const Eigen::VectorXd& start) {
  const Eigen::MatrixXd change = (law * time).exp();
  return change * start;
}

/// State under a linear law with a polynomial of degree 3 as input, over `length` [s].
/// @param inputs a polynomial for each column of `by_input`
inline Eigen::VectorXd moved(const Eigen::MatrixXd& law, const Eigen::MatrixXd& by_input,
                             const std::vector<InputPolynomial>& inputs, const Eigen::VectorXd& x,
                             double length) {
  constexpr Eigen::Index powers = 4;
  const Eigen::Index n = x.size();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n + powers, n + powers);
  all.topLeftCorner(n, n) = law;
  for (Eigen::Index i = 0; i < by_input.cols(); ++i)
    for (Eigen::Index k = 0; k < powers; ++k)
      all.col(n + k).head(n) +=
          by_input.col(i) * inputs[static_cast<std::size_t>(i)].coefficient[static_cast<std::size_t>(k)];
  // Large inputs are in the start vector, since the exponential loses digits where columns differ in size.
  const double size = std::max(1.0, all.rightCols(powers).cwiseAbs().maxCoeff());
  all.rightCols(powers) /= size;
  for (Eigen::Index k = 1; k < powers; ++k)
    all(n + k, n + k - 1) = static_cast<double>(k);  // (s^k)' = k s^(k-1)
  Eigen::VectorXd start = Eigen::VectorXd::Zero(n + powers);
  start.head(n) = x;
  start[n] = size;
  return after(all, length, start).head(n);
}

/// One half: its laws, and what it gives from its state and its inputs.
/// Motion is displacement and velocity, in this order.
class LinearHalf : public Participant {
 public:
  LinearHalf(std::vector<Input> inputs, std::vector<Output> outputs, Eigen::VectorXd start)
      : Participant(std::move(inputs), std::move(outputs)), start_(std::move(start)) {}

  void initialize(double, const std::vector<double>&) override { x_ = start_; }
  std::vector<double> slopes(const std::vector<double>&, std::size_t) const override { return {}; }
  void save(SavedState& state) const override { state = {x_.begin(), x_.end()}; }
  void restore(const SavedState& state) override {
    x_ = Eigen::Map<const Eigen::VectorXd>(state.data(), x_.size());
  }

  const Eigen::VectorXd& state() const { return x_; }

 protected:
  Eigen::VectorXd start_, x_;
};

/// Gives the motion of the first mass; state (x, x').
class MassHalf : public LinearHalf {
 public:
  explicit MassHalf(const LinearPair& pair, double displacement = 1.0, double velocity = 0.0)
      : LinearHalf({{"force", "N", {}}}, {{"displacement", "m", {}, {}, {}}, {"velocity", "m/s", {}, {}, {}}},
                   Eigen::Vector2d(displacement, velocity)),
        pair_(pair) {}

  void advance(const Window& window, const std::vector<InputPolynomial>& force) override {
    Eigen::Matrix2d law;
    law << 0.0, 1.0, -pair_.stiffness / pair_.mass, -pair_.damping / pair_.mass;
    x_ = moved(law, Eigen::Vector2d(0.0, 1.0 / pair_.mass), force, x_, window.length());
  }
  std::vector<double> values(const std::vector<double>&, std::size_t) const override {
    return {x_[0], x_[1]};
  }
  Side side() { return {this, {{"x", PortKind::translation, PortOutput::motion, 0, 1, 0}}}; }

 private:
  LinearPair pair_;
};

/// Gives the force of the joint; state (z, z') of the mass behind it, zero at first.
class ForceHalf : public LinearHalf {
 public:
  explicit ForceHalf(const LinearPair& pair)
      : LinearHalf({{"displacement", "m", {}}, {"velocity", "m/s", {}}}, {{"force", "N", {}, {}, {}}},
                   Eigen::Vector2d::Zero()),
        pair_(pair) {}

  void advance(const Window& window, const std::vector<InputPolynomial>& motion) override {
    if (pair_.behind == 0.0) return;
    Eigen::Matrix2d law, by_input;
    law << 0.0, 1.0, -(pair_.joint_stiffness + pair_.behind_stiffness) / pair_.behind,
        -pair_.joint_damping / pair_.behind;
    by_input << 0.0, 0.0, pair_.joint_stiffness / pair_.behind, pair_.joint_damping / pair_.behind;
    x_ = moved(law, by_input, motion, x_, window.length());
  }
  std::vector<double> values(const std::vector<double>& motion, std::size_t) const override {
    return {pair_.joint_stiffness * (x_[0] - motion[0]) + pair_.joint_damping * (x_[1] - motion[1])};
  }
  Side side() { return {this, {{"x", PortKind::translation, PortOutput::force, 0, 1, 0}}}; }

 private:
  LinearPair pair_;
};

/// Both in one: (x, x', z, z') at `time` [s].
inline Eigen::Vector4d exact(const LinearPair& p, double time, double displacement = 1.0) {
  Eigen::Matrix4d law = Eigen::Matrix4d::Zero();
  law(0, 1) = law(2, 3) = 1.0;
  law.row(1) << -(p.stiffness + p.joint_stiffness) / p.mass, -(p.damping + p.joint_damping) / p.mass,
      p.joint_stiffness / p.mass, p.joint_damping / p.mass;
  law.row(3) << p.joint_stiffness / p.behind, p.joint_damping / p.behind,
      -(p.joint_stiffness + p.behind_stiffness) / p.behind, -p.joint_damping / p.behind;
  return after(law, time, Eigen::Vector4d(displacement, 0.0, 0.0, 0.0));
}

/// A pair of halves and their run.
struct LinearRun {
  LinearRun(const LinearPair& pair, const CoupledOptions& options, bool force_first = false)
      : mass(pair),
        force(pair),
        run(force_first ? Sides{force.side(), mass.side()} : Sides{mass.side(), force.side()}, options) {
    run.initialize(0.0);
  }
  LinearRun(const LinearRun&) = delete;

  MassHalf mass;
  ForceHalf force;
  CoupledRun run;
};

}  // namespace orbearing::cosim::linear_halves
