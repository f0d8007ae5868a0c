#include "bearing/equilibrium/level_pitch.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <numeric>

#include "bearing/contact/race_form.hpp"

namespace orbearing::bearing::vectorised {

namespace {

using boost::math::double_constants::two_pi;

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

}  // namespace

std::optional<LevelPitch> LevelPitch::of(const Bearing& bearing, const QuasiStaticOptions& options,
                                         mechanics::InstructionSet set) {
  if (!is_round(bearing) || options.film) return std::nullopt;
  const std::vector<double> drops = drops_at(bearing, Race::inner);
  if (!are_same(drops, {drops.rbegin(), drops.rend()}) || !are_same(drops, drops_at(bearing, Race::outer)))
    return std::nullopt;
  std::vector<std::size_t> order(drops.size()), lamina_of(drops.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return drops[a] < drops[b]; });
  UnlikeLaminae laminae;
  const double same = same_drop(drops);
  for (const std::size_t k : order) {
    if (laminae.drop.empty() || drops[k] > laminae.drop.back() + same) {
      laminae.drop.push_back(drops[k]);
      laminae.share.push_back(0.0);
    }
    laminae.share.back() += 1.0 / static_cast<double>(drops.size());
    lamina_of[k] = laminae.drop.size() - 1;
  }
  return LevelPitch(bearing, options, std::move(laminae), std::move(lamina_of), set);
}

LevelPitch::LevelPitch(const Bearing& bearing, const QuasiStaticOptions& options, UnlikeLaminae laminae,
                       std::vector<std::size_t> lamina_of, mechanics::InstructionSet set)
    : bearing_(bearing),
      options_(options),
      unlike_(laminae.drop.size()),
      lamina_of_(std::move(lamina_of)),
      block_(bearing, options.inertia, set, std::move(laminae)) {}

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
  const std::size_t room = 2 * unlike_ * static_cast<std::size_t>(rollers) * kBlock;
  results.load = point.bore_load;
  results.rollers.resize(
      static_cast<std::size_t>(2 * rollers * ((positions + kBlock - 1) / kBlock) * kBlock));
  results.displacement.resize(2, positions);
  results.inner_load.resize(positions, rollers);
  results.outer_load.resize(positions, rollers);
  results.stiffness.resize(static_cast<std::size_t>(positions));
  results.reports.assign(static_cast<std::size_t>(positions), {});
  const double step = two_pi / (positions * rollers);
  for (int first = 0; first < positions; first += kBlock) {
    const int count = std::min(kBlock, positions - first);
    block_.start_near(near == nullptr ? nullptr : near->rollers.data() + 2 * rollers * first);
    for (int lane = 0; lane < kBlock; ++lane) {
      const int position = first + std::min(lane, count - 1);
      block_.put(point, options_.first_roller + step * position, lane);
      if (near != nullptr)
        block_.start_at(near->displacement.col(position).matrix(), start(point, *near, position), lane);
    }
    const EquilibriumOutput& found =
        block_.solve(first, count, results.displacement, results.inner_load, results.outer_load,
                     results.rollers.data() + 2 * rollers * first, lamina_loads);
    if (lamina_loads != nullptr) lamina_loads += room;
    for (int lane = 0; lane < count; ++lane) {
      const auto position = static_cast<std::size_t>(first + lane);
      results.stiffness[position] << found.stiffness_xx[lane], found.stiffness_xy[lane],
          found.stiffness_xy[lane], found.stiffness_yy[lane];
      results.stiffness[position] /= block_.unit_length();
      SolverReport& report = results.reports[position];
      report.iterations = static_cast<int>(found.iterations[lane]);
      report.residual = found.residual[lane];
      report.converged = found.converged[lane] != 0.0;
      if (!report.converged) report.message = "level rollers found no balance";
    }
  }
}

std::optional<laminae::LaminaResult> LevelPitch::laminae_under(const laminae::LaminaBearing& cut,
                                                               const OperatingPoint& point,
                                                               const PitchResults* near) {
  const int positions = options_.cage_positions, rollers = bearing_.rollers().count;
  const auto stride = static_cast<std::size_t>(rollers) * kBlock;  // from one unlike lamina to the next
  const std::size_t of_one_race = unlike_ * stride,
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
