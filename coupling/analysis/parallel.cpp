#include "coupling/analysis/parallel.hpp"

#include <tbb/concurrent_queue.h>
#include <tbb/info.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>
#include <system_error>
#include <thread>

#include "mechanics/cancellation.hpp"

namespace orbearing::analysis {
namespace {

/// Points that may wait for delivery; bounds memory where delivery is the slower side.
constexpr std::ptrdiff_t most_waiting = 64;

/// Finished points on their way to the delivering thread; an empty one: no more follow.
using Queue = tbb::concurrent_bounded_queue<std::optional<ComputedPoint>>;

PointResult failed_point(const std::string& reason) {
  PointResult result;
  result.status = reason;
  return result;
}

PointResult result_or_reason(const Evaluate& evaluate, std::size_t index) {
  try {
    return evaluate(index);
  } catch (const std::exception& error) {
    return failed_point(error.what());
  } catch (const Cancelled&) {
    throw;
  } catch (...) {
    return failed_point("failed for a reason that is not known");
  }
}

/// Points are taken in line, so that an interrupted sweep is done up to some point; those that were broken
/// off are dropped.
void compute_all(const std::vector<std::size_t>& indices, int jobs, const Evaluate& evaluate, Queue& queue,
                 const std::atomic<bool>& stop, bool& cancelled) {
  try {
    in_parallel(indices.size(), jobs, [&](std::size_t position) {
      if (!stop) queue.push(ComputedPoint{indices[position], result_or_reason(evaluate, indices[position])});
    });
  } catch (const Cancelled&) {
    cancelled = true;
  }
  queue.push(std::nullopt);
}

/// Waits for a point, takes those behind it along. Empty at the end.
std::vector<ComputedPoint> next_points(Queue& queue, bool& ended) {
  std::vector<ComputedPoint> points;
  std::optional<ComputedPoint> point;
  queue.pop(point);
  while (point) {
    points.push_back(std::move(*point));
    if (std::ptrdiff_t(points.size()) >= most_waiting || !queue.try_pop(point)) return points;
  }
  ended = true;
  return points;
}

}  // namespace

std::size_t threads_for(std::size_t count, int jobs) {
  const auto processors = static_cast<std::size_t>(tbb::info::default_concurrency());
  const std::size_t allowed = jobs > 0 ? std::min(static_cast<std::size_t>(jobs), processors) : processors;
  return std::clamp(count, std::size_t{1}, allowed);
}

void in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::exception_ptr failure;
  const auto take_in_line = [&] {
    for (std::size_t i; !failed && (i = next++) < count;) try {
        throw_if_stopped();
        work(i);
      } catch (...) {
        if (!failed.exchange(true)) failure = std::current_exception();
      }
  };
  std::vector<std::jthread> others;
  try {
    while (others.size() + 1 < threads_for(count, jobs)) others.emplace_back(take_in_line);
  } catch (const std::system_error&) {
    // Those that there are do it all, only later.
  }
  take_in_line();
  others.clear();  // waits for them
  if (failure) std::rethrow_exception(failure);
}

void compute_points(const std::vector<std::size_t>& indices, int jobs, const Evaluate& evaluate,
                    const Deliver& deliver) {
  Queue queue;
  queue.set_capacity(most_waiting);
  std::atomic<bool> delivery_failed = false;
  bool cancelled = false;
  std::exception_ptr failure;
  std::jthread computing([&] { compute_all(indices, jobs, evaluate, queue, delivery_failed, cancelled); });
  for (bool ended = false; !ended;) {
    std::vector<ComputedPoint> points = next_points(queue, ended);
    if (points.empty() || failure) continue;
    try {
      deliver(std::move(points));
    } catch (...) {
      failure = std::current_exception();
      delivery_failed = true;
    }
  }
  computing.join();
  if (failure) std::rethrow_exception(failure);
  if (cancelled) throw Cancelled{};
}

}  // namespace orbearing::analysis
