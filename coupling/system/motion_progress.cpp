#include "coupling/system/motion_progress.hpp"

#include <atomic>
#include <mutex>
#include <utility>

namespace orbearing::system {

namespace {

std::atomic<bool> motions_are_watched = false;
std::mutex telling_of_motion;
MotionObserver motion_observer;  // guarded by the mutex

void watch_motions(MotionObserver observer) {
  const std::scoped_lock lock(telling_of_motion);
  motion_observer = std::move(observer);
  motions_are_watched = motion_observer != nullptr;
}

}  // namespace

ObservedMotions::ObservedMotions(MotionObserver observer) {
  watch_motions(std::move(observer));
}

ObservedMotions::~ObservedMotions() {
  watch_motions(nullptr);
}

void tell_of_motion(double time, double most) {
  if (!motions_are_watched.load(std::memory_order_relaxed)) return;
  const std::scoped_lock lock(telling_of_motion);
  if (motion_observer) motion_observer(time, most);
}

}  // namespace orbearing::system
