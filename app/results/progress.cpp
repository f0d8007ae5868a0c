#include "app/results/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <utility>

#include "mechanics/cancellation.hpp"

namespace orbearing::app {

namespace {

constexpr std::chrono::milliseconds least_pause{100};
constexpr const char* wiped_line = "\r\x1b[K";

std::string clock_text(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

thread_local ProgressObserver observer_of_thread;

}  // namespace

ObservedProgress::ObservedProgress(ProgressObserver observer) {
  observer_of_thread = std::move(observer);
}

ObservedProgress::~ObservedProgress() {
  observer_of_thread = nullptr;
}

std::string progress_text(std::size_t done, std::size_t kept, std::size_t all, double seconds) {
  std::string text = fmt::format("{} of {} points done, {} left", done, all, all - done);
  if (done > kept && done < all)
    text += fmt::format(", {} to go", clock_text(seconds / static_cast<double>(done - kept) *
                                                 static_cast<double>(all - done)));
  return text;
}

std::string motion_text(double time, double most) {
  return fmt::format("a point at {:.3g} s of motion, at most {:.3g} s", time, most);
}

Progress::Progress(std::size_t kept, std::size_t all, bool shown, std::string doing)
    : kept_(kept),
      all_(all),
      shown_(shown && ::isatty(STDERR_FILENO) == 1),
      doing_(std::move(doing)),
      observer_(observer_of_thread),
      done_(kept) {
  show(kept);
  if (shown_ && !observer_)
    motions_.emplace([this](const system::MotionProgress& now) { show_motion(now.time, now.most); });
}

Progress::~Progress() {
  motions_.reset();
  if (shown_) fmt::print(stderr, "{}", wiped_line);
}

void Progress::show(std::size_t done) {
  const std::scoped_lock lock(printing_);
  done_ = done;
  const Clock::time_point now = Clock::now();
  if ((!shown_ && !observer_) || now - last_ < least_pause) return;
  last_ = now;
  if (observer_) return observer_(done, all_, doing_);
  print({});
}

void Progress::show_motion(double time, double most) {
  const std::scoped_lock lock(printing_);
  const Clock::time_point now = Clock::now();
  if (now - last_ < least_pause) return;
  last_ = now;
  print("; " + motion_text(time, most));
}

void Progress::print(const std::string& behind) {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  fmt::print(stderr, "{}{}{}{}", wiped_line, doing_, progress_text(done_, kept_, all_, seconds), behind);
  std::fflush(stderr);
}

namespace {

constexpr std::array<int, 2> signals = {SIGINT, SIGTERM};

std::mutex counting;
int living = 0;
std::array<struct sigaction, signals.size()> former;

}  // namespace

Interruption::Interruption() {
  const std::scoped_lock lock(counting);
  if (living++ > 0) return;
  clear_stop();
  for (std::size_t i = 0; i < signals.size(); ++i) {
    struct sigaction action {};
    action.sa_handler = [](int) { request_stop(); };
    action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
    sigaction(signals[i], nullptr, &former[i]);
    // A parent that ignores SIGINT, as nohup and shells do for work in the background, is respected.
    if (former[i].sa_handler != SIG_IGN) sigaction(signals[i], &action, nullptr);
  }
}

Interruption::~Interruption() {
  const std::scoped_lock lock(counting);
  if (--living > 0) return;
  clear_stop();
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &former[i], nullptr);
}

}  // namespace orbearing::app
