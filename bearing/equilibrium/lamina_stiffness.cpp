#include "bearing/equilibrium/lamina_stiffness.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "bearing/equilibrium/elastic_waves.hpp"

namespace orbearing::bearing::laminae {

namespace {

using Eigen::Matrix2d;

// By approach and end displacement of one contact [N/m].
Matrix2d contact_stiffness(const LaminaForce& force) {
  Matrix2d stiffness;
  stiffness << force.by_approach, force.mixed, force.mixed, force.by_end_displacement;
  return stiffness;
}

constexpr double kSingular = 1e-14;  // of a determinant over the square of the trace

// A contact that a single lamina touches holds no tilt about it: then that of what it does hold.
Matrix2d pseudo_inverse(const Matrix2d& symmetric) {
  const double size = symmetric.trace();
  if (!(size > 0.0)) return Matrix2d::Zero();
  if (symmetric.determinant() > kSingular * size * size) return symmetric.inverse();
  return symmetric / (size * size);
}

}  // namespace

// Both contacts in series, where one of them or both may be open or hold no tilt; then the films, which yield
// with the load alone.
Matrix2d roller_stiffness(const RollerState& roller) {
  const Matrix2d inner = contact_stiffness(roller.inner), outer = contact_stiffness(roller.outer);
  Matrix2d series = inner * pseudo_inverse(inner + outer) * outer;
  series = 0.5 * (series + series.transpose()).eval();
  if (!(series(0, 0) > 0.0)) return Matrix2d::Zero();
  const double share = roller.stiffness / series(0, 0);  // that the films leave
  series(1, 1) -= (1.0 - share) * series(0, 1) * series(1, 0) / series(0, 0);
  series(0, 0) *= share;
  series(0, 1) *= share;
  series(1, 0) *= share;
  return series;
}

// Displacement and tilt come first, then the waves of the race, which follow without force.
Eigen::Matrix4d stiffness_at(const LaminaBearing& bearing, const LaminaState& state,
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

Eigen::Matrix4d mean_stiffness(const LaminaBearing& bearing, const LaminaResult& result,
                               const ElasticRace& outer_race) {
  // Displacement and moment by load and tilt, since these are what all cage angles have in common.
  Matrix2d by_load = Matrix2d::Zero(), by_tilt = Matrix2d::Zero(), moment_by_load = Matrix2d::Zero(),
           moment_by_tilt = Matrix2d::Zero();
  const double share = 1.0 / static_cast<double>(result.states.size());
  for (const LaminaState& state : result.states) {
    const Eigen::Matrix4d k = stiffness_at(bearing, state, outer_race);
    const Matrix2d across = k.topLeftCorner<2, 2>();
    if (!(across.determinant() > kSingular * across.trace() * across.trace()))
      throw std::domain_error("stiffness: the bearing bears no load in some direction");
    const Matrix2d compliance = across.inverse();
    const Matrix2d coupled = compliance * k.topRightCorner<2, 2>();
    by_load += share * compliance;
    by_tilt -= share * coupled;
    moment_by_load += share * k.bottomLeftCorner<2, 2>() * compliance;
    moment_by_tilt += share * (k.bottomRightCorner<2, 2>() - k.bottomLeftCorner<2, 2>() * coupled);
  }
  const Matrix2d load_by_place = by_load.inverse(), moment_by_place = moment_by_load * load_by_place;
  Eigen::Matrix4d mean;
  mean << load_by_place, -load_by_place * by_tilt, moment_by_place,
      moment_by_tilt - moment_by_place * by_tilt;
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
