// Seats by tolerance classes: a catalogue bearing on a seat as in its drawing. Values of [ISO286] as in every
// table of fits, from memory.
#include "bearing/catalogue/classes.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

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
  for (const Known& one :
       {Known{"k6", 50, 2, 18}, Known{"n6", 25, 15, 28}, Known{"h6", 30, -13, 0}, Known{"g6", 40, -25, -9},
        Known{"m5", 60, 11, 24}, Known{"p6", 100, 37, 59}, Known{"js5", 30, -4.5, 4.5},
        Known{"k5", 200, 4, 24}, Known{"h7", 10, -15, 0}, Known{"j5", 75, -7, 6}, Known{"j6", 40, -5, 11},
        Known{"j5", 280, -16, 7}, Known{"j6", 350, -18, 18}}) {
    const Deviations found = shaft_deviations(one.name, per_milli * one.diameter);
    EXPECT_NEAR(found.least / per_micro, one.least, 1e-9) << one.name;
    EXPECT_NEAR(found.most / per_micro, one.most, 1e-9) << one.name;
  }
}

TEST(SeatClass, HolesAreThoseOfTheStandard) {
  for (const Known& one :
       {Known{"H7", 50, 0, 25}, Known{"N6", 46, -28, -12}, Known{"P6", 46, -37, -21}, Known{"M7", 80, -30, 0},
        Known{"K6", 100, -18, 4}, Known{"K7", 100, -25, 10}, Known{"P7", 40, -42, -17},
        Known{"N7", 62, -39, -9}, Known{"G7", 30, 7, 28}, Known{"J6", 62, -6, 13}, Known{"J7", 90, -13, 22},
        Known{"F7", 52, 30, 60}, Known{"H8", 160, 0, 63}, Known{"M6", 250, -37, -8},
        Known{"M6", 280, -41, -9}, Known{"M6", 320, -46, -10}, Known{"M7", 280, -52, 0}}) {
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

// Limits of 28 shaft and hole classes as a maker's catalogue prints them. Within 1 um, to which it prints and
// rounds; its bore of 250 to 315 mm has -34 for -35 um.
TEST(SeatClass, AgreesWithAPrintedTableOfFits) {
  std::ifstream table(ORBEARING_SOURCE_DIR "/tests/reference/printed_fits.csv");
  ASSERT_TRUE(table);
  int rows = 0;
  for (std::string line; std::getline(table, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream cells(line);
    std::string seat, name;
    std::getline(cells, seat, ',');
    std::getline(cells, name, ',');
    const bool shaft = seat == "shaft";
    for (std::string range; std::getline(cells, range, ';'); ++rows) {
      std::istringstream numbers(range);
      double over = 0.0, up_to = 0.0, upper = 0.0, lower = 0.0, largest = 0.0, least = 0.0;
      ASSERT_TRUE(numbers >> over >> up_to >> upper >> lower >> largest >> least) << name << ": " << range;
      const double diameter = per_milli * 0.5 * (over + up_to);
      const Deviations part = shaft ? shaft_deviations(name, diameter) : hole_deviations(name, diameter);
      const Deviations fit = shaft ? inner_interference(name, diameter) : outer_interference(name, diameter);
      EXPECT_NEAR(part.most / per_micro, upper, 1.0) << name << ": " << range;
      EXPECT_NEAR(part.least / per_micro, lower, 1.0) << name << ": " << range;
      EXPECT_NEAR(fit.most / per_micro, largest, 1.0 + 1e-9) << name << ": " << range;
      EXPECT_NEAR(fit.least / per_micro, least, 1.0 + 1e-9) << name << ": " << range;
    }
  }
  EXPECT_EQ(rows, 369);
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
