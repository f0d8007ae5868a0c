// Common parts of all integrators: limits of a run and its report.
#pragma once

#include <algorithm>
#include <chrono>
#include <sstream>

#include "coupling/integration/integration_options.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::integration {

/// An integration in progress: its budget and its report.
class Run {
 public:
  Run(const IntegrationOptions& options, IntegrationReport& report)
      : options_(options), report_(report), begin_(Clock::now()) {}

  /// Books an accepted step that ended at `time`; false where the budget is used up. Throws Cancelled.
  bool accept(double time, double step) {
    throw_if_stopped();
    ++report_.steps;
    report_.reached = time;
    report_.smallest_step = std::min(report_.smallest_step, step);
    if (report_.steps > options_.most_steps) return fail("the largest number of steps was taken");
    if (report_.steps % kStepsPerClockRead == 0 && seconds() > options_.most_seconds)
      return fail("the allowed wall time was used up");
    if (step < options_.smallest_step) return fail("the step fell below the smallest allowed");
    return true;
  }

  /// Writes the reason to the report. Always false.
  bool fail(const std::string& reason) {
    std::ostringstream text;
    text << reason << " at t = " << report_.reached << " s after " << report_.steps << " steps";
    report_.message = text.str();
    return false;
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr long kStepsPerClockRead = 256;

  const IntegrationOptions& options_;
  IntegrationReport& report_;
  Clock::time_point begin_;
};

}  // namespace orbearing::integration
