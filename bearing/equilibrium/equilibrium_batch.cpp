#include "bearing/equilibrium/equilibrium_batch.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "bearing/carrier_frame.hpp"
#include "bearing/contact/line_contact.hpp"

namespace orbearing::bearing::vectorised {

namespace {

using boost::math::double_constants::two_pi;

EquilibriumEngine* make_engine([[maybe_unused]] mechanics::InstructionSet set,
                               const EquilibriumConstants& constants) {
#if defined(__x86_64__) && !defined(_WIN32)
  if (set == mechanics::InstructionSet::avx512) return avx512_equilibrium(constants);
  if (set == mechanics::InstructionSet::avx2) return avx2_equilibrium(constants);
#endif
  return baseline_equilibrium(constants);
}

double mass_through_cage(const Bearing& bearing, const BearingGeometry& geometry) {
  if (bearing.cage.guidance != Race::outer) return 0.0;
  return geometry.cage_mass + 0.5 * bearing.rollers().count * geometry.element_mass;
}

void resize(EquilibriumResults& results, std::size_t points, int rollers) {
  const auto count = static_cast<Eigen::Index>(points);
  results.displacement.resize(2, count);
  results.inner_load.resize(count, rollers);
  results.outer_load.resize(count, rollers);
  results.residual.resize(count);
  results.iterations.resize(count);
  results.failures.clear();
  results.solved_singly = 0;
}

}  // namespace

EquilibriumBlock::EquilibriumBlock(const Bearing& bearing, const InertiaSwitches& inertia)
    : geometry_(geometry_of(bearing)),
      inertia_(inertia),
      unit_length_(roller_race_contact(bearing.contact_law, bearing.rollers().length).approach(1.0)),
      round_(bearing.inner.form.empty() && bearing.outer.form.empty() &&
             bearing.rollers().diameter_deviation.empty()),
      cage_mass_(mass_through_cage(bearing, geometry_)) {
  const int rollers = bearing.rollers().count;
  for (int j = 0; j < rollers; ++j) {
    const double angle = two_pi * j / rollers;
    pocket_cosine_.push_back(std::cos(angle));
    pocket_sine_.push_back(std::sin(angle));
  }
}

EquilibriumConstants EquilibriumBlock::constants(double half_clearance) const {
  return {.rollers = static_cast<int>(pocket_cosine_.size()),
          .half_clearance = half_clearance / unit_length_,
          .pocket_cosine = pocket_cosine_.data(),
          .pocket_sine = pocket_sine_.data()};
}

// The inertial load of a roller is radial_inertial_acceleration() on the pitch circle, split by its angle.
void EquilibriumBlock::put(const OperatingPoint& point, double first_roller, int lane) {
  const CarrierFrame frame = carrier_frame(point.carrier, inertia_);
  const double cage_speed = kinematic_cage_speed(geometry_, point.inner_speed, point.outer_speed);
  const double mass = geometry_.element_mass;
  const Eigen::Vector2d through_cage =
      cage_mass_ * inertial_acceleration(frame, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  input_.force_x[lane] = point.bore_load.x() + through_cage.x();
  input_.force_y[lane] = point.bore_load.y() + through_cage.y();
  input_.steady[lane] = mass * geometry_.pitch_radius *
                        (frame.own_orbit * cage_speed * cage_speed + 2.0 * frame.coriolis_speed * cage_speed +
                         frame.centrifugal);
  input_.cosine[lane] = mass * frame.centrifugal * frame.orbit_radius;
  input_.sine[lane] = -mass * frame.euler * frame.orbit_radius;
  input_.first_roller[lane] =
      std::abs(first_roller) < 1e6 ? first_roller : std::remainder(first_roller, two_pi);
}

EquilibriumBatch::EquilibriumBatch(const Bearing& bearing, const InertiaSwitches& inertia,
                                   mechanics::InstructionSet set)
    : bearing_(bearing), inertia_(inertia), block_(bearing, inertia) {
  const auto rollers = static_cast<std::size_t>(bearing.rollers().count);
  inner_.resize(rollers * kBlock);
  outer_.resize(rollers * kBlock);
  engine_.reset(make_engine(set, block_.constants(0.5 * bearing.radial_clearance)));
}

void EquilibriumBatch::solve_singly(const EquilibriumPoint& point, std::size_t index,
                                    EquilibriumResults& results) const {
  const QuasiStaticState state =
      quasi_static_state(bearing_, point.point, {.inertia = inertia_}, point.first_roller);
  const auto row = static_cast<Eigen::Index>(index);
  results.displacement.col(row) = state.displacement;
  results.inner_load.row(row) = state.inner_load.transpose();
  results.outer_load.row(row) = state.outer_load.transpose();
  results.residual[row] = state.report.residual;
  results.iterations[row] = state.report.iterations;
  ++results.solved_singly;
  if (!state.report.converged) results.failures.push_back({index, state.report.message});
}

void EquilibriumBatch::solve(std::span<const EquilibriumPoint> points, EquilibriumResults& results) {
  resize(results, points.size(), bearing_.rollers().count);
  const bool all_rigid = std::all_of(points.begin(), points.end(), [](const EquilibriumPoint& at) {
    return at.point.outer_race.is_rigid();
  });
  if (!block_.is_round() || !all_rigid) {
    for (std::size_t index = 0; index < points.size(); ++index) solve_singly(points[index], index, results);
    return;
  }
  for (std::size_t first = 0; first < points.size(); first += kBlock) {
    const std::size_t count = std::min<std::size_t>(kBlock, points.size() - first);
    for (int lane = 0; lane < kBlock; ++lane) {
      const EquilibriumPoint& at = points[first + std::min(count - 1, static_cast<std::size_t>(lane))];
      block_.put(at.point, at.first_roller, lane);
    }
    engine_->solve(block_.input(), output_, inner_.data(), outer_.data());
    const auto row = static_cast<Eigen::Index>(first);
    const auto rows = static_cast<Eigen::Index>(count);
    for (Eigen::Index j = 0; j < bearing_.rollers().count; ++j) {
      std::copy_n(inner_.data() + j * kBlock, rows, results.inner_load.col(j).data() + row);
      std::copy_n(outer_.data() + j * kBlock, rows, results.outer_load.col(j).data() + row);
    }
    for (Eigen::Index lane = 0; lane < rows; ++lane) {
      results.displacement(0, row + lane) = block_.unit_length() * output_.displacement_x[lane];
      results.displacement(1, row + lane) = block_.unit_length() * output_.displacement_y[lane];
      results.residual[row + lane] = output_.residual[lane];
      results.iterations[row + lane] = static_cast<int>(output_.iterations[lane]);
      if (output_.converged[lane] == 0.0) {
        const std::size_t index = first + static_cast<std::size_t>(lane);
        solve_singly(points[index], index, results);
      }
    }
  }
}

}  // namespace orbearing::bearing::vectorised
