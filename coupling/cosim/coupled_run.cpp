#include "coupling/cosim/coupled_run.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "mechanics/checks.hpp"

namespace orbearing::cosim {

using Eigen::VectorXd;

void QuasiNewton::begin() {
  columns_.push_front({});
  if (columns_.size() > windows_ + 1) columns_.pop_back();
  residual_.resize(0);
}

VectorXd QuasiNewton::next(const VectorXd& expected, const VectorXd& output, const VectorXd& weight) {
  const VectorXd residual = output - expected;
  if (residual_.size() == residual.size())
    columns_.front().insert(columns_.front().begin(), {residual - residual_, output - output_});
  residual_ = residual;
  output_ = output;
  return output + correction(residual, weight);
}

// The newest differences first, no more than unknowns.
VectorXd QuasiNewton::correction(const VectorXd& residual, const VectorXd& weight) const {
  constexpr double kLeastPivot = 1e-6;  // differences that are nearly dependent are left out
  const Eigen::Index n = residual.size();
  Eigen::MatrixXd differences(n, n), outputs(n, n);
  Eigen::Index count = 0;
  for (const std::vector<Column>& window : columns_)
    for (const Column& column : window) {
      const VectorXd difference = weight.cwiseProduct(column.residual);
      const double size = difference.norm();
      if (count == n || !(size > 0.0)) continue;
      differences.col(count) = difference / size;
      outputs.col(count++) = column.output / size;
    }
  if (count == 0) return VectorXd::Zero(n);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors;
  factors.setThreshold(kLeastPivot);
  factors.compute(differences.leftCols(count));
  return -outputs.leftCols(count) * factors.solve(weight.cwiseProduct(residual));
}

namespace {

using mechanics::refuse;

constexpr int kHighestOrder = 2;

// Sizes of typical values, one over which is their weight.
struct JointScales {
  JointValue translation;
  JointValue rotation;
};

void take_largest(const JointValue& value, JointValue& largest) {
  largest.displacement = std::max(largest.displacement, std::abs(value.displacement));
  largest.velocity = std::max(largest.velocity, std::abs(value.velocity));
  largest.force = std::max(largest.force, std::abs(value.force));
}

void complete(JointValue& scale, double length) {
  constexpr double share = 1e-3;
  scale.velocity = std::max(scale.velocity, share * scale.displacement / length);
  for (double* value : {&scale.displacement, &scale.velocity, &scale.force})
    if (*value == 0.0) *value = 1.0;
}

// Calls `function` with each value that belongs to the vector.
template <class Values, class Function>
void for_each_expected(const Exchange& exchange, Values& values, const Function& function) {
  for (std::size_t joint = 0; joint < exchange.joints(); ++joint) {
    auto& value = values.joints[joint];
    if (exchange.motion_is_expected(joint)) {
      function(value.displacement);
      function(value.velocity);
    }
    if (exchange.force_is_expected(joint)) function(value.force);
  }
}

// Largest absolute values of each kind in both; 1 where all are zero. A velocity counts at least as much as
// would move the joint a thousandth of the displacements in a window of `length` [s], so that joints at rest
// can converge.
JointScales scales_of(const Exchange& exchange, const InterfaceValues& a, const InterfaceValues& b,
                      double length) {
  JointScales scales;
  for (std::size_t joint = 0; joint < exchange.joints(); ++joint) {
    JointValue& scale =
        exchange.port(joint).kind == PortKind::translation ? scales.translation : scales.rotation;
    take_largest(a.joints[joint], scale);
    take_largest(b.joints[joint], scale);
  }
  complete(scales.translation, length);
  complete(scales.rotation, length);
  return scales;
}

// Vector of the expected values of all joints: displacement and velocity if the motion is expected, the force
// if that is.
Eigen::VectorXd packed(const Exchange& exchange, const InterfaceValues& values) {
  std::vector<double> list;
  for_each_expected(exchange, values, [&](double value) { list.push_back(value); });
  return Eigen::Map<const Eigen::VectorXd>(list.data(), static_cast<Eigen::Index>(list.size()));
}

// The inverse; writes the vector into `values`.
void unpack(const Exchange& exchange, const Eigen::VectorXd& vector, InterfaceValues& values) {
  Eigen::Index position = 0;
  for_each_expected(exchange, values, [&](double& value) { value = vector[position++]; });
}

// One over the size of each of them.
Eigen::VectorXd weights(const Exchange& exchange, const JointScales& scales) {
  InterfaceValues sizes;
  for (std::size_t joint = 0; joint < exchange.joints(); ++joint)
    sizes.joints.push_back(exchange.port(joint).kind == PortKind::translation ? scales.translation
                                                                              : scales.rotation);
  return packed(exchange, sizes).cwiseInverse();
}

void require_sound(const CoupledOptions& options) {
  if (!(options.window > 0.0 && std::isfinite(options.window)))
    refuse("length of a window [s]", options.window, "above 0");
  if (options.extrapolation < 0 || options.extrapolation > kHighestOrder)
    refuse("degree of extrapolation", options.extrapolation, "0, 1 or 2");
  if (options.iteration.most_passes < 1) refuse("passes", options.iteration.most_passes, "at least 1");
}

// Power [W] that the interface makes out of nothing: the input of one side and the output of the other.
double false_power(const InterfaceValues& input, const InterfaceValues& output) {
  double power = 0.0;
  for (std::size_t joint = 0; joint < output.joints.size(); ++joint)
    power += input.joints[joint].force * output.joints[joint].velocity -
             output.joints[joint].force * input.joints[joint].velocity;
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

CoupledReport& CoupledReport::operator+=(const CoupledReport& later) {
  completed = later.completed;
  reached = later.reached;
  windows += later.windows;
  passes += later.passes;
  not_converged += later.not_converged;
  residual += later.residual;
  absolute_residual += later.absolute_residual;
  passed += later.passed;
  wall_seconds += later.wall_seconds;
  message = later.message;
  return *this;
}

CoupledRun::CoupledRun(const Sides& sides, const CoupledOptions& options)
    : options_(options), exchange_(sides, options.order), iteration_(options.iteration.windows) {
  require_sound(options);
}

void CoupledRun::initialize(double time) {
  start_from({exchange_.initialize(time, options_.balance_rounds, options_.balanced_change)});
}

void CoupledRun::start_from(const InterfaceHistory& history) {
  if (history.empty()) throw std::invalid_argument("history: found none; required: values at the start");
  history_ = history;
  exchange_.renew_forces(history_.back());
  begin_ = history_.back().time;
  done_ = 0;
}

// With nothing to extrapolate from, the first window would spoil the order of all others. A second pass mends
// what was expected of the state, a third the forces that an expected velocity gave.
int CoupledRun::most_passes() const {
  constexpr int passes_at_start = 3;
  const bool first = history_.size() == 1 && options_.extrapolation == kHighestOrder;
  return std::max(options_.iteration.most_passes, first ? passes_at_start : 1);
}

// Times are an index times a length, never added up.
Window CoupledRun::next_window() const {
  return {begin_ + static_cast<double>(done_) * options_.window,
          begin_ + static_cast<double>(done_ + 1) * options_.window};
}

CoupledRun::Solution CoupledRun::solve(const Window& window) {
  Solution solution;
  solution.record.window = window;
  InterfaceValues expected = extrapolated(history_, options_.extrapolation, window);
  iteration_.begin();
  const int most = most_passes();
  while (true) {
    solution.result = exchange_.pass(history_, expected, options_.extrapolation, window);
    require_finite(solution.result.end);
    ++solution.record.passes;
    if (most == 1) return solution;
    const Eigen::VectorXd weight =
        weights(exchange_, scales_of(exchange_, solution.result.end, history_.back(), window.length()));
    const Eigen::VectorXd input = packed(exchange_, expected);
    const Eigen::VectorXd output = packed(exchange_, solution.result.end);
    solution.record.change =
        input.size() == 0 ? 0.0 : weight.cwiseProduct(output - input).cwiseAbs().maxCoeff();
    solution.converged = solution.record.change <= options_.iteration.allowed_change;
    if (solution.converged || solution.record.passes == most) return solution;
    unpack(exchange_, iteration_.next(input, output, weight), expected);
    restore();
  }
}

void CoupledRun::save() {
  saved_.resize(exchange_.sides().size());
  for (std::size_t s = 0; s < saved_.size(); ++s) exchange_.sides()[s].participant->save(saved_[s]);
}

void CoupledRun::restore() {
  for (std::size_t s = 0; s < saved_.size(); ++s) exchange_.sides()[s].participant->restore(saved_[s]);
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
  report.reached = record.window.end;
  ++done_;
  solution.record.end = &history_.back();
  if (observer) observer(solution.record);
}

bool CoupledRun::step(CoupledReport& report, const WindowObserver& observer) {
  save();
  try {
    Solution solution = solve(next_window());
    // At the window's beginning the input of each is the others' output.
    solution.record.residual =
        0.5 * solution.record.window.length() * false_power(solution.result.input, solution.result.end);
    accept(solution, report, observer);
    return true;
  } catch (const std::runtime_error& error) {
    restore();
    std::ostringstream text;
    text << error.what() << "; in the window that begins at t = " << next_window().begin << " s";
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
  report.completed = true;
  while (report.completed && report.windows < windows) report.completed = step(report, observer);
  report.wall_seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return report;
}

}  // namespace orbearing::cosim
