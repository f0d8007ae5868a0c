// How far motions in progress are, for whoever watches the process.
#pragma once

#include <functional>

namespace orbearing::system {

/// Called with how far one of the motions in progress is [s] and how far it may go at most [s].
using MotionObserver = std::function<void(double time, double most)>;

/// While it lives `observer` is called for every motion of the process, from any thread, one call at a time.
/// One object at a time.
class ObservedMotions {
 public:
  explicit ObservedMotions(MotionObserver observer);
  ObservedMotions(const ObservedMotions&) = delete;
  ObservedMotions& operator=(const ObservedMotions&) = delete;
  ~ObservedMotions();
};

/// Costs next to nothing where nobody watches.
void tell_of_motion(double time, double most);

}  // namespace orbearing::system
