#include "coupling/study/two_way.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace orbearing::study {

namespace {

using bearing::dynamics::Snapshot;
using bearing::dynamics::StatisticsCollector;
using bearing::dynamics::WindowStatistics;
using boost::math::double_constants::two_pi;

constexpr long kStatesPerSample =
    5;  // of the series, for one state of the means; loads are taken at every step

// The run in progress.
class TwoWayRun {
 public:
  TwoWayRun(cosim::CoupledMotion& motion, double interval, const integration::SteadyStateOptions& options)
      : motion_(motion), samples_(options.series_samples), interval_(interval) {
    motion_.take_snapshot(0, snapshot_);
    for (int b = 0; b < motion_.bearings(); ++b) {
      collectors_.emplace_back(snapshot_.angle.size(), options.places,
                               bearing::dynamics::uneven_laminae(snapshot_.laminae));
      targets_.push_back(nullptr);
    }
  }

  /// Means of all bearings over `windows` windows; `series`, where given, keeps the last one of the first
  /// bearing.
  std::vector<WindowStatistics> advance(int windows, integration::BearingSeries* series) {
    begin();
    if (series) resize(*series, snapshot_.angle.size(), samples_);
    const long all = samples_ * windows;
    for (long sample = 1; sample <= all; ++sample) {
      motion_.advance(time(++done_));
      if (sample % kStatesPerSample == 0 || sample == all) add_states();
      const long of_last = sample - (all - samples_) - 1;
      if (series && of_last >= 0) keep(of_last, *series);
    }
    std::vector<WindowStatistics> means;
    for (const StatisticsCollector& collector : collectors_) means.push_back(collector.means());
    return means;
  }

 private:
  double time(long sample) const { return static_cast<double>(sample) * interval_; }

  void begin() {
    for (int b = 0; b < motion_.bearings(); ++b) {
      const auto place = static_cast<std::size_t>(b);
      motion_.take_snapshot(b, snapshot_);
      collectors_[place].begin(time(done_), snapshot_);
      targets_[place] = &collectors_[place];
    }
    motion_.collect_loads(targets_);
  }

  void add_states() {
    for (int b = 0; b < motion_.bearings(); ++b) {
      motion_.take_snapshot(b, snapshot_);
      collectors_[static_cast<std::size_t>(b)].add_state(time(done_), snapshot_);
    }
  }

  void keep(long sample, integration::BearingSeries& series) {
    motion_.take_snapshot(0, snapshot_);
    record(time(done_), snapshot_, sample, series);
  }

  cosim::CoupledMotion& motion_;
  long samples_;     // of one window
  double interval_;  // [s]
  long done_ = 0;    // samples since the start
  Snapshot snapshot_;
  std::vector<StatisticsCollector> collectors_;
  std::vector<StatisticsCollector*> targets_;
};

using RaceStatistics = bearing::dynamics::RaceStatistics;

// Sums over bearings, to be divided by their number.
void add(const RaceStatistics& one, RaceStatistics& sum) {
  sum.roller_rms += one.roller_rms.square();
  sum.load_rms += one.load_rms * one.load_rms;
  sum.load_max = std::max(sum.load_max, one.load_max);
  sum.mean_load += one.mean_load;
  sum.passages += one.passages;
  sum.damage += one.damage;
  sum.lamina_damage += one.lamina_damage;
  sum.lamina_load_max = std::max(sum.lamina_load_max, one.lamina_load_max);
  sum.mean_sliding += one.mean_sliding;
  sum.least_film = std::min(sum.least_film, one.least_film);
}

RaceStatistics zero(const RaceStatistics& like) {
  return {.roller_rms = Eigen::ArrayXd::Zero(like.roller_rms.size()),
          .mean_load = Eigen::ArrayXd::Zero(like.mean_load.size()),
          .passages = Eigen::ArrayXd::Zero(like.passages.size()),
          .damage = Eigen::ArrayXd::Zero(like.damage.size()),
          .lamina_damage = Eigen::ArrayXXd::Zero(like.lamina_damage.rows(), like.lamina_damage.cols()),
          .least_film = like.least_film};
}

void divide(double number, RaceStatistics& sum) {
  sum.roller_rms = (sum.roller_rms / number).sqrt();
  sum.load_rms = std::sqrt(sum.load_rms / number);
  sum.mean_load /= number;
  sum.passages /= number;
  sum.damage /= number;
  sum.lamina_damage /= number;
  sum.mean_sliding /= number;
}

}  // namespace

WindowStatistics pooled(const std::vector<WindowStatistics>& bearings) {
  WindowStatistics all{.samples = bearings.front().samples,
                       .duration = bearings.front().duration,
                       .inner = zero(bearings.front().inner),
                       .outer = zero(bearings.front().outer)};
  const double number = static_cast<double>(bearings.size());
  for (const WindowStatistics& one : bearings) {
    add(one.inner, all.inner);
    add(one.outer, all.outer);
    all.cage_speed += one.cage_speed / number;
    all.mean_spin += one.mean_spin / number;
    all.mean_cage_eccentricity += one.mean_cage_eccentricity / number;
    all.largest_cage_eccentricity = std::max(all.largest_cage_eccentricity, one.largest_cage_eccentricity);
    all.mean_cage_position += one.mean_cage_position / number;
    all.bore_friction_moment += one.bore_friction_moment / number;
    all.loss += one.loss / number;
  }
  divide(number, all.inner);
  divide(number, all.outer);
  return all;
}

double sample_interval(double kinematic_cage_speed, const integration::SteadyStateOptions& options) {
  return two_pi / std::abs(kinematic_cage_speed) / static_cast<double>(options.series_samples);
}

TwoWayMeans run_two_way(cosim::CoupledMotion& motion, double kinematic_cage_speed, double kinematic_spin,
                        const integration::SteadyStateOptions& options) {
  const double window = two_pi / std::abs(kinematic_cage_speed);
  TwoWayRun run(motion, sample_interval(kinematic_cage_speed, options), options);
  TwoWayMeans result;
  integration::SteadyStateResult& all = result.pooled;
  all.kinematic_cage_speed = kinematic_cage_speed;
  all.kinematic_spin = kinematic_spin;
  while (static_cast<int>(all.windows.size()) < options.most_windows && !all.steady) {
    all.windows.push_back(pooled(run.advance(1, nullptr)));
    const std::size_t done = all.windows.size();
    if (done < 2 || static_cast<int>(done) < options.least_windows) continue;
    all.steady = is_steady(all.windows[done - 2], all.windows[done - 1], kinematic_cage_speed, options);
  }
  result.bearings = run.advance(options.observed_windows, &all.series);
  all.statistics = pooled(result.bearings);
  result.duration =
      window * static_cast<double>(all.windows.size() + static_cast<std::size_t>(options.observed_windows));
  all.completed = true;
  if (!all.steady) all.message = "the means still drifted after the last window";
  return result;
}

}  // namespace orbearing::study
