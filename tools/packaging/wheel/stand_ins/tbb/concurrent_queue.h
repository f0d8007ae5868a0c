// The parts of oneTBB that coupling/analysis/parallel.cpp uses, by the standard library: a wheel carries no TBB.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace tbb {

template <class Value>
class concurrent_bounded_queue {
 public:
  void set_capacity(std::ptrdiff_t most) { most_ = static_cast<std::size_t>(most); }

  void push(Value value) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return values_.size() < most_; });
    values_.push_back(std::move(value));
    changed_.notify_all();
  }

  void pop(Value& value) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !values_.empty(); });
    take(value);
  }

  bool try_pop(Value& value) {
    const std::scoped_lock lock(mutex_);
    if (values_.empty()) return false;
    take(value);
    return true;
  }

 private:
  void take(Value& value) {
    value = std::move(values_.front());
    values_.pop_front();
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Value> values_;
  std::size_t most_ = 0;
};

}  // namespace tbb
