#include "coupling/diagnosis/orders.hpp"

#include <algorithm>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>
#include <stdexcept>

#include "mechanics/constants.hpp"
#include "mechanics/easy_length.hpp"

namespace orbearing::diagnosis {

namespace {

using constants::pi;
using constants::two_pi;

constexpr Eigen::Index kReach = 32;  // samples to each side

// Of what the samples hold at `place`, counted in samples.
double between(const Eigen::ArrayXd& signal, double position) {
  const auto nearest = static_cast<Eigen::Index>(std::floor(position));
  const Eigen::Index from = std::max<Eigen::Index>(0, nearest - kReach + 1);
  const Eigen::Index to = std::min(signal.size() - 1, nearest + kReach);
  double sum = 0.0;
  for (Eigen::Index k = from; k <= to; ++k) {
    const double off = position - static_cast<double>(k), turn = pi * off / static_cast<double>(kReach);
    const double blackman = 0.42 + 0.5 * std::cos(turn) + 0.08 * std::cos(2.0 * turn);
    sum += signal[k] * blackman * boost::math::sinc_pi(pi * off);
  }
  return sum;
}

// Where the angle is `wanted`: within the samples after `k` by the parabola through three of them.
double position_of(const Eigen::ArrayXd& angle, Eigen::Index k, double wanted) {
  const Eigen::Index middle = std::clamp<Eigen::Index>(k, 1, angle.size() - 2);
  const double slope = 0.5 * (angle[middle + 1] - angle[middle - 1]);
  const double bend = angle[middle + 1] - 2.0 * angle[middle] + angle[middle - 1];
  double off = (wanted - angle[middle]) / slope;
  for (int i = 0; i < 4; ++i)
    off -= (angle[middle] + off * (slope + 0.5 * bend * off) - wanted) / (slope + bend * off);
  return static_cast<double>(middle) + off;
}

}  // namespace

AngleSignal resampled(const Eigen::ArrayXd& signal, const Eigen::ArrayXd& angle) {
  const Eigen::Index samples = signal.size();
  if (samples < 3 || angle.size() != samples)
    throw std::invalid_argument(
        "order tracking: found a signal without an angle for each of its samples; "
        "required: at least 3 of both");
  const double sense = angle[samples - 1] > angle[0] ? 1.0 : -1.0;
  const Eigen::ArrayXd turned = sense * (angle - angle[0]);
  const Eigen::ArrayXd steps = turned.tail(samples - 1) - turned.head(samples - 1);
  if (!(steps.minCoeff() > 0.0))
    throw std::invalid_argument(
        "order tracking: found a shaft that stands or turns back; required: one that turns");
  AngleSignal out{.per_revolution = std::ceil(two_pi / steps.minCoeff())};
  // Interpolation wants neighbours on both sides.
  const Eigen::Index edge = std::min(kReach, samples / 4);
  const double begin = turned[edge], end = turned[samples - 1 - edge];
  const double spacing = two_pi / out.per_revolution;
  const auto most = static_cast<long>(std::floor((end - begin) / spacing)) + 1;
  const auto count = static_cast<Eigen::Index>(mechanics::easy_length_within(most));
  out.value.resize(count);
  Eigen::Index k = edge;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double wanted = begin + spacing * static_cast<double>(i);
    while (k + 2 < samples && turned[k + 1] <= wanted) ++k;
    out.value[i] = between(signal, position_of(turned, k, wanted));
  }
  return out;
}

Spectrum order_spectrum(const AngleSignal& signal, Window window) {
  return spectrum_of(signal.value, signal.per_revolution, window);
}

}  // namespace orbearing::diagnosis
