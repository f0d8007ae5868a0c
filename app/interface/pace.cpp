#include "orbearing/pace.hpp"

#include <algorithm>

namespace orbearing {

std::optional<double> Pace::seconds_left(const std::string& piece, double done, double all) {
  if (last_ < 0.0 || done < last_ || piece != piece_) {
    start_ = Clock::now();
    from_ = done;
    piece_ = piece;
  }
  last_ = done;
  if (!(done > from_)) return std::nullopt;
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  return seconds * std::max(0.0, all - done) / (done - from_);
}

}  // namespace orbearing
