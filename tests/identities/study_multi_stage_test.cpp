// Several sets with bearings: each as if it were alone with its own torque and speed, and all of them
// together.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "coupling/analysis/multi_stage.hpp"
#include "gearset/drivetrain/power_flow.hpp"
#include "tests/messages.hpp"
#include "tests/reducer.hpp"
#include "tests/unit/gearset/arrangements.hpp"

namespace orbearing::analysis::study_multi_stage_test {
namespace {

using example::reducer;
using example::rpm;

// The ratios of an arrangement come from a linear solver, those of a single set from a quotient; the loads of
// the races balance to 1e-12 and life takes the fourth power.
constexpr double same = 1e-9;

NamedSet named(const std::string& name, PlanetaryDrivetrain drivetrain) {
  const DrivetrainGeometry geometry = derive(drivetrain);
  return {name, std::move(drivetrain), geometry};
}

/// Two reducers one after the other.
std::vector<NamedSet> pair_in_series() {
  using namespace gearset::example_sets;
  const gearset::Arrangement arrangement{{arranged("first", 37, 22, 79), arranged("second", 37, 22, 79)},
                                         {motor({{0, sun}}), ground({{0, ring}, {1, ring}}),
                                          shaft("middle", {{0, carrier}, {1, sun}}), load({{1, carrier}})}};
  const gearset::PowerFlow flow = gearset::power_flow(arrangement);
  PlanetaryDrivetrain first = reducer();
  PlanetaryDrivetrain second = reducer();
  first.in_arrangement = flow.sets[0];
  second.in_arrangement = flow.sets[1];
  return {named("first", first), named("second", second)};
}

void expect_equal(double ours, double theirs) {
  EXPECT_NEAR(ours, theirs, same * std::abs(theirs));
}

TEST(MultiStage, InSeriesAreAsEachAloneAtItsOwnSpeed) {
  const std::vector<NamedSet> sets = pair_in_series();
  PlanetaryDrivetrain alone = reducer();
  const PointResult first = evaluate(alone, derive(alone));
  alone.drive.speed /= 1.0 + 79.0 / 37.0;
  const PointResult second = evaluate(alone, derive(alone));
  const PointResult both = evaluate(sets);
  ASSERT_EQ(both.sets.size(), 2U);
  expect_equal(both.sets[0].life_hours, first.life_hours);
  expect_equal(both.sets[0].planet_load, first.planet_load);
  expect_equal(both.sets[1].life_hours, second.life_hours);
  expect_equal(both.sets[1].carrier_speed, second.carrier_speed);
  EXPECT_EQ(both.limiting_set, "second");
  expect_equal(both.life_hours, second.life_hours);
  EXPECT_EQ(both.input_speed, first.input_speed);
  // Eq. (4) of coupling/README.md: eight bearings of each.
  const double together =
      8.0 * std::pow(first.life_hours, -9.0 / 8.0) + 8.0 * std::pow(second.life_hours, -9.0 / 8.0);
  expect_equal(both.system_life_hours, std::pow(together, -8.0 / 9.0));
}

// With several sets, too, each life of the whole is computed from the same lives of the sets.
TEST(MultiStage, HaveASystemsLivesOfTheSameLives) {
  std::vector<NamedSet> sets = pair_in_series();
  double kappa = 0.7;
  for (NamedSet& set : sets) {
    set.drivetrain.rated.oil =
        bearing::rating::StatedOil{.viscosity_ratio = kappa, .contamination_factor = 0.5};
    kappa *= 2.0;
  }
  const PointResult both = evaluate(sets);
  for (const auto life : bearing::rating::kRatedHours) {
    double damage = 0.0;
    for (const SetResult& set : both.sets) damage += 8.0 * std::pow(set.rating.hours.*life, -9.0 / 8.0);
    expect_equal(both.rating.system_hours.*life, std::pow(damage, -8.0 / 9.0));
  }
  EXPECT_GT(std::abs(both.rating.system_hours.modified / both.rating.system_hours.basic - 1.0), 0.1);
}

// A set that is alone goes the old way to the last bit.
TEST(MultiStage, OneWithoutANameIsItself) {
  const PlanetaryDrivetrain alone = reducer();
  const PointResult one = evaluate({named("", alone)});
  EXPECT_EQ(one.life_hours, evaluate(alone, derive(alone)).life_hours);
  EXPECT_TRUE(one.sets.empty());
  EXPECT_TRUE(one.limiting_set.empty());
}

// The carrier's own speed, not the motor's, determines the inertial loads: with the ring rotating forwards
// beside the sun the planets are stationary in the carrier's frame at w_s = w_r, and the whole set rotates as
// one.
TEST(MultiStage, CarrierFrameTurnsWithItsOwnCarrier) {
  PlanetaryDrivetrain drivetrain = reducer();
  const double ring_speed = 0.5;
  const double carrier_speed = (37.0 + 79.0 * ring_speed) / 116.0;
  gearset::MemberRatios ratios;
  ratios.speed = {1.0, ring_speed, carrier_speed, -(1.0 - carrier_speed) * 37.0 / 22.0};
  ratios.torque = {0.5, 0.5 * 79.0 / 37.0, -0.5 * 116.0 / 37.0};
  drivetrain.in_arrangement = ratios;
  const DrivetrainGeometry geometry = derive(drivetrain);
  const BearingDuty duty = bearing_duty(drivetrain, geometry);
  const double omega = carrier_speed * 6000.0 * rpm;  // [rad/s]
  expect_equal(duty.point.carrier.speed, omega);
  expect_equal(duty.point.outer_speed, -(1.0 - carrier_speed) * 37.0 / 22.0 * 6000.0 * rpm);
  const double centrifugal = geometry.planet_mass * omega * omega * geometry.gears.centre_distance;
  expect_equal(2.0 * duty.point.bore_load.x(), centrifugal + duty.gears.radial_force);
  const double carrier_torque = 0.5 * 116.0 / 37.0 * 150e3 / (6000.0 * rpm);  // [N m]
  expect_equal(2.0 * duty.point.bore_load.y(), carrier_torque / (4.0 * geometry.gears.centre_distance));
}

// Seen from the other side a backwards carrier runs forwards: the same bearing, the same loads.
TEST(MultiStage, DoNotFeelTheSenseOfRotation) {
  PlanetaryDrivetrain forwards = reducer();
  gearset::MemberRatios ratios = pair_in_series().front().drivetrain.in_arrangement.value();
  forwards.in_arrangement = ratios;
  for (double* value :
       {&ratios.speed.sun, &ratios.speed.ring, &ratios.speed.carrier, &ratios.speed.planet_relative,
        &ratios.torque.sun, &ratios.torque.ring, &ratios.torque.carrier})
    *value = -*value;
  PlanetaryDrivetrain backwards = forwards;
  backwards.in_arrangement = ratios;
  const PointResult a = evaluate(forwards, derive(forwards));
  const PointResult b = evaluate(backwards, derive(backwards));
  EXPECT_EQ(a.life_hours, b.life_hours);
  EXPECT_EQ(a.planet_load, b.planet_load);
  EXPECT_EQ(a.outer.load_max, b.outer.load_max);
}

TEST(MultiStage, NameTheSetThatFails) {
  std::vector<NamedSet> sets = pair_in_series();
  EXPECT_REFUSED(std::invalid_argument, "no sets", (void)evaluate(std::vector<NamedSet>{}));
  sets[1].drivetrain.drive.power = -1.0;
  try {
    evaluate(sets);
    FAIL() << "no result was expected";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("second: ", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace orbearing::analysis::study_multi_stage_test
