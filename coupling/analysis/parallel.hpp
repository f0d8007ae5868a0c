// Many operating points at once, each on a thread of its own.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "coupling/analysis/operating_point.hpp"

namespace orbearing::analysis {

/// Threads for so many calls: at most `jobs` (0: no bound), never more than processors or calls.
std::size_t threads_for(std::size_t count, int jobs);

/// Calls work(0) to work(count - 1) on at most `jobs` threads (0: no bound), never on more than there are
/// processors or calls, and on fewer if the system does not give so many. The first exception of `work` stops
/// the others and is passed on; after request_stop() (mechanics/cancellation.hpp) that is Cancelled.
void in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

struct ComputedPoint {
  std::size_t index = 0;
  PointResult result;  // of an exception: its text as status, all else at its default
};

/// Computes a point; called from several threads at once.
using Evaluate = std::function<PointResult(std::size_t index)>;
/// Takes finished points, always on the thread that called `compute_points`; may throw.
using Deliver = std::function<void(std::vector<ComputedPoint> points)>;
/// Computes the points `indices` on the threads of `in_parallel` and delivers them in the order they finish,
/// several together where delivery is slower than computing. Points are independent of each other, so results
/// do not depend on `jobs`. Returns when all points are delivered. An exception of `deliver` stops the
/// computation and is passed on. After request_stop() finished points are delivered, those in progress
/// dropped, and Cancelled is thrown.
void compute_points(const std::vector<std::size_t>& indices, int jobs, const Evaluate& evaluate,
                    const Deliver& deliver);

}  // namespace orbearing::analysis
