#include "coupling/study/parallel.hpp"

#include <tbb/concurrent_queue.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>
#include <thread>

namespace orbearing::study {
namespace {

/// Points that may wait for delivery; bounds memory where delivery is the slower side.
constexpr std::ptrdiff_t most_waiting = 64;

/// Finished points on their way to the delivering thread; an empty one says that no more follow.
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
  } catch (...) {
    return failed_point("failed for a reason that is not known");
  }
}

/// Each worker takes the next point in line, so that an interrupted sweep is done up to some point.
void compute_all(const std::vector<std::size_t>& indices, int jobs, const Evaluate& evaluate, Queue& queue,
                 const StopRequested& stop_requested) {
  std::atomic<std::size_t> next = 0;
  const auto worker = [&](int) {
    for (std::size_t place; !stop_requested() && (place = next++) < indices.size();)
      queue.push(ComputedPoint{indices[place], result_or_reason(evaluate, indices[place])});
  };
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(jobs));
  tbb::task_arena arena(jobs);
  arena.execute([&] { tbb::parallel_for(0, jobs, worker, tbb::simple_partitioner()); });
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

void compute_points(const std::vector<std::size_t>& indices, int jobs, const Evaluate& evaluate,
                    const Deliver& deliver, const StopRequested& stop_requested) {
  Queue queue;
  queue.set_capacity(most_waiting);
  std::atomic<bool> delivery_failed = false;
  std::exception_ptr failure;
  const int threads = jobs > 0 ? jobs : tbb::info::default_concurrency();
  std::jthread computing([&] {
    compute_all(indices, threads, evaluate, queue, [&] { return delivery_failed || stop_requested(); });
  });
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
}

}  // namespace orbearing::study
