#include "coupling/diagnosis/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace orbearing::diagnosis::spectrum_test {
namespace {

constexpr double kPi = 3.14159265358979324;
constexpr double kRate = 1000.0;         // [Hz]
constexpr Eigen::Index kSamples = 2000;  // 0.5 Hz between lines

Eigen::ArrayXd times(Eigen::Index samples = kSamples) {
  return Eigen::ArrayXd::LinSpaced(samples, 0.0, static_cast<double>(samples - 1)) / kRate;
}

Eigen::ArrayXd sine(double frequency, double amplitude, double phase = 0.0) {
  return amplitude * (2.0 * kPi * frequency * times() + phase).sin();
}

Eigen::ArrayXd noise(Eigen::Index samples, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::ArrayXd signal(samples);
  for (double& sample : signal) sample = normal(random);
  return signal;
}

// A resonance struck at an even pace, each blow dying away.
Eigen::ArrayXd blows(double pace, double resonance, double decay) {
  const Eigen::ArrayXd t = times();
  Eigen::ArrayXd signal(t.size());
  for (Eigen::Index k = 0; k < t.size(); ++k) {
    const double since = std::fmod(t[k], 1.0 / pace);
    signal[k] = std::exp(-decay * since) * std::sin(2.0 * kPi * resonance * since);
  }
  return signal;
}

TEST(Spectrum, PlantedLinesHaveTheirLevels) {
  const Eigen::ArrayXd signal = 5.0 + sine(50.0, 3.0, 0.4) + sine(120.5, 0.02);
  for (const Window window : {Window::none, Window::hann}) {
    const Spectrum found = spectrum_of(signal, kRate, window);
    EXPECT_DOUBLE_EQ(found.resolution, 0.5);
    EXPECT_NEAR(found.amplitude[100], 3.0, 1e-12);
    EXPECT_NEAR(found.amplitude[241], 0.02, 1e-12);
    EXPECT_NEAR(found.amplitude[0], 0.0, 1e-2);  // the mean is taken off; the window brings a little back
    EXPECT_LT(found.amplitude[170], 1e-12);
  }
}

// Half the sum of the squares is the mean square, for any length.
TEST(Spectrum, LevelsByParseval) {
  for (const Eigen::Index samples : {Eigen::Index{2000}, Eigen::Index{1001}, Eigen::Index{1944}}) {
    const Eigen::ArrayXd signal = noise(samples, 7);
    const Eigen::ArrayXd squares = spectrum_of(signal, kRate, Window::none).amplitude.square();
    double sum = 0.5 * squares.sum();
    if (samples % 2 == 0) sum += 0.5 * squares[squares.size() - 1];  // it is its own mirror image
    const double mean_square = (signal - signal.mean()).square().mean();
    EXPECT_NEAR(sum, mean_square, 1e-12 * mean_square) << samples;
  }
}

TEST(Spectrum, AnEnvelopeIsThatOfTheBandAlone) {
  const Eigen::ArrayXd beat = 1.0 + 0.6 * (2.0 * kPi * 5.0 * times()).cos();
  const Eigen::ArrayXd signal = beat * sine(200.0, 2.0) + sine(60.0, 10.0);
  const Eigen::ArrayXd found = envelope_of(signal, kRate, {150.0, 250.0});
  EXPECT_LT((found - 2.0 * beat).abs().maxCoeff(), 1e-9);
}

TEST(Spectrum, KurtosisKnowsASineNoiseAndBlows) {
  EXPECT_NEAR(kurtosis_of(sine(200.0, 1.0), kRate, {150.0, 250.0}), -1.0, 1e-9);
  EXPECT_NEAR(kurtosis_of(noise(200000, 3), kRate, {100.0, 300.0}), 0.0, 0.1);
  EXPECT_GT(kurtosis_of(blows(8.0, 330.0, 200.0), kRate, {250.0, 400.0}), 3.0);
}

TEST(Spectrum, TheMostImpulsiveBandHoldsTheStruckResonance) {
  const Eigen::ArrayXd signal = 1.0 * blows(8.0, 330.0, 150.0) + 0.02 * noise(kSamples, 11) + sine(60.0, 1.0);
  const KurtosisOfBand found = most_impulsive_band(signal, kRate, 60.0);
  EXPECT_LT(found.band.low, 330.0);
  EXPECT_GT(found.band.high, 330.0);
  EXPECT_GT(found.band.low, 60.0);
  EXPECT_GE(found.band.high - found.band.low, 60.0);
}

// Off the lines of the spectrum too.
TEST(Peaks, AreFoundBetweenLines) {
  for (const double frequency : {40.0, 40.11, 40.25, 40.4}) {
    const Spectrum spectrum = spectrum_of(sine(frequency, 2.0) + sine(97.3, 0.5), kRate, Window::hann);
    const std::vector<Peak> found = peaks_of(spectrum, {.highest = 200.0});
    ASSERT_EQ(found.size(), 2u) << frequency;
    constexpr double of_others = 1e-4;  // side lobes of the other line, a hundred lines away
    EXPECT_NEAR(found[0].frequency, frequency, of_others * spectrum.resolution);
    EXPECT_NEAR(found[0].amplitude, 2.0, of_others * 2.0);
    EXPECT_NEAR(found[1].frequency, 97.3, of_others * spectrum.resolution);
  }
}

TEST(Peaks, AreCutByLevelNumberAndFrequency) {
  const Eigen::ArrayXd signal = sine(40.0, 1.0) + sine(80.0, 0.3) + sine(120.0, 0.005) + sine(160.0, 0.2);
  const Spectrum spectrum = spectrum_of(signal, kRate, Window::hann);
  EXPECT_EQ(peaks_of(spectrum, {.highest = 150.0}).size(), 2u);
  EXPECT_EQ(peaks_of(spectrum, {.highest = 200.0, .least_share = 1e-3}).size(), 4u);
  EXPECT_EQ(peaks_of(spectrum, {.highest = 200.0, .most = 1}).size(), 1u);
  EXPECT_TRUE(
      peaks_of(spectrum_of(Eigen::ArrayXd::Zero(100), kRate, Window::hann), {.highest = 400.0}).empty());
}

TEST(Peaks, HaveTheSimplestName) {
  std::vector<ExpectedLine> lines;
  add_lines(100.0, "defect", 3, 20.0, "shaft", 3, 0, lines);
  add_lines(20.0, "shaft", 10, 0.0, "", 0, 1, lines);
  EXPECT_EQ(name_of(100.1, lines, 0.2), "defect");
  EXPECT_EQ(name_of(80.0, lines, 0.2), "defect - shaft");
  EXPECT_EQ(name_of(240.0, lines, 0.2), "2 x defect + 2 x shaft");
  EXPECT_EQ(name_of(20.0, lines, 0.2), "shaft");
  EXPECT_EQ(name_of(93.0, lines, 0.2), "unknown");
}

}  // namespace
}  // namespace orbearing::diagnosis::spectrum_test
