// Time spent: of this thread's own work where other programs share the machine, of the wall where threads do.
#pragma once

#include <ctime>

namespace orbearing::bench {

/// [s]
inline double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Both clocks from a common start.
class Stopwatch {
 public:
  double cpu() const { return seconds_of(CLOCK_THREAD_CPUTIME_ID) - cpu_; }  // [s]
  double wall() const { return seconds_of(CLOCK_MONOTONIC) - wall_; }        // [s]

 private:
  double cpu_ = seconds_of(CLOCK_THREAD_CPUTIME_ID);
  double wall_ = seconds_of(CLOCK_MONOTONIC);
};

}  // namespace orbearing::bench
