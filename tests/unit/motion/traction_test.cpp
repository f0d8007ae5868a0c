#include "bearing/motion/traction.hpp"

#include <gtest/gtest.h>

#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::dynamics::traction_test {
namespace {

constexpr double kRoundOff = 1e-13;
constexpr double kCurvature =
    1e-3;  // relative: what a slope over a thousandth of the scale misses of the tangent

FilmContact oiled_contact() {
  const CylindricalRollerBearing bearing = test::reducer_bearing();
  return film_contact(bearing, geometry_of(bearing), Race::inner, {0.01, 1.5e-8});
}

TEST(Traction, CoulombLevelsOffAtFrictionTimesLoad) {
  const TractionCurve curve({.friction = 0.05, .sliding_scale = 0.1}, oiled_contact());
  EXPECT_NEAR(curve.force(1000.0, 0.1, 5.0), 0.05 * 1000.0 / std::sqrt(2.0), kRoundOff * 50.0);
  EXPECT_NEAR(curve.force(1000.0, -1e6, 5.0), -0.05 * 1000.0, kRoundOff * 50.0);
  EXPECT_EQ(curve.force(1000.0, 0.0, 5.0), 0.0);
}

TEST(Traction, LimitingShearBeginsAsANewtonianFilm) {
  const FilmContact contact = oiled_contact();
  RaceContactParameters parameters;
  parameters.traction = TractionLaw::limiting_shear;
  parameters.least_sliding_scale = 0.0;
  const TractionCurve curve(parameters, contact);
  const double load = 20.0;  // N: light enough for Barus to hold
  const double half_width =
      std::sqrt(8.0 * load * contact.equivalent_radius / (M_PI * contact.reduced_modulus * contact.length));
  const double area = 2.0 * half_width * contact.length;
  const double viscosity = 0.01 * std::exp(1.5e-8 * load / area);
  const double film = Film(contact, 1.0).central(load);
  const double slope = viscosity * area / film;
  const double sliding = kCurvature * parameters.limiting_friction * load / slope;
  EXPECT_NEAR(curve.force(load, sliding, 1.0), slope * sliding, kCurvature * slope * sliding);
  EXPECT_NEAR(curve.force(load, -1e3, 1.0), -parameters.limiting_friction * load, kRoundOff * load);
}

TEST(Traction, LimitingShearHasNoForceWithoutLoad) {
  RaceContactParameters parameters;
  parameters.traction = TractionLaw::limiting_shear;
  EXPECT_EQ(TractionCurve(parameters, oiled_contact()).force(0.0, 1.0, 1.0), 0.0);
}

// U = eta u / (E' R), G = alpha E', W = Q / (E' R l) at round numbers, by hand.
TEST(RollingResistance, FollowsThePublishedRegression) {
  const FilmContact contact{.equivalent_radius = 0.01,
                            .length = 0.01,
                            .reduced_modulus = 2e11,
                            .lubricant = {.viscosity = 0.02, .pressure_viscosity = 2e-8}};
  const double speed_number = 0.02 * 10.0 / (2e11 * 0.01);
  const double material_number = 2e-8 * 2e11;
  const double load = 1e4;
  const double load_number = load / (2e11 * 0.01 * 0.01);
  const double published = 4.318 * std::pow(material_number * speed_number, 0.658) *
                           std::pow(load_number, 0.0126) * 0.01 * 0.01 / 2e-8;
  const double fades_out = load / (load + 1.0);
  EXPECT_NEAR(RollingResistance(contact).force(load, 10.0, 10.0), published * fades_out,
              kRoundOff * published);
}

TEST(RollingResistance, VanishesWithLoadAndSpeedAndWithoutOil) {
  const RollingResistance resistance(oiled_contact());
  EXPECT_EQ(resistance.force(0.0, 5.0, 5.0), 0.0);
  EXPECT_EQ(resistance.force(100.0, 0.0, 0.01), 0.0);
  EXPECT_LT(resistance.force(1e-6, 5.0, 5.0), 1e-5 * resistance.force(100.0, 5.0, 5.0));
  EXPECT_EQ(resistance.force(100.0, -5.0, 5.0), -resistance.force(100.0, 5.0, 5.0));
  FilmContact dry = oiled_contact();
  dry.lubricant = {};
  EXPECT_EQ(RollingResistance(dry).force(100.0, 5.0, 5.0), 0.0);
}

}  // namespace
}  // namespace orbearing::bearing::dynamics::traction_test
