#include "coupling/analysis/motion_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "bearing/motion/initial_state.hpp"
#include "bearing/motion/model.hpp"
#include "bearing/motion/vector_bearing.hpp"
#include "coupling/analysis/light_load.hpp"
#include "coupling/analysis/load_sharing.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "coupling/system/bearing_steps.hpp"
#include "coupling/system/free_bearing.hpp"
#include "gearset/dynamics/parameters.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::analysis {

namespace {

using bearing::motion::BearingModel;

// All constants are of measured motions: docs/motion_time.md.

// Mean step over the longest one.
constexpr double kOfOrder2 = 0.83;        // rollers that bounce, under mean loads
constexpr double kOfDampedOrder2 = 0.99;  // oil takes the impacts
constexpr double kOfOrder3 = 0.96;
constexpr double kOfDampedOrder3 = 0.6;  // oil takes the blows on the bars too
constexpr double kOfOrder4 = 0.36;
// Steps of order 2 that errors allow where rollers bounce under loads that vary, over 1/w of a roller between
// its races; they grow with the root of the allowed error, up to the longest.
constexpr double kAccurateStep = 1.45;
constexpr double kLargestShare = 0.97;
constexpr double kUsualError = 2e-10;  // [m]
// Without a cage rollers strike each other so often in the passage of a roller.
constexpr double kStepsOfPassage = 700.0;

// Processor time [s] of a step of order 2, refused ones included, by lanes of rollers.
constexpr double kStep = 1.1e-6, kLane = 0.166e-6;
constexpr double kLamina = 3.6e-9;       // of a lane and a lamina
constexpr double kTiltedLamina = 13e-9;  // the same where rollers tilt
constexpr double kWave = 12e-9;          // of a lane and a wave
constexpr double kHigherOrder = 1.67;    // steps of order 3 and 4
constexpr double kRefused = 1.17;        // steps of order 2 where rollers bounce under loads that vary
constexpr double kExplicit = 15.0;       // dopri5, for the same time of motion
// Factors of one system: bearings that take steps of their own, and gears.
constexpr double kOneSystem = 1.4, kUncagedSystem = 1.3, kSmoothSystem = 1.2;
constexpr double kJumpsOfPeriod = 16.0;     // of the mesh stiffness, which end a step
constexpr double kExchange = 15e-6;         // [s]  of an exchange in a co-simulation
constexpr double kExchangeSteps = 0.5;      // [-]  that a window ends
constexpr double kExchangeOfWindow = 0.82;  // [-]  mean over the longest window

// Gears and bearing in turn: runs where teeth pass slowly against the vibration of the ring on its rollers,
// up to where they pass fast, as shares of its frequency.
constexpr double kSlowRuns = 2.5, kFastRuns = 4.7, kHelicalSlowRuns = 1.5;
constexpr double kSlowPassage = 0.13, kFastPassage = 0.27;  // [-]
constexpr double kRunsOfSlowMotion = 1.3;                   // dampers do not decide: one_way.cpp
constexpr double kGears = 0.02;                             // [s]  of the gears in a run

constexpr double kCagedSettling = 2.0, kUncagedSettling = 5.0;  // [-]

constexpr long kMostCounted = 16'000;  // steps of slow motion

double lanes_of(const BearingModel& model) {
  constexpr double pack = 8.0;
  return pack * std::ceil(static_cast<double>(model.layout.rollers) / pack);
}

// Time of a step of order 2 of a single bearing [s].
double step_seconds(const BearingModel& model, int laminae) {
  const double of_laminae = laminae * (model.layout.tilting ? kTiltedLamina : kLamina);
  return kStep + lanes_of(model) * (kLane + of_laminae + kWave * static_cast<double>(model.layout.waves));
}

// Motion of one set: common data of all its motions.
struct SetMotion {
  const PlanetaryDrivetrain& drivetrain;
  const SeatedBearing& seated;  // the bearing
  const bearing::motion::DynamicsParameters& parameters;
  const BearingModel& model;
  bool shaken;            // by meshes that vary
  double mesh_frequency;  // [Hz]
  int bearings;           // of all planets

  // Helical teeth share the load so evenly that rollers stay in contact.
  bool rattles() const { return shaken && drivetrain.set.helix_angle == 0.0; }
  bool bounces() const { return rattles() && !system::impacts_are_damped(model); }
};

// [Hz]  of the bore on its rollers, in a time t of which the longest step of order 4 holds kRingTimes.
double ring_frequency(const BearingModel& model) {
  constexpr double kRingTimes = 2.5 * system::kStepOfImpact;
  const bearing::vectorised::VectorBearing bearing(model);
  const double longest =
      system::fourth_order_steps(bearing, system::allowed_errors(model, kUsualError)).longest;
  return kRingTimes / (constants::two_pi * longest);
}

// [s]  Mean step of the bearing under mean loads with errors that `length_error` [m] allows, while a roller
// passes the load after the passage of another, or in the second half of kMostCounted steps. None where the
// integration fails.
std::optional<double> counted_step(const SetMotion& set, double length_error) {
  const system::SteadyStateOptions& stated = set.drivetrain.steady_state;
  bearing::vectorised::VectorBearing bearing(set.model);
  Eigen::VectorXd x =
      initial_state(set.seated.drivetrain.bearing, set.model, set.parameters, stated.first_roller).x;
  integration::IntegrationOptions options = stated.integration;
  options.allowed_error = system::allowed_errors(set.model, length_error);
  options.most_steps = kMostCounted;
  const double passage = constants::two_pi / (static_cast<double>(set.model.layout.rollers) *
                                              std::abs(set.model.kinematic_cage_speed));
  std::vector<double> times;  // [s]
  system::integrate_bearing(bearing, x, {0.0, 2.0 * passage, 1}, options, nullptr,
                            [&](const system::StepSample& step) { times.push_back(step.time); });
  const auto second = std::min(std::ranges::lower_bound(times, passage),
                               times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
  const auto counted = times.end() - second;
  if (counted < 2) return std::nullopt;
  return (times.back() - *second) / static_cast<double>(counted - 1);
}

void put_counted_steps(const SetMotion& set, double longest_step, MotionWork& work) {
  const double error = std::max(set.drivetrain.steady_state.allowed_length_error, work.load_error);
  const std::optional<double> counted = counted_step(set, error);
  if (!counted) return;
  work.accurate_step = *counted * std::sqrt(kUsualError / error);
  work.longest_step = longest_step;
}

void put_steps(const SetMotion& set, MotionWork& work) {
  const BearingModel& model = set.model;
  const bearing::vectorised::VectorBearing bearing(model);
  const Eigen::VectorXd allowed = system::allowed_errors(model, kUsualError);
  const int order = system::order_of_steps(model, set.shaken);
  const bool damped = system::impacts_are_damped(model);
  const double slow = system::slowness(model);
  const double longest = system::steps_of_order(order, bearing, allowed, slow).longest;
  work.longest_step = longest;
  if (order == 4)
    work.longest_step *= kOfOrder4 / slow;
  else if (order == 3)
    work.longest_step *= system::blows_are_damped(model) ? kOfDampedOrder3 : kOfOrder3;
  else
    work.longest_step *= damped ? kOfDampedOrder2 : set.rattles() ? kLargestShare : kOfOrder2;
  work.accurate_step = std::numeric_limits<double>::infinity();
  if (set.bounces() && order == 2) {
    const auto rollers = static_cast<Eigen::Index>(model.layout.rollers);
    work.accurate_step = kAccurateStep * allowed[0] / allowed[2 * rollers];
  }
  if (!model.layout.caged)
    work.longest_step = std::min(work.longest_step,
                                 work.turn / (kStepsOfPassage * static_cast<double>(model.layout.rollers)));
  work.step_seconds = step_seconds(model, set.drivetrain.bearing.rollers().laminae);
  if (order > 2)
    work.step_seconds *= kHigherOrder;
  else if (set.bounces())
    work.step_seconds *= kRefused;
  work.slow = system::is_slow(model);
  if (work.slow) work.accuracy = model.layout.caged ? kAccuracyOfSlow : kAccuracyOfSlowUncaged;
  if (set.drivetrain.steady_state.integration.method != integration::Method::linearly_implicit)
    work.step_seconds *= kExplicit;
  else if (work.slow && set.drivetrain.run_up.acceleration == 0.0)
    put_counted_steps(set, longest, work);
}

void put_runs(const SetMotion& set, MotionWork& work) {
  if (!set.shaken || set.drivetrain.run_up.acceleration != 0.0) return;
  const double passage = set.mesh_frequency / ring_frequency(set.model);
  const double fast = std::clamp((passage - kSlowPassage) / (kFastPassage - kSlowPassage), 0.0, 1.0);
  const double slow = set.rattles() ? kSlowRuns : kHelicalSlowRuns;
  work.runs = work.slow ? kRunsOfSlowMotion : slow + fast * (kFastRuns - slow);
  work.other_seconds += kGears * work.runs;
}

void put_one_system(const SetMotion& set, MotionWork& work) {
  const int order = system::order_of_steps(set.model, true);
  work.step_seconds *= set.bearings * (!set.model.layout.caged ? kUncagedSystem
                                       : order == 4            ? kSmoothSystem
                                                               : kOneSystem);
  if (!set.shaken) return;
  const double jumps = kJumpsOfPeriod * set.mesh_frequency;
  const auto between_jumps = [jumps](double step) { return 1.0 / (1.0 / step + jumps); };
  work.longest_step = between_jumps(work.longest_step);
  if (work.slow) work.accurate_step = between_jumps(work.accurate_step);
}

void put_exchange(const SetMotion& set, MotionWork& work) {
  const cosim::CoupledOptions& exchange = set.drivetrain.exchange;
  const double window = kExchangeOfWindow * exchange.window;
  const double of_steps = work.step_seconds * set.bearings * exchange.iteration.most_passes;
  work.step_seconds = of_steps;
  work.window_seconds = (kExchange * exchange.iteration.most_passes + kExchangeSteps * of_steps) / window;
}

// [m]  0 where the error is stated, not that of the load.
double error_of_load(const PlanetaryDrivetrain& drivetrain, const MeansAtRest& at_rest) {
  if (drivetrain.steady_state.load_error_share == 0.0) return 0.0;
  return with_error_of_load(drivetrain, at_rest).steady_state.allowed_length_error;
}

// A bearing of the set; in slow motion with the tilt that it has at rest.
SeatedBearing seated_in_slow_motion(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                    const BearingDuty& duty) {
  const BearingModel upright =
      bearing_model(drivetrain.bearing, duty.point, bearing_dynamics(drivetrain, geometry));
  if (drivetrain.seats.tilt != TiltState::computed || !system::is_slow(upright))
    return {drivetrain, geometry, duty};
  return seated_bearings(seat_of_each(drivetrain, geometry), drivetrain, geometry, duty).front();
}

MotionWork work_of(const NamedSet& named, Fidelity fidelity) {
  const PlanetaryDrivetrain& drivetrain = named.drivetrain;
  const std::vector<BearingDuty> duties = planet_duties(drivetrain, named.geometry);
  const MeansAtRest at_rest = means_at_rest(drivetrain, named.geometry, duties);
  const BearingDuty& duty = duties.front();
  const SeatedBearing seated = seated_in_slow_motion(drivetrain, named.geometry, duty);
  const bearing::motion::DynamicsParameters parameters = bearing_dynamics(seated.drivetrain, seated.geometry);
  const BearingModel model = bearing_model(seated.drivetrain.bearing, seated.duty.point, parameters);
  const double cage =
      bearing::kinematic_cage_speed(model.geometry, duty.point.inner_speed, duty.point.outer_speed);
  const bool gears = static_cast<bool>(drivetrain.gear_set);
  const bool coupled =
      fidelity != Fidelity::dynamic ||
      moves_with_its_gears(
          drivetrain, drag_over_traction(drivetrain, named.geometry, duty, at_rest.front()).value_or(0.0));
  const SetMotion set{
      drivetrain,
      seated,
      parameters,
      model,
      gears && drivetrain.mesh_variation,
      gears ? gearset::dynamics::operation_of(drivetrain.set, drivetrain.drive).mesh_frequency : 0.0,
      drivetrain.set.planets * drivetrain.bearings_per_planet};
  MotionWork work{.settling = model.layout.caged ? kCagedSettling : kUncagedSettling,
                  .turn = window_length({cage, 0.0}, with_window(drivetrain.steady_state, model.gravity,
                                                                 duty.point.carrier.speed)),
                  .load_error = error_of_load(drivetrain, at_rest),
                  .run_up = drivetrain.run_up.acceleration != 0.0 ? drivetrain.run_up.duration : 0.0};
  put_steps(set, work);
  if (fidelity == Fidelity::co_simulated) {
    put_exchange(set, work);
  } else if (coupled) {
    put_one_system(set, work);
  } else {
    put_runs(set, work);
    work.alike = static_cast<int>(duties.size()) *
                 (drivetrain.seats.tilt == TiltState::computed ? drivetrain.bearings_per_planet : 1);
  }
  return work;
}

}  // namespace

double MotionWork::step(const MotionWindows& windows) const {
  return std::min(longest_step,
                  accurate_step * std::sqrt(std::max(windows.length_error, load_error) / kUsualError));
}

// Runs before the last are broken off after a third of the observed revolutions, or observed to their end.
double MotionWork::time(const MotionWindows& windows) const {
  const double settled = std::min(settling, static_cast<double>(windows.most));
  if (run_up > 0.0) return turn * (settled + 1.0) + run_up;
  const double whole = windows.observed, third = std::max(1, windows.observed / 3);
  return turn * (settled + whole + (runs - 1.0) * (settled + 0.5 * (third + whole)));
}

double MotionWork::seconds(const MotionWindows& windows) const {
  return alike * (steps(windows) * step_seconds + time(windows) * window_seconds + other_seconds);
}

std::vector<MotionWork> motion_work(const std::vector<NamedSet>& sets, Fidelity fidelity) {
  std::vector<MotionWork> all;
  for (const NamedSet& set : sets) all.push_back(work_of(set, fidelity));
  return all;
}

double seconds_of(const std::vector<MotionWork>& motions, const MotionWindows& windows) {
  double sum = 0.0;
  for (const MotionWork& motion : motions) sum += motion.seconds(windows);
  return sum;
}

}  // namespace orbearing::analysis
