#include "app/results/interruption.hpp"

#include <array>
#include <csignal>
#include <cstddef>
#include <mutex>

#include "mechanics/cancellation.hpp"

namespace orbearing::app {
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
