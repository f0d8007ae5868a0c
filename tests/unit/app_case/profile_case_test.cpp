#include "app/case/profile_case.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "app/study/fidelity.hpp"
#include "app/study/planetary_case.hpp"
#include "bearing/profile/profile.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::profile_case_test {
namespace {

using bearing::profile::Profile;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kHalf = 0.5 * 5.7e-3;
constexpr double kStation = 0.975 * kHalf;
constexpr double kRoundOff = 1e-18;  // [m]
const std::string kKind = "bearing.profile.kind=";

Profile profile_with(std::vector<std::string> settings) {
  settings.push_back("bearing.laminae=40");
  return drivetrain_of(shipped(settings)).bearing.rollers().profile;
}

TEST(ProfileCase, NothingStatedIsAStraightUncutRoller) {
  const analysis::PlanetaryDrivetrain drivetrain = drivetrain_of(shipped());
  EXPECT_EQ(drivetrain.bearing.rollers().laminae, 0);
  EXPECT_EQ(kind(drivetrain.bearing.rollers().profile), "straight");
  EXPECT_FALSE(drivetrain.misalignment.planet_tilt);
}

TEST(ProfileCase, EveryKindAloneIsAsDeepAsTheStandardsProfile) {
  const double standard = 0.00035 * 5.24e-3 * -std::log(1.0 - 0.975 * 0.975);
  for (const char* kind : {"chamfer", "circular", "straight-circular", "lundberg", "johns-gohar", "iso16281",
                           "fujiwara-kawase"}) {
    const Profile profile = profile_with({kKind + kind});
    EXPECT_EQ(bearing::profile::kind(profile), kind);
    EXPECT_NEAR(drop(profile, kStation), standard, kRoundOff) << kind;
    EXPECT_NEAR(drop(profile_with({kKind + kind, "bearing.profile.drop=9 um"}), kStation), 9e-6, kRoundOff)
        << kind;
    EXPECT_EQ(drop(profile_with({kKind + kind, "bearing.profile.drop=0 um"}), kHalf), 0.0) << kind;
  }
  EXPECT_EQ(drop(profile_with({kKind + "straight"}), kHalf), 0.0);
}

TEST(ProfileCase, TheDropIsThatOfItsDesignLoadUnlessStated) {
  const Profile alone = profile_with({kKind + "johns-gohar"});
  const Profile designed = profile_with({kKind + "johns-gohar", "bearing.profile.design_load=2 kN"});
  const double a = 2.0 * 2000.0 / (M_PI * 206e9 / 0.91 * 5.7e-3);
  const auto& smooth = std::get<bearing::profile::JohnsGohar>(designed);
  EXPECT_NEAR(smooth.amplitude, a, 1e-12 * a);
  // Races of 30.4 mm: 1/R = 1/2.62 + 1/15.2.
  const double radius = 1.0 / (1.0 / 2.62e-3 + 1.0 / 15.2e-3);
  const double half_width = std::sqrt(8.0 * 2000.0 * radius / (M_PI * 206e9 / 0.91 * 5.7e-3));
  EXPECT_NEAR(smooth.width_ratio, half_width / kHalf, 1e-12);
  EXPECT_NE(drop(alone, kStation), drop(designed, kStation));
}

TEST(ProfileCase, ShapesReachTheirKinds) {
  const auto chamfer = std::get<bearing::profile::Chamfer>(
      profile_with({kKind + "chamfer", "bearing.profile.chamfer_length=0.4 mm"}));
  EXPECT_DOUBLE_EQ(chamfer.chamfer_length, 0.4e-3);
  const auto arc = std::get<bearing::profile::StraightCircular>(
      profile_with({kKind + "straight-circular", "bearing.profile.straight_length=3 mm"}));
  EXPECT_DOUBLE_EQ(arc.straight_length, 3e-3);
  const Profile three =
      profile_with({kKind + "fujiwara-kawase", "bearing.profile.design_load=2 kN", "bearing.profile.k1=1.5",
                    "bearing.profile.k2=0.5", "bearing.profile.end_drop=20 um"});
  EXPECT_NEAR(drop(three, kHalf), 20e-6, 1e-14);
  EXPECT_EQ(drop(three, 0.49 * kHalf), 0.0);
  // Without end_drop its end is as deep as that of Johns and Gohar, times K1.
  const Profile smooth = profile_with({kKind + "johns-gohar", "bearing.profile.design_load=2 kN"}),
                two = profile_with({kKind + "fujiwara-kawase", "bearing.profile.design_load=2 kN",
                                    "bearing.profile.k1=1.5"});
  EXPECT_NEAR(drop(two, kHalf) / (1.5 * drop(smooth, kHalf)), 1.0, 1e-12);
  const Profile table = profile_with({kKind + "table", "bearing.profile.x=[-2.85 mm, 0 mm, 2.85 mm]",
                                      "bearing.profile.drops=[6 um, 0 um, 4 um]"});
  EXPECT_NEAR(drop(table, -0.5 * kHalf), 3e-6, kRoundOff);
}

TEST(ProfileCase, MisalignmentReachesTheBoreInThePlanesItNames) {
  const analysis::PlanetaryDrivetrain drivetrain =
      drivetrain_of(shipped({"bearing.laminae=40", "bearing.misalignment.planet_tilt=1 mrad",
                             "bearing.misalignment.carrier_wind_up=0.5 mrad"}));
  EXPECT_DOUBLE_EQ(drivetrain.misalignment.planet_tilt.value(), 1e-3);
  const Eigen::Vector2d tilt = bore_tilt(drivetrain.misalignment, {-30.0, 40.0});
  EXPECT_NEAR(tilt.x(), -0.6e-3, 1e-18);
  EXPECT_NEAR(tilt.y(), 0.8e-3 + 0.5e-3, 1e-18);
  EXPECT_NEAR(bore_tilt(drivetrain.misalignment, Eigen::Vector2d::Zero()).y(), 0.5e-3, 1e-18);
}

// A profile acts on lives by the standards without laminae too; a tilt does not.
TEST(ProfileCase, MisalignmentWithoutLaminaeIsAMistake) {
  EXPECT_THAT(setting_mistakes({kKind + "iso16281"}), testing::IsEmpty());
  EXPECT_THAT(setting_mistakes({"bearing.misalignment.planet_tilt=1 mrad"}),
              ElementsAre(HasSubstr("without bearing.laminae")));
  EXPECT_THAT(
      setting_mistakes({"bearing.laminae=40", "bearing.profile.drop=3 um"}),
      ElementsAre(HasSubstr("profile straight: found no relief at the position of the required drop")));
}

TEST(ProfileCase, WhatCannotBeMadeIsAMistake) {
  const auto of = [](std::vector<std::string> settings) {
    settings.push_back("bearing.laminae=40");
    return setting_mistakes(settings);
  };
  EXPECT_THAT(of({kKind + "straight", "bearing.profile.drop=3 um"}),
              ElementsAre(HasSubstr("bearing.profile.kind")));
  EXPECT_THAT(of({kKind + "chamfer", "bearing.profile.chamfer_length=0.05 mm"}),
              ElementsAre(HasSubstr("no relief at the position")));
  EXPECT_THAT(of({kKind + "straight-circular", "bearing.profile.straight_length=6 mm"}),
              ElementsAre(HasSubstr("straight length")));
  EXPECT_THAT(of({kKind + "table"}), ElementsAre(HasSubstr("number of points")));
  EXPECT_THAT(of({kKind + "lundberg", "bearing.profile.design_load=9e7 N"}),
              ElementsAre(HasSubstr("width over length")));
  EXPECT_THAT(setting_mistakes({"bearing.laminae=201"}), ElementsAre(HasSubstr("laminae")));
  EXPECT_THAT(setting_mistakes({"bearing.laminae=0"}), ElementsAre(HasSubstr("laminae")));
}

TEST(ProfileCase, LaminaeServeBothFidelities) {
  const ResolvedCase cut = shipped({"bearing.laminae=40"});
  EXPECT_NO_THROW(require_computable(cut, "quasi-static", true));
  EXPECT_NO_THROW(require_computable(cut, "dynamic", true));
}

}  // namespace
}  // namespace orbearing::app::profile_case_test
