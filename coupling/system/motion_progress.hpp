// How far motions in progress are and what they show, for whoever watches the process.
#pragma once

#include <functional>

namespace orbearing::bearing::motion {
struct Snapshot;
}

namespace orbearing::system {

/// One of the motions in progress, now.
struct MotionProgress {
  double time = 0.0;                         // [s]
  double most = 0.0;                         // [s]      the latest time that it may come to
  double rolling_cage_speed = 0.0;           // [rad/s]  of the cage at pure rolling, relative to the carrier
  const bearing::motion::Snapshot& bearing;  // the first one
};
using MotionObserver = std::function<void(const MotionProgress&)>;

/// While it lives `observer` is called for a motion of the process, from any thread, one call at a time, not
/// more than twenty times a second. Of several motions the first is followed to its end, then another one.
/// One object at a time.
class ObservedMotions {
 public:
  explicit ObservedMotions(MotionObserver observer);
  ObservedMotions(const ObservedMotions&) = delete;
  ObservedMotions& operator=(const ObservedMotions&) = delete;
  ~ObservedMotions();
};

/// Belongs to a motion as long as it is in progress.
class WatchedMotion {
 public:
  WatchedMotion() = default;
  WatchedMotion(const WatchedMotion&) = delete;
  WatchedMotion& operator=(const WatchedMotion&) = delete;
  ~WatchedMotion();

  /// Whether the observer waits for this motion. Costs next to nothing where nobody watches.
  bool is_due() const;
  /// Does not change what is computed.
  void tell(const MotionProgress& now) const;
};

}  // namespace orbearing::system
