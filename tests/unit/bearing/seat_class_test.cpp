// Seats by tolerance classes. Issue 16, Build 8: a bearing as it is bought sits on a seat as it is drawn.
// Values of [ISO286] as they stand in every table of fits, from memory.
#include "bearing/catalogue/seat_class.hpp"

#include <gtest/gtest.h>

#include "tests/messages.hpp"

namespace orbearing::bearing::catalogue::seat_class_test {
namespace {

constexpr double kMicro = 1e-6, kMilli = 1e-3;

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
    const Deviations found = shaft_deviations(one.name, kMilli * one.diameter);
    EXPECT_NEAR(found.least / kMicro, one.least, 1e-9) << one.name;
    EXPECT_NEAR(found.most / kMicro, one.most, 1e-9) << one.name;
  }
}

TEST(SeatClass, HolesAreThoseOfTheStandard) {
  for (const Known& one : {Known{"H7", 50, 0, 25}, Known{"N6", 46, -28, -12}, Known{"P6", 46, -37, -21},
                           Known{"M7", 80, -30, 0}, Known{"K6", 100, -18, 4}, Known{"K7", 100, -25, 10},
                           Known{"P7", 40, -42, -17}, Known{"N7", 62, -39, -9}, Known{"G7", 30, 7, 28}}) {
    const Deviations found = hole_deviations(one.name, kMilli * one.diameter);
    EXPECT_NEAR(found.least / kMicro, one.least, 1e-9) << one.name;
    EXPECT_NEAR(found.most / kMicro, one.most, 1e-9) << one.name;
  }
}

// A bearing of 25 mm on k5: bore 0/-10 um, pin +2/+11; outside of 46 mm in N6: 0/-11 um, hole -28/-12.
TEST(SeatClass, InterferencesTakeTheBearingsOwnTolerance) {
  const Deviations inner = inner_interference("k5", 25 * kMilli),
                   outer = outer_interference("N6", 46 * kMilli);
  EXPECT_NEAR(inner.least / kMicro, 2, 1e-9);
  EXPECT_NEAR(inner.most / kMicro, 21, 1e-9);
  EXPECT_NEAR(outer.least / kMicro, 1, 1e-9);
  EXPECT_NEAR(outer.most / kMicro, 28, 1e-9);
  EXPECT_NEAR(outer.middle() / kMicro, 14.5, 1e-9);
  // Outsides of normal accuracy have a step of their own at 150 mm.
  EXPECT_NEAR(outer_interference("H7", 140 * kMilli).least / kMicro, -58, 1e-9);
  EXPECT_NEAR(outer_interference("H7", 160 * kMilli).least / kMicro, -65, 1e-9);
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
