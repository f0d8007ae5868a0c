#include "bearing/motion/model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bearing/motion/snapshot.hpp"
#include "tests/unit/motion/reducer_bearing.hpp"

namespace orbearing::bearing::motion::model_test {
namespace {

std::string message(const Bearing& bearing, const DynamicsParameters& parameters) {
  try {
    bearing_model(bearing, test::reducer_point(6000.0), parameters);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BearingModel, RefusesWhatHasNoMeaningAndSaysWhy) {
  using testing::HasSubstr;
  const Bearing bearing = test::reducer_bearing();
  const DynamicsParameters parameters = test::reducer_parameters();
  EXPECT_EQ(message(bearing, parameters), "accepted");

  Bearing cage_of_nothing = bearing;
  cage_of_nothing.cage.density = 0.0;
  EXPECT_THAT(message(cage_of_nothing, parameters), HasSubstr("mass of the cage"));
  // Without a cage rollers touch one another, and must have room.
  Bearing crowded = bearing;
  crowded.cage = {};
  crowded.rollers().count = 21;
  EXPECT_EQ(message(crowded, parameters), "accepted");
  crowded.rollers().count = 22;
  EXPECT_THAT(message(crowded, parameters), HasSubstr("found 6.49"));
  crowded.rollers().count = 2;
  EXPECT_THAT(message(crowded, parameters), HasSubstr("rollers without a cage"));
  DynamicsParameters tight_land = parameters;
  tight_land.cage.guide_diameter = 38.0e-3;
  EXPECT_THAT(message(bearing, tight_land), HasSubstr("clearance of cage and land"));
  DynamicsParameters dry_film = parameters;
  dry_film.race.film_in_approach = true;
  dry_film.lubricant = {};
  EXPECT_THAT(message(bearing, dry_film), HasSubstr("viscosity"));
  DynamicsParameters no_support = parameters;
  no_support.support.stiffness = 0.0;
  EXPECT_THAT(message(bearing, no_support), HasSubstr("support stiffness"));
  DynamicsParameters not_a_number = parameters;
  not_a_number.cage.pocket_clearance = std::nan("");
  EXPECT_THAT(message(bearing, not_a_number), HasSubstr("pocket clearance"));
}

// Two rollers in contact are (d_1 + d_2)/2 apart, so that rollers which are all larger by the space left
// between neighbours just fit.
TEST(BearingModel, RefusesLargerRollersThanGoIn) {
  Bearing bearing = test::full_complement_bearing();  // 3 um are left between two
  const auto with_deviation = [&](double deviation) {
    bearing.rollers().diameter_deviation.assign(21, deviation);
    return message(bearing, test::reducer_parameters());
  };
  EXPECT_EQ(with_deviation(2.95e-6), "accepted");
  EXPECT_THAT(with_deviation(3.05e-6), testing::HasSubstr("give fewer or smaller rollers"));
  // Larger and smaller by turns, the mean decides.
  for (std::size_t j = 0; j < 21; ++j) bearing.rollers().diameter_deviation[j] = j % 2 == 0 ? 9e-6 : -9e-6;
  EXPECT_EQ(message(bearing, test::reducer_parameters()), "accepted");
}

// A hollow cylinder from each race to its seat.
TEST(BearingModel, WhereNoMassIsStatedTheBoreHasThatOfTheOuterRing) {
  const Bearing bearing = test::reducer_bearing();
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.bore_mass = 0.0;
  const BearingModel model = bearing_model(bearing, test::reducer_point(6000.0), parameters);
  const auto ring = [&](double outside, double inside) {
    return bearing.material.density * M_PI / 4.0 * (outside * outside - inside * inside) * 11.9e-3;
  };
  EXPECT_NEAR(model.bore_mass, ring(47e-3, 40.88e-3), 1e-12);
  EXPECT_NEAR(model.pin_mass, ring(30.4e-3, 25e-3), 1e-12);
}

TEST(BearingModel, RippleAddsItsHarmonics) {
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.excitation = {.angular_frequency = 1000.0,
                           .harmonics = {{.order = 1, .cosine = {0.0, 7.0}, .sine = {0.0, 20.0}},
                                         {.order = 2, .cosine = {0.0, 0.0}, .sine = {4.0, 0.0}}}};
  const OperatingPoint point = test::reducer_point(6000.0);
  const BearingModel model = bearing_model(test::reducer_bearing(), point, parameters);
  const Vector2 load = bore_load(model, 0.003);
  EXPECT_DOUBLE_EQ(load.x(), point.bore_load.x() + 4.0 * std::sin(6.0));
  EXPECT_DOUBLE_EQ(load.y(), point.bore_load.y() + 7.0 * std::cos(3.0) + 20.0 * std::sin(3.0));
  const double step = 1e-7;  // [s]  the series bends by 1e-8 of itself in it
  const Vector2 difference = (bore_load(model, 0.003 + step) - bore_load(model, 0.003 - step)) / (2.0 * step);
  EXPECT_LT((bore_load_slope(model, 0.003) - difference).norm(), 1e-6 * difference.norm());
}

// The run begins in equilibrium: the quasi-static loads are those of the equations, film or not.
TEST(InitialState, CarriesTheQuasiStaticLoads) {
  for (bool film : {false, true}) {
    const Bearing bearing = test::reducer_bearing();
    DynamicsParameters parameters = test::reducer_parameters();
    parameters.race.film_in_approach = film;
    const OperatingPoint point = test::reducer_point(6000.0);
    const BearingModel model = bearing_model(bearing, point, parameters);
    const Snapshot start = snapshot(model, initial_state(bearing, model, parameters, 0.2).x);
    QuasiStaticOptions options;
    if (film) options.film = parameters.lubricant;
    const QuasiStaticState balance = quasi_static_state(bearing, point, options, 0.2);
    // Second order in displacement / pitch radius (3e-4) on the direction of the line of centres, and the
    // film at a speed that differs as little.
    const double geometric = 2e-3 * balance.inner_load.maxCoeff();
    for (int j = 0; j < bearing.rollers().count; ++j)
      EXPECT_NEAR(start.inner.load[j], balance.inner_load[j], geometric)
          << "film " << film << " roller " << j;
  }
}

// Likewise with races that are not round, unequal rollers and a film.
TEST(InitialState, CarriesTheQuasiStaticLoadsOfAnUnevenBearing) {
  Bearing bearing = test::reducer_bearing();
  bearing.inner.form = {{2, 3e-6, 0.4, false}};
  bearing.outer.form = {{3, -2e-6, 0.0, false}, {8, 5e-7, 0.9, true}};
  bearing.rollers().diameter_deviation = {2e-6, 0.0, -3e-6};
  DynamicsParameters parameters = test::reducer_parameters();
  parameters.race.film_in_approach = true;
  const OperatingPoint point = test::reducer_point(6000.0);
  const BearingModel model = bearing_model(bearing, point, parameters);
  const Snapshot start = snapshot(model, initial_state(bearing, model, parameters, 0.2).x);
  QuasiStaticOptions options;
  options.film = parameters.lubricant;
  const QuasiStaticState balance = quasi_static_state(bearing, point, options, 0.2);
  const double geometric =
      1e-2 * balance.inner_load.maxCoeff();  // as above, times the waves' order of some 8
  for (int j = 0; j < bearing.rollers().count; ++j)
    EXPECT_NEAR(start.inner.load[j], balance.inner_load[j], geometric) << "roller " << j;
}

}  // namespace
}  // namespace orbearing::bearing::motion::model_test
