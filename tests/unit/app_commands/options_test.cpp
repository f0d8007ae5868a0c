// Options of every command: words of the command line and a JSON object fill one structure by its rows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "app/commands/command_line.hpp"
#include "app/errors.hpp"
#include "app/options/option_json.hpp"

namespace orbearing::app::options_test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

// A permitted value other than the default.
Json sample(const Option& option) {
  if (is_switch(option)) return true;
  if (!option.details.choices.empty()) return option.details.choices.back();
  if (option.details.range) return option.details.range->most;
  if (is_list(option)) return Json{"load.radial=[1 N, 2 N]", "b=2"};
  return std::holds_alternative<std::string*>(option.member) ? Json("4 um, 5 um") : Json(7);
}

// As a user types it; a whole number without a point.
std::string word_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  const auto number = value.get<double>();
  return number == std::floor(number) ? std::to_string(static_cast<std::int64_t>(number)) : value.dump();
}

void add_words(const Option& option, const Json& value, std::vector<std::string>& words) {
  for (const Json& one : value.is_array() ? value : Json::array({value}))
    words.push_back(is_positional(option) ? word_of(one)
                    : is_switch(option)   ? long_name(option)
                                          : long_name(option) + "=" + word_of(one));
}

// All values of a command's options, by names.
std::map<std::string, Json> values_of(CommandRequest& request) {
  std::map<std::string, Json> values;
  for (const Option& option : option_list(request))
    values[long_name(option)] = json_of({option}).begin().value();
  return values;
}

TEST(Options, WordsAndJsonFillTheSameMembers) {
  for (CommandRequest& by_json : all_commands()) {
    SCOPED_TRACE(name_of(by_json));
    std::vector<std::string> words{name_of(by_json)};
    Json object;
    for (const Option& option : option_list(by_json)) {
      Json value = sample(option);
      add_words(option, value, words);
      if (value.is_number() && !std::holds_alternative<double*>(option.member))
        value = Json::parse(word_of(value));
      const std::string key = json_of({option}).begin().key();
      EXPECT_FALSE(object.contains(key)) << key;
      object[key] = value;
    }
    put_json(object, option_list(by_json));
    CommandRequest by_words = request_of_words(words);
    EXPECT_EQ(by_words.index(), by_json.index());
    EXPECT_EQ(values_of(by_words), values_of(by_json));
    CommandRequest with_defaults = command_called(name_of(by_json));
    for (const auto& [name, value] : values_of(with_defaults))
      EXPECT_NE(values_of(by_json).at(name), value) << name;
  }
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "taken";
}

std::string refused_word(const std::string& command, const std::vector<std::string>& words) {
  std::vector<std::string> all{command, "case.yaml"};
  all.insert(all.end(), words.begin(), words.end());
  return refusal([&] { request_of_words(all); });
}

std::string refused_json(const std::string& command, const Json& object) {
  return refusal([&] {
    CommandRequest request = command_called(command);
    put_json(object, option_list(request), {"CASE"});
  });
}

TEST(Options, BothWaysRefuseTheSameValues) {
  const std::vector<std::tuple<const char*, const char*, const char*, Json>> all{
      {"sweep", "--jobs", "jobs", 0},          {"sweep", "--jobs", "jobs", 4097},
      {"sweep", "--jobs", "jobs", 2.5},        {"sweep", "--jobs", "jobs", "0x10"},
      {"sweep", "--jobs", "jobs", "many"},     {"table", "--bound", "bound", 1.5},
      {"table", "--bound", "bound", "nan"},    {"sweep", "--fidelity", "fidelity", "fast"},
      {"sweep", "--fidelity", "fidelity", " "}, {"crown", "--of", "of", " "},
      {"signals", "--seed", "seed", -1},       {"signals", "--seed", "seed", "1234567890123456789"},
      {"signals", "--seed", "seed", 1},        {"sweep", "--moon", "moon", 1}};
  for (const auto& [command, option, key, value] : all) {
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    const std::string said = refused_word(command, {std::string(option) + "=" + text});
    EXPECT_THAT(said, HasSubstr(option));
    if (std::string(key) == "seed" && value != 1) continue;  // it lacks the noise besides
    EXPECT_EQ(refused_json(command, {{key, value}}), said);
  }
  EXPECT_THAT(refused_json("signals", {{"seed", -1}}),
              HasSubstr("--seed: found '-1'; required: a whole number from 0"));
}

TEST(Options, JsonNamesEveryMistakeAtOnce) {
  EXPECT_EQ(refused_json("merge", {{"jobs", true}, {"grid_only", 1}, {"output", {"a", "b"}}}),
            "--jobs: found 'true'; required: a whole number of at most 18 digits\n"
            "--grid-only: found '1'; required: true or false\n"
            "--output: found 2 values; required: one\n"
            "DIR is required");
}

TEST(Options, NullAndFalseLeaveTheDefault) {
  CommandRequest request = command_called("sweep");
  put_json({{"jobs", nullptr}, {"grid_only", false}, {"fidelity", Json::array()}}, option_list(request),
           {"CASE"});
  const auto& sweep = std::get<SweepOptions>(request);
  EXPECT_EQ(sweep.jobs, 0);
  EXPECT_FALSE(sweep.grid_only);
  EXPECT_EQ(sweep.fidelity, "");
}

// Options that do not go together are refused before a case is read.
TEST(Options, WhatExcludesEachOtherIsRefusedFirst) {
  SweepOptions sweep{
      .print = {.json = true}, .stated = {.file = "none.yaml"}, .jobs = 2, .shard = "1/2", .direction = "up"};
  EXPECT_EQ(problems(sweep).size(), 2U);
  EXPECT_THAT(refusal([&] { execute(CommandRequest(sweep)); }), HasSubstr("--continue: found with --shard"));
  sweep.shard.clear();
  sweep.jobs = 1;
  EXPECT_THAT(problems(sweep), testing::IsEmpty());
}

}  // namespace
}  // namespace orbearing::app::options_test
