// Time that a computation still takes, by its progress.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace orbearing {

/// Time to go of one piece of work after the other, by what each has done since it was first seen.
class Pace {
 public:
  /// [s]  of the piece that is called so; none at its first sight
  std::optional<double> seconds_left(const std::string& piece, double done, double all);

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_{};
  double from_ = 0.0, last_ = -1.0;  // done
  std::string piece_;
};

}  // namespace orbearing
