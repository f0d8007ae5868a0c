#include "bearing/equilibrium/lamina_stiffness.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "bearing/equilibrium/elastic_waves.hpp"

namespace orbearing::bearing::laminae {

namespace {

using Eigen::Matrix2d;

constexpr double kHoldsNothing = 1e-14;  // of a determinant over the square of the trace

}  // namespace

// Displacement and tilt come first, then the waves of the race, which follow without force.
Eigen::Matrix4d stiffness_at(const LaminaBearing& bearing, const QuasiStaticState& state,
                             const ElasticRace& outer_race) {
  const Eigen::Index waves = wave_count(outer_race);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(4 + waves, 4 + waves);
  sum.diagonal().tail(waves) = wave_stiffness(outer_race);
  for (Eigen::Index j = 0; j < state.angle.size(); ++j) {
    const Eigen::RowVector2d outward(std::cos(state.angle[j]), std::sin(state.angle[j]));
    Eigen::Matrix<double, 2, Eigen::Dynamic> follows =  // approach and end displacement of the races
        Eigen::Matrix<double, 2, Eigen::Dynamic>::Zero(2, 4 + waves);
    follows.topLeftCorner<1, 2>() = outward;
    follows.block<1, 2>(1, 2) = bearing.half_length() * outward;
    follows.row(0).tail(waves) = wave_shapes(outer_race, state.angle[j]).transpose();
    sum += follows.transpose() * roller_stiffness(state.rollers[static_cast<std::size_t>(j)]) * follows;
  }
  return without_waves(sum, 4);
}

Eigen::Matrix4d mean_stiffness(const LaminaBearing& bearing, const QuasiStaticResult& result,
                               const ElasticRace& outer_race) {
  // Displacement and moment by load and tilt, since these are what all cage angles have in common.
  Matrix2d by_load = Matrix2d::Zero(), by_tilt = Matrix2d::Zero(), moment_by_load = Matrix2d::Zero(),
           moment_by_tilt = Matrix2d::Zero();
  const double share = 1.0 / static_cast<double>(result.states.size());
  for (const QuasiStaticState& state : result.states) {
    const Eigen::Matrix4d k = stiffness_at(bearing, state, outer_race);
    const Matrix2d across = k.topLeftCorner<2, 2>();
    if (!(across.determinant() > kHoldsNothing * across.trace() * across.trace()))
      throw std::domain_error("stiffness: the bearing bears no load in some direction");
    const Matrix2d compliance = across.inverse();
    const Matrix2d coupled = compliance * k.topRightCorner<2, 2>();
    by_load += share * compliance;
    by_tilt -= share * coupled;
    moment_by_load += share * k.bottomLeftCorner<2, 2>() * compliance;
    moment_by_tilt += share * (k.bottomRightCorner<2, 2>() - k.bottomLeftCorner<2, 2>() * coupled);
  }
  const Matrix2d load_by_position = by_load.inverse(), moment_by_position = moment_by_load * load_by_position;
  Eigen::Matrix4d mean;
  mean << load_by_position, -load_by_position * by_tilt, moment_by_position,
      moment_by_tilt - moment_by_position * by_tilt;
  return mean;
}

Eigen::Matrix<double, 5, 5> about_axes(const Eigen::Matrix4d& stiffness) {
  Eigen::Matrix<double, 5, 4> turned = Eigen::Matrix<double, 5, 4>::Zero();
  turned(0, 0) = turned(1, 1) = 1.0;
  turned(3, 3) = -1.0;  // the bore leans along y where it turns about -x
  turned(4, 2) = 1.0;
  return turned * stiffness * turned.transpose();
}

}  // namespace orbearing::bearing::laminae
