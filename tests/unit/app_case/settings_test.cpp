#include "app/case/settings.hpp"

#include <gmock/gmock.h>

#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::settings_test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Settings, ReplaceValuesOfEveryKind) {
  const ResolvedCase resolved = shipped(
      {"bearing.radial_clearance=37 um", "film.enabled=true", "gearset.teeth={sun: 37, planet: 22, ring: 83}",
       "inertia.coriolis=false", "input.power= 75 kW", "name=two: words [and more"});
  EXPECT_EQ(resolved.given("bearing.radial_clearance"), "37 um");
  EXPECT_EQ(resolved.origin("bearing.radial_clearance"), "--set");
  EXPECT_TRUE(resolved.flag("film.enabled"));
  EXPECT_EQ(resolved.integer("gearset.teeth.ring"), 83);
  EXPECT_FALSE(resolved.flag("inertia.coriolis"));
  EXPECT_EQ(resolved.quantity("input.power"), 75e3);
  EXPECT_EQ(resolved.text("name"), "two: words [and more");
}

TEST(Settings, TheLaterOneHolds) {
  EXPECT_EQ(shipped({"input.power=1 kW", "input.power=2 kW"}).quantity("input.power"), 2e3);
}

TEST(Settings, DropTheReasonOfTheValueTheyReplace) {
  EXPECT_TRUE(shipped().assumed().contains("bearing.radial_clearance"));
  EXPECT_FALSE(shipped({"bearing.radial_clearance=37 um"}).assumed().contains("bearing.radial_clearance"));
  const ResolvedCase reasoned =
      shipped({"bearing.radial_clearance=37 um", "assumed.bearing.radial_clearance=a: b"});
  EXPECT_EQ(reasoned.assumed().at("bearing.radial_clearance"), "a: b");
}

TEST(Settings, ReachTheSweep) {
  EXPECT_EQ(sweep_size(shipped({"sweep.input.speed.step=500 rpm"})), 23U);
  EXPECT_EQ(sweep_size(shipped({"sweep.input.speed={from: 1000 rpm, to: 2000 rpm, step: 250 rpm}"})), 5U);
  EXPECT_EQ(sweep_size(shipped({"sweep.input.speed=[1000 rpm, 3000 rpm]"})), 2U);
  EXPECT_EQ(sweep_size(shipped({"sweep.input.power=[75 kW, 150 kW]"})), 24U);
  EXPECT_EQ(sweep_size(shipped({"sweep={}"})), 1U);
}

TEST(Settings, ReportMalformedOnesTogether) {
  EXPECT_THAT(setting_mistakes({"input.power", "=3", "a..b=3", "input.powr=3 kW", "bearing.width=]"}),
              ElementsAre(StartsWith("--set: input.power: 'input.power' has no '='"),
                          AllOf(StartsWith("--set: (option): "), HasSubstr("no complete path")),
                          StartsWith("--set: a..b: "),
                          AllOf(StartsWith("--set: input.powr: unknown key"), HasSubstr("'input.power'")),
                          StartsWith("--set: bearing.width: ")));
}

// Bytes that are not UTF-8 must not reach the writer of JSON.
TEST(Settings, MustBeText) {
  EXPECT_THAT(setting_mistakes({"name=\xff"}), ElementsAre(HasSubstr("--set: name: a byte that is not UTF-8")));
  EXPECT_THAT(setting_mistakes({"name=a\x1b[31m"}), ElementsAre(HasSubstr("--set: name: a control character")));
  EXPECT_THAT(setting_mistakes({"name=a: b [c"}), IsEmpty());
}

TEST(Settings, ReportBadValues) {
  EXPECT_THAT(setting_mistakes({"gearset.teeth=[37, 22, 79]"}),
              ElementsAre(StartsWith("--set: gearset.teeth: a list found; a block")));
  EXPECT_THAT(setting_mistakes({"gearset.teeth.sun.x=3"}),
              ElementsAre(HasSubstr("gearset.teeth.sun: a block found")));
  EXPECT_THAT(setting_mistakes({"input.power="}),
              ElementsAre(StartsWith("--set: input.power: nothing found")));
  EXPECT_THAT(setting_mistakes({"assumed.film=x"}),
              ElementsAre(StartsWith("--set: assumed.film: unknown path")));
  EXPECT_THAT(setting_mistakes({"sweep=3"}), ElementsAre(HasSubstr("sweep: '3' found")));
  EXPECT_THAT(setting_mistakes({"bearing.cage.width=9.5 mm"}), IsEmpty());
}

TEST(Settings, AreToBlameForWhatTheFileAloneDoesNotHave) {
  // Keys missing from a replaced block, a ring that no longer fits, a model without the fields. The file's
  // reasons for values that the option removed are attributed to the option as well.
  EXPECT_THAT(setting_mistakes({"bearing={rollers: 14}"}),
              Each(AnyOf(StartsWith("--set: bearing."), StartsWith("--set: assumed.bearing."))));
  EXPECT_THAT(setting_mistakes({"bearing={rollers: 14}"}),
              Contains(StartsWith("--set: bearing.type: missing")));
  EXPECT_THAT(setting_mistakes({"bearing.pitch_diameter=29 mm"}),
              Contains(StartsWith("--set: bearing.bore: '25 mm' does not fit")));
  EXPECT_THAT(setting_mistakes({"model=roller-bearing"}), Each(StartsWith("--set: ")));
  EXPECT_THAT(setting_mistakes({"bearing={rollers: 14, rollers: 15}"}),
              Contains("--set: bearing.rollers: duplicate key; each key once is required"));
}

TEST(Settings, LeaveTheFileItsOwnMistakes) {
  EXPECT_THAT(mistakes(replaced(bearing_case, "10 mm", "10 kg"), {"bearing.rollers=two"}),
              ElementsAre(StartsWith("case.yaml:9:20: bearing.roller_diameter"),
                          StartsWith("--set: bearing.rollers")));
}

TEST(Settings, AreCheckedEvenIfTheFileIsNoYaml) {
  EXPECT_THAT(mistakes("a: 'b", {"nothing"}),
              ElementsAre(StartsWith("case.yaml:1:6: (file)"), StartsWith("--set")));
}

}  // namespace
}  // namespace orbearing::app::settings_test
