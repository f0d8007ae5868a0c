#include "coupling/integration/run_up.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "bearing/motion/driving.hpp"
#include "bearing/motion/equations.hpp"

namespace orbearing::integration {

namespace {

using namespace bearing::dynamics;
using boost::math::double_constants::two_pi;

constexpr double kLeastRatio =
    0.05;  // of the first speed: the meshes' load at constant power grows without bound

void require_speed(const Driving& driving, double duration) {
  if (duration > 0.0 && speed_ratio(driving, duration) >= kLeastRatio) return;
  std::ostringstream text;
  text << "run-up: found " << driving.growth << " 1/s for " << duration
       << " s; required: a positive time, at whose end at least " << kLeastRatio
       << " of the first speed is left";
  throw std::invalid_argument(text.str());
}

// As many samples in a mean revolution of the cage as in the steady state.
long samples_of(const BearingModel& model, const SteadyStateOptions& options, double duration) {
  const double turned = std::abs(model.kinematic_cage_speed) * equivalent_time(model.driving, duration);
  const double samples = static_cast<double>(options.samples_per_window) * turned / two_pi;
  return std::max(options.series_samples, static_cast<long>(std::ceil(samples)));
}

void follow(const PlanetBearingEquations& equations, const SteadyStateOptions& options, double duration,
            SteadyStateResult& result) {
  const BearingModel& model = equations.model();
  const long samples = samples_of(model, options, duration);
  const long stride = std::max(1L, samples / std::max(1L, options.series_samples));
  const double interval = duration / static_cast<double>(samples);
  StatisticsCollector collector(model.layout.rollers, options.places, uneven_laminae(cut_races(model)));
  Snapshot now;
  take_snapshot(model, result.final_state, now, 0.0);
  collector.begin(0.0, now);
  resize(result.series, model.layout.rollers, (samples - 1) / stride + 1);
  long sample = 0;
  const auto observe = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x) {
    take_snapshot(model, x, now, time);
    collector.add(time, now);
    if (sample % stride == 0) record(time, now, sample / stride, result.series);
    ++sample;
  };
  const auto derivative = [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                              Eigen::Ref<Eigen::VectorXd> dx) { equations.derivative(time, x, dx); };
  IntegrationOptions settings = integration_options(model, options);
  settings.step = std::min(settings.step, interval);
  result.report = integrate(derivative, result.final_state, {0.0, interval, samples}, settings, observe);
  result.completed = result.report.completed;
  result.message = result.report.message;
  if (result.completed) result.statistics = collector.means();
}

}  // namespace

SteadyStateResult run_up(const bearing::CylindricalRollerBearing& bearing,
                         const bearing::OperatingPoint& point, const DynamicsParameters& parameters,
                         const SteadyStateOptions& options, double duration) {
  require_speed(parameters.driving, duration);
  const PlanetBearingEquations equations(bearing_model(bearing, point, parameters));
  DynamicsParameters before = parameters;
  before.driving = {};
  SteadyStateOptions settling = options;
  settling.observed_windows = 1;
  SteadyStateResult result = run_to_steady_state(bearing, point, before, settling);
  if (!result.completed) return result;
  follow(equations, options, duration, result);
  const double mean_ratio = equivalent_time(parameters.driving, duration) / duration;
  result.kinematic_cage_speed *= mean_ratio;
  result.kinematic_spin *= mean_ratio;
  return result;
}

}  // namespace orbearing::integration
