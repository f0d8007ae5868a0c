#include "app/case/consistency.hpp"

#include <gmock/gmock.h>

#include "app/case/drivetrain_reader.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::consistency_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// One setting that contradicts the rest of the shipped case, and where the objection goes.
struct Contradiction {
  const char* setting;
  const char* validation_error;
};

class Contradictions : public testing::TestWithParam<Contradiction> {};

TEST_P(Contradictions, AreReported) {
  EXPECT_THAT(setting_mistakes({GetParam().setting}), Contains(HasSubstr(GetParam().validation_error)));
}

INSTANTIATE_TEST_SUITE_P(
    ShippedCase, Contradictions,
    testing::Values(
        Contradiction{"input.member=ring", ": input.member: 'ring' is the fixed member"},
        Contradiction{"gearset.planets=5", ": gearset.planets: found 5 equally spaced planets"},
        Contradiction{"gearset.teeth.ring=80", ": gearset.planets: "},
        Contradiction{"bearing.outside_diameter=60 mm", ": bearing.outside_diameter: found a planet bore"},
        Contradiction{"bearing.rollers=22", ": bearing.rollers: 22 rollers do not fit"},
        Contradiction{"bearing.cage.pocket_clearance=2.2 mm", ": bearing.cage.pocket_clearance: "},
        Contradiction{"bearing.bore=30.4 mm", ": bearing.bore: "},
        Contradiction{"bearing.outside_diameter=40.8 mm", ": bearing.outside_diameter: '40.8 mm'"},
        Contradiction{"bearing.pitch_diameter=5 mm", ": bearing.roller_diameter: "},
        Contradiction{"bearing.cage.inner_diameter=39 mm", ": bearing.cage.inner_diameter: "},
        Contradiction{"bearing.cage.inner_diameter=30 mm", ": bearing.cage.inner_diameter: "},
        Contradiction{"bearing.cage.outer_diameter=41 mm", ": bearing.cage.outer_diameter: "},
        Contradiction{"bearing.cage.guide_land_diameter=38 mm", ": bearing.cage.guide_land_diameter: "},
        Contradiction{"bearing.cage.guidance=inner", ": bearing.cage.guide_land_diameter: "},
        Contradiction{"bearing.cage.width=5.7 mm", ": bearing.cage.width: "},
        Contradiction{"bearing.roller_length=12 mm", ": bearing.roller_length: "},
        Contradiction{"bearing.per_planet=3", ": bearing.per_planet: "}));

// Figures of a public model of a 10 MW gearbox, stage 1, whose source prints the ring's shift as -0.1591 by
// DIN 3960.
const std::string kStage = R"(name: stage
source: made up
model: planetary-drivetrain
input: {member: carrier, power: 10 MW, speed: 9.6 rpm}
gearset:
  planets: 5
  teeth: {sun: 26, planet: 31, ring: 89}
  module: 30 mm
  helix_angle: 8 deg
  profile_shift: {sun: 0.2702, ring: 0.1591}
  face_width: 800 mm
  addendum: 0.9748
)";

TEST(StatedGeometry, IsCheckedAgainstWhatFollows) {
  EXPECT_THAT(mistakes(kStage, {"gearset.centre_distance=877.033 mm", "gearset.profile_shift.planet=0.2094"}), IsEmpty());
  EXPECT_THAT(mistakes(kStage, {"gearset.centre_distance=877.05 mm"}),
              ElementsAre(AllOf(HasSubstr("gearset.centre_distance: '877.05 mm'; 877.03"), HasSubstr("within 0.01 mm"))));
  EXPECT_THAT(mistakes(kStage, {"gearset.profile_shift.planet=0.22"}),
              ElementsAre(AllOf(HasSubstr("gearset.profile_shift.planet: '0.22'; 0.2"), HasSubstr("within 0.005"))));
  // They stay checks after settings of what they follow from.
  EXPECT_THAT(mistakes(kStage, {"gearset.centre_distance=877.033 mm", "gearset.module=31 mm"}),
              ElementsAre(HasSubstr("gearset.centre_distance")));
  EXPECT_THAT(parse_case(kStage, "case.yaml", {"gearset.centre_distance=877.033 mm"}).quantity("gearset.centre_distance"),
              testing::DoubleEq(0.877033));
}

TEST(StatedGeometry, NamesTheSignOfDin) {
  EXPECT_THAT(mistakes(kStage, {"gearset.centre_distance=877.033 mm", "gearset.profile_shift.ring=-0.1591"}),
              ElementsAre(AllOf(HasSubstr("872.39"), HasSubstr("DIN 3960"), HasSubstr("opposite sign, 0.1591, gives centre distance 877.03"))));
  const auto warnings = [](const std::vector<std::string>& settings) {
    const ResolvedCase in = parse_case(kStage, "case.yaml", settings);
    const analysis::StatedSet& set = stated_drivetrain(in).single();
    std::vector<std::string> texts;
    for (const gearset::Warning& warning : gearset::ring_sign_warnings(with_bore(set), set.geometry))
      texts.push_back(warning.key + ": " + warning.text);
    return texts;
  };
  EXPECT_THAT(warnings({}), IsEmpty());
  EXPECT_THAT(warnings({"gearset.profile_shift.ring=-0.1591"}),
              ElementsAre(AllOf(HasSubstr("DIN"), HasSubstr("opposite sign"), HasSubstr("872.39"), HasSubstr("877.03"))));
  EXPECT_THAT(warnings({"gearset.profile_shift.ring=-0.1591", "gearset.centre_distance=872.394 mm"}), IsEmpty());
}

TEST(StatedGeometry, TeethThatDoNotAddUpAreToBlameBeforeShifts) {
  const std::vector<std::string> found = mistakes(kStage, {"gearset.teeth.ring=99", "gearset.profile_shift.ring=0"});
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found, Contains(AllOf(HasSubstr("gearset.teeth.ring: found 99"), HasSubstr("26 + 2 x 31 = 88"))));
}

TEST(StatedGeometry, AnglesNearestToEqualStepsAreProposed) {
  const std::vector<std::string> four{"gearset.teeth={sun: 17, planet: 22, ring: 61}", "gearset.planets=4",
                                      "gearset.profile_shift={sun: 0, ring: 0}", "gearset.addendum=1.0"};
  EXPECT_THAT(mistakes(kStage, four),
              ElementsAre(HasSubstr("[0.0000 deg, 92.3077 deg, 180.0000 deg, 272.3077 deg] are nearest to equal steps")));
}

// A block that only a bearing needs is known, whether or not the set has one.
TEST(StatedGeometry, BlocksOfABearingSayThatTheyNeedOne) {
  for (const char* block : {"lubricant.viscosity=0.01 Pa.s", "life.reliability=0.9", "support.stiffness=1e9 N/m"})
    EXPECT_THAT(mistakes(kStage, {block}), ElementsAre(AllOf(HasSubstr("a field that a set without a bearing does not use"),
                                                           HasSubstr("with a bearing, is required"))))
        << block;
}

TEST(Consistency, AcceptsLimits) {
  EXPECT_THAT(setting_mistakes({"bearing.rollers=21", "bearing.cage.pocket_clearance=0.05 mm"}), IsEmpty());
  EXPECT_THAT(setting_mistakes({"bearing.width=14 mm"}), IsEmpty());
  EXPECT_THAT(setting_mistakes({"bearing.radial_clearance=-100 um"}), IsEmpty());
}

TEST(Consistency, PointsAtTheFile) {
  const std::string text = replaced(text_of(shipped_path()), "rollers: 15", "rollers: 25");
  EXPECT_THAT(mistakes(text),
              ElementsAre(StartsWith("case.yaml:25:12: bearing.rollers: 25 rollers do not fit")));
}

TEST(Consistency, IsLeftOutWhereValuesAreBad) {
  EXPECT_THAT(setting_mistakes({"bearing.rollers=many"}), ElementsAre(HasSubstr("not a whole number")));
}

TEST(Consistency, HoldsForChangedCopies) {
  const ResolvedCase resolved = shipped();
  EXPECT_THROW(resolved.with("bearing.rollers", "22"), BadInput);
  EXPECT_THROW(resolved.with("bearing.rollers", "many"), BadInput);
  EXPECT_THROW(resolved.with("bearing.nothing", "1"), BadInput);
  EXPECT_THROW(resolved.with("model", "roller-bearing"), BadInput);
  // Each alone is a contradiction, both together are not.
  EXPECT_THROW(resolved.with("gearset.planets", "3"), BadInput);
  EXPECT_NO_THROW(resolved.with({{"gearset.planets", "3"}, {"gearset.teeth.ring", "80"}}));
}

TEST(Consistency, WantsAWholeCageOrNone) {
  EXPECT_THAT(mistakes(bearing_case), IsEmpty());
  EXPECT_THAT(mistakes(bearing_case + "  cage:\n    width: 12 mm\n"),
              ElementsAre(HasSubstr("a cage without")));
}

// Each list of the carrier has as many values as its bearings or directions ask for, at the place where it is stated.
TEST(Consistency, ListsOfTheCarrierFitItsBearings) {
  const std::string carrier = "gearset.carrier.";
  const std::vector<std::string> sound{carrier + "bearing_positions=[-40 mm, 60 mm]",
                                       carrier + "bearing_stiffness=[1e8 N/m, 2e8 N/m]"};
  EXPECT_THAT(setting_mistakes(sound), IsEmpty());
  const struct {
    const char* list;
    const char* count;
  } wrong[]{{"bearing_stiffness=[1e8 N/m]", "a list of 1; 2 values are required"},
            {"bearing_clearance=[1 um, 2 um, 3 um]", "a list of 3; 2 values are required"},
            {"rotor_force=[1 N, 2 N]", "a list of 2; 3 values are required"},
            {"rotor_moment=[1 N.m, 2 N.m, 3 N.m]", "a list of 3; 2 values are required"},
            {"housing_stiffness=[1e9 N/m, 1e9 N/m]", "a list of 2; 36 values, 6 rows and columns"},
            {"bearing_positions=[1 mm]", "a list of 1; at least two bearings"}};
  for (const auto& one : wrong) {
    std::vector<std::string> settings = sound;
    settings.push_back(carrier + one.list);
    EXPECT_THAT(setting_mistakes(settings), Contains(HasSubstr(one.count))) << one.list;
  }
}

}  // namespace
}  // namespace orbearing::app::consistency_test
