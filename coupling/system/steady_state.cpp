#include "coupling/system/steady_state.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "bearing/motion/initial_state.hpp"
#include "bearing/motion/model.hpp"
#include "coupling/system/free_bearing.hpp"
#include "coupling/system/motion_progress.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::system {

namespace {

using bearing::motion::BearingModel;
using bearing::motion::RaceStatistics;
using bearing::motion::Snapshot;
using bearing::motion::StatisticsCollector;
using bearing::motion::WindowStatistics;
using constants::two_pi;
using integration::OutputTimes;

constexpr double kLongestWindow =
    4.0;  // of a kinematic revolution: a stationary cage must not hold up the run
// If loads are taken at every step, fewer states are sufficient for all other means:
constexpr long kSamplesPerState = 5;            // of the series, for one state of the means
constexpr double kGolden = 0.6180339887498949;  // [-]
constexpr long kSamplesApart = 25;              // of the series, on the way to the steady state

void resize(BearingSeries& series, const Snapshot& like, Eigen::Index samples) {
  const Eigen::Index rollers = like.angle.size();
  series.caged = like.caged;
  for (Eigen::ArrayXXd* matrix :
       {&series.angle, &series.inner_load, &series.outer_load, &series.inner_sliding, &series.outer_sliding,
        &series.inner_film, &series.outer_film, &series.neighbour_load, &series.pocket_load, &series.spin})
    matrix->setZero(rollers, samples);
  series.time.setZero(samples);
  series.cage_position.setZero(2, samples);
  series.orbit_angle.setZero(samples);
  series.orbit_speed.setZero(samples);
  series.power_loss.setZero(samples);
}

void record(double time, const Snapshot& now, Eigen::Index i, BearingSeries& series) {
  series.time[i] = time;
  series.angle.col(i) = now.angle;
  series.inner_load.col(i) = now.inner.load;
  series.outer_load.col(i) = now.outer.load;
  series.inner_sliding.col(i) = now.inner.sliding;
  series.outer_sliding.col(i) = now.outer.sliding;
  series.inner_film.col(i) = now.inner.least_film;
  series.outer_film.col(i) = now.outer.least_film;
  if (now.caged)
    series.pocket_load.col(i) = now.pocket_load;
  else
    series.neighbour_load.col(i) = now.neighbour_load;
  series.spin.col(i) = now.spin;
  series.cage_position.col(i) = now.cage_position;
  series.orbit_angle[i] = now.orbit_angle;
  series.orbit_speed[i] = now.orbit_speed;
  series.power_loss[i] = now.loss.total();
}

// Keeps samples of the last window as series.
class Recorder {
 public:
  Recorder(long all, long per_window, long wanted, const Snapshot& like, BearingSeries* series)
      : series_(series), stride_(std::max(1L, per_window / std::max(1L, wanted))), before_(all - per_window) {
    if (series_) resize(*series_, like, (per_window - 1) / stride_ + 1);
  }

  /// Samples count from 1.
  bool wants(long sample) const {
    return series_ && sample > before_ && (sample - 1 - before_) % stride_ == 0;
  }
  void take(long sample, double time, const Snapshot& now) {
    record(time, now, (sample - 1 - before_) / stride_, *series_);
  }

 private:
  BearingSeries* series_;
  long stride_;
  long before_;  // samples before the last window
};

// Gathers what bearings in motion show.
class Observation {
 public:
  /// `most` [s]: the latest time that it will come to. `rolling_cage_speed` [rad/s]: for those who watch.
  Observation(Motion& motion, const SteadyStateOptions& options, double most, double rolling_cage_speed)
      : motion_(motion), options_(options), most_(most), rolling_cage_speed_(rolling_cage_speed) {
    motion_.take_snapshot(0, snapshot_);
    for (int b = 0; b < motion_.bearings(); ++b)
      collectors_.emplace_back(snapshot_.angle.size(), options.bins, uneven_laminae(snapshot_.laminae));
  }

  /// The time [s] that the motion is expected to come to, for those who watch.
  void expect(double end) { expected_ = end; }

  /// Means of all bearings over `times`; `series`, if given, keeps the last `per_window` of the first one.
  /// Without it only the criteria of a steady state are computed: loads, and the cage's turn from end to end.
  /// If the look among them ends the run, `times` end there.
  std::vector<WindowStatistics> through(OutputTimes& times, long per_window, BearingSeries* series) {
    StepObservers observers{{}, series ? options_.on_bore : BoreObserver()};
    for (int b = 0; b < motion_.bearings(); ++b) {
      motion_.take_snapshot(b, snapshot_);
      of(b).begin(times.time(0), snapshot_);
      observers.loads.push_back(&of(b));
    }
    motion_.observe_steps(observers);
    Recorder recorder(times.samples, per_window, options_.series_samples, snapshot_, series);
    const long states = series ? kSamplesPerState : times.samples;
    const long apart = !motion_.shows_steps() ? 1 : std::gcd(per_window, series ? states : kSamplesApart);
    const long look = series ? std::min(options_.look.windows * per_window, times.samples) : 0;
    long sample = 0;
    const auto advance_to = [&](long end, long stride) {
      if (end <= sample) return;
      const OutputTimes part{times.start, static_cast<double>(stride) * times.interval,
                             (end - sample) / stride, (times.passed + sample) / stride};
      motion_.advance(part, [&](double time) {
        sample += stride;
        show(time, sample, states, sample == times.samples || sample == look, recorder);
      });
    };
    const long before_series = series ? times.samples - per_window : times.samples;
    if (look > 0) {
      advance_to(std::min(look, before_series), apart);
      advance_to(look, 1);
      if (!options_.look.goes_on()) times.samples = look;
    }
    advance_to(std::min(before_series, times.samples), apart);
    advance_to(times.samples, 1);
    std::vector<WindowStatistics> means;
    for (const StatisticsCollector& collector : collectors_) means.push_back(collector.means());
    return means;
  }

 private:
  // If steps show loads, one bearing at a time gives the states for all other means, and all of them the
  // last. The order follows the golden ratio, so that no bearing is always observed in the same position.
  void show(double time, long sample, long states, bool last, Recorder& recorder) {
    const bool all = last || !motion_.shows_steps();
    const double turns = kGolden * static_cast<double>(sample / states);
    const int turn = static_cast<int>((turns - std::floor(turns)) * motion_.bearings());
    for (int b = motion_.bearings() - 1; b >= 0; --b) {
      const bool counts = all || (sample % states == 0 && b == turn),
                 recorded = b == 0 && recorder.wants(sample);
      if (!counts && !recorded) continue;
      motion_.take_snapshot(b, snapshot_);
      if (counts) add(time, of(b));
      if (recorded) recorder.take(sample, time, snapshot_);
    }
    if (!watched_.is_due()) return;
    motion_.take_snapshot(0, snapshot_);
    watched_.tell({time, most_, std::min(most_, expected_), rolling_cage_speed_, snapshot_});
  }
  StatisticsCollector& of(int b) { return collectors_[static_cast<std::size_t>(b)]; }
  void add(double time, StatisticsCollector& collector) const {
    if (motion_.shows_steps())
      collector.add_state(time, snapshot_);
    else
      collector.add(time, snapshot_);
  }

  Motion& motion_;
  const SteadyStateOptions& options_;
  double most_;                // [s]
  double rolling_cage_speed_;  // [rad/s]
  double expected_ = most_;    // [s]
  WatchedMotion watched_;
  Snapshot snapshot_;
  std::vector<StatisticsCollector> collectors_;
};

// Windows in turn. One lasts a revolution of the cage: at the speed that it had in the window before, or at
// the kinematic one where one interval holds for all; or as long as is stated.
class Windows {
 public:
  Windows(Motion& motion, const RollingSpeeds& rolling, const SteadyStateOptions& options)
      : motion_(motion),
        options_(options),
        revolution_(window_length(rolling, options)),
        observation_(motion, options, revolution_ * (options.most_windows + options.observed_windows),
                     rolling.cage),
        per_window_(motion.shows_steps() ? options.series_samples : options.samples_per_window) {
    times_.interval = revolution_ / static_cast<double>(per_window_);
  }

  /// Means of all bearings over the next `windows` taken as one.
  std::vector<WindowStatistics> next(int windows, BearingSeries* series) {
    times_.samples = per_window_ * windows;
    const int settling = series ? 0 : std::max(0, options_.least_windows - ++begun_);
    observation_.expect(times_.time(times_.samples) +
                        times_.interval * static_cast<double>(per_window_) *
                            (settling + (series ? 0 : options_.observed_windows)));
    std::vector<WindowStatistics> means = observation_.through(times_, per_window_, series);
    if (motion_.keeps_to_interval() || options_.window > 0.0) {
      times_.passed += times_.samples;
    } else {
      const double turn = two_pi / std::max(std::abs(pooled(means).orbit_speed), 1e-300);
      times_.start = times_.time(times_.samples);
      times_.interval = std::min(turn, kLongestWindow * revolution_) / static_cast<double>(per_window_);
    }
    return means;
  }
  double time() const { return times_.time(0); }  // [s]

 private:
  Motion& motion_;
  const SteadyStateOptions& options_;
  double revolution_;  // [s]  of the cage at its kinematic speed, or of a stated window
  Observation observation_;
  long per_window_;  // samples
  int begun_ = 0;    // windows on the way to the steady state
  OutputTimes times_;
};

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
  if (bearings.size() == 1) return bearings.front();
  WindowStatistics all{.samples = bearings.front().samples,
                       .duration = bearings.front().duration,
                       .inner = zero(bearings.front().inner),
                       .outer = zero(bearings.front().outer),
                       .mean_waves = Eigen::VectorXd::Zero(bearings.front().mean_waves.size())};
  const double number = static_cast<double>(bearings.size());
  for (const WindowStatistics& one : bearings) {
    add(one.inner, all.inner);
    add(one.outer, all.outer);
    all.orbit_speed += one.orbit_speed / number;
    all.mean_spin += one.mean_spin / number;
    all.mean_cage_eccentricity += one.mean_cage_eccentricity / number;
    all.largest_cage_eccentricity = std::max(all.largest_cage_eccentricity, one.largest_cage_eccentricity);
    all.mean_cage_position += one.mean_cage_position / number;
    all.bore_friction_moment += one.bore_friction_moment / number;
    all.vibration_power += one.vibration_power / number;
    all.mean_waves += one.mean_waves / number;
    all.loss += one.loss / number;
  }
  divide(number, all.inner);
  divide(number, all.outer);
  return all;
}

bool is_steady(const WindowStatistics& before, const WindowStatistics& now, double kinematic_cage_speed,
               const SteadyStateOptions& options) {
  const auto close = [&](double a, double b) {
    return std::abs(a - b) <= options.load_drift * std::max(a, b);
  };
  return close(before.inner.load_rms, now.inner.load_rms) &&
         close(before.outer.load_rms, now.outer.load_rms) &&
         std::abs(before.orbit_speed - now.orbit_speed) <=
             options.cage_drift * std::abs(kinematic_cage_speed);
}

double window_length(const RollingSpeeds& rolling, const SteadyStateOptions& options) {
  return options.window > 0.0 ? options.window : two_pi / std::abs(rolling.cage);
}

double sample_interval(const RollingSpeeds& rolling, const SteadyStateOptions& options) {
  return window_length(rolling, options) / static_cast<double>(options.series_samples);
}

SteadyStateResult run_to_steady_state(Motion& motion, const RollingSpeeds& rolling,
                                      const SteadyStateOptions& options) {
  if (rolling.cage == 0.0)
    throw std::invalid_argument(
        "speed of the races: found a stationary cage; required: races that rotate the cage");
  SteadyStateResult result;
  result.rolling = rolling;
  Windows windows(motion, rolling, options);
  std::vector<WindowStatistics>& done = result.windows;
  try {
    while (static_cast<int>(done.size()) < options.most_windows && !result.steady) {
      done.push_back(pooled(windows.next(1, nullptr)));
      if (done.size() < 2 || static_cast<int>(done.size()) < options.least_windows) continue;
      result.steady = is_steady(done.end()[-2], done.back(), rolling.cage, options);
    }
    result.bearings = windows.next(options.observed_windows, &result.series);
    result.statistics = pooled(result.bearings);
    result.completed = true;
    if (!result.steady) result.message = "the means still drifted after the last window";
  } catch (const std::runtime_error& error) {
    result.message = error.what();
  }
  result.duration = windows.time();
  result.report = motion.report();
  return result;
}

namespace {

RollingSpeeds rolling_speeds(const BearingModel& model) {
  return {model.kinematic_cage_speed,
          bearing::kinematic_roller_spin(model.geometry, model.point.inner_speed, model.point.outer_speed)};
}

constexpr double kLeastRatio =
    0.05;  // of the first speed: the meshes' load at constant power grows without bound

void require_speed(const bearing::motion::Driving& driving, double duration) {
  if (duration > 0.0 && speed_ratio(driving, duration) >= kLeastRatio) return;
  std::ostringstream text;
  text << "run-up: found " << driving.ramp << " 1/s for " << duration
       << " s; required: a positive time that ends at " << kLeastRatio << " of the first speed or more";
  throw std::invalid_argument(text.str());
}

// As many samples in a mean revolution of the cage as in the steady state.
long samples_of(const BearingModel& model, const SteadyStateOptions& options, double duration) {
  const double turned = std::abs(model.kinematic_cage_speed) * equivalent_time(model.driving, duration);
  const double samples = static_cast<double>(options.samples_per_window) * turned / two_pi;
  return std::max(options.series_samples, static_cast<long>(std::ceil(samples)));
}

}  // namespace

SteadyStateResult run_to_steady_state(const bearing::Bearing& bearing, const bearing::OperatingPoint& point,
                                      const bearing::motion::DynamicsParameters& parameters,
                                      const SteadyStateOptions& options,
                                      const std::optional<Eigen::VectorXd>& start) {
  const BearingModel model = bearing_model(bearing, point, parameters);
  if (model.driving.ramp != 0.0)
    throw std::invalid_argument("speed ramp: found a run-up, which has no steady state; required: 0");
  FreeBearing motion(model,
                     start ? *start : initial_state(bearing, model, parameters, options.first_roller).x,
                     options.allowed_length_error, options.integration);
  SteadyStateResult result = run_to_steady_state(
      motion, rolling_speeds(model), with_window(options, model.gravity, model.point.carrier.speed));
  result.final_state = motion.state();
  result.layout = model.layout;
  return result;
}

SteadyStateResult run_up(const bearing::Bearing& bearing, const bearing::OperatingPoint& point,
                         const bearing::motion::DynamicsParameters& parameters,
                         const SteadyStateOptions& options, double duration) {
  require_speed(parameters.driving, duration);
  if (options.look.windows > 0)
    throw std::invalid_argument("check among windows: found in a run-up, which has none; required: none");
  const BearingModel model = bearing_model(bearing, point, parameters);
  bearing::motion::DynamicsParameters before = parameters;
  before.driving = {};
  SteadyStateOptions settling = options;
  settling.observed_windows = 1;
  SteadyStateResult result = run_to_steady_state(bearing, point, before, settling);
  if (!result.completed) return result;
  FreeBearing motion(model, result.final_state, options.allowed_length_error, options.integration);
  const long samples = samples_of(model, options, duration);
  try {
    OutputTimes times{0.0, duration / static_cast<double>(samples), samples};
    result.bearings = Observation(motion, options, duration, model.kinematic_cage_speed)
                          .through(times, samples, &result.series);
    result.statistics = pooled(result.bearings);
  } catch (const std::runtime_error& error) {
    result.completed = false;
    result.message = error.what();
  }
  result.report = motion.report();
  result.final_state = motion.state();
  result.layout = model.layout;
  result.duration = duration;
  const double mean_ratio = equivalent_time(parameters.driving, duration) / duration;
  result.rolling.cage *= mean_ratio;
  result.rolling.spin *= mean_ratio;
  return result;
}

}  // namespace orbearing::system
