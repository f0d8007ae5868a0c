#include "gearset/dynamics/period_map.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gearset/dynamics/stage_matrix.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::gearset::dynamics {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kStep = 0.4;      // [rad]  of the fastest motion, by classic Runge-Kutta
constexpr double kDecay = 2.0;     // [-]  of the fastest decay in a step: it is stable up to 2.78
constexpr double kMargin = 1e-9;   // [mesh period]  kept off jumps, to be on one side of them
constexpr double kNothing = 1e-6;  // [-]  of the fastest frequency: round-off of multipliers of one
constexpr double kFree = 1e-8;     // [-]  of the largest pivot: a direction that the map leaves as it is

// Accelerations over departures, which change with the meshes.
class Linearised {
 public:
  Linearised(const SetModel& model, const std::vector<Index>& free)
      : model_(model), still_(VectorXd::Zero(model.layout.size())), free_(free) {
    model_.parameters.separation = false;
    for (Mesh* mesh : {&model_.parameters.sun_mesh, &model_.parameters.ring_mesh}) mesh->loaded = nullptr;
    at(0.0);
  }

  /// [mesh period]  where something jumps
  std::vector<double> jumps() const { return jump_phases(model_); }

  /// [rad/s]  by the largest sum of a row
  double fastest() const { return std::sqrt(by_position_.cwiseAbs().rowwise().sum().maxCoeff()); }
  /// [1/s]  likewise. The friction of slow, heavily loaded bearings is a damper faster than any vibration.
  double fastest_decay() const { return by_velocity_.cwiseAbs().rowwise().sum().maxCoeff(); }

  void at(double time) {
    force_slopes(model_, time, still_, slopes_);  // linear: of no state
    by_position_ = accelerations(slopes_.by_position);
    by_velocity_ = accelerations(slopes_.by_velocity);
  }
  /// Rate of departures whose velocities are over `frequency`.
  void rate(double frequency, const MatrixXd& x, MatrixXd& dx) const {
    const Index n = static_cast<Index>(free_.size());
    dx.topRows(n) = frequency * x.bottomRows(n);
    dx.bottomRows(n).noalias() = by_velocity_ * x.bottomRows(n);
    dx.bottomRows(n).noalias() += (1.0 / frequency) * by_position_ * x.topRows(n);
  }

 private:
  MatrixXd accelerations(const MatrixXd& slopes) const {
    return model_.mobility(free_).asDiagonal() * slopes(free_, free_);
  }

  SetModel model_;
  VectorXd still_;
  const std::vector<Index>& free_;
  ForceSlopes slopes_;
  MatrixXd by_position_, by_velocity_;
};

// The largest rate among the multipliers of `map`.
double growth_of(const MatrixXd& map, double period, double frequency) {
  const double growth = std::log(mechanics::eigenvalues(map).cwiseAbs().maxCoeff()) / period;
  return growth > kNothing * frequency ? growth : std::min(growth, 0.0);
}

// For kept change + rotation = departure, with no rotation in the change.
MatrixXd bordered_by_rotations(const MatrixXd& kept) {
  Eigen::FullPivLU<MatrixXd> factors(kept);
  factors.setThreshold(kFree);
  const Index size = kept.rows(), rotations = factors.dimensionOfKernel();
  MatrixXd matrix = MatrixXd::Zero(size + rotations, size + rotations);
  matrix.topLeftCorner(size, size) = kept;
  if (rotations > 0) {
    const MatrixXd rotation = factors.kernel();
    matrix.topRightCorner(size, rotations) = rotation;
    matrix.bottomLeftCorner(rotations, size) = rotation.transpose();
  }
  return matrix;
}

void require_steady_speed(const Operation& operation) {
  if (operation.run_up.duration > 0.0 || !(operation.mesh_frequency > 0.0))
    throw std::invalid_argument(
        "map of a mesh period: found a run-up, or a stationary set; required: a steady speed");
}

// Classic Runge-Kutta from `begin` to `end` [s], inside of which nothing jumps.
void pass_piece(Linearised& linear, double frequency, double begin, double end, MatrixXd& x) {
  linear.at(begin);
  const double pace = std::max(frequency / kStep, linear.fastest_decay() / kDecay);  // [1/s]
  const long steps = std::max(1L, std::lround(std::ceil((end - begin) * pace)));
  const double h = (end - begin) / static_cast<double>(steps);
  MatrixXd k1(x.rows(), x.cols()), k2 = k1, k3 = k1, k4 = k1;
  for (long i = 0; i < steps; ++i) {
    linear.rate(frequency, x, k1);
    linear.at(begin + (static_cast<double>(i) + 0.5) * h);
    linear.rate(frequency, x + 0.5 * h * k1, k2);
    linear.rate(frequency, x + 0.5 * h * k2, k3);
    linear.at(begin + static_cast<double>(i + 1) * h);
    linear.rate(frequency, x + h * k3, k4);
    x += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
}

}  // namespace

PeriodMap::PeriodMap(const SetModel& model) : freedoms_(model.layout.freedoms()) {
  require_steady_speed(model.operation);
  const double period = 1.0 / model.operation.mesh_frequency;  // [s]
  for (Index i = 0; i < freedoms_; ++i)
    if (model.mobility[i] > 0.0) free_.push_back(i);
  Linearised linear(model, free_);
  frequency_ = linear.fastest();
  const Index size = 2 * static_cast<Index>(free_.size());
  MatrixXd map = MatrixXd::Identity(size, size);
  std::vector<double> ends = linear.jumps();
  ends.push_back(1.0);
  double begin = 0.0;
  for (const double end : ends) {
    if (end - begin > 4.0 * kMargin)
      pass_piece(linear, frequency_, (begin + kMargin) * period, (end - kMargin) * period, map);
    begin = end;
  }
  growth_ = growth_of(map, period, frequency_);
  bordered_ = bordered_by_rotations(MatrixXd::Identity(size, size) - map);
}

VectorXd PeriodMap::to_repeating(const Eigen::Ref<const VectorXd>& departure) const {
  const Index n = static_cast<Index>(free_.size());
  VectorXd right = VectorXd::Zero(bordered_.rows());
  right.head(n) = departure.head(freedoms_)(free_);
  right.segment(n, n) = departure.tail(freedoms_)(free_) / frequency_;
  const VectorXd found = mechanics::least_squares(bordered_, right, kFree);
  VectorXd change = VectorXd::Zero(2 * freedoms_);
  change.head(freedoms_)(free_) = found.head(n);
  change.tail(freedoms_)(free_) = frequency_ * found.segment(n, n);
  return change;
}

}  // namespace orbearing::gearset::dynamics
