#include "app/case/consistency.hpp"

#include <gmock/gmock.h>

#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::sweep_consistency_test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

TEST(SweepConsistency, ReportsEveryBadValueOfAnOption) {
  // 37 + 79 teeth can be shared among 4 planets only.
  EXPECT_THAT(setting_mistakes({"sweep.gearset.planets=[3, 4, 5, 7]"}),
              ElementsAre(StartsWith("--set: sweep.gearset.planets: found 3 equally spaced planets"),
                          StartsWith("--set: sweep.gearset.planets: found 5 equally spaced planets"),
                          StartsWith("--set: sweep.gearset.planets: found 7 equally spaced planets")));
}

TEST(SweepConsistency, PointsAtTheValueInTheFile) {
  const std::string text =
      replaced(text_of(shipped_path()), "sweep:\n", "sweep:\n  gearset.planets: [3, 4, 5]\n");
  EXPECT_THAT(mistakes(text), ElementsAre(StartsWith("case.yaml:9:21: sweep.gearset.planets: found 3"),
                                          StartsWith("case.yaml:9:27: sweep.gearset.planets: found 5")));
}

TEST(SweepConsistency, ReportsMistakesOfEveryKindTogether) {
  EXPECT_THAT(setting_mistakes({"sweep.gearset.planets=[3.5, 29, 5]", "sweep.bearing.rollers=[15, 25]"}),
              ElementsAre(HasSubstr("planets: '3.5' is not a whole number"),
                          HasSubstr("planets: '29' is out of range"), HasSubstr("planets: found 5"),
                          StartsWith("--set: sweep.bearing.rollers: 25 rollers do not fit")));
}

TEST(SweepConsistency, NamesTheValueThatIsContradicted) {
  EXPECT_THAT(
      setting_mistakes({"sweep.bearing.pitch_diameter=[29 mm, 35.64 mm]"}),
      ElementsAre(AllOf(StartsWith("--set: sweep.bearing.pitch_diameter: "),
                        HasSubstr("'29 mm' contradicts bearing.bore: '25 mm' does not fit; a bore within")),
                  HasSubstr("'29 mm' contradicts bearing.cage.outer_diameter")));
}

TEST(SweepConsistency, LooksAtPointsOfTheSweepOnly) {
  // Three planets need other teeth than the case's own; both axes together are sound.
  EXPECT_THAT(setting_mistakes({"sweep.gearset.planets=[3]", "sweep.gearset.teeth.ring=[80]"}), IsEmpty());
}

TEST(SweepConsistency, BlamesNoAxisForAnother) {
  for (const auto& settings :
       {std::vector<std::string>{"sweep.bearing.rollers=[14, 15]", "sweep.gearset.planets=[3]"},
        {"sweep.gearset.planets=[3]", "sweep.bearing.rollers=[14, 15]"}})
    EXPECT_THAT(setting_mistakes(settings), ElementsAre(StartsWith("--set: sweep.gearset.planets: found 3")));
}

TEST(SweepConsistency, DoesNotRepeatTheMistakesOfTheCase) {
  EXPECT_THAT(setting_mistakes({"gearset.planets=5", "sweep.bearing.rollers=[14, 15]"}),
              ElementsAre(StartsWith("--set: gearset.planets: found 5")));
}

TEST(SweepConsistency, CountsManyMistakes) {
  const std::vector<std::string> lines =
      setting_mistakes({"sweep.bearing.rollers={from: 15, to: 115, step: 1}"});
  ASSERT_THAT(lines, SizeIs(21));  // the first twenty, and how many more
  EXPECT_THAT(lines, Each(StartsWith("--set: sweep.bearing.rollers: ")));
  EXPECT_THAT(lines.back(), HasSubstr("more contradictions"));
}

}  // namespace
}  // namespace orbearing::app::sweep_consistency_test
