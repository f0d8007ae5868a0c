// Cases that were written with former keys are still read; keys have the terms of the field now.
#include "app/case/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/case/case_file.hpp"
#include "app/case/field_table.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app {
namespace {

using testing::HasSubstr;

TEST(FormerKeys, PathsGetTheirPresentNames) {
  EXPECT_EQ(present_path("life.lambda"), "life.reduction_factor");
  EXPECT_EQ(present_path("sweep.life.lambda"), "sweep.life.reduction_factor");
  EXPECT_EQ(present_path("sets.first.bearing.outer_race.standing_form.order"),
            "sets.first.bearing.outer_race.out_of_roundness.order");
  EXPECT_EQ(present_path("assumed.bearing.inner_race.turning_form.amplitude"),
            "assumed.bearing.inner_race.waviness.amplitude");
  for (const char* path : {"life", "life.lambdas", "lambda", "input.speed", ""})
    EXPECT_EQ(present_path(path), path);
}

std::string with(std::string text, const std::string& present, const std::string& former) {
  for (std::size_t at = text.find(present); at != std::string::npos;
       at = text.find(present, at + former.size()))
    text.replace(at, present.size(), former);
  return text;
}

// A text with former names throughout is the same case, its reasons included.
TEST(FormerKeys, ACaseThatWasWrittenWithThemIsTheSameCase) {
  const std::string form = "bearing:\n  outer_race: {out_of_roundness: {order: [2], amplitude: [1 um]}}\n";
  const std::string now = with(text_of(shipped_path()), "\nbearing:\n", "\n" + form);
  const std::string before =
      with(with(now, "reduction_factor", "lambda"), "out_of_roundness", "standing_form");
  ASSERT_NE(now, before);
  const ResolvedCase present = parse_case(now, "case.yaml"), former = parse_case(before, "case.yaml");
  EXPECT_EQ(former.number("life.reduction_factor"), 0.83);
  EXPECT_EQ(former.assumed(), present.assumed());
  EXPECT_EQ(former.list("bearing.outer_race.out_of_roundness.amplitude"), std::vector{1e-6});
}

TEST(FormerKeys, ASettingReplacesWhatTheFileGivesByThePresentName) {
  EXPECT_EQ(shipped({"life.lambda=0.61"}).number("life.reduction_factor"), 0.61);
}

// The deprecation rule. A renamed key is read until the next major version, and each use of it is warned of
// with the present name.
TEST(FormerKeys, EachLeadsToAKeyOfTheTableAndIsNoneItself) {
  const auto has = [](const std::string& path) {
    return std::ranges::any_of(all_fields(), [&](const Field& field) {
      return field.path == path || field.path.starts_with(path + ".");
    });
  };
  ASSERT_FALSE(former_keys().empty());
  for (const FormerKey& key : former_keys()) {
    EXPECT_TRUE(has(key.present)) << key.present;
    EXPECT_FALSE(has(key.former)) << key.former;
  }
}

TEST(FormerKeys, EachUseIsWarnedOfWithThePresentName) {
  const std::string form = "bearing:\n  outer_race: {standing_form: {order: [2], amplitude: [1 um]}}\n";
  const std::string text = with(with(text_of(shipped_path()), "\nbearing:\n", "\n" + form),
                                "  reduction_factor: 0.83", "  lambda: 0.83");
  const ResolvedCase resolved =
      parse_case(text, "case.yaml", {"bearing.inner_race.turning_form={order: [3], amplitude: [1 um]}"});
  const auto warning = [](const std::string& former, const std::string& present) {
    return former + ": former name of " + present +
           "; write the present one. Versions 2 and later do not read the former name";
  };
  EXPECT_THAT(former_key_warnings(resolved),
              testing::UnorderedElementsAre(
                  warning("life.lambda", "life.reduction_factor"),
                  warning("bearing.outer_race.standing_form", "bearing.outer_race.out_of_roundness"),
                  warning("bearing.inner_race.turning_form", "bearing.inner_race.waviness")));
  EXPECT_THAT(require_used(resolved.without_sweep(), AnalysisId::monolithic),
              testing::Contains(warning("life.lambda", "life.reduction_factor")));
  EXPECT_THAT(former_key_warnings(shipped()), testing::IsEmpty());
}

TEST(FormerKeys, BothNamesInOneFileAreAMistake) {
  try {
    parse_case(
        "name: both\nsource: none\nmodel: roller-bearing\nlife: {lambda: 0.7, reduction_factor: 0.8}\n",
        "both.yaml", {});
    ADD_FAILURE();
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("life.lambda: unknown key"));
  }
}

}  // namespace
}  // namespace orbearing::app
