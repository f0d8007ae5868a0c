// How far a sweep is: one line on standard error that is written over.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "coupling/system/motion_progress.hpp"

namespace orbearing::app {

/// "120 of 1201 points done, 1081 left, 0:42 to go". `seconds` [s] went by for the `done` less `kept` points.
std::string progress_text(std::size_t done, std::size_t kept, std::size_t all, double seconds);

/// A caller in the same process who sees the progress in place of standard error; from any thread, one call
/// at a time.
using ProgressObserver = std::function<void(std::size_t done, std::size_t all, const std::string& doing)>;

/// While it lives, what this thread begins is reported to the observer, if there is one.
class ObservedProgress {
 public:
  explicit ObservedProgress(ProgressObserver observer);
  ObservedProgress(const ObservedProgress&) = delete;
  ObservedProgress& operator=(const ObservedProgress&) = delete;
  ~ObservedProgress();
};

/// "a point at 0.12 s of motion, at most 0.35 s": bearings that are steady sooner end sooner.
std::string motion_text(double time, double most);

/// Shows nothing unless `shown` and standard error is a terminal. Wipes its line at the end of its life.
class Progress {
 public:
  /// `doing` begins the line: "peak, round 2: ".
  Progress(std::size_t kept, std::size_t all, bool shown, std::string doing = {});
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void show(std::size_t done);

 private:
  void show_motion(double time, double most);
  void print(const std::string& behind);

  using Clock = std::chrono::steady_clock;
  std::size_t kept_;
  std::size_t all_;
  bool shown_;
  std::string doing_;
  ProgressObserver observer_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
  std::size_t done_;
  std::mutex printing_;  // motions are reported by those who compute
  std::optional<system::ObservedMotions> motions_;
};

// SIGINT and SIGTERM ask computations to stop.

/// While any lives the first SIGINT or SIGTERM is request_stop() (mechanics/cancellation.hpp); a second one
/// ends the program at once. The first of several begins without a wish, the last takes it back and gives the
/// signals back. Made by whoever calls: the libraries and the commands do not touch signals.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();
};

}  // namespace orbearing::app
