// How long the next window is: fixed, or halved and doubled by the energy residual of the interface.
#pragma once

#include <cmath>

#include "coupling/cosim/participant.hpp"

namespace orbearing::cosim {

/// A window is the longest one over a power of two, and begins at a multiple of its own length.
struct WindowControl {
  double longest = 0.0;           // [s]
  int halvings = 0;               // [-]  at most; 0: all windows are of one length
  double allowed_residual = 0.0;  // [W]  energy residual of a window over its length
};

/// Where a run stands on the grid of windows. All times are an index times a length.
class WindowGrid {
 public:
  WindowGrid(const WindowControl& control, double begin)
      : control_(control), begin_(begin), tick_(std::ldexp(control.longest, -control.halvings)) {}

  Window window() const { return {time_of(index_), time_of(index_ + ticks())}; }
  long ticks_of_longest() const { return 1L << control_.halvings; }
  long index() const { return index_; }  // [tick]

  /// Whether a window with this residual [J] stands; it always does where it can be no shorter.
  bool accepts(double residual) const {
    return level_ == control_.halvings ||
           !(std::abs(residual) > control_.allowed_residual * window().length());
  }
  void reject() { ++level_; }

  /// The next window; twice as long where the grid has room and the residual, of order `order` in the length
  /// of the window, would stay well below what is allowed.
  void accept(double residual, int order) {
    const double share = std::abs(residual) / window().length();
    index_ += ticks();
    const bool small = share * std::ldexp(kSafety, order - 1) < control_.allowed_residual;
    if (level_ > 0 && small && index_ % (2 * ticks()) == 0) --level_;
  }

 private:
  static constexpr double kSafety = 1.5;  // against windows that are doubled and at once refused

  long ticks() const { return 1L << (control_.halvings - level_); }
  double time_of(long index) const { return begin_ + static_cast<double>(index) * tick_; }

  WindowControl control_;
  double begin_;  // [s]
  double tick_;   // [s]
  long index_ = 0;
  int level_ = 0;
};

}  // namespace orbearing::cosim
