#include "benchmarks/speed.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

#include "benchmarks/clocks.hpp"

namespace orbearing::bench {

namespace {

constexpr int kPairs = 7;
constexpr int kRealTimeRuns = 3;
constexpr double kShortestRun = 20e-3;  // [s]  simulated, so that a run takes some milliseconds
constexpr int kSweepPoints = 12;
constexpr int kSweepRuns = 5;
constexpr int kSweepThreads = 2;
constexpr double kSweepDuration = 0.13;  // [s]

void simulate(const analysis::PlanetaryDrivetrain& drivetrain, double rpm, double clearance) {
  Contest contest(duty_at(drivetrain, rpm, clearance));
  contest.run(Method::fast, contest.quasi_static_start(), {kSweepDuration, 1},
              contest.duty().allowed_length_error);
}

// Slow speeds take longest, and go first.
double sweep_once(const analysis::PlanetaryDrivetrain& drivetrain, double clearance) {
  std::atomic<int> next = 1;
  const auto work = [&] {
    for (int point = next++; point <= kSweepPoints; point = next++)
      simulate(drivetrain, 1000.0 * point, clearance);
  };
  const Stopwatch watch;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < kSweepThreads; ++i) threads.emplace_back(work);
  }
  return watch.wall();
}

}  // namespace

Quartiles speedup(Trial& trial, Trial& theirs, Method method, double tolerance) {
  const Span one{trial.span.duration / kRevolutions};
  std::vector<double> ratios;
  for (int pair = 0; pair < kPairs; ++pair) {
    const double fast =
        trial.contest.run(Method::fast, trial.start, one, trial.contest.duty().allowed_length_error)
            .cpu_seconds;
    const double other = theirs.contest.run(method, theirs.start, one, tolerance).cpu_seconds;
    ratios.push_back(other / fast);
  }
  return quartiles(ratios);
}

double real_time(const Duty& duty) {
  Contest contest(duty);
  const double duration = std::max(contest.duty().cage_revolution(), kShortestRun);
  const Eigen::VectorXd start = contest.settled(duration);
  std::vector<double> factors;
  for (int run = 0; run < kRealTimeRuns; ++run)
    factors.push_back(
        duration /
        contest.run(Method::fast, start, {duration, 1}, contest.duty().allowed_length_error).cpu_seconds);
  return median(factors);
}

double sweep_seconds(const analysis::PlanetaryDrivetrain& drivetrain, double clearance) {
  std::vector<double> seconds;
  for (int run = 0; run < kSweepRuns; ++run) seconds.push_back(sweep_once(drivetrain, clearance));
  return median(seconds);
}

}  // namespace orbearing::bench
