// A single ball bearing, run in time under given speeds and loads: run-up, settling, then the observed part.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bearing/life/rating_lives.hpp"
#include "bearing/life/standard_life.hpp"
#include "bearing/motion/balls/ball_bearing.hpp"
#include "coupling/integration/integration_options.hpp"
#include "coupling/system/steady_state.hpp"

namespace orbearing::system {

/// Motion of balls and cage at the start.
enum class Start { rolling, rest };

constexpr described::Names<Start, 2> names_of(Start) {
  return {{{Start::rolling, "rolling"}, {Start::rest, "rest"}}};
}

/// Positions that have inertia.
enum class BallForm {
  complete,   // all
  published,  // as [Chen2026]: those of rings and balls in their contacts follow from equilibrium
};

constexpr described::Names<BallForm, 2> names_of(BallForm) {
  return {{{BallForm::complete, "complete"}, {BallForm::published, "printed"}}};
}

/// Settings of the method and of the start.
struct BallRunOptions {
  double duration = 1.0;        // [s]  of the whole run
  double observed = 0.2;        // [-]  share of it at its end, over which means are taken
  double settling_band = 0.05;  // [-]  of the cage's kinematic speed: see settling_time()
  Start start = Start::rolling;
  int samples = 4000;           // [-]  of the whole run
  double length_error = 2e-10;  // [m]  as SteadyStateOptions::allowed_length_error
  double first_ball = 0.0;      // [rad]  angle of the first ball at the start
  BallForm form = BallForm::complete;
  std::vector<double>
      from;  // final_state of a run before it, from which this one goes on; empty: from the start
  double published_step = 1e-6;  // [s]  of the classic Runge-Kutta method in the printed form
  int bins = 72;                 // [-]  bins on the races
  double most_seconds = 3600.0;  // [s]  of wall time
};

template <class Visitor>
void describe(Visitor& visit, BallRunOptions& m) {
  using namespace described;
  rows(visit,
       input(m.duration, "simulation.duration", "time that is simulated",
             {.dimension = dimension::time, .range = positive(1e5)}),
       input(m.observed, "simulation.observed_share", "share of the time, at its end, for the means",
             {.range = {.least = 0.0, .most = 1.0, .least_allowed = false},
              .reason = "the time before it is for settling",
              .numerical = true}),
       input(m.settling_band, "simulation.settling_band",
             "band about the mean of the last third of the run, as a share of the cage's kinematic speed; "
             "outside it the cage slip has not settled",
             {.range = {.least = 0.0, .most = 1.0, .least_allowed = false},
              .reason = "settling times are usually stated for a band of 5 %",
              .numerical = true}),
       input(m.start, "simulation.start", "motion of balls and cage at the start",
             {.reason = "as at pure rolling on the rings' speeds of that instant"}),
       input(m.samples, "simulation.samples", "number of output states, at equal time steps",
             {.range = {2, 10'000'000}, .reason = "enough for a picture", .numerical = true}),
       input(m.form, "simulation.form",
             "degrees of freedom with inertia: all, or as published in [Chen2026], with static equilibrium "
             "where contacts hold them",
             {.reason = "the complete equations are faster, too"}),
       input(m.published_step, "simulation.step", "step of the classic Runge-Kutta method",
             {.dimension = dimension::time,
              .range = positive(1e-3),
              .reason = "not printed; contacts of balls and cage and the friction of the races bear it",
              .where = {"simulation.form", "printed"},
              .numerical = true}),
       length_error_row(m.length_error));
}

/// The run over time; entries are samples.
struct BallSeries {
  std::vector<double> time;                         // [s]
  std::vector<double> cage_slip;                    // [-]  1 - cage speed / that of pure rolling; 0 at rest
  std::vector<double> cage_speed;                   // [rad/s]
  std::vector<double> inner_speed;                  // [rad/s]
  std::vector<double> cage_x, cage_y;               // [m]
  std::vector<double> pocket_load;                  // [N]  largest of all balls since the sample before
  std::vector<double> torque;                       // [N m]  of the drive of the inner ring
  std::vector<double> inner_x, inner_y, inner_z;    // [m]  position of the inner ring
  std::vector<double> first_angle;                  // [rad]  of the first ball
  std::vector<double> first_inner, first_outer;     // [N]  loads of the first ball
  std::vector<bearing::balls::BallPowerLoss> loss;  // [W]
};

/// Parts of the observed time for the error of its means.
inline constexpr std::size_t kPartsObserved = 10;
/// Half of the 95 % interval of a mean, by Student's t of the means of its parts, in their unit.
double error_of_mean(const std::array<double, kPartsObserved>& parts);

/// Means over the observed time.
struct BallMeans {
  double cage_slip = 0.0;        // [-]  from the angle that the cage turned
  double cage_slip_error = 0.0;  // [-]  of that, as heat_error
  double cage_speed = 0.0;       // [rad/s]
  double inner_load_rms = 0.0;   // [N]  over all balls, unloaded time included
  double outer_load_rms = 0.0;   // [N]
  double inner_load_max = 0.0;   // [N]
  double outer_load_max = 0.0;   // [N]
  /// [N m]  Energy that is lost over the angle by which the rings turn against each other. The mean of the
  /// drive's torque over states of the integrator tends to it as its steps shorten, and is a tenth off
  /// before.
  double friction_torque = 0.0;
  double inner_angle = 0.0;            // [rad]  mean contact angle, weighed by load
  double outer_angle = 0.0;            // [rad]
  double inner_film = 0.0;             // [m]  mean central film of loaded balls
  double outer_film = 0.0;             // [m]
  bearing::balls::BallPowerLoss loss;  // [W]
  /// [W]  Half of the interval that holds the mean of all losses with 95 %, by the means of `kPartsObserved`
  /// equal parts of the observed time. It does not know of motions that come later.
  double heat_error = 0.0;
  bearing::BearingLife life;                        // [rev]  of the turning race, from true passages
  bearing::rating::EquivalentBallLoads equivalent;  // [N]  cube means over time, bin by bin, that lives go by
  double balls_life = 0.0;  // [rev]  of all balls, as bearing/life/ball_failure.hpp has it
};

struct BallRunResult {
  bool completed = false;
  std::string message;
  BallSeries series;
  BallMeans means;
  std::optional<double> slip_settling;  // [s]  from the start; none where the slip does not settle
  double pocket_load_max = 0.0;         // [N]  of the whole run
  std::vector<double> final_state;      // padded
  integration::IntegrationReport report;
};

/// Distance of the cage's centre from the axis at the start [m], where no load has a direction.
inline constexpr double kOffCentre = 1e-6;

/// A slip over time, at every step.
struct SlipHistory {
  std::vector<double> time;  // [s]  rising
  std::vector<double> slip;  // [-]  share of the cage's kinematic speed
};

/// Last time [s] at which the slip leaves a band of +-`band` [-] about its mean over the last third of a run
/// until `end` [s]; linear between the steps, 0 where it never does. None where that is within the last
/// third.
std::optional<double> settling_time(const SlipHistory& history, double end, double band);

/// Runs `bearing` under `duty`. Where nothing but an axial load acts on the rings, the cage starts
/// `kOffCentre` beside the axis: a centred one is in an equilibrium that it leaves by round-off alone.
/// `capacities` are those of one contact, for the life; `progress` gets the time reached [s], if any. Errors
/// during the run are in the result; throws std::invalid_argument for input that ball_numbers() refuses, and
/// where nothing is left to observe.
BallRunResult run_balls(const bearing::Bearing& bearing, const bearing::balls::MotionParameters& parameters,
                        const bearing::balls::BallDuty& duty,
                        const bearing::rating::ContactCapacities& capacities, const BallRunOptions& options,
                        const std::function<void(double)>& progress = {});

}  // namespace orbearing::system
