// The low-pass of an instrument.
#pragma once

#include <Eigen/Core>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>

#include "mechanics/constants.hpp"

namespace orbearing::analysis {

// Low-pass of an instrument before it samples, here the windowed sine of Blackman over samples taken more
// often. Without it, forces that jump would cause false lines.
template <int kChannels>
class InstrumentLowPass {
 public:
  static constexpr long kOversampling = 8;
  static constexpr long kReach = 16;  // samples to each side that one takes part in

  InstrumentLowPass() : weight_(2 * kReach * kOversampling + 1), last_(kChannels, weight_.size()) {
    constexpr double middle =
        0.42;  // of the fall from 1 to 0, over the sampling rate: between a third and a half
    const auto reach = static_cast<double>(kReach * kOversampling);
    for (Eigen::Index k = 0; k < weight_.size(); ++k) {
      const double at = static_cast<double>(k) - reach, turn = constants::pi * at / reach;
      const double blackman = 0.42 + 0.5 * std::cos(turn) + 0.08 * std::cos(2.0 * turn);
      weight_[k] = blackman * boost::math::sinc_pi(2.0 * constants::pi * middle * at / kOversampling);
    }
    weight_ /= weight_.sum();
    last_.setZero();
  }

  void take(const Eigen::Matrix<double, kChannels, 1>& value) {
    last_.col(next_) = value.array();
    next_ = (next_ + 1) % last_.cols();
  }

  /// The value `kReach` samples ago.
  Eigen::Array<double, kChannels, 1> value() const {
    const Eigen::Index old = last_.cols() - next_;  // number at the end of the store
    return (last_.rightCols(old).matrix() * weight_.head(old).matrix() +
            last_.leftCols(next_).matrix() * weight_.tail(next_).matrix())
        .array();
  }

 private:
  Eigen::ArrayXd weight_;
  Eigen::Array<double, kChannels, Eigen::Dynamic> last_;
  Eigen::Index next_ = 0;
};

}  // namespace orbearing::analysis
