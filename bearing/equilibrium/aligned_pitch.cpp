#include "bearing/equilibrium/aligned_pitch.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bearing/carrier_frame.hpp"
#include "bearing/contact/line_contact.hpp"
#include "bearing/contact/race_form.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/force_left.hpp"

namespace orbearing::bearing::vectorised {

namespace {

using constants::two_pi;

// Difference of equal laminae at both ends: profiles are computed from both sides.
constexpr double kSameDrop = 1e-12;

double same_drop(const std::vector<double>& drops) {
  return kSameDrop * std::abs(*std::max_element(drops.begin(), drops.end()));
}

bool are_same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [same = same_drop(a)](double x, double y) { return std::abs(x - y) <= same; });
}

void make_room(int positions, int rollers, PitchResults& results) {
  results.states.clear();
  results.displacement.resize(2, positions);
  results.inner_load.resize(positions, rollers);
  results.outer_load.resize(positions, rollers);
  results.stiffness.resize(static_cast<std::size_t>(positions));
  results.reports.assign(static_cast<std::size_t>(positions), {});
}

AlignedEngine* make_engine([[maybe_unused]] mechanics::InstructionSet set,
                           const AlignedConstants& constants) {
#ifdef ORBEARING_HAS_AVX512
  if (set == mechanics::InstructionSet::avx512) return avx512_aligned_engine(constants);
#endif
#ifdef ORBEARING_HAS_AVX2
  if (set == mechanics::InstructionSet::avx2) return avx2_aligned_engine(constants);
#endif
  return baseline_aligned_engine(constants);
}

}  // namespace

std::optional<AlignedPitch> AlignedPitch::of(const Bearing& bearing, const QuasiStaticOptions& options,
                                             mechanics::InstructionSet set) {
  if (!is_round(bearing) || options.film) return std::nullopt;
  const std::vector<double> drops = laminae::lamina_drops(bearing, Race::inner);
  if (!are_same(drops, {drops.rbegin(), drops.rend()}) ||
      !are_same(drops, laminae::lamina_drops(bearing, Race::outer)))
    return std::nullopt;
  std::vector<std::size_t> order(drops.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return drops[a] < drops[b]; });
  UnlikeLaminae laminae;
  laminae.lamina_of.resize(drops.size());
  const double same = same_drop(drops);
  for (const std::size_t k : order) {
    if (laminae.drop.empty() || drops[k] > laminae.drop.back() + same) {
      laminae.drop.push_back(drops[k]);
      laminae.share.push_back(0.0);
    }
    laminae.share.back() += 1.0 / static_cast<double>(drops.size());
    laminae.lamina_of[k] = laminae.drop.size() - 1;
  }
  return AlignedPitch(bearing, options, std::move(laminae), set);
}

AlignedPitch::AlignedPitch(const Bearing& bearing, const QuasiStaticOptions& options, UnlikeLaminae laminae,
                           mechanics::InstructionSet set)
    : bearing_(bearing),
      geometry_(geometry_of(bearing)),
      options_(options),
      unit_length_(roller_race_contact(bearing.contact_law, bearing.rollers().length).approach(1.0)),
      laminae_(std::move(laminae)),
      inner_(static_cast<std::size_t>(bearing.rollers().count * kBlock)),
      outer_(inner_) {
  const int rollers = bearing.rollers().count;
  for (int j = 0; j < rollers; ++j) {
    const double angle = two_pi * j / rollers;
    pocket_cosine_.push_back(std::cos(angle));
    pocket_sine_.push_back(std::sin(angle));
  }
  const double least = laminae_.drop.front();
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
void AlignedPitch::put(const OperatingPoint& point, double first_roller, int lane) {
  const CarrierFrame frame = carrier_frame(point.carrier, options_.inertia);
  const double cage_speed = kinematic_cage_speed(geometry_, point.inner_speed, point.outer_speed);
  const double mass = geometry_.element_mass;
  const Eigen::Vector2d load = total_bore_load(bearing_, geometry_, point, options_.inertia);
  input_.force_x[lane] = load.x();
  input_.force_y[lane] = load.y();
  input_.steady[lane] = mass * geometry_.pitch_radius *
                        (frame.own_orbit * cage_speed * cage_speed + 2.0 * frame.coriolis_speed * cage_speed +
                         frame.centrifugal);
  input_.cosine[lane] = mass * frame.centrifugal * frame.orbit_radius;
  input_.sine[lane] = -mass * frame.euler * frame.orbit_radius;
  input_.first_roller[lane] =
      std::abs(first_roller) < 1e6 ? first_roller : std::remainder(first_roller, two_pi);
}

void AlignedPitch::start_near(const OperatingPoint& point, const PitchResults& near, int position, int lane) {
  const Eigen::Vector2d at = near.displacement.col(position).matrix() / unit_length_;
  const Eigen::Vector2d moved =
      mechanics::lengths_under<2>(Eigen::Vector2d(point.bore_load - near.load),
                                  near.stiffness[static_cast<std::size_t>(position)]) /
      unit_length_;
  input_.near_x[lane] = at.x();
  input_.near_y[lane] = at.y();
  input_.start_x[lane] = at.x() + moved.x();
  input_.start_y[lane] = at.y() + moved.y();
}

// `count` cage angles of the block, those from `first` on of the pitch.
void AlignedPitch::take(Eigen::Index first, Eigen::Index count, PitchResults& results) const {
  for (Eigen::Index j = 0; j < results.inner_load.cols(); ++j) {
    std::copy_n(inner_.data() + j * kBlock, count, results.inner_load.col(j).data() + first);
    std::copy_n(outer_.data() + j * kBlock, count, results.outer_load.col(j).data() + first);
  }
  for (Eigen::Index lane = 0; lane < count; ++lane) {
    results.displacement.col(first + lane) << unit_length_ * output_.displacement_x[lane],
        unit_length_ * output_.displacement_y[lane];
    const auto position = static_cast<std::size_t>(first + lane);
    results.stiffness[position] << output_.stiffness_xx[lane], output_.stiffness_xy[lane],
        output_.stiffness_xy[lane], output_.stiffness_yy[lane];
    results.stiffness[position] /= unit_length_;
    SolverReport& report = results.reports[position];
    report.iterations = static_cast<int>(output_.iterations[lane]);
    report.residual = mechanics::force_left(output_.residual[lane]);
    report.converged = output_.converged[lane] != 0.0;
    if (!report.converged) report.message = "aligned rollers found no static equilibrium";
  }
}

void AlignedPitch::solve(const OperatingPoint& point, PitchResults& results, const PitchResults* near) {
  solve(point, results, near, nullptr);
}

// `lamina_loads` has room for the loads of all blocks.
void AlignedPitch::solve(const OperatingPoint& point, PitchResults& results, const PitchResults* near,
                         double* lamina_loads) {
  require_finite(point);
  const int positions = options_.cage_positions, rollers = bearing_.rollers().count;
  make_room(positions, rollers, results);
  results.load = point.bore_load;
  results.rollers.resize(
      static_cast<std::size_t>(2 * rollers * ((positions + kBlock - 1) / kBlock) * kBlock));
  const double step = two_pi / (positions * rollers);
  output_.lamina_loads = lamina_loads;
  for (int first = 0; first < positions; first += kBlock) {
    const int count = std::min(kBlock, positions - first);
    input_.near_rollers = near == nullptr ? nullptr : near->rollers.data() + 2 * rollers * first;
    output_.rollers = results.rollers.data() + 2 * rollers * first;
    for (int lane = 0; lane < kBlock; ++lane) {
      const int position = first + std::min(lane, count - 1);
      put(point, options_.first_roller + step * position, lane);
      if (near != nullptr) start_near(point, *near, position, lane);
    }
    engine_->solve(input_, output_, inner_.data(), outer_.data());
    take(first, count, results);
    if (lamina_loads != nullptr)
      output_.lamina_loads += 2 * laminae_.drop.size() * static_cast<std::size_t>(rollers * kBlock);
  }
}

std::optional<QuasiStaticResult> AlignedPitch::under(const laminae::LaminaBearing& bearing,
                                                     const OperatingPoint& point, const PitchResults* near) {
  const int positions = options_.cage_positions, rollers = bearing_.rollers().count;
  const auto stride = static_cast<std::size_t>(rollers) * kBlock;  // from one unlike lamina to the next
  const std::size_t of_one_race = laminae_.drop.size() * stride,
                    blocks = static_cast<std::size_t>((positions + kBlock - 1) / kBlock);
  lamina_loads_.resize(bearing.is_cut() ? 2 * of_one_race * blocks : 0);
  PitchResults pitch;
  solve(point, pitch, near, bearing.is_cut() ? lamina_loads_.data() : nullptr);
  QuasiStaticResult result = empty_result(bearing, point, options_);
  const double part = 1.0 / static_cast<double>(laminae_.lamina_of.size());
  const auto put = [&](const double* loads, double load, auto column) {
    column.setZero();
    if (load == 0.0) return;
    for (std::size_t k = 0; k < laminae_.lamina_of.size(); ++k)
      column[static_cast<Eigen::Index>(k)] = part * loads[laminae_.lamina_of[k] * stride];
  };
  for (int position = 0; position < positions; ++position) {
    keep_worst(pitch.reports[static_cast<std::size_t>(position)], result.report);
    result.displacement += pitch.displacement.col(position).matrix() / positions;
    const double* block = lamina_loads_.data() +
                          static_cast<std::size_t>(position / kBlock) * 2 * of_one_race + position % kBlock;
    for (int j = 0; j < rollers; ++j) {
      const Eigen::Index column = position + j * positions;
      result.inner_load[column] = pitch.inner_load(position, j);
      result.outer_load[column] = pitch.outer_load(position, j);
      if (!bearing.is_cut()) continue;
      const double* loads = block + j * kBlock;
      put(loads, result.inner_load[column], result.inner_lamina_load.col(column));
      put(loads + of_one_race, result.outer_load[column], result.outer_lamina_load.col(column));
    }
  }
  if (!result.report.converged) return std::nullopt;
  return result;
}

// Each search starts from the result of `near` at that cage angle, displaced along its tangent by the change
// of the load; else from the cage angle before.
void PitchSearch::solve(const OperatingPoint& point, PitchResults& results, const PitchResults* near) {
  if (level_ && AlignedPitch::holds(point)) {
    level_->solve(point, results, near && !near->rollers.empty() ? near : nullptr);
    if (std::all_of(results.reports.begin(), results.reports.end(),
                    [](const SolverReport& report) { return report.converged; }))
      return;
  }
  const int positions = options_.cage_positions, rollers = bearing_.bearing().rollers().count;
  make_room(positions, rollers, results);
  results.load = point.bore_load;
  results.rollers.clear();
  for (int position = 0; position < positions; ++position) {
    const auto i = static_cast<std::size_t>(position);
    QuasiStaticState start;
    if (near && !near->states.empty()) {
      start = near->states[i];
      start.displacement +=
          mechanics::lengths_under<2>(Eigen::Vector2d(point.bore_load - near->load), start.stiffness);
    } else if (position > 0) {
      start = results.states.back();
    }
    const double first = options_.first_roller + position * two_pi / (positions * rollers);
    QuasiStaticState state =
        quasi_static_state(bearing_, point, options_, first, start.angle.size() > 0 ? &start : nullptr);
    results.displacement.col(position) = state.displacement;
    results.stiffness[i] = state.stiffness;
    results.inner_load.row(position) = state.inner_load.transpose();
    results.outer_load.row(position) = state.outer_load.transpose();
    results.reports[i] = state.report;
    results.states.push_back(std::move(state));
  }
}

}  // namespace orbearing::bearing::vectorised
