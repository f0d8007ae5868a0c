// Progress and present state of motions, for observers of the process.
#pragma once

#include <algorithm>
#include <functional>

namespace orbearing::bearing::motion {
struct Snapshot;
}

namespace orbearing::system {

/// One of the motions in progress, now.
struct MotionProgress {
  double time = 0.0;      // [s]
  double most = 0.0;      // [s]  the latest time that it may come to
  double expected = 0.0;  // [s]  that it comes to if it is steady after this window; once steady, its end
  double rolling_cage_speed = 0.0;           // [rad/s]  of the cage at pure rolling, relative to the carrier
  const bearing::motion::Snapshot& bearing;  // the first one
  int run = 0;        // which of several runs of gears and bearing in turn, counted from 1; 0: a single one
  int most_runs = 0;  // of these

  /// Done of what is expected [-].
  double share() const { return expected > 0.0 ? std::clamp(time / expected, 0.0, 1.0) : 0.0; }
};
using MotionObserver = std::function<void(const MotionProgress&)>;

/// During its lifetime `observer` is called for a motion of the process, from any thread, one call at a time,
/// not more than twenty times a second. Several motions: the first is followed to its end, then another one.
/// All such objects observe the same motion.
class ObservedMotions {
 public:
  explicit ObservedMotions(MotionObserver observer);
  ObservedMotions(const ObservedMotions&) = delete;
  ObservedMotions& operator=(const ObservedMotions&) = delete;
  ~ObservedMotions();

 private:
  MotionObserver observer_;
};

/// While it lives a motion of this thread is one of several runs in turn.
class RunInTurn {
 public:
  /// @param run counted from 1
  RunInTurn(int run, int most_runs);
  RunInTurn(const RunInTurn&) = delete;
  RunInTurn& operator=(const RunInTurn&) = delete;
  ~RunInTurn();
};

/// Belongs to a motion as long as it is in progress.
class WatchedMotion {
 public:
  WatchedMotion() = default;
  WatchedMotion(const WatchedMotion&) = delete;
  WatchedMotion& operator=(const WatchedMotion&) = delete;
  ~WatchedMotion();

  /// Whether the observer waits for this motion. Costs almost nothing without an observer.
  bool is_due() const;
  /// Does not change what is computed. Which run it is in turn is filled in.
  void tell(MotionProgress now) const;
};

}  // namespace orbearing::system
