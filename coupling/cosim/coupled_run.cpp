#include "coupling/cosim/coupled_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "coupling/cosim/joint_vector.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::cosim {

namespace {

using mechanics::refuse;

constexpr int kHighestOrder = 2;
constexpr int kMostHalvings = 30;

void require_sound(const CoupledOptions& options, bool can_restore) {
  const WindowControl& window = options.window;
  if (!(window.longest > 0.0 && std::isfinite(window.longest)))
    refuse("length of a window [s]", window.longest, "above 0");
  if (options.extrapolation < 0 || options.extrapolation > kHighestOrder)
    refuse("degree of extrapolation", options.extrapolation, "0, 1 or 2");
  if (options.iteration.most_passes < 1) refuse("passes", options.iteration.most_passes, "at least 1");
  if (window.halvings < 0 || window.halvings > kMostHalvings)
    refuse("halvings of a window", window.halvings, "0 to 30");
  if (window.halvings > 0 && !(window.allowed_residual > 0.0))
    refuse("allowed energy residual [W]", window.allowed_residual, "above 0");
  if (window.halvings > 0 && options.iteration.most_passes > 1)
    refuse("passes of windows that the energy residual controls", options.iteration.most_passes,
           "1, since iterated windows have no residual");
  if (!can_restore && (window.halvings > 0 || options.iteration.most_passes > 1))
    throw std::invalid_argument(
        "participants: found one that cannot be restored; required: explicit exchange in fixed windows");
}

// Power [W] that the interface makes out of nothing: what is told to one side and what the other has given.
double false_power(const InterfaceValues& told, const InterfaceValues& given) {
  double power = 0.0;
  for (std::size_t joint = 0; joint < given.joints.size(); ++joint)
    power += told.joints[joint].force * given.joints[joint].velocity -
             given.joints[joint].force * told.joints[joint].velocity;
  return power;
}

void require_finite(const InterfaceValues& values) {
  for (const JointValue& joint : values.joints)
    if (!std::isfinite(joint.displacement + joint.velocity + joint.force))
      throw std::runtime_error("a motion or force at a port is not finite; windows may be too long");
}

}  // namespace

struct CoupledRun::Solution {
  PassResult result;
  WindowRecord record;
  bool converged = true;
};

CoupledRun::CoupledRun(const Participants& participants, const std::vector<Connection>& connections,
                       const CoupledOptions& options)
    : options_(options),
      exchange_(participants, connections, options.order),
      accelerator_(make_accelerator(options.iteration.acceleration, options.iteration.windows)) {
  can_restore_ = std::all_of(participants.begin(), participants.end(),
                             [](const Participant* participant) { return participant->can_restore(); });
  require_sound(options, can_restore_);
}

void CoupledRun::initialize(double time) {
  start_from({exchange_.initialize(time, options_.balance_rounds, options_.balanced_change)});
}

void CoupledRun::start_from(const InterfaceHistory& history) {
  if (history.empty()) throw std::invalid_argument("history: found none; required: values at the start");
  history_ = history;
  exchange_.renew_forces(history_.back());
  grid_ = std::make_unique<WindowGrid>(options_.window, history_.back().time);
}

// With nothing to extrapolate from, the first window would spoil the order of all others. A second pass mends
// what was expected of the state, a third the forces that answered an expected velocity.
int CoupledRun::most_passes() const {
  constexpr int passes_at_start = 3;
  const bool first = history_.size() == 1 && options_.extrapolation == kHighestOrder && can_restore_;
  return std::max(options_.iteration.most_passes, first ? passes_at_start : 1);
}

CoupledRun::Solution CoupledRun::solve(const Window& window) {
  Solution solution;
  solution.record.window = window;
  InterfaceValues expected = extrapolated(history_, options_.extrapolation, window);
  accelerator_->begin();
  const int most = most_passes();
  while (true) {
    solution.result = exchange_.pass(history_, expected, options_.extrapolation, window);
    require_finite(solution.result.end);
    ++solution.record.passes;
    if (most == 1) return solution;
    const Eigen::VectorXd weight =
        weights(exchange_, scales_of(exchange_, solution.result.end, history_.back(), window.length()));
    const Eigen::VectorXd told = packed(exchange_, expected);
    const Eigen::VectorXd answer = packed(exchange_, solution.result.end);
    solution.record.change =
        told.size() == 0 ? 0.0 : weight.cwiseProduct(answer - told).cwiseAbs().maxCoeff();
    solution.converged = solution.record.change <= options_.iteration.allowed_change;
    if (solution.converged || solution.record.passes == most) return solution;
    unpack(exchange_, accelerator_->next(told, answer, weight), expected);
    restore();
  }
}

void CoupledRun::save() {
  if (!can_restore_) return;
  saved_.resize(exchange_.participants().size());
  for (std::size_t p = 0; p < saved_.size(); ++p) exchange_.participants()[p]->save(saved_[p]);
}

void CoupledRun::restore() {
  if (!can_restore_) return;
  for (std::size_t p = 0; p < saved_.size(); ++p) exchange_.participants()[p]->restore(saved_[p]);
}

void CoupledRun::accept(Solution& solution, CoupledReport& report, const WindowObserver& observer) {
  InterfaceValues& end = solution.result.end;
  exchange_.renew_forces(end);
  history_.push_back(end);
  if (history_.size() > static_cast<std::size_t>(kHighestOrder) + 1) history_.pop_front();
  const WindowRecord& record = solution.record;
  ++report.windows;
  report.passes += record.passes;
  report.not_converged += solution.converged || options_.iteration.most_passes == 1 ? 0 : 1;
  report.residual += record.residual;
  report.absolute_residual += std::abs(record.residual);
  for (const JointValue& joint : end.joints)
    report.passed += std::abs(joint.force * joint.velocity) * record.window.length();
  report.shortest_window = std::min(report.shortest_window, record.window.length());
  report.reached = record.window.end;
  grid_->accept(record.residual, options_.extrapolation + 2);
  solution.record.end = &history_.back();
  if (observer) observer(solution.record);
}

bool CoupledRun::step(CoupledReport& report, const WindowObserver& observer) {
  save();
  try {
    Solution solution = solve(grid_->window());
    const InterfaceValues& begin = history_.back();
    InterfaceValues told = begin;
    if (options_.order == ExchangeOrder::one_way)
      for (JointValue& joint : told.joints) joint.force = 0.0;
    solution.record.residual =
        0.5 * solution.record.window.length() *
        (false_power(told, begin) + false_power(solution.result.input, solution.result.end));
    if (grid_->accepts(solution.record.residual)) {
      accept(solution, report, observer);
    } else {
      restore();
      grid_->reject();
      ++report.rejected;
    }
    return true;
  } catch (const std::runtime_error& error) {
    restore();
    std::ostringstream text;
    text << error.what() << "; in the window that begins at t = " << grid_->window().begin << " s";
    report.message = text.str();
    return false;
  }
}

CoupledReport CoupledRun::advance(long windows, const WindowObserver& observer) {
  if (history_.empty()) throw std::logic_error("a co-simulation is initialised before it advances");
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  CoupledReport report;
  report.reached = history_.back().time;
  report.shortest_window = std::numeric_limits<double>::infinity();
  const long last = grid_->index() + windows * grid_->ticks_of_longest();
  report.completed = true;
  while (report.completed && grid_->index() < last) report.completed = step(report, observer);
  if (report.windows == 0) report.shortest_window = 0.0;
  report.wall_seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return report;
}

}  // namespace orbearing::cosim
