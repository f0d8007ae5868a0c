#include "app/results/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/standard_error.hpp"
#include "app/units.hpp"
#include "bearing/motion/snapshot.hpp"
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

std::string progress_text(std::size_t done, std::size_t kept, std::size_t all, double seconds, double share) {
  std::string text = fmt::format("{} of {} points done, {} left", done, all, all - done);
  if (share < 0.0) share = static_cast<double>(done - kept) / static_cast<double>(std::max(all - kept, 1UL));
  if (done > kept && done < all && share > 0.0)
    text += fmt::format(", {} to go", clock_text(seconds * (1.0 - share) / share));
  return text;
}

// A point begins at time 0, and another one may roll at another speed.
std::optional<double> seconds_left(Pace& pace, const system::MotionProgress& now) {
  return pace.seconds_left(fmt::format("{}", now.rolling_cage_speed), now.time, now.expected);
}

namespace {

std::string to_go(std::optional<double> seconds) {
  return seconds ? fmt::format(", {} to go", clock_text(*seconds)) : "";
}

}  // namespace

std::string motion_text(const system::MotionProgress& now, std::optional<double> seconds_left) {
  return fmt::format("{}{:.3g} s of {:.3g} s in motion, {:.0f} %{}",
                     now.run > 0 ? fmt::format("run {} of at most {}: ", now.run, now.most_runs) : "",
                     now.time, now.expected, 100.0 * now.share(), to_go(seconds_left));
}

nlohmann::ordered_json motion_json(const system::MotionProgress& now, std::optional<double> seconds_left) {
  const auto list = [](const Eigen::ArrayXd& values) {
    return std::vector<double>(values.begin(), values.end());
  };
  const bearing::motion::Snapshot& bearing = now.bearing;
  nlohmann::ordered_json object{
      {"time_s", now.time},
      {"expected_s", now.expected},
      {"most_s", now.most},
      {"share", now.share()},
      {"seconds_left", nullptr},
      {"run", now.run},
      {"most_runs", now.most_runs},
      {"rolling_cage_rpm", kRpm * now.rolling_cage_speed},
      {"cage_rpm", kRpm * bearing.orbit_speed},
      {"cage_turned_deg", kDegree * bearing.orbit_angle},
      {"cage_um", {per_micro * bearing.cage_position.x(), per_micro * bearing.cage_position.y()}},
      {"angle_deg", list(kDegree * bearing.angle)},
      {"spin_rpm", list(kRpm * bearing.spin)},
      {"inner_load_N", list(bearing.inner.load)},
      {"outer_load_N", list(bearing.outer.load)}};
  if (seconds_left) object["seconds_left"] = *seconds_left;
  return object;
}

std::string share_text(double share, double simulated, double seconds) {
  const bool under_way = share > 0.0 && share < 1.0;
  return fmt::format("{:.3g} s of {:.3g} s in motion, {:.0f} %{}", share * simulated, simulated,
                     100.0 * share,
                     to_go(under_way ? std::optional(seconds * (1.0 - share) / share) : std::nullopt));
}

Progress::Progress(std::size_t kept, std::size_t all, bool shown, std::string doing, double simulated)
    : kept_(kept),
      all_(all),
      shown_(shown && ::isatty(STDERR_FILENO) == 1),
      doing_(std::move(doing)),
      simulated_(simulated),
      observer_(observer_of_thread),
      done_(kept) {
  show(kept);
  if (shown_ && !observer_) motions_.emplace([this](const system::MotionProgress& now) { show_motion(now); });
}

Progress::~Progress() {
  motions_.reset();
  if (shown_) print_to_standard_error("{}", wiped_line);
}

void Progress::show(std::size_t done, double work) {
  const std::scoped_lock lock(printing_);
  done_ = done;
  work_ = work;
  const Clock::time_point now = Clock::now();
  if ((!shown_ && !observer_) || now - last_ < least_pause) return;
  last_ = now;
  if (observer_) return observer_(done, all_, doing_);
  print({});
}

void Progress::show_motion(const system::MotionProgress& motion) {
  const std::scoped_lock lock(printing_);
  const std::optional<double> left = seconds_left(pace_, motion);
  const Clock::time_point now = Clock::now();
  if (now - last_ < least_pause) return;
  last_ = now;
  print(motion_text(motion, left));
}

// For a single point the text is the progress of its motion.
void Progress::print(const std::string& motion) {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  std::string text = simulated_ > 0.0 ? "" : doing_;
  if (simulated_ > 0.0)
    text = share_text(static_cast<double>(done_) / static_cast<double>(all_), simulated_, seconds);
  else if (motion.empty() || all_ > 1)
    text += progress_text(done_, kept_, all_, seconds, work_) + (motion.empty() ? "" : "; a point: ");
  print_to_standard_error("{}{}{}", wiped_line, text, motion);
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
