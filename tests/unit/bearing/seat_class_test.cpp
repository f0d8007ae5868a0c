// Seats by tolerance classes. Issue 16, Build 8: a bearing as it is bought sits on a seat as it is drawn.
// Values of [ISO286] as they stand in every table of fits, from memory.
#include "bearing/catalogue/classes.hpp"

#include <gtest/gtest.h>

#include "tests/messages.hpp"

namespace orbearing::bearing::catalogue::seat_class_test {
namespace {

constexpr double per_micro = 1e-6, per_milli = 1e-3;

struct Known {
  const char* name;
  double diameter;  // [mm]
  double least;     // [um]
  double most;      // [um]
};

TEST(SeatClass, ShaftsAreThoseOfTheStandard) {
  for (const Known& one : {Known{"k6", 50, 2, 18}, Known{"n6", 25, 15, 28}, Known{"h6", 30, -13, 0},
                           Known{"g6", 40, -25, -9}, Known{"m5", 60, 11, 24}, Known{"p6", 100, 37, 59},
                           Known{"js5", 30, -4.5, 4.5}, Known{"k5", 200, 4, 24}, Known{"h7", 10, -15, 0}}) {
    const Deviations found = shaft_deviations(one.name, per_milli * one.diameter);
    EXPECT_NEAR(found.least / per_micro, one.least, 1e-9) << one.name;
    EXPECT_NEAR(found.most / per_micro, one.most, 1e-9) << one.name;
  }
}

TEST(SeatClass, HolesAreThoseOfTheStandard) {
  for (const Known& one : {Known{"H7", 50, 0, 25}, Known{"N6", 46, -28, -12}, Known{"P6", 46, -37, -21},
                           Known{"M7", 80, -30, 0}, Known{"K6", 100, -18, 4}, Known{"K7", 100, -25, 10},
                           Known{"P7", 40, -42, -17}, Known{"N7", 62, -39, -9}, Known{"G7", 30, 7, 28}}) {
    const Deviations found = hole_deviations(one.name, per_milli * one.diameter);
    EXPECT_NEAR(found.least / per_micro, one.least, 1e-9) << one.name;
    EXPECT_NEAR(found.most / per_micro, one.most, 1e-9) << one.name;
  }
}

// A bearing of 25 mm on k5: bore 0/-10 um, pin +2/+11; outside of 46 mm in N6: 0/-11 um, hole -28/-12.
TEST(SeatClass, InterferencesTakeTheBearingsOwnTolerance) {
  const Deviations inner = inner_interference("k5", 25 * per_milli),
                   outer = outer_interference("N6", 46 * per_milli);
  EXPECT_NEAR(inner.least / per_micro, 2, 1e-9);
  EXPECT_NEAR(inner.most / per_micro, 21, 1e-9);
  EXPECT_NEAR(outer.least / per_micro, 1, 1e-9);
  EXPECT_NEAR(outer.most / per_micro, 28, 1e-9);
  EXPECT_NEAR(outer.middle() / per_micro, 14.5, 1e-9);
  // Outsides of normal accuracy have a step of their own at 150 mm.
  EXPECT_NEAR(outer_interference("H7", 140 * per_milli).least / per_micro, -58, 1e-9);
  EXPECT_NEAR(outer_interference("H7", 160 * per_milli).least / per_micro, -65, 1e-9);
}

TEST(SeatClass, EveryNameIsKnown) {
  for (const std::string& name : shaft_classes())
    EXPECT_LT(shaft_deviations(name, 0.03).least, shaft_deviations(name, 0.03).most);
  for (const std::string& name : hole_classes())
    EXPECT_LT(hole_deviations(name, 0.03).least, hole_deviations(name, 0.03).most);
  EXPECT_REFUSED(std::invalid_argument, "seat_class 1", shaft_deviations("k5", 3e-3));
  EXPECT_REFUSED(std::invalid_argument, "seat_class 2", hole_deviations("H7", 0.401));
}

}  // namespace
}  // namespace orbearing::bearing::catalogue::seat_class_test
