#include "app/commands/plain_commands.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "app/case/case_file.hpp"
#include "app/case/machines.hpp"
#include "app/commands/commands.hpp"
#include "app/errors.hpp"
#include "tests/messages.hpp"

namespace orbearing::app {
namespace {

/// A word that machines alone have: that of the meshes of a pair of gears.
struct PairWord {
  static constexpr const char* command = "mesh";
  static constexpr const char* purpose = "";
};

int result_of(const std::string& name, nlohmann::ordered_json& found) {
  PlainCommand<PairWord> command;
  command.print = {.json = true, .to = {.result = [&](const auto& object) { found = object; }}};
  std::ifstream file(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  command.stated.given = parse_case(text, "case.yaml");
  return execute(command);
}

TEST(PlainCommand, WithoutAFunctionHasTheAnalysisOfTheMachine) {
  nlohmann::ordered_json found;
  EXPECT_EQ(result_of("mesh_62_62", found), 0);
  EXPECT_TRUE(found.contains("warnings"));
  EXPECT_GT(found.size(), 4u);
}

TEST(PlainCommand, RefusesAMachineWithoutTheAnalysis) {
  nlohmann::ordered_json found;
  EXPECT_REFUSED(BadInput, "word of another machine", result_of("harris_209", found));
}

// A row of a machine whose word is no command would never be asked.
TEST(PlainCommand, EachWordOfMachinesIsACommand) {
  EXPECT_FALSE(machine_analyses().empty());
  for (const MachineAnalysis& one : machine_analyses())
    EXPECT_NO_THROW(command_called(std::string(one.command)));
  EXPECT_THROW(command_called("statics"), BadInput);
}

}  // namespace
}  // namespace orbearing::app
