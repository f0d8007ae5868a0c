// Bearings of a point that carry unlike loads: the shortest of their lives, and which planet has it.
#include "coupling/analysis/worst_bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace orbearing::analysis::worst_bearing_test {
namespace {

using bearing::rating::LifeMethod;

TEST(WorstBearing, WithoutUnlikeOnesIsAny) {
  PointResult point;
  point.life_hours = 700.0;
  EXPECT_TRUE(std::isnan(unlike_bearings(point).shortest_hours));
  EXPECT_TRUE(std::isnan(unlike_bearings(point).planet));
  EXPECT_EQ(worst_governing_hours(point), 700.0);
}

TEST(WorstBearing, OfPlanets) {
  PointResult point;
  point.life_hours = 700.0;
  point.planets = {
      {.load_share = 0.9, .life_hours = 900.0, .rated_hours = {.basic = 90.0, .reference = 70.0}},
      {.load_share = 1.2, .life_hours = 400.0, .rated_hours = {.basic = 40.0, .reference = 80.0}},
      {.load_share = 1.1, .life_hours = 500.0, .rated_hours = {.basic = 50.0}}};
  const UnlikeBearings unlike = unlike_bearings(point);
  EXPECT_EQ(unlike.shortest_hours, 400.0);
  EXPECT_EQ(unlike.shortest_rated.basic, 40.0);
  EXPECT_EQ(unlike.shortest_rated.reference, 70.0);  // life by life
  EXPECT_TRUE(std::isnan(unlike.shortest_rated.modified));
  EXPECT_EQ(unlike.planet, 2.0);
  EXPECT_EQ(unlike.load_share, 1.2);
  EXPECT_EQ(worst_governing_hours(point), 400.0);
  point.life_method = LifeMethod::iso281;
  EXPECT_EQ(worst_governing_hours(point), 40.0);
}

TEST(WorstBearing, OfSeatsComesBeforePlanets) {
  PointResult point;
  point.planets = {{.life_hours = 400.0}};
  point.seats.resize(2);
  point.seats[0].life_hours = 800.0;
  point.seats[1].life_hours = 300.0;
  EXPECT_EQ(unlike_bearings(point).shortest_hours, 300.0);
}

TEST(WorstBearing, OfGearsAndBearingsInOneSystemIsTheShortestOfAll) {
  PointResult point;
  point.coupled.emplace();
  point.coupled->bearing_life_hours = {500.0, 200.0, 900.0, 400.0};
  EXPECT_EQ(unlike_bearings(point).shortest_hours, 200.0);
  EXPECT_EQ(worst_governing_hours(point), 200.0);
}

TEST(WorstBearing, OfACarrierOnItsBearingsIsTheWorstOverItsRevolution) {
  PointResult point;
  point.life_hours = 700.0;
  point.planets = {{.life_hours = 400.0}};
  point.carrier.emplace();
  point.carrier->bearings.resize(2);
  point.carrier->bearings[0].life_hours = 650.0;
  point.carrier->bearings[1].life_hours = 600.0;
  EXPECT_EQ(worst_governing_hours(point), 600.0);
}

}  // namespace
}  // namespace orbearing::analysis::worst_bearing_test
