// SIGINT and SIGTERM as a wish to stop, for as long as results are being written.
#pragma once

namespace orbearing::app {

/// While any lives the first SIGINT or SIGTERM sets a flag; a second one ends the program at once. The first of
/// several clears the flag, the last gives the signals back.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// From any thread.
  static bool requested();
};

}  // namespace orbearing::app
