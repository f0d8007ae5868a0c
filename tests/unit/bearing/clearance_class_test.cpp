// Clearance classes of catalogue bearings.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "bearing/catalogue/classes.hpp"
#include "tests/messages.hpp"

namespace orbearing::bearing::catalogue::clearance_class_test {
namespace {

constexpr double kUm = 1e-6;

TEST(ClearanceClasses, AreThoseOfTheStandard) {
  const ClearanceRange rollers = clearance_range(Family::cylindrical, ClearanceClass::cn, 25e-3);
  EXPECT_DOUBLE_EQ(rollers.least, 20.0 * kUm);
  EXPECT_DOUBLE_EQ(rollers.most, 45.0 * kUm);
  EXPECT_DOUBLE_EQ(clearance_range(Family::deep_groove, ClearanceClass::c3, 25e-3).middle(), 20.5 * kUm);
  // "Over 24 up to 30 mm".
  EXPECT_DOUBLE_EQ(clearance_range(Family::cylindrical, ClearanceClass::c5, 24e-3).most, 90.0 * kUm);
  EXPECT_DOUBLE_EQ(clearance_range(Family::cylindrical, ClearanceClass::c5, 30e-3).most, 95.0 * kUm);
}

TEST(ClearanceClasses, RiseFromClassToClassAndWithTheBore) {
  using enum ClearanceClass;
  for (const Family family : {Family::cylindrical, Family::deep_groove})
    for (double bore = 12e-3; bore < 200e-3; bore += 1e-3) {
      double before = 0.0;
      for (const ClearanceClass one : {c2, cn, c3, c4, c5}) {
        const ClearanceRange range = clearance_range(family, one, bore);
        EXPECT_LT(range.least, range.most);
        EXPECT_GT(range.middle(), before);
        EXPECT_LE(range.middle(), clearance_range(family, one, std::min(1.1 * bore, 200e-3)).middle());
        before = range.middle();
      }
    }
}

TEST(ClearanceClasses, BeyondTheTableAreRefused) {
  EXPECT_REFUSED(std::invalid_argument, "catalogue 1",
                 (void)clearance_range(Family::cylindrical, ClearanceClass::cn, 10e-3));
  EXPECT_REFUSED(std::invalid_argument, "catalogue 2",
                 (void)clearance_range(Family::cylindrical, ClearanceClass::cn, 201e-3));
  EXPECT_REFUSED(std::invalid_argument, "catalogue 3",
                 (void)clearance_range(Family::angular_contact, ClearanceClass::cn, 25e-3));
}

}  // namespace
}  // namespace orbearing::bearing::catalogue::clearance_class_test
