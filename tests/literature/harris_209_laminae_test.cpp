// The bearing 209 of [Harris2006] cut into laminae: loads as without, lives by the formulas of [ISO16281];
// and how the life of a straight roller depends on the number of laminae through the stress riser.
#include <gtest/gtest.h>

#include <vector>

#include "bearing/equilibrium/rollers.hpp"
#include "bearing/life/rating_lives.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::equilibrium::harris_209_laminae_test {
namespace {

constexpr double kPublished = 0.05;  // [N]  half a unit of the last digit given

Bearing bearing_209(double clearance) {
  Bearing bearing = example_bearings::bearing_209();
  bearing.rollers().laminae = 40;
  bearing.radial_clearance = clearance;
  bearing.contact_law = ContactLaw::iso16281;
  return bearing;
}

void expect_loads(const Bearing& bearing, const std::vector<double>& published) {
  const RingState state = balance_ring(RollerRow(bearing), {.radial = 4450.0});
  ASSERT_TRUE(state.report.converged) << state.report.message;
  for (std::size_t j = 0; j < published.size(); ++j)
    EXPECT_NEAR(state.contact_load[static_cast<Eigen::Index>(j)], published[j], kPublished) << "roller " << j;
  EXPECT_NEAR(state.tilt, 0.0, 1e-15);
}

TEST(Harris209Laminae, RollerLoads) {
  for (const int laminae : {1, 40, 41}) {
    SCOPED_TRACE(laminae);
    Bearing tight = bearing_209(0.0), loose = bearing_209(40.6e-6);
    tight.rollers().laminae = loose.rollers().laminae = laminae;
    expect_loads(tight, {1298.8, 1156.7, 768.4, 244.6, 0.0, 0.0, 0.0, 0.0});
    expect_loads(loose, {1956.3, 1383.9, 0.0, 0.0, 0.0});
    loose.contact_law = ContactLaw::palmgren;
    expect_loads(loose, {1964.7, 1379.2, 0.0});
  }
}

double planet_life(int laminae) {
  Bearing planet;
  planet.rollers() = {.count = 15, .diameter = 5.24e-3, .length = 5.7e-3, .laminae = laminae};
  planet.pitch_diameter = 36e-3;
  planet.contact_law = ContactLaw::iso16281;
  const RingState state = balance_ring(RollerRow(planet), {.radial = 3000.0});
  EXPECT_TRUE(state.report.converged);
  planet.motions = rating::rotating(Race::outer);
  const rating::ElementLoads loads{state.contact_load, state.lamina_load};
  return rating::rating_lives(rating::bearing_rating(planet, {.stress_riser = rating::StressRiser::standard}),
                              {}, loads, loads)
      .reference.bearing;
}

// Recomputed by independent programs, in whole per cent.
TEST(StraightRoller, LifeByThePrintedFormulaDependsOnTheNumberOfLaminae) {
  constexpr double half_a_per_cent = 0.5;
  const double at_40 = planet_life(40);
  EXPECT_NEAR(100.0 * (planet_life(30) / at_40 - 1.0), -16.0, half_a_per_cent);
  EXPECT_NEAR(100.0 * (planet_life(50) / at_40 - 1.0), 13.0, half_a_per_cent);
  EXPECT_NEAR(100.0 * (planet_life(100) / at_40 - 1.0), 52.0, half_a_per_cent);
}

}  // namespace
}  // namespace orbearing::bearing::equilibrium::harris_209_laminae_test
