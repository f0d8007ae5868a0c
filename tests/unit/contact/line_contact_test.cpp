#include "bearing/contact/line_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace orbearing::bearing::line_contact_test {
namespace {

constexpr double kRoundOff = 1e-13;        // a few powers in double precision, relative
constexpr double kDifferenceError = 1e-8;  // central difference with a step of 1e-5 of the approach, relative
constexpr double kPrintedDigits = 0.5;     // [N] constants in series are published to whole newtons

TEST(LineContact, LoadOfOneMicrometreByHand) {
  // 1 mm of contact, 1e-3 mm approach: 8.06e4 (1e-3)^(10/9) N.
  const LineContact contact = roller_race_contact(ContactLaw::palmgren, 1e-3);
  EXPECT_NEAR(contact.load(1e-6), 8.06e4 * 4.641588833612779e-4, 1e-9);
}

TEST(LineContact, LengthEntersWithEightNinths) {
  const LineContact one = roller_race_contact(ContactLaw::palmgren, 1e-3);
  const LineContact long_roller = roller_race_contact(ContactLaw::palmgren, 512e-3);
  EXPECT_NEAR(long_roller.constant() / one.constant(), 256.0, 256.0 * kRoundOff);
}

TEST(LineContact, TwoContactsInSeriesGiveThePublishedConstants) {
  // 1 mm of total approach over two equal contacts of 1 mm length.
  const double each = 0.5e-3;
  EXPECT_NEAR(roller_race_contact(ContactLaw::palmgren, 1e-3).load(each), 37313.0, kPrintedDigits);
  EXPECT_NEAR(roller_race_contact(ContactLaw::iso16281, 1e-3).load(each), 35948.0, kPrintedDigits);
}

TEST(LineContact, ApproachIsTheInverseOfLoad) {
  const LineContact contact = roller_race_contact(ContactLaw::palmgren, 5.7e-3);
  for (double load = 1e-3; load < 1e7; load *= 10.0) {
    EXPECT_NEAR(contact.load(contact.approach(load)), load, load * kRoundOff);
  }
}

TEST(LineContact, ComplianceIsTheReciprocalOfStiffness) {
  const LineContact contact = roller_race_contact(ContactLaw::iso16281, 5.7e-3);
  for (double load = 1e-3; load < 1e7; load *= 10.0) {
    EXPECT_NEAR(contact.compliance(load) * contact.stiffness(contact.approach(load)), 1.0, kRoundOff);
  }
}

TEST(LineContact, StiffnessIsTheSlopeOfTheLoad) {
  const LineContact contact = roller_race_contact(ContactLaw::palmgren, 5.7e-3);
  for (double approach = 1e-9; approach < 1e-3; approach *= 10.0) {
    const double step = 1e-5 * approach;
    const double slope = (contact.load(approach + step) - contact.load(approach - step)) / (2.0 * step);
    EXPECT_NEAR(contact.stiffness(approach), slope, slope * kDifferenceError);
  }
}

TEST(LineContact, NeverPulls) {
  const LineContact contact = roller_race_contact(ContactLaw::palmgren, 5.7e-3);
  for (const double gap : {0.0, -1e-9, -1.0}) {
    EXPECT_EQ(contact.load(gap), 0.0);
    EXPECT_EQ(contact.stiffness(gap), 0.0);
    EXPECT_EQ(contact.energy(gap), 0.0);
  }
  EXPECT_EQ(contact.approach(0.0), 0.0);
}

}  // namespace
}  // namespace orbearing::bearing::line_contact_test
