#include "app/case/sweep_axes.hpp"

#include <gmock/gmock.h>

#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::sweep_axes_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::StartsWith;

using Texts = std::vector<std::pair<std::string, std::string>>;

Texts texts_of_point(const ResolvedCase& resolved, std::size_t index) {
  Texts texts;
  for (const Setting& one : sweep_point(resolved, index)) texts.emplace_back(one.path, one.text);
  return texts;
}

std::vector<std::string> speeds(const std::string& axis) {
  return shipped({"sweep={}", "sweep.input.speed=" + axis}).axes().at(0).values;
}

TEST(SweepAxes, StepInTheUnitAsWritten) {
  EXPECT_THAT(speeds("{from: 1000 rpm, to: 3000 rpm, step: 1000 rpm}"),
              ElementsAre("1000 rpm", "2000 rpm", "3000 rpm"));
  EXPECT_THAT(speeds("{from: 100 rad/s, to: 0.3 krad/s, step: 100 rad/s}").size(), 3U);
}

TEST(SweepAxes, ReachTheEndDespiteRounding) {
  // 0.1 and 0.3 are not binary fractions: (0.3 - 0) / 0.1 lies below 3.
  EXPECT_EQ(speeds("{from: 0.1 rpm, to: 0.7 rpm, step: 0.1 rpm}").size(), 7U);
  EXPECT_EQ(speeds("{from: 5 rpm, to: 5 rpm, step: 1 rpm}").size(), 1U);
}

TEST(SweepAxes, MakeEveryCombinationFirstAxisSlowest) {
  const ResolvedCase resolved = shipped(
      {"sweep={}", "sweep.input.power=[75 kW, 150 kW]", "sweep.bearing.rollers={from: 13, to: 15, step: 1}"});
  ASSERT_EQ(sweep_size(resolved), 6U);
  EXPECT_THAT(texts_of_point(resolved, 0),
              ElementsAre(Pair("input.power", "75 kW"), Pair("bearing.rollers", "13")));
  EXPECT_THAT(texts_of_point(resolved, 2),
              ElementsAre(Pair("input.power", "75 kW"), Pair("bearing.rollers", "15")));
  EXPECT_THAT(texts_of_point(resolved, 3),
              ElementsAre(Pair("input.power", "150 kW"), Pair("bearing.rollers", "13")));
}

TEST(SweepAxes, SetTheValuesOfAPoint) {
  const ResolvedCase resolved = shipped();
  const ResolvedCase point = resolved.with(sweep_point(resolved, 2));
  EXPECT_EQ(point.given("input.speed"), "3000 rpm");
  EXPECT_EQ(resolved.given("input.speed"), "6000 rpm");
}

std::vector<std::string> axis_mistakes(const std::string& path, const std::string& axis) {
  return setting_mistakes({"sweep={}", "sweep." + path + "=" + axis});
}

TEST(SweepAxes, ReportMistakes) {
  EXPECT_THAT(axis_mistakes("input.sped", "[1 rpm]"), ElementsAre(HasSubstr("did you mean 'input.speed'?")));
  EXPECT_THAT(axis_mistakes("input", "[1 rpm]"),
              ElementsAre(HasSubstr("the whole path, as in 'input.power'")));
  EXPECT_THAT(axis_mistakes("gearset.fixed", "[sun]"), ElementsAre(HasSubstr("no number")));
  EXPECT_THAT(axis_mistakes("input.speed", "3 rpm"), ElementsAre(HasSubstr("a list of values or {from")));
  EXPECT_THAT(axis_mistakes("input.speed", "[]"), ElementsAre(HasSubstr("an empty list")));
  EXPECT_THAT(axis_mistakes("input.speed", "[1 rpm, 1 rpm, 2 mm]"),
              ElementsAre(HasSubstr("is listed twice"), HasSubstr("does not measure")));
  EXPECT_THAT(axis_mistakes("input.speed", "{from: 1 rpm, stop: 3 rpm}"),
              ElementsAre(HasSubstr("unknown key"), HasSubstr("speed.to: missing"),
                          HasSubstr("speed.step: missing")));
  EXPECT_THAT(axis_mistakes("input.speed", "{from: 1 rpm, to: 3 rpm, step: 0 rpm}"),
              ElementsAre(AllOf(HasSubstr("speed.step"), HasSubstr("greater than 0 rpm"))));
  EXPECT_THAT(axis_mistakes("input.speed", "{from: 3 rpm, to: 1 rpm, step: 1 rpm}"),
              ElementsAre(HasSubstr("less than 'from'")));
  EXPECT_THAT(axis_mistakes("input.speed", "{from: 0 rpm, to: 1 rpm, step: 1 rpm}"),
              ElementsAre(HasSubstr("speed.from")));
}

TEST(SweepAxes, WantAStepThatReachesTheEnd) {
  EXPECT_THAT(
      axis_mistakes("input.speed", "{from: 1000 rpm, to: 12000 rpm, step: 7777 rpm}"),
      ElementsAre(AllOf(StartsWith("--set: sweep.input.speed.step: '7777 rpm' leads past 'to', '12000 rpm'"),
                        HasSubstr("such as '11000 rpm', or 'to: 8777 rpm'"))));
  // A step wider than the range reaches its start only.
  EXPECT_THAT(axis_mistakes("input.speed", "{from: 1 rpm, to: 2 rpm, step: 5 rpm}"),
              ElementsAre(HasSubstr("such as '1 rpm', or 'to: 1 rpm'")));
  EXPECT_THAT(axis_mistakes("bearing.rollers", "{from: 10, to: 15, step: 2}"),
              ElementsAre(HasSubstr("divides the range, or 'to: 14'")));
}

TEST(SweepAxes, LimitTheNumberOfPoints) {
  EXPECT_THAT(axis_mistakes("input.speed", "{from: 1 rpm, to: 100000 rpm, step: 1 rpm}"), IsEmpty());
  EXPECT_THAT(axis_mistakes("input.speed", "{from: 1 rpm, to: 100001 rpm, step: 1 rpm}"),
              ElementsAre(HasSubstr("too many points")));
  EXPECT_THAT(axis_mistakes("input.speed", "{from: 1 rpm, to: 2 rpm, step: 1e-300 rpm}"),
              ElementsAre(HasSubstr("too many points")));
  EXPECT_THAT(
      setting_mistakes({"sweep.input.speed.step=1 rpm", "sweep.bearing.rollers={from: 3, to: 14, step: 1}"}),
      ElementsAre(HasSubstr("132012 operating points")));
}

// A point takes numbers that were read once: they equal those that the reader reads from the texts, to the
// bit.
TEST(SweepAxes, NumbersOfAPointAreThoseOfItsTexts) {
  const ResolvedCase resolved =
      shipped({"sweep={}", "sweep.input.speed={from: 0.1 krpm, to: 0.7 krpm, step: 0.1 krpm}",
               "sweep.bearing.radial_clearance=[5 um, 0.0123 mm]"});
  for (std::size_t i = 0; i < sweep_size(resolved); ++i) {
    const ResolvedCase point = resolved.with(sweep_point(resolved, i));
    for (const auto& [path, text] : texts_of_point(resolved, i)) {
      EXPECT_EQ(point.quantity(path), resolved.with(path, text).quantity(path)) << path << " = " << text;
      EXPECT_EQ(point.given(path), text);
    }
  }
  const ResolvedCase at = resolved.with({input_speed(74.45)});
  EXPECT_EQ(at.quantity("input.speed"), resolved.with("input.speed", "74.45 rpm").quantity("input.speed"));
  EXPECT_EQ(at.given("input.speed"), "74.45 rpm");
}

// Every combination of the axes once, the first axis slowest.
TEST(SweepAxes, PointsAreAllCombinations) {
  const ResolvedCase resolved = shipped({"sweep={}", "sweep.input.speed=[1000 rpm, 2000 rpm, 3000 rpm]",
                                         "sweep.bearing.rollers=[13, 14]",
                                         "sweep.bearing.radial_clearance=[0 um, 5 um, 10 um, 15 um, 20 um]"});
  ASSERT_EQ(sweep_size(resolved), 30U);
  std::size_t index = 0;
  for (const char* speed : {"1000 rpm", "2000 rpm", "3000 rpm"})
    for (const char* rollers : {"13", "14"})
      for (const char* clearance : {"0 um", "5 um", "10 um", "15 um", "20 um"}) {
        const Texts expected{
            {"input.speed", speed}, {"bearing.rollers", rollers}, {"bearing.radial_clearance", clearance}};
        EXPECT_EQ(texts_of_point(resolved, index), expected) << "point " << index;
        ++index;
      }
}

TEST(SweepAxes, ReportDuplicateAxes) {
  const std::string axis = "  input.speed: [1 rpm]\n";
  const std::string text = replaced(text_of(shipped_path()), "sweep:\n", "sweep:\n" + axis);
  EXPECT_THAT(mistakes(text), ElementsAre(StartsWith("case.yaml:10:3: sweep.input.speed: duplicate key")));
}

}  // namespace
}  // namespace orbearing::app::sweep_axes_test
