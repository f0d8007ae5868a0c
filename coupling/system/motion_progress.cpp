#include "coupling/system/motion_progress.hpp"

#include <atomic>
#include <chrono>
#include <mutex>
#include <utility>
#include <vector>

namespace orbearing::system {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds least_pause{50};

std::atomic<bool> motions_are_watched = false;
std::atomic<const WatchedMotion*> followed = nullptr;
std::atomic<Clock::time_point> told{};
std::mutex telling_of_motion;
std::vector<const MotionObserver*> watching;  // guarded by the mutex
thread_local int run_in_turn = 0, runs_in_turn = 0;

}  // namespace

ObservedMotions::ObservedMotions(MotionObserver observer) : observer_(std::move(observer)) {
  const std::scoped_lock lock(telling_of_motion);
  watching.push_back(&observer_);
  motions_are_watched = true;
  told = Clock::time_point{};
}

ObservedMotions::~ObservedMotions() {
  const std::scoped_lock lock(telling_of_motion);
  std::erase(watching, &observer_);
  motions_are_watched = !watching.empty();
}

RunInTurn::RunInTurn(int run, int most_runs) {
  run_in_turn = run;
  runs_in_turn = most_runs;
}

RunInTurn::~RunInTurn() {
  run_in_turn = runs_in_turn = 0;
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

void WatchedMotion::tell(MotionProgress now) const {
  now.run = run_in_turn;
  now.most_runs = runs_in_turn;
  const std::scoped_lock lock(telling_of_motion);
  for (const MotionObserver* observer : watching) (*observer)(now);
  told = Clock::now();
}

}  // namespace orbearing::system
