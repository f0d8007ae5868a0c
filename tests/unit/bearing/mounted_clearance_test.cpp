// Operating clearance against textbook rings: fits, temperatures and speeds by hand.
#include "bearing/mounted_clearance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bearing/geometry.hpp"
#include "tests/messages.hpp"

namespace orbearing::bearing::mounted_clearance_test {
namespace {

constexpr double kPublished = 1e-4;  // relative: numbers worked out on paper to five digits
constexpr double kRoundOff = 1e-12;  // [m] times thousandths: differences of lengths near 50 mm
constexpr double kMm = 1e-3, kUm = 1e-6;

const Material kSteel{.youngs_modulus = 206e9, .poisson_ratio = 0.3, .density = 7850.0};

Bearing planet_bearing() {
  return {.inner = {.seat_diameter = 25.0 * kMm},
          .outer = {.seat_diameter = 47.0 * kMm},
          .elements = CylindricalRollers{.count = 15, .diameter = 5.24 * kMm, .length = 5.7 * kMm},
          .pitch_diameter = 35.64 * kMm,
          .width = 11.9 * kMm,
          .material = kSteel};
}

Mounting on_the_shelf(double clearance) {
  return {.state = ClearanceState::unmounted, .unmounted_clearance = clearance};
}

const Surroundings kRim{.planet_outer_radius = 30.0 * kMm};

// A ring pressed on a solid shaft of its own steel: its race grows by I d/F. 10 um * 25/30.4 = 8.2237 um.
TEST(MountedClearance, OfARingPressedOnASolidPin) {
  Mounting mounting = on_the_shelf(0.0);
  mounting.inner_interference = 10.0 * kUm;
  const ClearanceChain chain = clearance_chain(planet_bearing(), mounting, kRim);
  EXPECT_NEAR(chain.fitted, -8.2237 * kUm, kPublished * 8.0 * kUm);
  EXPECT_EQ(chain.operating, chain.fitted);
  // p = E I/(2 d) (1 - d^2/F^2) = 206e9 * 10e-6/0.05 * (1 - 0.676290) = 13.337 MPa
  EXPECT_NEAR(chain.inner_pressure, 13.337e6, kPublished * 13.337e6);
}

// Into a rim of Dh = 60 mm: I (E/D) [(Dh/D)^2 - 1]/[(Dh/D)^2 - (E/D)^2] = 12 um * 0.869787 *
// 0.629697/0.873154 = 7.5272 um.
TEST(MountedClearance, OfARingPressedIntoAPlanet) {
  Mounting mounting = on_the_shelf(0.0);
  mounting.outer_interference = 12.0 * kUm;
  EXPECT_NEAR(clearance_chain(planet_bearing(), mounting, kRim).fitted, -7.5272 * kUm,
              kPublished * 8.0 * kUm);
}

// A hole takes from the grip: pin 25 with a hole of 15, ring to 30.4. On paper, with C = (b^2 + a^2)/(b^2 -
// a^2): p = E I / {d [(C_ring + v) + (C_pin - v)]} with C_ring = 5.17823, C_pin = 2.125; race: 2 p d^2 F/[E
// (F^2 - d^2)].
TEST(MountedClearance, OfARingPressedOnAHollowPin) {
  Mounting mounting = on_the_shelf(0.0);
  mounting.inner_interference = 10.0 * kUm;
  mounting.pin_bore = 15.0 * kMm;
  const double pressure = 206e9 * 10e-6 / (0.025 * (5.17823 + 2.125));
  const double growth = 2.0 * pressure * 625e-6 * 30.4e-3 / (206e9 * (924.16e-6 - 625e-6));
  const ClearanceChain chain = clearance_chain(planet_bearing(), mounting, kRim);
  EXPECT_NEAR(chain.inner_pressure, pressure, kPublished * pressure);
  EXPECT_NEAR(chain.fitted, -growth, kPublished * growth);
}

// Loose rings, each of one temperature: e (D_o T_o - D_i T_i - 2 D_r T_r), the law of balls in their rings.
// 11.5e-6 * (40.88 * 30 - 30.4 * 50 - 10.48 * 40) mm = 11.5e-6 * (-712.8 mm) = -8.1972 um.
TEST(MountedClearance, OfWarmRingsThatSitLoosely) {
  Mounting mounting = on_the_shelf(0.0);
  mounting.pin_temperature = mounting.inner_ring_temperature = 70.0;
  mounting.roller_temperature = 60.0;
  mounting.outer_ring_temperature = mounting.planet_temperature = 50.0;
  const ClearanceChain chain = clearance_chain(planet_bearing(), mounting, kRim);
  EXPECT_EQ(chain.fitted, 0.0);
  EXPECT_NEAR(chain.warm, -8.1972 * kUm, kPublished * 8.0 * kUm);
}

// Equal heat everywhere makes all lengths longer by one factor, the clearance and the interferences too.
TEST(MountedClearance, GrowsWithAllLengthsWhereAllIsAlikeWarm) {
  Mounting mounting = on_the_shelf(40.0 * kUm);
  mounting.inner_interference = mounting.outer_interference = 8.0 * kUm;
  const double cold = clearance_chain(planet_bearing(), mounting, kRim).fitted;
  for (std::optional<double>* temperature :
       {&mounting.pin_temperature, &mounting.inner_ring_temperature, &mounting.roller_temperature,
        &mounting.outer_ring_temperature, &mounting.planet_temperature})
    *temperature = 120.0;
  // To first order in interference over length, as all elasticity of small strains is.
  EXPECT_NEAR(clearance_chain(planet_bearing(), mounting, kRim).warm - cold, 11.5e-6 * 100.0 * 40.0 * kUm,
              1e-4 * kUm);
}

// A pin warmer than its ring grips harder: by heat of 30 K, as much as by I = 11.5e-6 * 30 * 25 mm = 8.625
// um.
TEST(MountedClearance, OfAWarmPinIsThatOfATighterFit) {
  Mounting warm = on_the_shelf(0.0), tight = on_the_shelf(0.0);
  warm.inner_interference = 5.0 * kUm;
  warm.pin_temperature = 50.0;
  tight.inner_interference = 13.625 * kUm;
  EXPECT_NEAR(clearance_chain(planet_bearing(), warm, kRim).warm,
              clearance_chain(planet_bearing(), tight, kRim).fitted, kRoundOff * kMm);
}

// A loose outer ring, E = 40.88, D = 47, at 2000 rad/s: bore grows by d w^2 a/(4E) [(3+v) b^2 + (1-v) a^2]
// = 1.64729 um in radius.
TEST(MountedClearance, OfASpinningOuterRing) {
  Surroundings around = kRim;
  around.planet_speed = 2000.0;
  Mounting mounting = on_the_shelf(0.0);
  mounting.outer_interference = -50.0 * kUm;
  const ClearanceChain chain = clearance_chain(planet_bearing(), mounting, around);
  EXPECT_EQ(chain.warm, 0.0);
  EXPECT_NEAR(chain.operating, 2.0 * 1.64729 * kUm, kPublished * 3.0 * kUm);
  EXPECT_EQ(chain.outer_pressure, 0.0);
}

// The rim of a solid disc: (1-v) d w^2 b^3/(4E).
TEST(MountedClearance, OfASpinningDiscByTheTextbook) {
  const Annulus disc{.outer_radius = 0.1, .material = kSteel, .speed = 1000.0};
  const double expected = 0.7 * 7850.0 * 1e6 * 1e-3 / (4.0 * 206e9);
  EXPECT_NEAR(displacement(disc, 0.1), expected, kRoundOff * expected);
}

// Pressed together at speed, both act as one ring: no interference, equal strains at the seat.
TEST(MountedClearance, OfASpinningRingInItsPlanetIsThatOfOneBody) {
  Surroundings around = kRim;
  around.planet_speed = 2000.0;
  Mounting mounting = on_the_shelf(0.0);
  mounting.outer_interference = 30.0 * kUm;
  const ClearanceChain chain = clearance_chain(planet_bearing(), mounting, around);
  const Annulus both{
      .inner_radius = 20.44 * kMm, .outer_radius = 30.0 * kMm, .material = kSteel, .speed = 2000.0};
  EXPECT_GT(chain.outer_pressure, 0.0);
  EXPECT_NEAR(chain.operating - chain.fitted, 2.0 * displacement(both, 20.44 * kMm), kRoundOff * kMm);
}

TEST(MountedClearance, TeethThatHangOnTheRimOpenIt) {
  Surroundings around = kRim;
  around.planet_speed = 2000.0;
  Mounting mounting = on_the_shelf(0.0);
  mounting.outer_interference = 30.0 * kUm;
  const double without = clearance_chain(planet_bearing(), mounting, around).operating;
  around.hanging_mass = 4.0;
  around.hanging_radius = 33.0 * kMm;
  // Traction m w^2 r/(2 pi b) on the outer circle of a ring opens its bore by 2 s b^2 a/[E (b^2 - a^2)].
  const double traction = 4.0 * 4e6 * 0.033 / (2.0 * 3.14159265358979 * 0.03);
  const double opened = 2.0 * traction * 900e-6 * 20.44e-3 / (206e9 * (900e-6 - 417.7936e-6));
  EXPECT_NEAR(clearance_chain(planet_bearing(), mounting, around).operating - without, 2.0 * opened,
              kPublished * opened);
}

TEST(MountedClearance, ThatIsStatedAsOperatingStays) {
  Bearing bearing = planet_bearing();
  bearing.radial_clearance = 17.0 * kUm;
  Mounting mounting{.inner_interference = 10.0 * kUm, .roller_temperature = 90.0};
  EXPECT_EQ(clearance_chain(bearing, mounting, kRim).operating, 17.0 * kUm);
}

TEST(MountedClearance, NeedsRoomForHoleAndRim) {
  Mounting mounting = on_the_shelf(0.0);
  mounting.pin_bore = 25.0 * kMm;
  EXPECT_REFUSED(std::invalid_argument, "mounted_clearance 1",
                 clearance_chain(planet_bearing(), mounting, kRim));
  EXPECT_REFUSED(std::invalid_argument, "mounted_clearance 2",
                 clearance_chain(planet_bearing(), on_the_shelf(0.0), {.planet_outer_radius = 23.0 * kMm}));
}

// Without rings pin and planet carry the races themselves: warm by 60 and 40 K they move by e T of their
// diameters, rollers by 70 K; no seat presses. 11.5e-6 (40 35.01 - 60 24.99 - 2 70 5) mm = -9.1885 um.
TEST(MountedClearance, WithoutRingsPinAndPlanetAreTheRaces) {
  Bearing needles{.inner = {.seat_diameter = 24.99 * kMm},
                  .outer = {.seat_diameter = 35.01 * kMm},
                  .elements = CylindricalRollers{.count = 14, .diameter = 5.0 * kMm, .length = 20.0 * kMm},
                  .pitch_diameter = 30.0 * kMm,
                  .width = 22.0 * kMm,
                  .material = kSteel};
  Mounting mounting = on_the_shelf(20.0 * kUm);
  mounting.rings = Rings::none;
  mounting.pin_temperature = 80.0;
  mounting.planet_temperature = 60.0;
  mounting.roller_temperature = 90.0;
  mounting.inner_interference = mounting.outer_interference = 10.0 * kUm;  // of rings that are not there
  const ClearanceChain chain = clearance_chain(needles, mounting, kRim);
  EXPECT_DOUBLE_EQ(chain.fitted, 20.0 * kUm);
  EXPECT_NEAR(chain.warm - chain.fitted, -9.1885 * kUm, kPublished * 9.0 * kUm);
  EXPECT_EQ(chain.inner_pressure, 0.0);
  EXPECT_EQ(chain.outer_pressure, 0.0);
  // Refused are a planet that ends within its own race, at 35.01 mm, and a pin whose bore is larger than the
  // pin.
  EXPECT_NO_THROW(clearance_chain(needles, mounting, {.planet_outer_radius = 17.6 * kMm}));
  EXPECT_REFUSED(std::invalid_argument, "mounted_clearance 3",
                 clearance_chain(needles, mounting, {.planet_outer_radius = 17.4 * kMm}));
  mounting.pin_bore = 24.9 * kMm;
  EXPECT_NO_THROW(clearance_chain(needles, mounting, kRim));
  mounting.pin_bore = 25.1 * kMm;
  EXPECT_REFUSED(std::invalid_argument, "mounted_clearance 4", clearance_chain(needles, mounting, kRim));
}

// With the outer ring alone, its seat acts as ever.
TEST(MountedClearance, OfAnOuterRingAloneIsThatOfItsSeat) {
  Mounting both = on_the_shelf(0.0);
  both.outer_interference = 12.0 * kUm;
  Mounting outer = both;
  outer.rings = Rings::outer;
  EXPECT_DOUBLE_EQ(clearance_chain(planet_bearing(), outer, kRim).fitted,
                   clearance_chain(planet_bearing(), both, kRim).fitted);
}

}  // namespace
}  // namespace orbearing::bearing::mounted_clearance_test
