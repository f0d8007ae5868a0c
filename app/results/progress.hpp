// How far a sweep is: one line on standard error that is written over.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "coupling/system/motion_progress.hpp"
#include "orbearing/pace.hpp"

namespace orbearing::app {

/// "120 of 1201 points done, 1081 left, 0:42 to go". `seconds` [s] is the time for the `done` less `kept`
/// points; `share` [-] of the work of all points but the kept ones, where they differ; below 0: all equal.
std::string progress_text(std::size_t done, std::size_t kept, std::size_t all, double seconds,
                          double share = -1.0);

/// Function of a caller in the same process that receives the progress instead of standard error; from any
/// thread, one call at a time.
using ProgressObserver = std::function<void(std::size_t done, std::size_t all, const std::string& doing)>;

/// While it exists, progress that this thread begins is reported to the observer, if there is one.
class ObservedProgress {
 public:
  explicit ObservedProgress(ProgressObserver observer);
  ObservedProgress(const ObservedProgress&) = delete;
  ObservedProgress& operator=(const ObservedProgress&) = delete;
  ~ObservedProgress();
};

/// Time to go of a motion [s]; none at its first sight.
std::optional<double> seconds_left(Pace& pace, const system::MotionProgress& now);

/// "run 2 of at most 8: 0.0231 s of 0.18 s in motion, 13 %, 0:04 to go". A motion that is not yet steady may
/// last longer than expected.
std::string motion_text(const system::MotionProgress& now, std::optional<double> seconds_left);

/// The same for callers, with cage and rollers (Request::motion).
nlohmann::ordered_json motion_json(const system::MotionProgress& now, std::optional<double> seconds_left);

/// "12 % of 0.5 s in motion, 0:04 to go": of an analysis in time that reports the share done. `simulated`
/// [s] in all; `seconds` [s] went by.
std::string share_text(double share, double simulated, double seconds);

/// Shows nothing unless `shown` and standard error is a terminal. Wipes its line at the end of its life.
class Progress {
 public:
  /// `doing` begins the line: "peak, round 2: ". `simulated` [s]: of a motion, whose shares the parts are
  /// then; else these are points.
  Progress(std::size_t kept, std::size_t all, bool shown, std::string doing = {}, double simulated = 0.0);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// `work` [-]: share of the work that is done, where points differ; below 0: all equal.
  void show(std::size_t done, double work = -1.0);

 private:
  void show_motion(const system::MotionProgress& now);
  void print(const std::string& behind);

  using Clock = std::chrono::steady_clock;
  std::size_t kept_;
  std::size_t all_;
  bool shown_;
  std::string doing_;
  double simulated_;  // [s]
  ProgressObserver observer_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
  std::size_t done_;
  double work_ = -1.0;  // [-]  done
  Pace pace_;
  std::mutex printing_;  // motions are reported by those who compute
  std::optional<system::ObservedMotions> motions_;
};

// SIGINT and SIGTERM request the end of computations.

/// While any exists, the first SIGINT or SIGTERM is request_stop() (mechanics/cancellation.hpp); a second one
/// ends the program at once. The first object begins without a request, the last one clears the request and
/// restores the handlers. Made by the caller: the libraries and the commands do not handle signals.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();
};

}  // namespace orbearing::app
