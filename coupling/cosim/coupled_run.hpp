// A co-simulation: sides that move over windows in turn, and its cost.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "coupling/cosim/exchange.hpp"

namespace orbearing::cosim {

// Next expectation for the end of a window, after a pass has given the output of the last expectation.

/// State of an iteration: IQN-ILS, least squares over all outputs of this window and the last ones
/// [Degroote2009]. Eqs. (9) and (10) of README.md.
class QuasiNewton {
 public:
  /// @param windows before the present one whose differences it goes on using
  explicit QuasiNewton(int windows) : windows_(static_cast<std::size_t>(std::max(0, windows))) {}

  /// A new window begins.
  void begin();
  /// The next expectation, from the last and the output that it gave.
  /// @param weight one over the size of a typical value: makes values of different units comparable; may
  /// change from call to call
  Eigen::VectorXd next(const Eigen::VectorXd& expected, const Eigen::VectorXd& output,
                       const Eigen::VectorXd& weight);

 private:
  struct Column {
    Eigen::VectorXd residual;  // difference of two residuals
    Eigen::VectorXd output;    // and of their outputs
  };

  Eigen::VectorXd correction(const Eigen::VectorXd& residual, const Eigen::VectorXd& weight) const;

  std::size_t windows_;
  std::deque<std::vector<Column>> columns_ = {{}};  // windows, the newest first
  Eigen::VectorXd residual_;
  Eigen::VectorXd output_;
};

struct Iteration {
  int most_passes = 1;           // [-]  1: explicit exchange
  double allowed_change = 1e-6;  // [-]  between input and output, over the largest value of its kind
  int windows = 4;               // [-]  before, whose differences the iteration goes on using
};

struct CoupledOptions {
  ExchangeOrder order = ExchangeOrder::gauss_seidel;
  int extrapolation = 1;  // [-]  degree, 0 to 2
  Iteration iteration;
  double window = 0.0;            // [s]
  int balance_rounds = 30;        // [-]  at the start, at most
  double balanced_change = 1e-9;  // [-]  of the largest force: good enough
};

/// Co-simulation in a case.
template <class Visitor>
void describe(Visitor& visit, CoupledOptions& m) {
  using namespace described;
  rows(visit,
       input(m.order, "simulation.exchange.order",
             "order of the co-simulation in a window: bearings after gears, or both at the same time",
             {.reason = "stable in longer windows", .numerical = true}),
       input(m.window, "simulation.exchange.window", "longest time between two exchanges",
             {.dimension = dimension::time,
              .range = positive(1e-3),
              .reason = "a fraction of the stability limit: life as of one system within 2 % (reducer)",
              .written = "us",
              .numerical = true}),
       input(m.extrapolation, "simulation.exchange.extrapolation",
             "degree of the polynomial that extrapolates forces and velocities in a window",
             {.range = {0, 2}, .reason = "order 2 without overshoot at impacts", .numerical = true}),
       input(m.iteration.most_passes, "simulation.exchange.passes",
             "maximum number of passes over a window until both sides agree; 1: no repetition",
             {.range = {1, 100}, .reason = "short windows cost less than repeated ones", .numerical = true}));
}

/// One window.
struct WindowRecord {
  Window window;
  int passes = 0;                        // [-]
  double residual = 0.0;                 // [J]  energy that the interface made or lost; Eq. (8) of README.md
  double change = 0.0;                   // [-]  of the last pass, where there were several
  const InterfaceValues* end = nullptr;  // valid while the observer is called
};
using WindowObserver = std::function<void(const WindowRecord&)>;

struct CoupledReport {
  bool completed = false;
  double reached = 0.0;            // [s]
  long windows = 0;                // [-]
  long passes = 0;                 // [-]
  long not_converged = 0;          // [-]  windows that were accepted after the most passes
  double residual = 0.0;           // [J]  sum over all windows
  double absolute_residual = 0.0;  // [J]  sum of absolute values
  double passed = 0.0;             // [J]  sum of |work| at all joints, by the values at the ends of windows
  double wall_seconds = 0.0;       // [s]
  std::string message;             // empty when completed

  /// Goes on with a later part of the run: sums add up, the rest is the later part's.
  CoupledReport& operator+=(const CoupledReport& later);
};

/// Continues from its present state with each call of advance().
class CoupledRun {
 public:
  /// The participants must outlive it. Throws std::invalid_argument for options without meaning, or as
  /// connect_by_name().
  CoupledRun(const Sides& sides, const CoupledOptions& options);

  /// All participants to their equilibrium at `time` [s].
  void initialize(double time);
  /// From the last values of `history`, which is the present state of the participants; up to two before them
  /// help the first windows to their order.
  void start_from(const InterfaceHistory& history);

  /// Over so many windows. Errors are in the report, which is of this call only; the run then is at the last
  /// good window.
  CoupledReport advance(long windows, const WindowObserver& observer = {});

  const InterfaceValues& values() const { return history_.back(); }
  /// Present inputs of a side that gives forces.
  const std::vector<double>& inputs(std::size_t side) const { return exchange_.inputs(side); }

 private:
  struct Solution;

  Solution solve(const Window& window);
  bool step(CoupledReport& report, const WindowObserver& observer);
  void accept(Solution& solution, CoupledReport& report, const WindowObserver& observer);
  int most_passes() const;
  Window next_window() const;
  void save();
  void restore();

  CoupledOptions options_;
  Exchange exchange_;
  QuasiNewton iteration_;
  InterfaceHistory history_;
  double begin_ = 0.0;  // [s]
  long done_ = 0;       // windows since then
  std::vector<SavedState> saved_;
};

}  // namespace orbearing::cosim
