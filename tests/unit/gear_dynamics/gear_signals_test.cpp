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

}  // namespace
}  // namespace orbearing::analysis::gear_signals_test
