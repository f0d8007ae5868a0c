#include "coupling/analysis/gear_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace orbearing::analysis::gear_signals_test {
namespace {

constexpr double kRoundOff = 1e-12;
constexpr int kHarmonics = 4;
constexpr int kSamples = 64;

double planted(double angle) {
  return 5.0 + 3.0 * std::cos(angle) - 0.7 * std::sin(angle) + 2.0 * std::sin(3.0 * angle);
}

// Samples of a signal with known harmonics give these harmonics back, signs and all, over any number of
// periods.
TEST(SignalSums, GivePlantedHarmonicsBack) {
  for (const int periods : {1, 3}) {
    SignalSums sums(kHarmonics);
    for (int i = 0; i < periods * kSamples; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kSamples;
      Eigen::ArrayXcd waves(kHarmonics);
      for (int order = 1; order <= kHarmonics; ++order) waves[order - 1] = std::polar(1.0, -order * angle);
      sums.add(planted(angle), waves);
    }
    const SignalStatistics found = sums.statistics();
    const double cosines[] = {3.0, 0.0, 0.0, 0.0}, sines[] = {-0.7, 0.0, 2.0, 0.0};
    EXPECT_NEAR(found.mean, 5.0, kRoundOff);
    EXPECT_NEAR(found.rms, std::sqrt(25.0 + 0.5 * (9.0 + 0.49 + 4.0)), kRoundOff * 10.0);
    for (std::size_t i = 0; i < kHarmonics; ++i) {
      EXPECT_NEAR(found.cosines[i], cosines[i], kRoundOff) << "order " << i + 1;
      EXPECT_NEAR(found.sines[i], sines[i], kRoundOff) << "order " << i + 1;
      EXPECT_NEAR(found.amplitudes[i], std::hypot(cosines[i], sines[i]), kRoundOff) << "order " << i + 1;
    }
  }
}

// The angle is that of the mesh period since time zero: a signal that is largest at its beginning is a
// cosine.
TEST(GearSignals, CountTheAngleFromTheBeginningOfTheMeshPeriod) {
  GearSignals signals(1, kHarmonics);
  gearset::dynamics::SetSnapshot now;
  now.sun_mesh_force = now.ring_mesh_force = Eigen::ArrayXd::Zero(1);
  now.bearing_force = now.acceleration = Eigen::Array2Xd::Zero(2, 1);
  now.in_housing = Eigen::Array2Xd::Constant(2, 1, 5.0);
  for (int i = 0; i < kSamples; ++i) {
    const double periods = 7.0 + static_cast<double>(i) / kSamples;
    now.sun_mesh_force[0] = planted(2.0 * std::numbers::pi * periods);
    now.ring_mesh_force[0] = -2.0 * now.sun_mesh_force[0];
    signals.add(periods, now);
  }
  const PlanetStatistics planet = signals.statistics().front();
  EXPECT_NEAR(planet.housing_acceleration, 5.0, 10.0 * kRoundOff);  // sqrt((5^2 + 5^2)/2)
  EXPECT_NEAR(planet.sun_mesh_force.cosines[0], 3.0, 10.0 * kRoundOff);
  EXPECT_NEAR(planet.sun_mesh_force.sines[0], -0.7, 10.0 * kRoundOff);
  EXPECT_NEAR(planet.ring_mesh_force.sines[2], -4.0, 10.0 * kRoundOff);
}

// Each signal of each planet has a value of its own: means, shares and rms values by hand.
TEST(GearSignals, KeepPlanetsAndSignalsApart) {
  GearSignals signals(2, kHarmonics);
  gearset::dynamics::SetSnapshot now;
  now.sun_mesh_force = Eigen::Array2d(3.0, 4.0);
  now.ring_mesh_force = Eigen::Array2d(12.0, 84.0);
  now.bearing_force = (Eigen::Array22d() << -7.0, 9.0, 20.0, 30.0).finished();
  now.acceleration = (Eigen::Array22d() << 1.0, 3.0, 5.0, 7.0).finished();
  now.in_housing = (Eigen::Array22d() << 6.0, 5.0, 8.0, 12.0).finished();
  signals.add(0.0, now);
  now.bearing_force(1, 0) = 40.0;  // means 30 and 30
  signals.add(0.5, now);
  EXPECT_NEAR(signals.rms_mesh_force(), std::sqrt((9.0 + 16.0 + 144.0 + 7056.0) / 4.0), kRoundOff * 50.0);
  EXPECT_NEAR(signals.rms_acceleration(), std::sqrt((1.0 + 9.0 + 25.0 + 49.0) / 2.0), kRoundOff * 10.0);
  const std::vector<PlanetStatistics> planets = signals.statistics();
  const PlanetStatistics &first = planets[0], &second = planets[1];
  EXPECT_EQ(first.sun_mesh_force.mean, 3.0);
  EXPECT_EQ(second.sun_mesh_force.mean, 4.0);
  EXPECT_EQ(first.ring_mesh_force.mean, 12.0);
  EXPECT_EQ(second.ring_mesh_force.mean, 84.0);
  EXPECT_EQ(first.radial_force.mean, -7.0);
  EXPECT_EQ(first.radial_force.maximum, 7.0);
  EXPECT_EQ(second.radial_force.mean, 9.0);
  EXPECT_EQ(first.tangential_force.mean, 30.0);
  EXPECT_EQ(first.tangential_force.largest, 40.0);
  EXPECT_EQ(first.tangential_force.least, 20.0);
  EXPECT_EQ(first.radial_acceleration.mean, 1.0);
  EXPECT_EQ(first.tangential_acceleration.mean, 5.0);
  EXPECT_EQ(second.tangential_acceleration.mean, 7.0);
  EXPECT_NEAR(first.housing_acceleration, std::sqrt(50.0), kRoundOff * 10.0);
  EXPECT_NEAR(second.housing_acceleration, std::sqrt(84.5), kRoundOff * 10.0);
  EXPECT_NEAR(first.load_share, 1.0, kRoundOff);
  EXPECT_NEAR(first.most_load_share, 40.0 / 30.0, kRoundOff);
  EXPECT_NEAR(second.most_load_share, 1.0, kRoundOff);
}

}  // namespace
}  // namespace orbearing::analysis::gear_signals_test
