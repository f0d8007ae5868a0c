#include "coupling/system/motion_progress.hpp"

#include <atomic>
#include <chrono>
#include <mutex>
#include <utility>

namespace orbearing::system {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds least_pause{50};

std::atomic<bool> motions_are_watched = false;
std::atomic<const WatchedMotion*> followed = nullptr;
std::atomic<Clock::time_point> told{};
std::mutex telling_of_motion;
MotionObserver motion_observer;  // guarded by the mutex

void watch_motions(MotionObserver observer) {
  const std::scoped_lock lock(telling_of_motion);
  motion_observer = std::move(observer);
  motions_are_watched = motion_observer != nullptr;
  told = Clock::time_point{};
}

}  // namespace

ObservedMotions::ObservedMotions(MotionObserver observer) {
  watch_motions(std::move(observer));
}

ObservedMotions::~ObservedMotions() {
  watch_motions(nullptr);
}

WatchedMotion::~WatchedMotion() {
  const WatchedMotion* self = this;
  followed.compare_exchange_strong(self, nullptr);
}

bool WatchedMotion::is_due() const {
  if (!motions_are_watched.load(std::memory_order_relaxed)) return false;
  const WatchedMotion* none = nullptr;
  followed.compare_exchange_strong(none, this);
  return followed.load() == this && Clock::now() - told.load() >= least_pause;
}

void WatchedMotion::tell(const MotionProgress& now) const {
  const std::scoped_lock lock(telling_of_motion);
  if (motion_observer) motion_observer(now);
  told = Clock::now();
}

}  // namespace orbearing::system
