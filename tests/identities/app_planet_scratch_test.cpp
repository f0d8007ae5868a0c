// Issue 14, Build 7: a planet bearing with scratches in the coupled gear set. Which lines follow is derived in
// docs/defects/planet.md.
#include <gtest/gtest.h>

#include <cmath>

#include "app/signals/spectrum.hpp"
#include "coupling/study/planet_scratch.hpp"
#include "tests/coupled_reducer.hpp"

namespace orbearing::study::app_planet_scratch_test {
namespace {

using bearing::defect::Scratch;
using bearing::defect::Scratched;

constexpr double kBriefly = 6.0;  // [-]  turns of the carrier that are sampled

PlanetSampling sampling() {
  return {.rate = 25600.0, .revolutions = kBriefly, .settling_revolutions = 0.5};
}

PlanetVibration vibration(const PlanetaryDrivetrain& drivetrain, const std::vector<Scratch>& scratches) {
  std::vector<system::ScratchedPlanet> planets;
  if (!scratches.empty()) planets.push_back({.planet = 1, .bearing = 0, .scratches = scratches});
  PlanetVibration out = sample_vibration(drivetrain, planets, sampling());
  EXPECT_TRUE(out.report.completed) << out.report.message;
  return out;
}

// Gears whose meshes keep their stiffness, so that bearings alone move them.
PlanetaryDrivetrain smooth_reducer() {
  PlanetaryDrivetrain drivetrain = example::coupled_reducer(true);
  drivetrain.mesh_variation = false;
  return drivetrain;
}

app::signals::Spectrum envelope(const Eigen::ArrayXd& signal, double rate) {
  using namespace app::signals;
  return spectrum_of(envelope_of(signal, rate, {2000.0, 10000.0}), rate, Window::hann);
}

double level(const app::signals::Spectrum& spectrum, double frequency) {
  const auto line = static_cast<Eigen::Index>(std::lround(frequency / spectrum.resolution));
  return spectrum.amplitude.segment(std::max<Eigen::Index>(1, line - 2), 5).maxCoeff();
}

Scratch scratch(Scratched race, double angle) {
  return {.race = race, .width = 0.3e-3, .depth = 20e-6, .angle = angle};
}

constexpr double kLoadZone = -1.5707963;  // [rad]  the meshes drive the planet against carrier rotation

TEST(PlanetScratch, OuterRaceGivesItsLineAndSideBandsOfThePlanet) {
  const PlanetaryDrivetrain drivetrain = smooth_reducer();
  const PlanetFrequencies at = planet_frequencies(drivetrain);
  const PlanetVibration out = vibration(drivetrain, {scratch(Scratched::outer, 0.0)});
  const auto spectrum = envelope(out.acceleration.row(1).transpose(), out.rate);
  const double pass = 15.0 * std::abs(out.planet_speed - out.cage_speed) / 6.283185307;
  EXPECT_NEAR(pass, at.bearing.outer_pass, 0.02 * at.bearing.outer_pass);
  const double beside = level(spectrum, pass + 0.37 * at.planet);
  EXPECT_GT(level(spectrum, pass), 5.0 * beside);
  EXPECT_GT(level(spectrum, pass - at.planet), 3.0 * beside);
  EXPECT_GT(level(spectrum, pass + at.planet), 3.0 * beside);
}

}  // namespace
}  // namespace orbearing::study::app_planet_scratch_test
