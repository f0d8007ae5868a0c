#include "bearing/equilibrium/equilibrium_batch.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "bearing/carrier_frame.hpp"
#include "bearing/contact/line_contact.hpp"
#include "bearing/contact/race_form.hpp"

namespace orbearing::bearing::vectorised {

namespace {

using boost::math::double_constants::two_pi;

EquilibriumEngine* make_engine([[maybe_unused]] mechanics::InstructionSet set,
                               const EquilibriumConstants& constants) {
  const bool cut = constants.laminae > 0;
#if defined(__x86_64__) && !defined(_WIN32)
  if (set == mechanics::InstructionSet::avx512)
    return cut ? avx512_level_equilibrium(constants) : avx512_equilibrium(constants);
  if (set == mechanics::InstructionSet::avx2)
    return cut ? avx2_level_equilibrium(constants) : avx2_equilibrium(constants);
#endif
  return cut ? baseline_level_equilibrium(constants) : baseline_equilibrium(constants);
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

EquilibriumBlock::EquilibriumBlock(const Bearing& bearing, const InertiaSwitches& inertia,
                                   mechanics::InstructionSet set, UnlikeLaminae laminae)
    : geometry_(geometry_of(bearing)),
      inertia_(inertia),
      unit_length_(roller_race_contact(bearing.contact_law, bearing.rollers().length).approach(1.0)),
      cage_mass_(mass_through_cage(bearing, geometry_)),
      laminae_(std::move(laminae)),
      inner_(static_cast<std::size_t>(bearing.rollers().count * kBlock)),
      outer_(inner_) {
  const int rollers = bearing.rollers().count;
  for (int j = 0; j < rollers; ++j) {
    const double angle = two_pi * j / rollers;
    pocket_cosine_.push_back(std::cos(angle));
    pocket_sine_.push_back(std::sin(angle));
  }
  const double least = laminae_.drop.empty() ? 0.0 : laminae_.drop.front();
  for (double& drop : laminae_.drop) drop = (drop - least) / unit_length_;
  engine_.reset(
      make_engine(set, {.rollers = rollers,
                        .half_clearance = (0.5 * bearing.radial_clearance + 2.0 * least) / unit_length_,
                        .pocket_cosine = pocket_cosine_.data(),
                        .pocket_sine = pocket_sine_.data(),
                        .laminae = static_cast<int>(laminae_.drop.size()),
                        .drop = laminae_.drop.data(),
                        .share = laminae_.share.data()}));
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

const EquilibriumOutput& EquilibriumBlock::solve(Eigen::Index first, Eigen::Index count,
                                                 Eigen::Array2Xd& displacement, Eigen::ArrayXXd& inner_load,
                                                 Eigen::ArrayXXd& outer_load, double* rollers,
                                                 double* lamina_loads) {
  output_.rollers = rollers;
  output_.lamina_loads = lamina_loads;
  engine_->solve(input_, output_, inner_.data(), outer_.data());
  for (Eigen::Index j = 0; j < inner_load.cols(); ++j) {
    std::copy_n(inner_.data() + j * kBlock, count, inner_load.col(j).data() + first);
    std::copy_n(outer_.data() + j * kBlock, count, outer_load.col(j).data() + first);
  }
  for (Eigen::Index lane = 0; lane < count; ++lane)
    displacement.col(first + lane) << unit_length_ * output_.displacement_x[lane],
        unit_length_ * output_.displacement_y[lane];
  return output_;
}

EquilibriumBatch::EquilibriumBatch(const Bearing& bearing, const InertiaSwitches& inertia,
                                   mechanics::InstructionSet set)
    : bearing_(bearing), inertia_(inertia), block_(bearing, inertia, set) {}

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
  if (!is_round(bearing_) || !all_rigid) {
    for (std::size_t index = 0; index < points.size(); ++index) solve_singly(points[index], index, results);
    return;
  }
  for (std::size_t first = 0; first < points.size(); first += kBlock) {
    const std::size_t count = std::min<std::size_t>(kBlock, points.size() - first);
    for (int lane = 0; lane < kBlock; ++lane) {
      const EquilibriumPoint& at = points[first + std::min(count - 1, static_cast<std::size_t>(lane))];
      block_.put(at.point, at.first_roller, lane);
    }
    const auto row = static_cast<Eigen::Index>(first);
    const auto rows = static_cast<Eigen::Index>(count);
    const EquilibriumOutput& found =
        block_.solve(row, rows, results.displacement, results.inner_load, results.outer_load);
    for (Eigen::Index lane = 0; lane < rows; ++lane) {
      results.residual[row + lane] = found.residual[lane];
      results.iterations[row + lane] = static_cast<int>(found.iterations[lane]);
      if (found.converged[lane] == 0.0) {
        const std::size_t index = first + static_cast<std::size_t>(lane);
        solve_singly(points[index], index, results);
      }
    }
  }
}

}  // namespace orbearing::bearing::vectorised
