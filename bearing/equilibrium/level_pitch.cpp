#include "bearing/equilibrium/level_pitch.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace orbearing::bearing::vectorised {

namespace {

using boost::math::double_constants::two_pi;

EquilibriumEngine* level_engine([[maybe_unused]] mechanics::InstructionSet set,
                                const EquilibriumConstants& constants) {
#if defined(__x86_64__) && !defined(_WIN32)
  if (set == mechanics::InstructionSet::avx512) return avx512_level_equilibrium(constants);
  if (set == mechanics::InstructionSet::avx2) return avx2_level_equilibrium(constants);
#endif
  return baseline_level_equilibrium(constants);
}

// Of the same lamina at the other end: profiles are computed from both sides.
constexpr double kSameDrop = 1e-12;

double same_drop(const std::vector<double>& drops) {
  return kSameDrop * std::abs(*std::max_element(drops.begin(), drops.end()));
}

std::vector<double> drops_at(const Bearing& bearing, Race race) {
  const CylindricalRollers& rollers = bearing.rollers();
  if (rollers.laminae == 0) return {0.0};
  profile::require_sound(rollers.profile);
  profile::require_sound(bearing.ring(race).profile);
  return laminae::lamina_drops(rollers.profile, bearing.ring(race).profile, rollers.length, rollers.laminae);
}

bool are_same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [same = same_drop(a)](double x, double y) { return std::abs(x - y) <= same; });
}

bool rollers_stay_level(const Bearing& bearing) {
  const std::vector<double> inner = drops_at(bearing, Race::inner);
  return are_same(inner, {inner.rbegin(), inner.rend()}) && are_same(inner, drops_at(bearing, Race::outer));
}

}  // namespace

bool LevelPitch::holds(const Bearing& bearing, const OperatingPoint& point,
                       const QuasiStaticOptions& options) {
  const bool round = bearing.inner.form.empty() && bearing.outer.form.empty() &&
                     bearing.rollers().diameter_deviation.empty();
  return round && !options.film && point.outer_race.is_rigid() && point.bore_tilt.isZero(0.0) &&
         rollers_stay_level(bearing);
}

LevelPitch::LevelPitch(const Bearing& bearing, const QuasiStaticOptions& options,
                       mechanics::InstructionSet set)
    : bearing_(bearing), options_(options), block_(bearing, options.inertia) {
  const std::vector<double> drops = drops_at(bearing, Race::inner);
  const double same = same_drop(drops), unit = block_.unit_length();
  std::vector<std::size_t> order(drops.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return drops[a] < drops[b]; });
  const double least = drops[order.front()];
  lamina_of_.resize(drops.size());
  for (const std::size_t k : order) {
    const double drop = drops[k] - least;
    if (drop_.empty() || drop > unit * drop_.back() + same) {
      drop_.push_back(drop / unit);
      share_.push_back(0.0);
    }
    share_.back() += 1.0 / static_cast<double>(drops.size());
    lamina_of_[k] = drop_.size() - 1;
  }
  const auto rollers = static_cast<std::size_t>(bearing.rollers().count);
  inner_.resize(rollers * kBlock);
  outer_.resize(rollers * kBlock);
  EquilibriumConstants constants = block_.constants(0.5 * bearing.radial_clearance + 2.0 * least);
  constants.laminae = static_cast<int>(drop_.size());
  constants.drop = drop_.data();
  constants.share = share_.data();
  engine_.reset(level_engine(set, constants));
}

void LevelPitch::solve(const OperatingPoint& point, PitchResults& results, const PitchResults* near) {
  solve(point, results, near, nullptr);
}

Eigen::Vector2d LevelPitch::start(const OperatingPoint& point, const PitchResults& near, int position) const {
  return near.displacement.col(position).matrix() +
         mechanics::lengths_under<2>(Eigen::Vector2d(point.bore_load - near.load),
                                     near.stiffness[static_cast<std::size_t>(position)]);
}

// `lamina_loads` has room for the loads of all blocks.
void LevelPitch::solve(const OperatingPoint& point, PitchResults& results, const PitchResults* near,
                       double* lamina_loads) {
  require_finite(point);
  const int positions = options_.cage_positions, rollers = bearing_.rollers().count;
  const std::size_t room = 2 * drop_.size() * static_cast<std::size_t>(rollers) * kBlock;
  results.load = point.bore_load;
  results.rollers.resize(
      static_cast<std::size_t>(2 * rollers * ((positions + kBlock - 1) / kBlock) * kBlock));
  results.displacement.resize(2, positions);
  results.inner_load.resize(positions, rollers);
  results.outer_load.resize(positions, rollers);
  results.stiffness.resize(static_cast<std::size_t>(positions));
  results.reports.assign(static_cast<std::size_t>(positions), {});
  const double step = two_pi / (positions * rollers), unit = block_.unit_length();
  for (int first = 0; first < positions; first += kBlock) {
    const int count = std::min(kBlock, positions - first);
    double* const of_rollers = results.rollers.data() + 2 * rollers * first;
    block_.start_near(near == nullptr ? nullptr : near->rollers.data() + 2 * rollers * first);
    for (int lane = 0; lane < kBlock; ++lane) {
      const int position = first + std::min(lane, count - 1);
      block_.put(point, options_.first_roller + step * position, lane);
      if (near != nullptr)
        block_.start_at(near->displacement.col(position).matrix(), start(point, *near, position), lane);
    }
    output_.rollers = of_rollers;
    output_.lamina_loads = lamina_loads;
    if (lamina_loads != nullptr) lamina_loads += room;
    engine_->solve(block_.input(), output_, inner_.data(), outer_.data());
    for (Eigen::Index j = 0; j < rollers; ++j) {
      std::copy_n(inner_.data() + j * kBlock, count, results.inner_load.col(j).data() + first);
      std::copy_n(outer_.data() + j * kBlock, count, results.outer_load.col(j).data() + first);
    }
    for (int lane = 0; lane < count; ++lane) {
      const auto position = static_cast<std::size_t>(first + lane);
      results.displacement.col(first + lane) << unit * output_.displacement_x[lane],
          unit * output_.displacement_y[lane];
      results.stiffness[position] << output_.stiffness_xx[lane], output_.stiffness_xy[lane],
          output_.stiffness_xy[lane], output_.stiffness_yy[lane];
      results.stiffness[position] /= unit;
      SolverReport& report = results.reports[position];
      report.iterations = static_cast<int>(output_.iterations[lane]);
      report.residual = output_.residual[lane];
      report.converged = output_.converged[lane] != 0.0;
      if (!report.converged) report.message = "level rollers found no balance";
    }
  }
}

std::optional<laminae::LaminaResult> LevelPitch::laminae_under(const laminae::LaminaBearing& cut,
                                                               const OperatingPoint& point,
                                                               const PitchResults* near) {
  const int positions = options_.cage_positions, rollers = bearing_.rollers().count;
  const auto stride = static_cast<std::size_t>(rollers) * kBlock;  // from one unlike lamina to the next
  const std::size_t of_one_race = drop_.size() * stride,
                    blocks = static_cast<std::size_t>((positions + kBlock - 1) / kBlock);
  lamina_loads_.resize(2 * of_one_race * blocks);
  PitchResults pitch;
  solve(point, pitch, near, lamina_loads_.data());
  laminae::LaminaResult result = laminae::empty_result(cut, point, options_);
  const double part = 1.0 / static_cast<double>(lamina_of_.size());
  const auto put = [&](const double* loads, double load, auto column) {
    column.setZero();
    if (load == 0.0) return;
    for (std::size_t k = 0; k < lamina_of_.size(); ++k)
      column[static_cast<Eigen::Index>(k)] = part * loads[lamina_of_[k] * stride];
  };
  result.roller_tilt.setZero();
  for (int position = 0; position < positions; ++position) {
    keep_worst(pitch.reports[static_cast<std::size_t>(position)], result.report);
    result.displacement += pitch.displacement.col(position).matrix() / positions;
    const double* block = lamina_loads_.data() +
                          static_cast<std::size_t>(position / kBlock) * 2 * of_one_race + position % kBlock;
    for (int j = 0; j < rollers; ++j) {
      const Eigen::Index place = position + j * positions;
      result.inner_load[place] = pitch.inner_load(position, j);
      result.outer_load[place] = pitch.outer_load(position, j);
      const double* loads = block + j * kBlock;
      put(loads, result.inner_load[place], result.inner_lamina_load.col(place));
      put(loads + of_one_race, result.outer_load[place], result.outer_lamina_load.col(place));
    }
  }
  if (!result.report.converged) return std::nullopt;
  return result;
}

}  // namespace orbearing::bearing::vectorised
