// Issue 45, Build 10: one function takes a request and gives what --json prints.
#include "app/commands/request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/case/case_file.hpp"
#include "app/errors.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::app::request_test {
namespace {

using testing::HasSubstr;

const std::string file = ORBEARING_SOURCE_DIR "/cases/harris_209/case.yaml";

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(Request, FileTextAndCaseGiveOneAnswer) {
  const std::vector<std::string> settings{"load.radial=5 kN"};
  const Answer by_file = answer({.command = "run", .case_file = file, .settings = settings});
  const Answer by_text = answer({.command = "run", .case_text = text_of(file), .settings = settings});
  const Answer by_case = answer({.command = "run", .given = read_case(file, settings)});
  EXPECT_EQ(by_file.code, 0);
  EXPECT_GT(by_file.result.at("L10_Mrev"), 1.0);
  EXPECT_EQ(by_text.result, by_file.result);
  EXPECT_EQ(by_case.result, by_file.result);
  EXPECT_NE(answer({.command = "run", .case_file = file}).result, by_file.result);
}

TEST(Request, OptionsAreThoseOfTheCommandLine) {
  const Request sensitivities{
      .command = "sensitivities",
      .case_file = file,
      .options = {{"result", "displacement/radial_um"}, {"by", {"load.radial", "bearing.roller_diameter"}}, {"jobs", 2}}};
  const nlohmann::ordered_json result = answer(sensitivities).result;
  EXPECT_EQ(result.at("inputs").size(), 1U);
  EXPECT_EQ(result.at("without_effect").size(), 1U);
}

std::string refusal(const Request& request) {
  try {
    answer(request);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "taken";
}

TEST(Request, RefusesWhatNoCommandTakes) {
  EXPECT_THAT(refusal({.command = "fly"}), HasSubstr("found the command fly; required: check, run"));
  EXPECT_THAT(refusal({.command = "run", .case_file = file, .options = {{"moon", 1}}}), HasSubstr("--moon=1"));
  EXPECT_THAT(refusal({.command = "run", .case_file = file, .options = {{"fidelity", "fast"}}}), HasSubstr("fast not in"));
  EXPECT_THAT(refusal({.command = "run", .case_text = "name: x\nmodel: ball"}), HasSubstr("case.yaml:2:8: model"));
}

// A caller who wants no more ends the computation, and the next request runs as ever.
TEST(Request, ProgressStopsIt) {
  Request sweep{.command = "sweep", .case_file = ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", .options = {{"grid_only", true}, {"jobs", 1}}};
  std::size_t most = 0;
  sweep.progress = [&](std::size_t, std::size_t all, const std::string&) {
    most = all;
    return false;
  };
  EXPECT_ANY_THROW(answer(sweep));
  EXPECT_EQ(most, 12U);
  EXPECT_FALSE(stop_requested());
  sweep.progress = [](std::size_t, std::size_t, const std::string&) { return true; };
  EXPECT_EQ(answer(sweep).result.at("points").size(), 12U);
}

}  // namespace
}  // namespace orbearing::app::request_test
