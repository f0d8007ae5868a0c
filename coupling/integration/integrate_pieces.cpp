#include "coupling/integration/integrate_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/integration/dopri5.hpp"

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

// One stepper that is started anew in each piece.
class PiecesRun : public DenseRun {
 public:
  PiecesRun(System system, const OutputTimes& output, const IntegrationOptions& options,
            const Observer& observe, Run& run, long& starts)
      : DenseRun(output, observe, run, ControlledDopri5(WeightedError(options)), starts),
        system_{system},
        wanted_step_(options.step) {}

  /// Step that the error allows, without the cut at the ends of pieces [s].
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
      if (!step(system_)) return false;
      take_over(x);
      time = stepper_.current_time();
      if (!run_.accept(time, last_step())) return false;
      if (end - time <= close) time = end;
      show_until(time);
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
    start(start_, time, attempted_);
    going_on_ = true;
  }

  // A step cut short does not show the step that the error allows, if it was not refused.
  void take_over(Eigen::VectorXd& x) {
    x = view(stepper_.current_state());
    const double suggested = stepper_.current_time_step();
    const bool shortened = attempted_ < wanted_step_;
    const bool refused = suggested < attempted_;
    wanted_step_ = shortened && !refused ? std::max(wanted_step_, suggested) : suggested;
  }

  PieceSystem system_;
  double wanted_step_;      // [s]  that the error allows
  double attempted_ = 0.0;  // [s]
  bool going_on_ = false;   // the stepper is at the end of the last step
  State start_;
};

bool run_pieces(Eigen::VectorXd& x, const OutputTimes& output, const Jumps& jumps, PiecesRun& pieces) {
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
    begin = stop;
    ++jump;
  }
  return true;
}

}  // namespace

IntegrationReport integrate_pieces(const RightHandSide& derivative, Eigen::VectorXd& x,
                                   const OutputTimes& output, const Jumps& jumps,
                                   const IntegrationOptions& options, const Observer& observe) {
  long starts = 0;
  return reported(derivative, x, output, options, starts,
                  [&](System system, Run& run, IntegrationReport& report) {
                    PiecesRun pieces(system, output, options, observe, run, starts);
                    const bool completed = run_pieces(x, output, jumps, pieces);
                    report.next_step = pieces.next_step();
                    return completed;
                  });
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
