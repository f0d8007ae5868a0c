// The public interface, and the one function that takes a request and returns the output of --json.
#include "orbearing/request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "mechanics/cancellation.hpp"
#include "orbearing/participant.hpp"
#include "orbearing/sweep.hpp"
#include "tests/messages.hpp"

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
  const Answer by_case = answer({.command = "run", .given = Case::read(file, settings)});
  EXPECT_EQ(by_file.code, 0);
  EXPECT_GT(nlohmann::json::parse(by_file.result).at("L10_Mrev"), 1.0);
  EXPECT_EQ(by_text.result, by_file.result);
  EXPECT_EQ(by_case.result, by_file.result);
  EXPECT_NE(answer({.command = "run", .case_file = file}).result, by_file.result);
}

TEST(Request, OptionsAreThoseOfTheCommandLine) {
  const Request sensitivities{
      .command = "sensitivities",
      .case_file = file,
      .options = R"({"result": "displacement/radial_um", "by": ["load.radial", "bearing.roller_diameter"], "jobs": 2})"};
  const nlohmann::ordered_json result = nlohmann::ordered_json::parse(answer(sensitivities).result);
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
  EXPECT_THAT(refusal({.command = "fly"}),
              HasSubstr("found the command fly; required: demo, new, open, check, run"));
  EXPECT_THAT(refusal({.command = "run", .case_file = file, .options = R"({"moon": 1})"}), HasSubstr("--moon=1"));
  EXPECT_THAT(refusal({.command = "run", .case_file = file, .options = R"({"fidelity": "fast"})"}), HasSubstr("fast not in"));
  EXPECT_REFUSED(BadInput, "interface.options", answer({.command = "run", .case_file = file, .options = "moon"}));
  EXPECT_REFUSED(BadInput, "interface.case", answer({.command = "merge", .case_file = file}));
  EXPECT_REFUSED(BadInput, "interface.case in memory", answer({.command = "validate", .given = Case::read(file)}));
  EXPECT_REFUSED(BadInput, "interface.settings", answer({.command = "run", .given = Case::read(file), .settings = {"load.radial=5 kN"}}));
  EXPECT_THAT(refusal({.command = "run", .case_text = "name: x\nmodel: ball"}), HasSubstr("case.yaml:2:8: model"));
}

TEST(PublicInterface, CaseAndPoints) {
  const Case reducer = Case::read(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml");
  EXPECT_EQ(reducer.with("input.power", "75 kW").number("input.power"), 75e3);
  EXPECT_EQ(reducer.with("input.power", 75e3).text("input.power"), "75000 W");
  EXPECT_FALSE(reducer.has("input.moon"));
  EXPECT_REFUSED(BadInput, "interface.number", reducer.number("name"));
  EXPECT_REFUSED(BadInput, "interface.text", reducer.text("input.moon"));
  EXPECT_REFUSED(BadInput, "interface.rung", evaluate(reducer, {"input.power"}, {}, "fast"));
  EXPECT_REFUSED(BadInput, "interface.values", evaluate(reducer, {"input.power", "input.speed"}, {1.0, 2.0, 3.0}));
  const Points points = evaluate(reducer, {"input.power"}, {150e3, 75e3, -1.0});
  ASSERT_EQ(points.status.size(), 3U);
  EXPECT_EQ(points.numbers.size(), 3 * points.columns.size());
  const auto at = [&](std::size_t point, const std::string& column) {
    const auto found = std::find(points.columns.begin(), points.columns.end(), column);
    return points.numbers.at(point * points.columns.size() + static_cast<std::size_t>(found - points.columns.begin()));
  };
  EXPECT_NEAR(at(1, "tangential_load_N"), 0.5 * at(0, "tangential_load_N"), 1e-9 * at(0, "tangential_load_N"));
  EXPECT_EQ(points.status.front(), "ok");
  EXPECT_THAT(points.status.back(), HasSubstr("input.power"));
}

// Advanced in one step or in two, a bearing arrives at one state; a state that is restored continues equally.
TEST(PublicInterface, Participants) {
  const Case reducer = Case::read(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml");
  Participant bearing = Participant::bearing(reducer);
  bearing.advance(1e-5);
  const std::vector<double> state = bearing.save();
  bearing.advance(1e-5);
  const std::vector<double> there = bearing.values();
  EXPECT_DOUBLE_EQ(bearing.time(), 2e-5);
  bearing.restore(state);
  EXPECT_DOUBLE_EQ(bearing.time(), 1e-5);
  bearing.advance(1e-5);
  EXPECT_EQ(bearing.values(), there);
  ASSERT_FALSE(bearing.outputs().empty());
  EXPECT_EQ(bearing.output(bearing.outputs().back().name), there.back());
  EXPECT_EQ(Participant::gearset(reducer).time(), 0.0);
}

// A caller can end the computation by its progress function, and the next request runs as usual.
TEST(Request, ProgressStopsIt) {
  Request sweep{.command = "sweep", .case_file = ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", .options = R"({"grid_only": true, "jobs": 1})"};
  std::size_t most = 0;
  sweep.progress = [&](std::size_t, std::size_t all, const std::string&) {
    most = all;
    return false;
  };
  EXPECT_ANY_THROW(answer(sweep));
  EXPECT_EQ(most, 12U);
  EXPECT_FALSE(stop_requested());
  sweep.progress = [](std::size_t, std::size_t, const std::string&) { return true; };
  EXPECT_EQ(nlohmann::json::parse(answer(sweep).result).at("points").size(), 12U);
}

// A caller receives the progress of a motion.
TEST(Request, TellsHowFarAMotionIs) {
  Request run{.command = "run",
              .case_file = ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml",
              .settings = {"gearset.mesh_variation=false", "simulation.observed_revolutions=40"},
              .options = R"({"fidelity": "dynamic"})"};
  std::vector<nlohmann::json> told;
  run.motion = [&](const std::string& motion) { told.push_back(nlohmann::json::parse(motion)); };
  EXPECT_EQ(answer(run).code, 0);
  ASSERT_GT(told.size(), 1U);
  EXPECT_TRUE(told.front().at("seconds_left").is_null());
  EXPECT_TRUE(told.back().at("seconds_left").is_number());
  EXPECT_NEAR(told.back().at("share"), told.back().at("time_s").get<double>() / told.back().at("expected_s").get<double>(), 1e-12);
}

}  // namespace
}  // namespace orbearing::app::request_test
