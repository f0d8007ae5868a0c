#include "coupling/analysis/gear_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "gearset/dynamics/bearing_force.hpp"
#include "gearset/dynamics/snapshot.hpp"
#include "gearset/dynamics/static_state.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::analysis {

using constants::two_pi;

SignalSums::SignalSums(int harmonics)
    : least_(std::numeric_limits<double>::infinity()),
      largest_(-std::numeric_limits<double>::infinity()),
      waves_(Eigen::ArrayXcd::Zero(harmonics)) {}

void SignalSums::add(double value, const Eigen::ArrayXcd& waves) {
  ++samples_;
  sum_ += value;
  square_ += value * value;
  least_ = std::min(least_, value);
  largest_ = std::max(largest_, value);
  waves_ += value * waves;
}

SignalStatistics SignalSums::statistics() const {
  SignalStatistics out;
  if (samples_ == 0) return out;
  const double samples = static_cast<double>(samples_);
  out.mean = sum_ / samples;
  out.rms = std::sqrt(mean_square());
  out.maximum = std::max(std::abs(least_), std::abs(largest_));
  out.least = least_;
  out.largest = largest_;
  for (const std::complex<double>& sum : waves_) {
    const std::complex<double> wave = 2.0 / samples * sum;
    out.cosines.push_back(wave.real());
    out.sines.push_back(-wave.imag());
    out.amplitudes.push_back(std::abs(wave));
  }
  return out;
}

GearSignals::GearSignals(Eigen::Index planets, int harmonics) : waves_(harmonics) {
  const SignalSums empty(harmonics);
  planets_.assign(static_cast<std::size_t>(planets), Planet{empty, empty, empty, empty, empty, empty, 0.0});
}

void GearSignals::add(double periods, const gearset::dynamics::SetSnapshot& now) {
  ++samples_;
  const double angle = two_pi * (periods - std::floor(periods));
  const std::complex<double> first = std::polar(1.0, -angle);
  for (Eigen::Index i = 0; i < waves_.size(); ++i) {
    // Products of real numbers: the library's complex product checks whether they are finite.
    const std::complex<double> before = i == 0 ? 1.0 : waves_[i - 1];
    waves_[i] = {before.real() * first.real() - before.imag() * first.imag(),
                 before.real() * first.imag() + before.imag() * first.real()};
  }
  for (std::size_t i = 0; i < planets_.size(); ++i) {
    const auto n = static_cast<Eigen::Index>(i);
    planets_[i].sun_mesh.add(now.sun_mesh_force[n], waves_);
    planets_[i].ring_mesh.add(now.ring_mesh_force[n], waves_);
    planets_[i].radial.add(now.bearing_force(0, n), waves_);
    planets_[i].tangential.add(now.bearing_force(1, n), waves_);
    planets_[i].radial_acceleration.add(now.acceleration(0, n), waves_);
    planets_[i].tangential_acceleration.add(now.acceleration(1, n), waves_);
    planets_[i].housing_squares += now.in_housing.col(n).square().sum();
  }
}

std::vector<PlanetStatistics> GearSignals::statistics() const {
  std::vector<PlanetStatistics> all;
  double tangential = 0.0;
  for (const Planet& planet : planets_) {
    all.push_back({.sun_mesh_force = planet.sun_mesh.statistics(),
                   .ring_mesh_force = planet.ring_mesh.statistics(),
                   .radial_force = planet.radial.statistics(),
                   .tangential_force = planet.tangential.statistics(),
                   .radial_acceleration = planet.radial_acceleration.statistics(),
                   .tangential_acceleration = planet.tangential_acceleration.statistics(),
                   .housing_acceleration = std::sqrt(0.5 * planet.housing_squares /
                                                     static_cast<double>(std::max(1L, samples_)))});
    tangential += all.back().tangential_force.mean / static_cast<double>(planets_.size());
  }
  for (PlanetStatistics& planet : all) {
    const SignalStatistics& force = planet.tangential_force;
    planet.load_share = force.mean / tangential;
    planet.most_load_share = std::max(force.least / tangential, force.largest / tangential);
  }
  return all;
}

double GearSignals::rms_acceleration() const {
  double sum = 0.0;
  for (const Planet& planet : planets_)
    sum += planet.radial_acceleration.mean_square() + planet.tangential_acceleration.mean_square();
  return std::sqrt(sum / static_cast<double>(planets_.size()));
}

double GearSignals::rms_mesh_force() const {
  double sum = 0.0;
  for (const Planet& planet : planets_) sum += planet.sun_mesh.mean_square() + planet.ring_mesh.mean_square();
  return std::sqrt(sum / (2.0 * static_cast<double>(planets_.size())));
}

namespace {

using gearset::dynamics::PlanetarySetEquations;
using gearset::dynamics::SetModel;
using gearset::dynamics::SetSnapshot;

void resize(GearSeries& series, Eigen::Index planets, Eigen::Index samples) {
  series.time.setZero(samples);
  for (Eigen::ArrayXXd* matrix :
       {&series.sun_mesh_force, &series.ring_mesh_force, &series.radial_force, &series.tangential_force,
        &series.radial_acceleration, &series.tangential_acceleration})
    matrix->setZero(planets, samples);
}

void record(double time, const SetSnapshot& now, Eigen::Index i, GearSeries& series) {
  series.time[i] = time;
  series.sun_mesh_force.col(i) = now.sun_mesh_force;
  series.ring_mesh_force.col(i) = now.ring_mesh_force;
  series.radial_force.col(i) = now.bearing_force.row(0).transpose();
  series.tangential_force.col(i) = now.bearing_force.row(1).transpose();
  series.radial_acceleration.col(i) = now.acceleration.row(0).transpose();
  series.tangential_acceleration.col(i) = now.acceleration.row(1).transpose();
}

// [-]  of the centre distance, by which a planet is off its pin: some ten times the clearance of any
// bearing.
constexpr double kRunAway = 0.01;

// A set on springs that give energy moves ever further, in ever shorter steps: it is given up long before
// these end.
struct RunAway : std::runtime_error {
  using std::runtime_error::runtime_error;
};

bool on_pins(const SetModel& model, double off) {
  return off <= kRunAway * model.parameters.carrier.radius;
}

// [m]  of the planet that is furthest off its pin
double most_off_pin(const SetModel& model, const Eigen::Ref<const Eigen::VectorXd>& x) {
  double most = 0.0;
  for (const gearset::dynamics::PlanetBearing& bearing : model.bearings)
    most = std::max(most, bearing_deflection(bearing, x).norm());
  return most;
}

void require_on_pins(const SetModel& model, double time, const Eigen::Ref<const Eigen::VectorXd>& x) {
  const double off = most_off_pin(model, x);
  if (on_pins(model, off)) return;
  std::ostringstream text;
  text << "a planet is " << 1e3 * off << " mm off its pin at t = " << time
       << " s: the vibration grows without bound";
  throw RunAway(text.str());
}

// Springs are those of small displacements: there is no motion about a state far from the pins.
void require_on_pins_at_rest(const SetModel& model, const Eigen::VectorXd& start) {
  const double off = most_off_pin(model, start);
  if (on_pins(model, off)) return;
  std::ostringstream text;
  text << "a planet is " << 1e3 * off << " mm off its pin under the load at rest, more than "
       << 100.0 * kRunAway << " % of the centre distance: pins or bearings are too soft for the load "
       << "(support.stiffness, gearset.dynamics.planet.bearing_stiffness)";
  throw RunAway(text.str());
}

// The run in progress: state, time, budget.
class GearRun {
 public:
  GearRun(const SetModel& model, const GearRunOptions& options, GearRunResult& result)
      : equations_(model),
        options_(options),
        result_(result),
        jumps_(integration::jumps_of(model)),
        settings_(options.integration),
        derivative_([this](double time, const Eigen::Ref<const Eigen::VectorXd>& x,
                           Eigen::Ref<Eigen::VectorXd> dx) { equations_.derivative(time, x, dx); }) {
    settings_.allowed_error = integration::gear_allowed_errors(model, options.allowed_share);
    settings_.step = 0.02 / model.operation.mesh_frequency;
  }

  /// To the end of the run-up, where nothing is observed.
  bool run_up() {
    const double end = model().operation.run_up.duration;
    return end <= 0.0 || integrate({0.0, end, 1}, {});
  }

  /// Passes a mesh period: how the state has changed; none where the integration failed.
  std::optional<Eigen::VectorXd> departure() {
    const Eigen::VectorXd before = result_.final_state;
    if (!integrate({time_, 1.0 / model().operation.mesh_frequency, 1}, {})) return std::nullopt;
    require_on_pins(model(), time_, result_.final_state);
    return result_.final_state - before;
  }

  /// Observes `periods` mesh periods; false where the integration failed.
  bool observe(long periods, GearSignals& signals, GearSeries* series) {
    const gearset::dynamics::Operation& operation = model().operation;
    const long samples = periods * options_.samples_per_period + 1;  // has no divisor with `periods`
    const double interval =
        static_cast<double>(periods) / (operation.mesh_frequency * static_cast<double>(samples));
    const long kept = std::min(samples, options_.series_periods * options_.samples_per_period);
    if (series) resize(*series, model().layout.planets, kept);
    long sample = 0, apart = 0;
    const bool good =
        integrate({time_, interval, samples}, [&](double time, const Eigen::Ref<const Eigen::VectorXd>& x) {
          require_on_pins(model(), time, x);
          take_snapshot(equations_, time, x, workspace_, snapshot_);
          signals.add(mesh_periods(operation, time), snapshot_);
          apart += snapshot_.separated ? 1 : 0;
          const long position = sample++ - (samples - kept);
          if (series && position >= 0) record(time, snapshot_, position, *series);
        });
    result_.separated = static_cast<double>(apart) / static_cast<double>(samples);
    return good;
  }

 private:
  const SetModel& model() const { return equations_.model(); }

  bool integrate(const integration::OutputTimes& output, const integration::Observer& observer) {
    const integration::IntegrationReport part =
        integrate_pieces(derivative_, result_.final_state, output, jumps_, settings_, observer);
    integration::IntegrationReport& all = result_.report;
    integration::append(part, all);
    settings_.most_seconds = options_.integration.most_seconds - all.wall_seconds;
    settings_.most_steps = options_.integration.most_steps - all.steps;
    time_ = output.time(output.samples);
    return part.completed;
  }

  PlanetarySetEquations equations_;
  const GearRunOptions& options_;
  GearRunResult& result_;
  integration::Jumps jumps_;
  integration::IntegrationOptions settings_;
  integration::RightHandSide derivative_;
  SetSnapshot snapshot_;
  Eigen::VectorXd workspace_;
  double time_ = 0.0;  // [s]
};

bool close(double a, double b, double drift) {
  return std::abs(a - b) <= drift * std::max(a, b);
}

// Windows until two in turn agree or there have been enough. False where the integration failed.
bool settle(GearRun& run, const SetModel& model, const GearRunOptions& options, GearRunResult& result) {
  double acceleration = 0.0, mesh_force = 0.0;
  while (result.windows < options.most_windows && !result.steady) {
    GearSignals window(model.layout.planets, 0);
    if (!run.observe(options.window_periods, window, nullptr)) return false;
    ++result.windows;
    result.steady = result.windows >= std::max(2, options.least_windows) &&
                    close(acceleration, window.rms_acceleration(), options.drift) &&
                    close(mesh_force, window.rms_mesh_force(), options.drift);
    acceleration = window.rms_acceleration();
    mesh_force = window.rms_mesh_force();
  }
  return true;
}

constexpr long kRepeatingPeriods = 10;  // [mesh period]  of samples, no two of which fall on one phase

// The motion that repeats with the meshes.
class RepeatingMotion {
 public:
  RepeatingMotion(GearRun& run, const gearset::dynamics::PeriodMap& map, const SetModel& model,
                  const GearRunOptions& options, GearRunResult& result)
      : run_(run),
        map_(map),
        allowed_(integration::gear_allowed_errors(model, options.allowed_share)),
        result_(result) {}

  /// Leaves the state on it; false where it is not found, or does not come nearer.
  bool find() {
    double away = INFINITY;
    for (int i = 0; i < kMostPeriods; ++i) {
      const Eigen::VectorXd before = result_.final_state;
      const std::optional<Eigen::VectorXd> change = change_to_it();
      if (!change) return false;
      // Over a long period the errors of many steps add up: no nearer is then near enough.
      if (!(errors_in(*change) < away)) return away <= kNear;
      away = errors_in(*change);
      result_.final_state = before + *change;
      if (away <= kFound) return true;
    }
    return false;
  }

  /// Whether a disturbance dies out within ten periods. Checked where teeth part, which the map does not
  /// include.
  bool lasts() {
    for (Eigen::Index i = 0; i < allowed_.size(); ++i)
      result_.final_state[i] += (i % 2 == 0 ? kDisturbed : -kDisturbed) * allowed_[i];
    std::optional<Eigen::VectorXd> change;
    for (long i = 0; i <= kRepeatingPeriods; ++i)
      if (!(change = change_to_it())) return false;
    return errors_in(*change) <= kNear;
  }

 private:
  // Newton's step, a period on.
  std::optional<Eigen::VectorXd> change_to_it() {
    const std::optional<Eigen::VectorXd> departure = run_.departure();
    if (!departure || !departure->allFinite()) return std::nullopt;
    return map_.to_repeating(*departure);
  }
  double errors_in(const Eigen::VectorXd& change) const {
    return (change.array() / allowed_.array()).abs().maxCoeff();
  }

  static constexpr int kMostPeriods = 12;
  // [-]  of the errors allowed in one step:
  static constexpr double kFound = 1.0, kNear = 10.0, kDisturbed = 30.0;

  GearRun& run_;
  const gearset::dynamics::PeriodMap& map_;
  Eigen::VectorXd allowed_;
  GearRunResult& result_;
};

// False where the integration failed, or the motion is not found or does not last.
bool observe_repeating(RepeatingMotion& motion, GearRun& run, GearSignals& signals, GearRunResult& result) {
  if (!motion.find() || !run.observe(kRepeatingPeriods, signals, &result.series)) return false;
  if (result.separated == 0.0) return true;
  const Eigen::VectorXd on_it = result.final_state;
  if (!motion.lasts()) return false;
  result.final_state = on_it;
  return true;
}

}  // namespace

GearRunResult run_gears_repeating(const Eigen::VectorXd& start, const SetModel& model,
                                  const gearset::dynamics::PeriodMap& map, const GearRunOptions& options) {
  GearRunResult result;
  result.mesh_frequency = model.operation.mesh_frequency;
  result.final_state = start;
  GearRun run(model, options, result);
  RepeatingMotion motion(run, map, model, options, result);
  GearSignals observed(model.layout.planets, options.harmonics);
  bool found = false;
  try {
    found = map.largest_growth() <= 0.0 && observe_repeating(motion, run, observed, result);
  } catch (const RunAway&) {
    // It is waited for, then.
  }
  if (!found) {
    GearRunResult waited = run_gears_from(start, model, options);
    append(result.report, waited.report);
    return waited;
  }
  result.planets = observed.statistics();
  result.completed = result.steady = true;
  return result;
}

GearRunResult run_gears(const SetModel& model, const GearRunOptions& options) {
  return run_gears_from(static_state(model), model, options);
}

GearRunResult run_gears_from(const Eigen::VectorXd& start, const SetModel& model,
                             const GearRunOptions& options) {
  if (!(model.operation.mesh_frequency > 0.0))
    throw std::invalid_argument("mesh frequency: found 0; required: a rotating set");
  GearRunResult result;
  result.mesh_frequency = model.operation.mesh_frequency;
  result.final_state = start;
  GearRun run(model, options, result);
  GearSignals observed(model.layout.planets, options.harmonics);
  try {
    require_on_pins_at_rest(model, start);
    if (run.run_up() && settle(run, model, options, result)) {
      run.observe(options.observed_periods, observed, &result.series);
      result.planets = observed.statistics();
    }
  } catch (const RunAway& reason) {
    result.message = reason.what();
    return result;
  }
  result.completed = result.report.completed;
  result.message = result.report.message;
  if (result.completed && !result.steady)
    result.message = "the vibration still drifted after the last window";
  return result;
}

}  // namespace orbearing::analysis
