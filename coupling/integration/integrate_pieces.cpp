#include "coupling/integration/integrate_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/integration/dopri5.hpp"
#include "coupling/integration/run.hpp"

namespace orbearing::integration {

namespace {

using namespace detail;

// Asks for times within the piece only, a margin off its ends.
struct PieceSystem {
  System system;
  double first = 0.0;  // [s]
  double last = 0.0;   // [s]

  void operator()(const State& x, State& dx, double time) const {
    system(x, dx, std::clamp(time, first, last));
  }
};

// The run in progress: one stepper that is started anew in each piece.
class PiecesRun {
 public:
  PiecesRun(System system, const OutputTimes& output, const IntegrationOptions& options,
            const Observer& observe, Run& run)
      : system_{system},
        output_(output),
        observe_(observe),
        run_(run),
        stepper_(ControlledDopri5(WeightedError(options))),
        wanted_step_(options.step) {}

  /// How often the stepper was started, which costs one call of the right-hand side each.
  long starts() const { return starts_; }

  /// That the error allows, whatever ends of pieces cut short [s].
  double next_step() const { return wanted_step_; }

  /// From `begin` to `end`; false where the run was given up.
  bool advance(Eigen::VectorXd& x, double begin, double end, double margin) {
    const double inner = std::min(margin, 0.25 * (end - begin));
    system_.first = begin + inner;
    system_.last = end - inner;
    const double close = 1e-12 * (end - begin) + 4e-16 * std::abs(end);  // [s]  round-off of the times
    double time = begin;
    while (end - time > close) {
      fit_step(x, time, end);
      try {
        stepper_.do_step(system_);
      } catch (const odeint::odeint_error&) {
        return run_.fail("no step was small enough, or the state is not finite,");
      }
      take_over(x);
      time = stepper_.current_time();
      if (!run_.accept(time, time - stepper_.previous_time())) return false;
      if (end - time <= close) time = end;
      emit(time);
    }
    going_on_ = false;
    return true;
  }

 private:
  // The next step ends at the piece's end or leaves room for another of like size.
  void fit_step(const Eigen::VectorXd& x, double time, double end) {
    const double left = end - time;
    attempted_ = left <= wanted_step_ ? left : left < 2.0 * wanted_step_ ? 0.5 * left : wanted_step_;
    if (going_on_ && attempted_ == stepper_.current_time_step()) return;
    start_.assign(x.data(), x.data() + x.size());
    stepper_.initialize(start_, time, attempted_);
    ++starts_;
    going_on_ = true;
  }

  // A step made short to end somewhere says little of the step that the error allows, if it was not refused.
  void take_over(Eigen::VectorXd& x) {
    x = view(stepper_.current_state());
    const double suggested = stepper_.current_time_step();
    const bool shortened = attempted_ < wanted_step_;
    const bool refused = suggested < attempted_;
    wanted_step_ = shortened && !refused ? std::max(wanted_step_, suggested) : suggested;
  }

  void emit(double time) {
    while (sample_ <= output_.samples && output_.time(sample_) <= time) {
      if (observe_) {
        at_sample_.resize(stepper_.current_state().size());
        stepper_.calc_state(output_.time(sample_), at_sample_);
        observe_(output_.time(sample_), view(at_sample_));
      }
      ++sample_;
    }
  }

  PieceSystem system_;
  const OutputTimes& output_;
  const Observer& observe_;
  Run& run_;
  DenseDopri5 stepper_;
  double wanted_step_;      // [s]  that the error allows
  double attempted_ = 0.0;  // [s]
  bool going_on_ = false;   // the stepper stands where the last step ended
  long starts_ = 0;
  long sample_ = 1;
  State start_;
  State at_sample_;
};

bool run_pieces(Eigen::VectorXd& x, const OutputTimes& output, const Jumps& jumps,
                const JumpObserver& at_jump, PiecesRun& pieces) {
  const double end = output.time(output.samples);
  double begin = output.time(0);
  long jump = 0;
  // Round-off of the times shall make no piece of its own.
  while (jumps.time && jumps.time(jump) <= begin + jumps.margin) ++jump;
  while (begin < end) {
    const double next = jumps.time ? jumps.time(jump) : std::numeric_limits<double>::infinity();
    const bool last = next >= end - jumps.margin;
    const double stop = last ? end : next;
    if (!pieces.advance(x, begin, stop, jumps.margin)) return false;
    if (at_jump && next <= stop + jumps.margin) at_jump(stop - jumps.margin, stop + jumps.margin, x);
    begin = stop;
    ++jump;
  }
  return true;
}

}  // namespace

IntegrationReport integrate_pieces(const RightHandSide& derivative, Eigen::VectorXd& x,
                                   const OutputTimes& output, const Jumps& jumps,
                                   const IntegrationOptions& options, const Observer& observe,
                                   const JumpObserver& at_jump) {
  IntegrationReport report;
  report.reached = output.time(0);
  Run run(options, report);
  const System system{derivative, report.rhs_calls};
  if (!x.allFinite()) {
    run.fail("the state is not finite");
    return report;
  }
  report.smallest_step = std::numeric_limits<double>::infinity();
  PiecesRun pieces(system, output, options, observe, run);
  report.completed = run_pieces(x, output, jumps, at_jump, pieces);
  report.rejected = std::max(0L, (report.rhs_calls - pieces.starts()) / kRhsPerAttempt - report.steps);
  report.next_step = pieces.next_step();
  if (report.steps == 0) report.smallest_step = 0.0;
  report.wall_seconds = run.seconds();
  return report;
}

namespace {

using gearset::dynamics::SetModel;

constexpr double kMargin = 1e-9;  // [mesh period]  kept off a jump: far above round-off, far below a step

}  // namespace

Jumps jumps_of(const SetModel& model, double from) {
  const std::vector<double> phases = jump_phases(model);
  const gearset::dynamics::Operation& operation = model.operation;
  if (phases.empty() || operation.mesh_frequency <= 0.0) return {};
  const double passed =
      from > 0.0 ? std::floor(gearset::dynamics::mesh_periods(operation, from)) : 0.0;  // [mesh period]
  const auto time = [phases, operation, passed](long index) {
    const long count = static_cast<long>(phases.size());
    const double periods =
        passed + static_cast<double>(index / count) + phases[static_cast<std::size_t>(index % count)];
    return gearset::dynamics::time_of_periods(operation, periods);
  };
  return {time, kMargin / operation.mesh_frequency};
}

Eigen::VectorXd gear_allowed_errors(const SetModel& model, double share) {
  constexpr double least_deflection = 1e-9;  // [m]  of a set that carries nothing
  const gearset::dynamics::SetParameters& set = model.parameters;
  const double force = std::abs(model.operation.torques.sun) / (set.planets * set.sun.radius);
  const double sun = set.sun_mesh.stiffness.mean(), ring = set.ring_mesh.stiffness.mean();
  const double length = share * std::max(least_deflection, force / std::min(sun, ring));
  const double frequency = std::sqrt((sun + ring) / set.planet.mass);
  Eigen::VectorXd allowed(model.layout.size());
  allowed.head(model.layout.freedoms()).setConstant(length);
  allowed.tail(model.layout.freedoms()).setConstant(length * frequency);
  return allowed;
}

}  // namespace orbearing::integration
