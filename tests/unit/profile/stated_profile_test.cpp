// Profiles from what a case states of them, and rollers with such a profile.
#include "bearing/profile/stated_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "bearing/geometry.hpp"

namespace orbearing::bearing::profile::stated_profile_test {
namespace {

constexpr double kRoundOff = 1e-12;  // relative, some steps of Newton's method
constexpr double kLength = 10e-3, kDiameter = 8e-3, kHalf = 0.5 * kLength;
constexpr double kStation = kDropPosition * kHalf;

// The profile of ISO/TS 16281 where a drop is stated.
double standard_drop() {
  return -0.00035 * kDiameter * std::log(1.0 - kDropPosition * kDropPosition);
}

DesignLoad contact() {
  return {.length = kLength, .equivalent_radius = 3e-3, .material = mechanics::Material{}};
}
Profile made(const StatedProfile& stated) {
  return profile_of(stated, kDiameter, contact());
}
DesignLoad under(double load) {
  DesignLoad design = contact();
  design.load = load;
  return design;
}

TEST(StatedProfile, NoneIsStraight) {
  EXPECT_EQ(made({.drop = 5e-6}), Profile(Straight{}));
}

// A kind by itself has the depth of the standard's profile; a drop is that depth.
TEST(StatedProfile, EachKindHasTheDropThatIsStated) {
  for (const auto& [value, text] : names_of(Kind{})) {
    if (value == Kind::straight || value == Kind::table) continue;
    SCOPED_TRACE(text);
    const Profile alone = made({.kind = value}), deep = made({.kind = value, .drop = 9e-6});
    EXPECT_EQ(kind(alone), text);
    EXPECT_NEAR(drop(alone, kStation) / standard_drop(), 1.0, kRoundOff);
    EXPECT_NEAR(drop(deep, kStation) / 9e-6, 1.0, kRoundOff);
    EXPECT_EQ(drop(made({.kind = value, .drop = 0.0}), kHalf), 0.0);
  }
  EXPECT_EQ(made({.kind = Kind::straight}), Profile(Straight{}));
}

TEST(StatedProfile, WhatIsLeftOutOfAShapeHasADefault) {
  const auto chamfer = [](const StatedProfile& stated) {
    return std::get<Chamfer>(made(stated)).chamfer_length;
  };
  EXPECT_EQ(chamfer({.kind = Kind::chamfer}), 0.1 * kLength);
  EXPECT_EQ(chamfer({.kind = Kind::chamfer, .chamfer_length = 2e-3}), 2e-3);
  const auto straight = [](const StatedProfile& stated) {
    return std::get<StraightCircular>(made(stated)).straight_length;
  };
  EXPECT_EQ(straight({.kind = Kind::straight_circular}), 0.6 * kLength);
  EXPECT_EQ(straight({.kind = Kind::straight_circular, .straight_length = 3e-3}), 3e-3);
}

TEST(StatedProfile, LogarithmicKindsAreThoseOfTheDesignLoad) {
  const DesignLoad design = under(2000.0);
  EXPECT_EQ(made({.kind = Kind::lundberg, .design_load = 2000.0}), Profile(lundberg_for(design)));
  EXPECT_EQ(made({.kind = Kind::johns_gohar, .design_load = 2000.0}), Profile(johns_gohar_for(design)));
  EXPECT_EQ(
      made({.kind = Kind::fujiwara_kawase, .design_load = 2000.0, .k1 = 1.5, .k2 = 0.5, .end_drop = 20e-6}),
      Profile(fujiwara_kawase_for(design, 1.5, 0.5, 20e-6)));
  // Without an end drop that of Johns and Gohar, times K1.
  EXPECT_EQ(made({.kind = Kind::fujiwara_kawase, .design_load = 2000.0, .k1 = 1.5}),
            Profile(fujiwara_kawase_for(design, 1.5, 1.0, 1.5 * drop(johns_gohar_for(design), kHalf))));
  // A drop scales it.
  EXPECT_NEAR(drop(made({.kind = Kind::lundberg, .drop = 7e-6, .design_load = 2000.0}), kStation) / 7e-6, 1.0,
              kRoundOff);
}

TEST(StatedProfile, ATableIsThatOfItsPoints) {
  const Table points{.x = {-kHalf, 0.0, kHalf}, .drop = {6e-6, 0.0, 4e-6}};
  EXPECT_EQ(made({.kind = Kind::table, .x = points.x, .drops = points.drop}), Profile(points));
  const Profile scaled = made({.kind = Kind::table, .drop = 8e-6, .x = points.x, .drops = points.drop});
  EXPECT_NEAR(drop(scaled, kStation) / 8e-6, 1.0, kRoundOff);
}

TEST(StatedProfile, WithoutAMeaningIsRefused) {
  EXPECT_THROW((void)made({.kind = Kind::straight, .drop = 3e-6}), std::invalid_argument);
  EXPECT_THROW((void)made({.kind = Kind::chamfer, .chamfer_length = 0.9 * kLength}), std::invalid_argument);
  EXPECT_THROW((void)made({.kind = Kind::table}), std::invalid_argument);
  // The kind by itself is sound, the negative drop is not.
  EXPECT_THROW((void)made({.kind = Kind::iso16281, .drop = -3e-6}), std::invalid_argument);
  EXPECT_THROW((void)made({.kind = Kind::lundberg, .design_load = 0.0}), std::invalid_argument);
}

TEST(StatedProfile, IsThatOfTheRollersOnTheInnerRace) {
  Bearing bearing{.elements = CylindricalRollers{.count = 12, .diameter = kDiameter, .length = kLength},
                  .pitch_diameter = 50e-3};
  const StatedProfile stated{.kind = Kind::johns_gohar, .design_load = 2000.0};
  put_profile(stated, bearing);
  DesignLoad design = under(2000.0);
  design.equivalent_radius = 4e-3 * 21e-3 / 25e-3;  // of a roller on a race of 42 mm
  const auto& profile = std::get<JohnsGohar>(bearing.rollers().profile);
  EXPECT_NEAR(profile.width_ratio / width_ratio(design), 1.0, kRoundOff);
  put_profile({}, bearing);  // none is stated
  EXPECT_EQ(kind(bearing.rollers().profile), "johns-gohar");
}

}  // namespace
}  // namespace orbearing::bearing::profile::stated_profile_test
