// Moving masses of the waves of a planet's rim, beside the kinetic energy of a ring that does not stretch.
#include <gtest/gtest.h>

#include <cmath>

#include "app/case/case_file.hpp"
#include "app/study/planetary_case.hpp"
#include "coupling/analysis/drivetrain.hpp"

namespace orbearing::analysis::wave_masses_test {
namespace {

// Twice the kinetic energy of a ring of 1 kg whose radial speed is cos(n phi) [m/s]; what is tangential keeps
// the ring's length: its slope along the ring is less the radial speed.
double twice_energy(int n) {
  constexpr int points = 720;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double phi = 2.0 * M_PI * i / points;
    const double radial = std::cos(n * phi), tangential = n == 0 ? 0.0 : std::sin(n * phi) / n;
    sum += radial * radial + tangential * tangential;
  }
  return sum / points;
}

TEST(WaveMasses, AreThoseOfARingThatDoesNotStretch) {
  const app::ResolvedCase resolved =
      app::read_case(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", {"gearset.planet_rim=elastic"});
  const NamedSet set = app::bearing_sets(resolved.without_sweep()).front();
  const Eigen::ArrayXd mass = bearing_duty(set.drivetrain, set.geometry).point.outer_race.mass;
  const double ring = set.geometry.planet_mass / set.drivetrain.bearings_per_planet;
  ASSERT_GT(mass.size(), 4);
  for (int n = 0; n < mass.size(); ++n) EXPECT_NEAR(mass[n], ring * twice_energy(n), 1e-12 * ring) << n;
}

}  // namespace
}  // namespace orbearing::analysis::wave_masses_test
