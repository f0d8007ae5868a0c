// Means by which two runs of the same bearing are compared: trajectories diverge within a millisecond, means
// do not.
#pragma once

#include <algorithm>
#include <cmath>

namespace orbearing::bench {

/// Loads gathered over a run, weighed by time.
class LoadTally {
 public:
  explicit LoadTally(int rollers) : rollers_(rollers) {}

  /// Loads [N] of all rollers on both races, with a weight of `weight` [s].
  void add(const double* inner, const double* outer, double weight) {
    double inner_square = 0.0, outer_square = 0.0;
    for (int j = 0; j < rollers_; ++j) {
      inner_square += inner[j] * inner[j];
      outer_square += outer[j] * outer[j];
      largest_ = std::max({largest_, inner[j], outer[j]});
    }
    inner_square_ += weight * inner_square;
    outer_square_ += weight * outer_square;
    time_ += weight;
  }

  double inner_rms() const { return std::sqrt(inner_square_ / (time_ * rollers_)); }  // [N]
  double outer_rms() const { return std::sqrt(outer_square_ / (time_ * rollers_)); }  // [N]
  double largest() const { return largest_; }                                         // [N]

 private:
  int rollers_;
  double time_ = 0.0;          // [s]
  double inner_square_ = 0.0;  // [N^2 s]
  double outer_square_ = 0.0;  // [N^2 s]
  double largest_ = 0.0;       // [N]
};

}  // namespace orbearing::bench
