#include "coupling/study/parallel.hpp"

#include <gtest/gtest.h>
#include <tbb/info.h>

#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace orbearing::study {
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

TEST(InParallel, WhatIsThrownIsPassedOn) {
  EXPECT_THROW(in_parallel(100, 0,
                           [](std::size_t i) {
                             if (i == 7) throw std::runtime_error("seven");
                           }),
               std::runtime_error);
}

}  // namespace
}  // namespace orbearing::study
