// SIGINT and SIGTERM as a wish to stop, for as long as results are being written.
#pragma once

#include <array>
#include <csignal>

namespace orbearing::app {

/// While it lives the first SIGINT or SIGTERM sets a flag; a second one ends the program at once. One object
/// at a time.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// From any thread.
  static bool requested();

 private:
  std::array<struct sigaction, 2> former_{};
};

}  // namespace orbearing::app
