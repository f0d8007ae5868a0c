#include "app/case/consistency.hpp"

#include <gmock/gmock.h>

#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::consistency_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// One setting that contradicts the rest of the shipped case, and where the objection goes.
struct Contradiction {
  const char* setting;
  const char* objection;
};

class Contradictions : public testing::TestWithParam<Contradiction> {};

TEST_P(Contradictions, AreReported) {
  EXPECT_THAT(setting_mistakes({GetParam().setting}), Contains(HasSubstr(GetParam().objection)));
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

TEST(Consistency, AcceptsLimits) {
  EXPECT_THAT(setting_mistakes({"bearing.rollers=21", "bearing.cage.pocket_clearance=0.05 mm"}), IsEmpty());
  EXPECT_THAT(setting_mistakes({"bearing.width=14 mm"}), IsEmpty());
  EXPECT_THAT(setting_mistakes({"bearing.radial_clearance=-100 um"}), IsEmpty());
}

TEST(Consistency, PointsAtTheFile) {
  const std::string text = replaced(text_of(shipped_path()), "rollers: 15", "rollers: 25");
  EXPECT_THAT(mistakes(text),
              ElementsAre(StartsWith("case.yaml:24:12: bearing.rollers: 25 rollers do not fit")));
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

}  // namespace
}  // namespace orbearing::app::consistency_test
