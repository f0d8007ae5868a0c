#include "coupling/analysis/parallel.hpp"

#include <gtest/gtest.h>
#include <tbb/info.h>

#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "mechanics/cancellation.hpp"

namespace orbearing::analysis {
namespace {

TEST(InParallel, EachCallIsMadeOnce) {
  for (const int jobs : {0, 1, 4096}) {
    std::vector<int> calls(1000, 0);
    in_parallel(calls.size(), jobs, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(1000, 1)) << jobs;
  }
  in_parallel(0, 0, [](std::size_t) { FAIL() << "called"; });
}

TEST(InParallel, NoMoreThreadsThanProcessorsOrJobs) {
  for (const int jobs : {1, 4096}) {
    std::mutex lock;
    std::set<std::thread::id> threads;
    in_parallel(1000, jobs, [&](std::size_t) {
      const std::scoped_lock locked(lock);
      threads.insert(std::this_thread::get_id());
    });
    EXPECT_LE(threads.size(), static_cast<std::size_t>(jobs == 1 ? 1 : tbb::info::default_concurrency()));
  }
}

TEST(ThreadsFor, AreAtMostThoseAskedForTheProcessorsAndTheWork) {
  const auto processors = static_cast<std::size_t>(tbb::info::default_concurrency());
  EXPECT_EQ(threads_for(1000, 1), 1U);
  EXPECT_EQ(threads_for(1000, 0), processors);
  EXPECT_EQ(threads_for(1000, 4096), processors);
  EXPECT_EQ(threads_for(1, 4096), 1U);
  EXPECT_EQ(threads_for(0, 0), 1U);
}

TEST(InParallel, WhatIsThrownIsPassedOn) {
  EXPECT_THROW(in_parallel(100, 0,
                           [](std::size_t i) {
                             if (i == 7) throw std::runtime_error("seven");
                           }),
               std::runtime_error);
}

// A computation with a stop request from any thread throws, delivers finished points and nothing else, and
// begins nothing until the request is cleared.
TEST(ComputePoints, AskedToStopTheyDeliverWhatIsFinished) {
  std::vector<std::size_t> indices(100), delivered;
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i;
  const auto evaluate = [](std::size_t i) {
    if (i == 40) std::thread(request_stop).join();
    throw_if_stopped();
    return PointResult{};
  };
  const auto deliver = [&](const std::vector<ComputedPoint>& points) {
    for (const ComputedPoint& point : points) {
      EXPECT_EQ(point.result.status, PointResult{}.status) << point.index;
      delivered.push_back(point.index);
    }
  };
  EXPECT_THROW(compute_points(indices, 1, evaluate, deliver), Cancelled);
  EXPECT_EQ(delivered, std::vector<std::size_t>(indices.begin(), indices.begin() + 40));
  EXPECT_THROW(in_parallel(1, 1, [](std::size_t) { FAIL() << "begun"; }), Cancelled);
  clear_stop();
  in_parallel(1, 1, [](std::size_t) { throw_if_stopped(); });
}

}  // namespace
}  // namespace orbearing::analysis
