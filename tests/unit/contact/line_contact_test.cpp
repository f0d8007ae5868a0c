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

// The law by the secant stiffness, as packs have it, gives the same numbers.
TEST(LineContact, IsTheLawByItsSecantStiffness) {
  const LineContact contact = roller_race_contact(ContactLaw::palmgren, 5.7e-3);
  const double log_constant = std::log(contact.constant());
  for (double approach = 1e-9; approach < 1e-3; approach *= 10.0) {
    const double load = contact.load(approach), stiffness = contact.stiffness(approach);
    EXPECT_NEAR(LineLaw::slope(load / approach), stiffness, stiffness * kRoundOff);
    EXPECT_NEAR(LineLaw::compliance(load, approach) * stiffness, 1.0, kRoundOff);
    const double step = 1e-5 * approach;
    const double slope = (contact.energy(approach + step) - contact.energy(approach - step)) / (2.0 * step);
    EXPECT_NEAR(load, slope, slope * kDifferenceError);
    const double log_load = LineLaw::log_load(std::log(approach), log_constant);
    EXPECT_NEAR(std::exp(log_load), load, load * 100.0 * kRoundOff);  // logarithms of some 20
    EXPECT_NEAR(std::exp(LineLaw::log_approach(log_load, log_constant)), approach,
                approach * 100.0 * kRoundOff);
  }
}

TEST(LineContact, BothInSeriesShareTheApproach) {
  const LineContact one = roller_race_contact(ContactLaw::iso16281, 5.7e-3);
  EXPECT_NEAR(both_in_series(one).load(2e-6), one.load(1e-6), one.load(1e-6) * kRoundOff);
}

// Same work on both sides of the lever.
TEST(LineContact, ThroughALeverItsLoadGrowsAsItsApproachFalls) {
  const LineContact one = roller_race_contact(ContactLaw::palmgren, 5.7e-3);
  constexpr double kRatio = 0.8;
  const LineContact through = one.through_lever(kRatio);
  EXPECT_NEAR(through.load(1e-6 / kRatio), one.load(1e-6) * kRatio, one.load(1e-6) * kRoundOff);
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
