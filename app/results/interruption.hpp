// SIGINT and SIGTERM ask computations to stop.
#pragma once

namespace orbearing::app {

/// While any lives the first SIGINT or SIGTERM is request_stop() (mechanics/cancellation.hpp); a second one ends
/// the program at once. The first of several begins without a wish, the last takes it back and gives the signals
/// back. Made by whoever calls: the libraries and the commands do not touch signals.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();
};

}  // namespace orbearing::app
