#include "bearing/profile/profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace orbearing::bearing::profile::profile_test {
namespace {

constexpr double kRoundOff = 1e-13;        // relative, a few operations
constexpr double kDifferenceError = 1e-7;  // relative, central difference over 1e-6 of the length
constexpr double kLength = 5.7e-3, kDiameter = 5.24e-3;
constexpr double kHalf = 0.5 * kLength;
constexpr double kPublishedConstant = 2e-4;  // 0.3033 and 1.1932 are printed to four digits

const DesignLoad design{
    .load = 2000.0, .length = kLength, .equivalent_radius = 2.2e-3, .material = mechanics::Material{}};

// One of each kind that has a parameter.
std::vector<Profile> relieved() {
  return {Chamfer{kLength, 0.6e-3, 8e-6},
          CircularCrown{kLength, 10e-6},
          StraightCircular{kLength, 0.6 * kLength, 10e-6},
          lundberg_for(design),
          johns_gohar_for(design),
          Iso16281{kLength, kDiameter, 1.0},
          Iso16281{30e-3, 8e-3, 1.0},
          fujiwara_kawase_for(design, 1.2, 0.7, 15e-6),
          Table{{-kHalf, -1e-3, 1e-3, kHalf}, {9e-6, 1e-6, 1e-6, 9e-6}, 1.0}};
}

TEST(RollerProfile, StraightHasNoRelief) {
  for (const double x : {-kHalf, 0.0, 1e-3}) EXPECT_EQ(drop(Straight{}, x), 0.0);
}

TEST(RollerProfile, ChamferIsALineFromItsEdge) {
  const Profile chamfer = Chamfer{10e-3, 2e-3, 8e-6};
  EXPECT_EQ(drop(chamfer, 3e-3), 0.0);
  EXPECT_NEAR(drop(chamfer, 4e-3), 4e-6, 4e-6 * kRoundOff);
  EXPECT_NEAR(drop(chamfer, -5e-3), 8e-6, 8e-6 * kRoundOff);
}

TEST(RollerProfile, CircularCrownIsACircleThroughMiddleAndEnds) {
  const double deep = 0.5e-3;  // deep, so that a parabola would be visible
  const Profile crown = CircularCrown{kLength, deep};
  const double radius = (kHalf * kHalf + deep * deep) / (2.0 * deep);
  EXPECT_NEAR(drop(crown, kHalf), deep, deep * kRoundOff);
  for (const double x : {-2e-3, 0.5e-3, 2.5e-3}) {
    const double below = radius - drop(crown, x);
    EXPECT_NEAR(x * x + below * below, radius * radius, radius * radius * kRoundOff);
  }
}

TEST(RollerProfile, StraightCircularLeavesTheStraightPartWithoutAKink) {
  const Profile profile = StraightCircular{10e-3, 6e-3, 12e-6};
  EXPECT_EQ(drop(profile, 3e-3), 0.0);
  EXPECT_NEAR(drop(profile, -5e-3), 12e-6, 12e-6 * kRoundOff);
  // Close to its beginning the arc is a parabola: a quarter of the drop half-way, but for P^2/a^2 = 4e-5.
  EXPECT_NEAR(drop(profile, 4e-3), 3e-6, 3e-6 * 1e-4);
  EXPECT_LT(drop(profile, 3e-3 + 1e-9), 1e-17);
}

TEST(RollerProfile, LundbergsAmplitudeAndEndAreThoseOfTheHalfSpace) {
  const double modulus = 206e9 / 0.91;
  const double a = 2.0 * 2000.0 / (std::numbers::pi * modulus * kLength);
  const double half_width = std::sqrt(8.0 * 2000.0 * 2.2e-3 / (std::numbers::pi * modulus * kLength));
  const Profile profile = lundberg_for(design);
  EXPECT_NEAR(drop(profile, 0.5 * kHalf), a * std::log(4.0 / 3.0), a * kRoundOff);
  EXPECT_NEAR(drop(profile, kHalf), a * (1.1932 + std::log(kHalf / half_width)), a * kPublishedConstant);
}

TEST(RollerProfile, JohnsAndGoharAreLundbergButForTheEnd) {
  const Profile lundberg = lundberg_for(design), smooth = johns_gohar_for(design);
  const double a = amplitude(design), ratio = width_ratio(design);
  EXPECT_NEAR(drop(smooth, kHalf), a * -std::log(0.3033 * ratio), a * kRoundOff);
  EXPECT_NEAR(drop(smooth, kHalf), drop(lundberg, kHalf), a * kPublishedConstant);
  EXPECT_NEAR(drop(smooth, 0.5 * kHalf), drop(lundberg, 0.5 * kHalf), a * ratio * 0.3033 / 3.0);
  EXPECT_LT(drop(smooth, 0.5 * kHalf), drop(lundberg, 0.5 * kHalf));
}

TEST(RollerProfile, TheStandardsProfileByHand) {
  const Profile profile = Iso16281{kLength, kDiameter, 1.0};
  EXPECT_NEAR(drop(profile, 0.5 * kHalf), 0.00035 * kDiameter * std::log(4.0 / 3.0), 1e-18);
  // The outermost of 40 laminae: 2x/l = 39/40.
  EXPECT_NEAR(drop(profile, 0.975 * kHalf), 0.00035 * kDiameter * -std::log(1.0 - 0.975 * 0.975), 1e-17);
  EXPECT_TRUE(std::isfinite(drop(profile, kHalf)));
  EXPECT_NEAR(drop(profile, kHalf) / (0.00035 * kDiameter), 13.12, 0.01);
}

TEST(RollerProfile, TheStandardsProfileOfALongRollerIsStraightInTheMiddle) {
  const Profile profile = Iso16281{30e-3, 8e-3, 1.0};  // 2.5 D = 20 mm: straight over 10 mm
  EXPECT_EQ(drop(profile, 4.999e-3), 0.0);
  EXPECT_GT(drop(profile, 5.1e-3), 0.0);
  EXPECT_NEAR(drop(profile, 10e-3), 0.0005 * 8e-3 * std::log(4.0 / 3.0), 1e-18);
}

TEST(RollerProfile, FujiwaraAndKawaseHoldJohnsAndGohar) {
  const Profile special = johns_gohar_for(design);
  const Profile general = fujiwara_kawase_for(design, 1.0, 1.0, drop(special, kHalf));
  for (double x = -kHalf; x <= kHalf; x += 0.05 * kHalf)
    EXPECT_NEAR(drop(general, x), drop(special, x), 1e-12 * drop(special, kHalf));
}

TEST(RollerProfile, FujiwaraAndKawaseEndAtTheirDropAndBeginAtTheirCrown) {
  const Profile profile = fujiwara_kawase_for(design, 1.7, 0.4, 21e-6);
  // 1 - (1 - exp(-z/A)) u^2 keeps round-off of 1 beside exp(-z/A).
  const double lost = std::exp(21e-6 / (1.7 * amplitude(design)));
  EXPECT_NEAR(drop(profile, -kHalf), 21e-6, 21e-6 * kRoundOff * lost);
  EXPECT_EQ(drop(profile, 0.599 * kHalf), 0.0);
  EXPECT_GT(drop(profile, 0.62 * kHalf), 0.0);
}

TEST(RollerProfile, TableIsJoinedByLinesAndHeldBeyondItsEnds) {
  const Profile table = Table{{-2e-3, 0.0, 1e-3}, {4e-6, 0.0, 3e-6}, 2.0};
  EXPECT_NEAR(drop(table, -1e-3), 4e-6, 4e-6 * kRoundOff);
  EXPECT_NEAR(drop(table, 0.5e-3), 3e-6, 3e-6 * kRoundOff);
  EXPECT_EQ(drop(table, 9e-3), 6e-6);
  EXPECT_EQ(drop(table, -9e-3), 8e-6);
}

TEST(RollerProfile, EveryKindIsSymmetricAndNeverProud) {
  for (const Profile& profile : relieved())
    for (double x = 0.0; x <= 1.1 * kHalf; x += 0.01 * kHalf) {
      EXPECT_NEAR(drop(profile, x), drop(profile, -x), kRoundOff * 1e-5) << kind(profile) << " at " << x;
      EXPECT_GE(drop(profile, x), 0.0) << kind(profile) << " at " << x;
    }
}

TEST(RollerProfile, DropPerParameterIsItsDifference) {
  for (const Profile& profile : relieved()) {
    const double value = leading_parameter(profile), step = 1e-4 * value;
    ASSERT_GT(value, 0.0) << kind(profile);
    for (const double share : {-1.0, -0.6, 0.2, 0.9}) {
      const double x = share * kHalf;
      const double difference =
          (drop(with_parameter(profile, value + step), x) - drop(with_parameter(profile, value - step), x)) /
          (2.0 * step);
      EXPECT_NEAR(relief(profile, x).per_parameter, difference, kDifferenceError * (difference + 1e-9))
          << kind(profile) << " at " << x;
    }
  }
}

TEST(RollerProfile, CanBeGivenADropAtAPosition) {
  const double station = 0.975 * kHalf, x = 0.95 * kHalf;
  for (const Profile& profile : relieved()) {
    if (drop(profile, station) == 0.0) continue;  // the long roller is straight that far in
    const Profile given = with_drop(profile, station, 7e-6);
    EXPECT_NEAR(drop(given, station), 7e-6, 7e-6 * kRoundOff) << kind(profile);
    EXPECT_EQ(drop(with_drop(profile, station, 0.0), x), 0.0);
  }
}

TEST(RollerProfile, RefusesADropWhereItHasNone) {
  EXPECT_THROW(with_drop(Straight{}, 0.0, 1e-6), std::invalid_argument);
  EXPECT_THROW(with_drop(Chamfer{10e-3, 1e-3, 1e-6}, 3e-3, 1e-6), std::invalid_argument);
}

TEST(RollerProfile, RefusesWhatHasNoMeaning) {
  for (const Profile& profile : relieved()) EXPECT_NO_THROW(require_sound(profile)) << kind(profile);
  const std::vector<Profile> unsound{Chamfer{5e-3, 3e-3, 1e-6},
                                     CircularCrown{5e-3, -1e-6},
                                     CircularCrown{5e-3, 2.6e-3},
                                     StraightCircular{5e-3, 5e-3, 0.0},
                                     Lundberg{5e-3, 1e-6, 0.0},
                                     JohnsGohar{5e-3, 1e-6, 1.0},
                                     Iso16281{5e-3, 0.0, 1.0},
                                     FujiwaraKawase{5e-3, 1e-6, 0.0},
                                     FujiwaraKawase{5e-3, 1e-6, 1.0, 1.1},
                                     Table{{0.0}, {0.0}, 1.0},
                                     Table{{0.0, 0.0}, {0.0, 1e-6}},
                                     Table{{0.0, 1e-3}, {0.0, -1e-6}},
                                     Chamfer{std::nan(""), 1e-3, 1e-6}};
  for (const Profile& profile : unsound) EXPECT_THROW(require_sound(profile), std::invalid_argument);
}

}  // namespace
}  // namespace orbearing::bearing::profile::profile_test
