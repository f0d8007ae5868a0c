// A wish from outside to stop computing: one flag of the process, which every long computation of the libraries
// looks at.
#pragma once

#include <atomic>

namespace orbearing {

/// Thrown by computations on request_stop(). Not a std::exception on purpose: code that turns errors of a
/// computation into a status or a message would otherwise report an interrupted computation as failed.
class Cancelled {
 public:
  const char* what() const noexcept { return "interrupted"; }
};

namespace detail {
extern std::atomic<bool> stop_wished;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing that locks");
}  // namespace detail

/// From any thread or signal handler: computations in progress, on all threads, throw Cancelled within a
/// second, and so do those that are begun until clear_stop(). The libraries never call it themselves.
inline void request_stop() noexcept {
  detail::stop_wished.store(true, std::memory_order_relaxed);
}
/// Before computations that an earlier wish shall not end.
inline void clear_stop() noexcept {
  detail::stop_wished.store(false, std::memory_order_relaxed);
}
inline bool stop_requested() noexcept {
  return detail::stop_wished.load(std::memory_order_relaxed);
}
/// In every loop that may last: costs one load.
inline void throw_if_stopped() {
  if (stop_requested()) throw Cancelled{};
}

}  // namespace orbearing
