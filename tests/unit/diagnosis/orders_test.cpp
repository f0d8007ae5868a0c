// Order tracking. Lines planted over orders are found, levels by Parseval; over frequency they are smeared.
#include "coupling/diagnosis/defect_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "coupling/diagnosis/spectrum.hpp"
#include "tests/messages.hpp"

namespace orbearing::diagnosis::orders_test {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kRate = 4096.0, kTime = 2.0;  // [Hz], [s]
constexpr double kFrom = 10.0, kRamp = 40.0;   // [rev/s], [rev/s^2]
constexpr double kStrong = 1.0, kWeak = 0.4;   // of the orders 3 and 7.5
constexpr double kInterpolation = 1e-3;        // window and interpolation at these orders, relative

Eigen::ArrayXd times() {
  return Eigen::ArrayXd::LinSpaced(static_cast<Eigen::Index>(kRate * kTime), 0.0, kTime - 1.0 / kRate);
}

// Angle of a shaft that runs up evenly from 10 to 90 turns a second.
Eigen::ArrayXd shaft_angle() {
  const Eigen::ArrayXd t = times();
  return kTwoPi * (kFrom * t + 0.5 * kRamp * t * t);
}

Eigen::ArrayXd run_up() {
  const Eigen::ArrayXd angle = shaft_angle();
  return kStrong * (3.0 * angle + 0.3).sin() + kWeak * (7.5 * angle + 1.0).sin();
}

TEST(OrderTracking, PlantedOrdersOfARunUpAreFoundAsLines) {
  const AngleSignal turned = resampled(run_up(), shaft_angle());
  const Spectrum orders = order_spectrum(turned, Window::hann);
  const std::vector<Peak> peaks = peaks_of(orders, {.highest = 20.0, .most = 2});
  ASSERT_EQ(peaks.size(), 2u);
  EXPECT_NEAR(peaks[0].frequency, 3.0, 1e-3);
  EXPECT_NEAR(peaks[0].amplitude, kStrong, kInterpolation * kStrong);
  EXPECT_NEAR(peaks[1].frequency, 7.5, 1e-3);
  EXPECT_NEAR(peaks[1].amplitude, kWeak, 3.0 * kInterpolation * kWeak);
}

TEST(OrderTracking, LevelsByParseval) {
  const AngleSignal turned = resampled(run_up(), shaft_angle());
  const Spectrum orders = order_spectrum(turned, Window::none);
  const double of_lines = 0.5 * orders.amplitude.tail(orders.amplitude.size() - 1).square().sum();
  const double mean = turned.value.mean();
  const double of_signal = (turned.value - mean).square().mean();
  EXPECT_NEAR(of_lines, of_signal, 1e-3 * of_signal);
  const double planted = 0.5 * (kStrong * kStrong + kWeak * kWeak);
  EXPECT_NEAR(of_signal, planted, 0.01 * planted);  // parts of a revolution at both ends
}

TEST(OrderTracking, OverFrequencyTheyAreSmeared) {
  const Spectrum plain = spectrum_of(run_up(), kRate, Window::hann);
  EXPECT_LT(plain.amplitude.maxCoeff(), 0.25 * kStrong);
}

TEST(OrderTracking, ShaftThatTurnsBackwardsGivesTheSame) {
  const Eigen::ArrayXd signal = run_up(), angle = shaft_angle();
  const Eigen::ArrayXd one = resampled(signal, angle).value, other = resampled(signal, -angle).value;
  ASSERT_EQ(one.size(), other.size());
  EXPECT_EQ((one - other).abs().maxCoeff(), 0.0);
}

// A resonance that is struck five times a revolution keeps its hertz; the blows keep their order.
TEST(OrderTracking, EnvelopeKeepsTheOrderOfBlowsOnAResonance) {
  const Eigen::ArrayXd angle = shaft_angle(), t = times();
  const Eigen::ArrayXd struck = (1.0 + 0.8 * (5.0 * angle).cos()) * (kTwoPi * 1400.0 * t).sin();
  const Eigen::ArrayXd envelope = envelope_of(struck, kRate, {800.0, 2000.0});
  const std::vector<Peak> peaks =
      peaks_of(order_spectrum(resampled(envelope, angle), Window::hann), {.highest = 40.0, .most = 1});
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_NEAR(peaks[0].frequency, 5.0, 1e-3);
  EXPECT_NEAR(peaks[0].amplitude, 0.8, 0.02);
}

TEST(OrderTracking, RefusesAShaftThatStands) {
  Eigen::ArrayXd angle = shaft_angle();
  angle[100] = angle[99];
  EXPECT_REFUSED(std::invalid_argument, "orders 1", resampled(run_up(), angle));
  EXPECT_REFUSED(std::invalid_argument, "orders 2", resampled(run_up(), angle.head(10)));
}

// A speed that sways is no parabola over the window: each sample is sought between its neighbours.
TEST(OrderTracking, FollowsASpeedThatSways) {
  const Eigen::ArrayXd angle = kTwoPi * (30.0 * times() + 2.0 * (kTwoPi * 1.5 * times()).sin());
  const AngleSignal turned = resampled((3.0 * angle).sin(), angle);
  const std::vector<Peak> peaks =
      peaks_of(order_spectrum(turned, Window::hann), {.highest = 20.0, .most = 1});
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_NEAR(peaks[0].frequency, 3.0, 1e-3);
  EXPECT_NEAR(peaks[0].amplitude, 1.0, kInterpolation);
}

}  // namespace
}  // namespace orbearing::diagnosis::orders_test
