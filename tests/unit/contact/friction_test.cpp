#include "bearing/contact/friction.hpp"

#include <gtest/gtest.h>

#include "bearing/motion/model.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::friction_test {
namespace {

using motion::Lubrication;
using motion::RaceContactParameters;
using motion::RollingLaw;

constexpr double kRoundOff = 1e-13;
constexpr double kCurvature =
    1e-3;  // relative: what a slope over a thousandth of the scale misses of the tangent
constexpr double kDifferenceError = 1e-8;  // central differences with a step of 1e-5 of the scale

FilmContact oiled_contact() {
  const Bearing bearing = test::reducer_bearing();
  return film_contact(bearing, geometry_of(bearing), Race::inner, {0.01, 1.5e-8});
}

double friction(const FrictionLaws<double>& laws, double load, double sliding, double speed) {
  return laws.friction(load, sliding, std::log(speed));
}

double resistance(const FilmContact& contact, double load, double rolling, double speed,
                  RollingLaw law = RollingLaw::reynolds) {
  RaceContactParameters parameters;
  parameters.rolling_resistance = true;
  parameters.rolling_law = law;
  const auto laws = FrictionLaws<double>::of(parameters, contact);
  return laws.rolling_resistance ? laws.inlet(load, rolling, std::log(speed)) : 0.0;
}

TEST(Friction, CoulombLevelsOffAtFrictionTimesLoad) {
  const auto laws = FrictionLaws<double>::of(RaceContactParameters{.friction = 0.05, .sliding_scale = 0.1},
                                             oiled_contact());
  EXPECT_NEAR(friction(laws, 1000.0, 0.1, 5.0), 0.05 * 1000.0 / std::sqrt(2.0), kRoundOff * 50.0);
  EXPECT_NEAR(friction(laws, 1000.0, -1e6, 5.0), -0.05 * 1000.0, kRoundOff * 50.0);
  EXPECT_EQ(friction(laws, 1000.0, 0.0, 5.0), 0.0);
}

TEST(Friction, LimitingShearBeginsAsANewtonianFilm) {
  const FilmContact contact = oiled_contact();
  RaceContactParameters parameters;
  parameters.traction = TractionLaw::limiting_shear;
  parameters.least_sliding_scale = 0.0;
  const auto laws = FrictionLaws<double>::of(parameters, contact);
  const double load = 20.0;  // N: light enough for Barus to hold
  const double half_width =
      std::sqrt(8.0 * load * contact.equivalent_radius / (M_PI * contact.reduced_modulus * contact.length));
  const double area = 2.0 * half_width * contact.length;
  const double viscosity = 0.01 * std::exp(1.5e-8 * load / area);
  const double film = Film(contact, 1.0).central(load);
  const double slope = viscosity * area / film;
  const double sliding = kCurvature * parameters.limiting_friction * load / slope;
  EXPECT_NEAR(friction(laws, load, sliding, 1.0), slope * sliding, kCurvature * slope * sliding);
  EXPECT_NEAR(friction(laws, load, -1e3, 1.0), -parameters.limiting_friction * load, kRoundOff * load);
}

// Halfway, by hand: sliding at s_c itself gives 1 - 1/e of the limit, with Barus held at its largest
// exponent.
TEST(Friction, LimitingShearAtItsScale) {
  const FilmContact contact = oiled_contact();
  RaceContactParameters parameters;
  parameters.traction = TractionLaw::limiting_shear;
  parameters.largest_barus_exponent = 2.0;
  const auto laws = FrictionLaws<double>::of(parameters, contact);
  const double load = 2000.0, speed = 3.0;
  const double pressure =
      std::sqrt(M_PI * load * contact.reduced_modulus / (8.0 * contact.equivalent_radius * contact.length)) /
      2.0;
  ASSERT_GT(1.5e-8 * pressure, 2.0);
  const double film = Film(contact, 1.0).central(load) * std::pow(speed, 0.7);
  const double scale = 0.06 * pressure * film / (0.01 * std::exp(2.0)) + parameters.least_sliding_scale;
  EXPECT_NEAR(friction(laws, load, -scale, speed), -0.06 * load * (1.0 - std::exp(-1.0)), kRoundOff * load);
}

TEST(Friction, LimitingShearHasNoForceWithoutLoad) {
  RaceContactParameters parameters;
  parameters.traction = TractionLaw::limiting_shear;
  EXPECT_EQ(friction(FrictionLaws<double>::of(parameters, oiled_contact()), 0.0, 1.0, 1.0), 0.0);
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
  EXPECT_NEAR(resistance(contact, load, 10.0, 10.0, RollingLaw::goksem_hargreaves), published * fades_out,
              kRoundOff * published);
}

// In the groups of Moes, by hand at round numbers.
TEST(RollingResistance, ComputedFollowsItsInterpolation) {
  const FilmContact contact{.equivalent_radius = 0.01,
                            .length = 0.01,
                            .reduced_modulus = 2e11,
                            .lubricant = {.viscosity = 0.02, .pressure_viscosity = 2e-8}};
  const double load = 1e4, twice_speed = 2.0 * 0.02 * 10.0 / (2e11 * 0.01);
  const double M = load / (2e11 * 0.01 * 0.01) / std::sqrt(twice_speed);
  const double L = 2e-8 * 2e11 * std::pow(twice_speed, 0.25);
  const double rigid = 1.4705 * std::sqrt(M), elastic = 2.2818 * std::pow(M, -0.04543) * std::pow(L, -0.0923);
  const double scale = 2e11 * 0.01 * 0.01 * std::pow(twice_speed, 0.75);
  const double both = scale * std::pow(std::pow(rigid, -3) + std::pow(elastic, -3), -1.0 / 3.0);
  EXPECT_NEAR(resistance(contact, load, 10.0, 10.0), both * std::sqrt(load / (load + 1.0)), 1e-12 * both);

  FilmContact thin = contact;  // keeps its viscosity under pressure
  thin.lubricant.pressure_viscosity = 0.0;
  EXPECT_NEAR(resistance(thin, load, 10.0, 10.0), scale * rigid * std::sqrt(load / (load + 1.0)),
              1e-12 * scale * rigid);
}

TEST(RollingResistance, VanishesWithLoadAndSpeedAndWithoutOil) {
  for (const RollingLaw law : {RollingLaw::reynolds, RollingLaw::goksem_hargreaves}) {
    const FilmContact oiled = oiled_contact();
    EXPECT_EQ(resistance(oiled, 0.0, 5.0, 5.0, law), 0.0);
    EXPECT_EQ(resistance(oiled, 100.0, 0.0, 0.01, law), 0.0);
    EXPECT_LT(resistance(oiled, 1e-6, 5.0, 5.0, law), 1e-5 * resistance(oiled, 100.0, 5.0, 5.0, law));
    EXPECT_EQ(resistance(oiled, 100.0, -5.0, 5.0, law), -resistance(oiled, 100.0, 5.0, 5.0, law));
    FilmContact dry = oiled_contact();
    dry.lubricant = {};
    EXPECT_EQ(resistance(dry, 100.0, 5.0, 5.0, law), 0.0);
  }
}

TEST(MixedFriction, ShareGoesFromAllToNothing) {
  EXPECT_EQ(asperity_share(0.0), 1.0);
  EXPECT_DOUBLE_EQ(asperity_share(1.0), 0.25);
  EXPECT_LT(asperity_share(1e6), 1e-11);
  for (double ratio = 0.01; ratio < 100.0; ratio *= 1.3)
    EXPECT_GT(asperity_share(ratio), asperity_share(1.3 * ratio));
}

RaceContactParameters mixed(double roughness) {
  RaceContactParameters parameters;
  parameters.lubrication = Lubrication::mixed;
  parameters.traction = TractionLaw::limiting_shear;
  parameters.roughness = roughness;
  return parameters;
}

// A surface far rougher than the film slides like asperities alone, one far smoother like the film alone.
TEST(MixedFriction, LimitsAreBoundaryFrictionAndTheFilmAlone) {
  const FilmContact contact = oiled_contact();
  const double load = 400.0, sliding = 0.7, speed = 9.0;
  RaceContactParameters full = mixed(1.0);
  full.lubrication = Lubrication::full;
  const double film = friction(FrictionLaws<double>::of(full, contact), load, sliding, speed);
  EXPECT_NEAR(friction(FrictionLaws<double>::of(mixed(1e-15), contact), load, sliding, speed), film,
              1e-10 * film);
  const double boundary = 0.12 * load * 0.7 / std::sqrt(0.7 * 0.7 + 0.1 * 0.1);
  EXPECT_NEAR(friction(FrictionLaws<double>::of(mixed(1e3), contact), load, sliding, speed), boundary,
              1e-8 * boundary);
}

// If the least film of Eq. (10) equals the roughness, asperities carry a quarter.
TEST(MixedFriction, AQuarterWhereTheLeastFilmIsTheRoughness) {
  const FilmContact contact = oiled_contact();
  const double load = 400.0, sliding = 0.7, speed = 9.0;
  const RaceContactParameters given = mixed(Film(contact, speed).least(load));
  RaceContactParameters full = given;
  full.lubrication = Lubrication::full;
  const double film = friction(FrictionLaws<double>::of(full, contact), load, sliding, speed);
  const double boundary = 0.12 * load * 0.7 / std::sqrt(0.7 * 0.7 + 0.1 * 0.1);
  EXPECT_NEAR(friction(FrictionLaws<double>::of(given, contact), load, sliding, speed),
              0.25 * boundary + 0.75 * film, kRoundOff * boundary);
}

TEST(MixedFriction, NeverGivesPower) {
  const auto laws = FrictionLaws<double>::of(mixed(0.2e-6), oiled_contact());
  for (double load : {1e-3, 1.0, 300.0, 5000.0})
    for (double sliding : {-8.0, -0.01, 0.0, 1e-6, 0.4, 20.0})
      for (double speed : {0.01, 2.0, 30.0}) EXPECT_GE(friction(laws, load, sliding, speed) * sliding, 0.0);
}

struct Laws {
  const char* name;
  TractionLaw traction;
  Lubrication lubrication;
};

class FrictionSlopes : public testing::TestWithParam<Laws> {};

// Slopes by forward differentiation against differences of the plain law.
TEST_P(FrictionSlopes, AreThoseOfTheForce) {
  RaceContactParameters parameters;
  parameters.traction = GetParam().traction;
  parameters.lubrication = GetParam().lubrication;
  const auto laws = FrictionLaws<double>::of(parameters, oiled_contact());
  for (const double load : {0.3, 40.0, 3000.0})
    for (const double sliding : {-3.0, -0.02, 1e-4, 0.5})
      for (const double log_speed : {-4.0, 0.5, 3.5}) {
        const auto at = [&](double q, double s, double u) { return laws.friction(q, s, u); };
        const double size = std::abs(at(load, sliding, log_speed));
        const double dq = 1e-5 * load, ds = 1e-5 * std::max(0.1, std::abs(sliding)), du = 1e-5;
        double found[3] = {};
        laws.friction(mechanics::variable<0>(load), mechanics::variable<1>(sliding),
                      mechanics::variable<2>(log_speed), [&](const auto& force) {
                        EXPECT_NEAR(force.value, at(load, sliding, log_speed), kRoundOff * size);
                        found[0] = force.template by<0>();
                        found[1] = force.template by<1>();
                        found[2] = force.template by<2>();
                      });
        const double by_sliding =
            (at(load, sliding + ds, log_speed) - at(load, sliding - ds, log_speed)) / (2.0 * ds);
        EXPECT_NEAR(found[0],
                    (at(load + dq, sliding, log_speed) - at(load - dq, sliding, log_speed)) / (2.0 * dq),
                    kDifferenceError * size / load);
        // The friction bends over the sliding scale, at least 0.01 m/s, of which ds may be a ten-thousandth.
        EXPECT_NEAR(found[1], by_sliding, 1e-6 * std::abs(by_sliding) + kDifferenceError * size / ds * 1e-5);
        EXPECT_NEAR(found[2],
                    (at(load, sliding, log_speed + du) - at(load, sliding, log_speed - du)) / (2.0 * du),
                    kDifferenceError * size);
      }
}

INSTANTIATE_TEST_SUITE_P(
    Laws, FrictionSlopes,
    testing::Values(Laws{"coulomb", TractionLaw::regularised_coulomb, Lubrication::full},
                    Laws{"limiting_shear", TractionLaw::limiting_shear, Lubrication::full},
                    Laws{"mixed", TractionLaw::limiting_shear, Lubrication::mixed},
                    Laws{"mixed_coulomb", TractionLaw::regularised_coulomb, Lubrication::mixed}),
    [](const auto& laws) { return std::string(laws.param.name); });

class RollingSlopes : public testing::TestWithParam<RollingLaw> {};

TEST_P(RollingSlopes, AreThoseOfTheForce) {
  RaceContactParameters parameters;
  parameters.rolling_law = GetParam();
  const auto laws = FrictionLaws<double>::of(parameters, oiled_contact());
  for (const double load : {0.3, 40.0, 3000.0})
    for (const double rolling : {-5.0, 0.02, 30.0}) {
      const double log_speed = 0.7;
      const auto at = [&](double q, double r, double u) { return laws.inlet(q, r, u); };
      const auto force = laws.inlet(mechanics::variable<0>(load), mechanics::variable<3>(rolling),
                                    mechanics::variable<2>(log_speed));
      const double h = 1e-5, size = std::abs(force.value);
      EXPECT_NEAR(force.by<0>() * load,
                  (at(load * (1 + h), rolling, log_speed) - at(load * (1 - h), rolling, log_speed)) / (2 * h),
                  kDifferenceError * size);
      EXPECT_NEAR(force.by<3>() * rolling, size * (rolling < 0.0 ? -1.0 : 1.0), kRoundOff * size);
      EXPECT_NEAR(force.by<2>(),
                  (at(load, rolling, log_speed + h) - at(load, rolling, log_speed - h)) / (2 * h),
                  kDifferenceError * size);
    }
}

INSTANTIATE_TEST_SUITE_P(Laws, RollingSlopes,
                         testing::Values(RollingLaw::reynolds, RollingLaw::goksem_hargreaves));

}  // namespace
}  // namespace orbearing::bearing::friction_test
