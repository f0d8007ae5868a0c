#include "coupling/integration/steady_state.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "bearing/motion/driven_bore.hpp"
#include "bearing/motion/equations.hpp"
#include "bearing/motion/initial_state.hpp"
#include "coupling/integration/in_place.hpp"
#include "coupling/integration/integrate_bearing.hpp"

namespace orbearing::integration {

namespace {

using bearing::dynamics::BearingModel;
using bearing::dynamics::PlanetBearingEquations;
using bearing::dynamics::Snapshot;
using bearing::dynamics::StatisticsCollector;
using bearing::dynamics::WindowStatistics;
using boost::math::double_constants::two_pi;

constexpr double kLongestWindow =
    4.0;  // of a kinematic revolution: a cage that stands shall not hold up the run

}  // namespace

void resize(BearingSeries& series, Eigen::Index rollers, Eigen::Index samples) {
  for (Eigen::ArrayXXd* matrix :
       {&series.angle, &series.inner_load, &series.outer_load, &series.inner_sliding, &series.outer_sliding,
        &series.inner_film, &series.outer_film, &series.pocket_load, &series.spin})
    matrix->setZero(rollers, samples);
  series.time.setZero(samples);
  series.cage_position.setZero(2, samples);
  series.cage_angle.setZero(samples);
  series.cage_speed.setZero(samples);
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
  series.pocket_load.col(i) = now.pocket_load;
  series.spin.col(i) = now.spin;
  series.cage_position.col(i) = now.cage_position;
  series.cage_angle[i] = now.cage_angle;
  series.cage_speed[i] = now.cage_speed;
  series.power_loss[i] = now.loss.total();
}

IntegrationOptions integration_options(const BearingModel& model, const SteadyStateOptions& options) {
  IntegrationOptions settings = options.integration;
  settings.allowed_error = bearing_allowed_errors(model.layout, options.allowed_length_error,
                                                  model.geometry.pitch_radius, roller_frequency(model));
  if (settings.method == Method::linearly_implicit && !bearing::fast::supports(model))
    settings.method = Method::dopri5;
  return settings;
}

bool is_steady(const WindowStatistics& before, const WindowStatistics& now, double kinematic_cage_speed,
               const SteadyStateOptions& options) {
  const auto close = [&](double a, double b) {
    return std::abs(a - b) <= options.load_drift * std::max(a, b);
  };
  return close(before.inner.load_rms, now.inner.load_rms) &&
         close(before.outer.load_rms, now.outer.load_rms) &&
         std::abs(before.cage_speed - now.cage_speed) <= options.cage_drift * std::abs(kinematic_cage_speed);
}

namespace {

// Keeps the samples of the last window as series.
class Recorder {
 public:
  Recorder(const OutputTimes& output, long per_window, long wanted, Eigen::Index rollers,
           BearingSeries* series)
      : series_(series),
        stride_(std::max(1L, per_window / std::max(1L, wanted))),
        sample_(per_window - output.samples) {
    if (series_) resize(*series_, rollers, (per_window - 1) / stride_ + 1);
  }

  bool wants_next() const { return series_ && sample_ >= 0 && sample_ % stride_ == 0; }
  void add(double time, const Snapshot& now) {
    if (wants_next()) record(time, now, sample_ / stride_, *series_);
    ++sample_;
  }

 private:
  BearingSeries* series_;
  long stride_;
  long sample_;  // of the last window; negative before it
};

// Ends an integration from within its observer.
struct CameOut {
  double time;  // [s]
  std::string reason;
};

// The run in progress: state, time and the length of the next window.
class SteadyRun {
 public:
  SteadyRun(const PlanetBearingEquations& equations, const SteadyStateOptions& options,
            SteadyStateResult& result)
      : equations_(equations),
        options_(options),
        result_(result),
        collector_(model().layout.rollers, options.places,
                   bearing::dynamics::uneven_laminae(cut_races(model()))),
        race_speeds_(bearing::dynamics::race_speeds(model().geometry, model().point.inner_speed,
                                                    model().point.outer_speed)),
        window_(two_pi / std::abs(result.kinematic_cage_speed)) {
    settings_ = integration_options(model(), options);
    if (settings_.method == Method::linearly_implicit) vectorised_.emplace(model());
  }

  /// Runs `windows` windows as one and returns their means; empty statistics where the integration failed.
  WindowStatistics advance(int windows, BearingSeries* series) {
    const long per_window = samples_per_window();
    const OutputTimes output{time_, window_ / static_cast<double>(per_window), per_window * windows};
    take_snapshot(model(), result_.final_state, snapshot_, time_);
    collector_.begin(time_, snapshot_);
    add_to_report(advanced(output, series));
    time_ = output.time(output.samples);
    if (!result_.report.completed) return {};
    const WindowStatistics means = collector_.means();
    set_window(means);
    return means;
  }

 private:
  const BearingModel& model() const { return equations_.model(); }

  // Loads are taken at every step of the vectorised bearing, so that fewer states do for all other means.
  static constexpr long kStatesPerSample = 5;  // of the series, for one state of the means
  long samples_per_window() const {
    return vectorised_ ? options_.series_samples : options_.samples_per_window;
  }

  IntegrationReport advanced(const OutputTimes& output, BearingSeries* series) {
    try {
      return vectorised_ ? advance_vectorised(output, series) : advance_readable(output, series);
    } catch (const CameOut& end) {
      IntegrationReport report;
      report.reached = end.time;
      report.message = end.reason;
      return report;
    }
  }

  void require_in_place(double time, const Eigen::Ref<const Eigen::VectorXd>& x) {
    const std::string reason = out_of_place(model(), x);
    if (!reason.empty()) throw CameOut{time, reason};
  }

  BoreSample bore_sample(double time, const Eigen::Ref<const Eigen::VectorXd>& x) const {
    const bearing::dynamics::BearingModel& m = model();
    const bearing::OperatingPoint& point = m.point;
    const bearing::dynamics::BoreMotion motion{.position = x.segment<2>(m.layout.bore()),
                                               .velocity = x.segment<2>(m.layout.bore() + 2),
                                               .speed = point.outer_speed,
                                               .angle = point.outer_speed * time,
                                               .carrier_speed = point.carrier.speed,
                                               .carrier_acceleration = point.carrier.acceleration};
    return {time, 1.0, motion.position, motion.velocity, reaction(m, motion, x).force};
  }

  IntegrationReport advance_readable(const OutputTimes& output, BearingSeries* series) {
    Recorder recorder(output, samples_per_window(), options_.series_samples, model().layout.rollers, series);
    const auto observe = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x) {
      require_in_place(time, x);
      take_snapshot(model(), x, snapshot_, time);
      collector_.add(time, snapshot_);
      recorder.add(time, snapshot_);
      if (series && options_.on_bore) options_.on_bore(bore_sample(time, x));
    };
    return integrate(derivative(), result_.final_state, output, settings_, observe);
  }

  IntegrationReport advance_vectorised(const OutputTimes& output, BearingSeries* series) {
    Recorder recorder(output, samples_per_window(), options_.series_samples, model().layout.rollers, series);
    long sample = 0;
    const auto observe = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x) {
      require_in_place(time, x);
      const bool counts = ++sample % kStatesPerSample == 0 || sample == output.samples;
      if (counts || recorder.wants_next()) take_snapshot(model(), x, snapshot_, time);
      if (counts) collector_.add_state(time, snapshot_);
      recorder.add(time, snapshot_);
    };
    const auto on_step = [&](const StepSample& step) {
      const int lanes = vectorised_->layout().lanes();
      collector_.add_loads(step.weight, {step.state + lanes, step.state + 3 * lanes, step.inner_load,
                                         step.outer_load, race_speeds_, cut_races(model()),
                                         step.inner_approach, step.outer_approach, step.tip});
      if (!series || !options_.on_bore) return;
      const double* bore = step.state + vectorised_->layout().bore();
      options_.on_bore({step.time, step.weight, {bore[0], bore[1]}, {bore[2], bore[3]}, step.bore_force});
    };
    return integrate_bearing(*vectorised_, result_.final_state, output, settings_, observe, on_step);
  }

  RightHandSide derivative() const {
    return [this](double time, const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> dx) {
      equations_.derivative(time, x, dx);
    };
  }

  // The next window lasts one revolution at the speed the cage had in this one.
  void set_window(const WindowStatistics& means) {
    const double kinematic = two_pi / std::abs(result_.kinematic_cage_speed);
    window_ = std::min(two_pi / std::max(std::abs(means.cage_speed), 1e-300), kLongestWindow * kinematic);
    settings_.step = std::min(settings_.step, window_ / static_cast<double>(samples_per_window()));
  }

  void add_to_report(const IntegrationReport& part) {
    IntegrationReport& all = result_.report;
    append(part, all);
    settings_.most_seconds = options_.integration.most_seconds - all.wall_seconds;
    settings_.most_steps = options_.integration.most_steps - all.steps;
  }

  const PlanetBearingEquations& equations_;
  std::optional<bearing::fast::VectorBearing> vectorised_;
  const SteadyStateOptions& options_;
  SteadyStateResult& result_;
  IntegrationOptions settings_;
  StatisticsCollector collector_;
  Snapshot snapshot_;
  bearing::dynamics::RaceSpeeds race_speeds_;
  double window_;      // [s]
  double time_ = 0.0;  // [s]
};

// Windows until two in turn agree or there have been enough. False where the integration failed.
bool settle(SteadyRun& run, const SteadyStateOptions& options, SteadyStateResult& result) {
  while (static_cast<int>(result.windows.size()) < options.most_windows && !result.steady) {
    result.windows.push_back(run.advance(1, nullptr));
    if (!result.report.completed) return false;
    const std::size_t done = result.windows.size();
    if (done < 2 || static_cast<int>(done) < options.least_windows) continue;
    result.steady =
        is_steady(result.windows[done - 2], result.windows[done - 1], result.kinematic_cage_speed, options);
  }
  return true;
}

SteadyStateResult run_from(Eigen::VectorXd start, const PlanetBearingEquations& equations,
                           const SteadyStateOptions& options) {
  const BearingModel& model = equations.model();
  const bearing::OperatingPoint& point = model.point;
  if (model.driving.growth != 0.0)
    throw std::invalid_argument(
        "growth of the speeds: found a run-up, which has no steady state; required: 0");
  SteadyStateResult result;
  result.kinematic_cage_speed = model.kinematic_cage_speed;
  result.kinematic_spin =
      bearing::kinematic_roller_spin(model.geometry, point.inner_speed, point.outer_speed);
  if (result.kinematic_cage_speed == 0.0)
    throw std::invalid_argument(
        "speed of the races: found a standing cage; required: races that turn the cage");
  result.final_state = std::move(start);
  SteadyRun run(equations, options, result);
  if (settle(run, options, result)) result.statistics = run.advance(options.observed_windows, &result.series);
  result.completed = result.report.completed;
  result.message = result.report.message;
  if (result.completed && !result.steady) result.message = "the means still drifted after the last window";
  return result;
}

}  // namespace

SteadyStateResult run_to_steady_state(const bearing::CylindricalRollerBearing& bearing,
                                      const bearing::OperatingPoint& point,
                                      const bearing::dynamics::DynamicsParameters& parameters,
                                      const SteadyStateOptions& options) {
  const PlanetBearingEquations equations(bearing_model(bearing, point, parameters));
  const bearing::dynamics::InitialState start =
      initial_state(bearing, equations.model(), parameters, options.first_roller);
  return run_from(start.x, equations, options);
}

SteadyStateResult run_to_steady_state_from(const Eigen::VectorXd& start,
                                           const bearing::CylindricalRollerBearing& bearing,
                                           const bearing::OperatingPoint& point,
                                           const bearing::dynamics::DynamicsParameters& parameters,
                                           const SteadyStateOptions& options) {
  return run_from(start, PlanetBearingEquations(bearing_model(bearing, point, parameters)), options);
}

}  // namespace orbearing::integration
