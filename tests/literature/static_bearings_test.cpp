// A roller bearing and a ball bearing by one and the same functions, from the bearing to its reference life:
// the 209 of [Harris2006] and the 6305 of [ISO16281], with the numbers of harris_209_laminae_test.cpp and
// ball_6305_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bearing/equilibrium/row_group.hpp"
#include "bearing/life/rating_lives.hpp"
#include "tests/unit/bearing/example_bearings.hpp"

namespace orbearing::bearing::static_bearings_test {
namespace {

using equilibrium::balance_bearing;
using equilibrium::RingLoad;
using equilibrium::RingState;

constexpr double kPublishedLoad = 0.05;  // [N]  half a unit of the last digit given
constexpr double kDisplacement = 4e-4;   // [um]  half a unit of the last of five or six digits
constexpr double kLife = 1e-3;           // two programs' constants carry four digits

struct Row {
  std::string name;
  Bearing bearing;
  RingLoad load;
  std::vector<double> contact_loads;  // [N]    of the first elements
  double radial = 0.0;                // [um]   0: not known
  double life = 0.0;                  // [Mrev]
  double dynamic_capacity = 0.0;      // [N]    0: that of the standard
};

Bearing bearing_209(double clearance) {
  Bearing bearing = example_bearings::bearing_209();
  bearing.rollers().laminae = 40;
  bearing.radial_clearance = clearance;
  bearing.contact_law = ContactLaw::iso16281;
  bearing.motions = rating::rotating(Race::inner);
  return bearing;
}

Bearing bearing_6305(double clearance) {
  return {.elements = Balls{.count = 7, .diameter = 11.5e-3},
          .pitch_diameter = 43.5e-3,
          .radial_clearance = clearance,
          .material = {.youngs_modulus = 210e9, .poisson_ratio = 0.3},
          .motions = rating::rotating(Race::inner)};
}

std::vector<Row> rows() {
  return {{"209", bearing_209(0.0), {.radial = 4450.0}, {1298.8, 1156.7, 768.4, 244.6, 0.0}},
          {"209, 40.6 um", bearing_209(40.6e-6), {.radial = 4450.0}, {1956.3, 1383.9, 0.0}},
          {"6305", bearing_6305(0.0), {.radial = 1000.0}, {}, 15.1101, 13163.019, 23400.0},
          {"6305, axial", bearing_6305(0.0), {.axial = 1000.0}, {}, 0.0, 2222.7318, 23400.0},
          {"6305, 10 um", bearing_6305(10e-6), {.radial = 1000.0}, {}, 21.223, 10795.7948, 23400.0}};
}

TEST(StaticBearings, RollersAndBallsGoOneWay) {
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.name);
    const RingState state = balance_bearing(row.bearing, row.load);
    ASSERT_TRUE(state.report.converged) << state.report.message;
    ASSERT_EQ(state.contact_load.size(), row.bearing.element_count());
    EXPECT_EQ(state.lamina_load.size() > 0, row.bearing.has_rollers());
    for (std::size_t j = 0; j < row.contact_loads.size(); ++j)
      EXPECT_NEAR(state.contact_load[static_cast<Eigen::Index>(j)], row.contact_loads[j], kPublishedLoad)
          << j;
    if (row.radial > 0.0) {
      EXPECT_NEAR(1e6 * state.radial, row.radial, kDisplacement);
    }

    rating::StatedRatings stated;
    if (row.dynamic_capacity > 0.0) stated.dynamic_capacity = row.dynamic_capacity;
    const rating::ElementLoads loads{state.contact_load, state.lamina_load};
    const BearingLife life =
        rating::rating_lives(rating::bearing_rating(row.bearing, stated), {}, loads, loads).reference;
    EXPECT_GT(life.bearing, 0.0);
    if (row.life > 0.0) {
      EXPECT_NEAR(1e-6 * life.bearing / row.life, 1.0, kLife);
    }
  }
}

// Pressure of the most heavily loaded lamina by Hertz's line contact; that of a ball grows with the third
// root of its load.
TEST(StaticBearings, PressureIsThatOfTheMostHeavilyLoadedContact) {
  const Bearing rollers = bearing_209(0.0), balls = bearing_6305(0.0);
  const RingLoad load{.radial = 2000.0};
  const RingState on_rollers = balance_bearing(rollers, load), on_balls = balance_bearing(balls, load);
  const double radius = 0.5 * 10e-3 * (1.0 - 10.0 / 65.0);
  const double line = on_rollers.lamina_load.maxCoeff() / (9.6e-3 / 40.0);
  const double modulus = rollers.material.plane_strain_modulus();
  const double hertz = std::sqrt(line * modulus / (2.0 * 3.141592653589793 * radius));
  EXPECT_NEAR(on_rollers.largest_pressure / hertz, 1.0, 1e-12);
  const RingState twice = balance_bearing(balls, {.radial = 16000.0});
  const double share = twice.contact_load.maxCoeff() / on_balls.contact_load.maxCoeff();
  EXPECT_NEAR(twice.largest_pressure / on_balls.largest_pressure, std::cbrt(share), 1e-12);
}

}  // namespace
}  // namespace orbearing::bearing::static_bearings_test
