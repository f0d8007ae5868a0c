// cases/result.schema.json: what each command prints, from the records of results of shipped cases.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands/command_line.hpp"
#include "app/results/record_writers.hpp"

namespace orbearing::app::result_schema_test {
namespace {

using Json = nlohmann::ordered_json;

/// One result that its schema is made of.
struct Look {
  std::string name;                  // its command, and which of its results
  std::string of;                    // folder of the case
  std::vector<std::string> words{};  // of the command line besides
};

// All analyses at least once, with what only some cases have, in few steps.
const std::vector<Look>& looks() {
  static const std::vector<Look> all{
      {"check", "reducer_150kW_as_built"},
      {"check", "reducer_150kW_uncertain"},
      {"check", "reducer_nu204"},
      {"check", "three_sets_150kW"},
      {"check", "lin_parker_1999"},
      {"check", "mesh_62_62"},
      {"check", "jones_218"},
      {"check", "duplex_7020"},
      {"check", "spin_film_guo2013"},
      {"check", "scratch_defect"},
      {"run static", "planet_bearing_iso16281"},
      {"run static",
       "planet_bearing_iso16281",
       {"--set=requirements={life: 1 h, S0: 3}", "--set=operation.outer_speed=100 rpm"}},
      {"run static", "harris_209"},
      {"run static", "ball_6305_iso16281"},
      {"run static", "jones_218"},
      {"run static", "spin_bearing_7210"},
      {"run dynamic", "deep_groove_motor", {"--set=simulation.duration=5 ms"}},
      {"run dynamic",
       "deep_groove_motor",
       {"--set=simulation.duration=5 ms", "--set=requirements={life: 1 h, S0: 3}"}},
      {"run dynamic", "nasa_35mm", {"--set=simulation.duration=5 ms"}},
      {"run defect", "scratch_defect"},
      {"run defect", "scratch_defect", {"--set=signal.run_up_from=0.5"}},
      {"run defect", "scratch_defect", {"--fidelity=dynamic", "--set=signal.revolutions=3"}},
      {"run defect", "scratched_rollers"},
      {"run scratched planet bearing", "planet_scratch", {"--set=signal.carrier_revolutions=1"}},
      {"run duplex", "duplex_7020"},
      {"run film", "spin_film_guo2013"},
      {"run film", "reynolds_line"},
      {"run gears", "reducer_150kW", {"--gears"}},
      {"run sweep", "reducer_150kW"},
      {"run sweep", "reducer_150kW", {"--set=requirements={life: 1 h, S0: 3}"}},
      {"run sweep", "three_sets_150kW"},
      {"run sweep",
       "wind_stage_750kW",
       {"--set=bearing.laminae=1", "--set=bearing.profile={kind: straight}",
        "--set=bearing.tilt_state=stated"}},
      {"sweep", "reducer_150kW", {"--grid-only", "--set=sweep.input.speed=[6000 rpm]"}},
      {"sweep",
       "reducer_150kW",
       {"--grid-only", "--set=sweep.input.speed=[6000 rpm]", "--set=requirements={life: 1 h, S0: 3}"}},
      {"mesh", "mesh_62_62"},
      {"mesh", "wind_stage_750kW"},
      {"mesh", "reducer_150kW_as_built"},
      {"modes", "lin_parker_1999"},
      {"modes", "reducer_150kW", {"--speed=6000 rpm"}},
      {"modes", "wind_stage_750kW"},
      {"modes duplex", "duplex_7020"},
      {"stiffness", "jones_218"},
      {"stiffness", "duplex_7020"},
      {"stiffness", "three_sets_150kW", {"--set=sweep.input.speed=[6000 rpm]"}},
      {"crown", "reducer_150kW", {"--drops=0 um, 4 um, 8 um", "--starts=1", "--tolerance=1 um"}},
      {"crown",
       "reducer_150kW",
       {"--drops=0 um, 4 um, 8 um", "--tilts=0 mrad, 1 mrad", "--starts=1", "--tolerance=1 um",
        "--tilt-tolerance=0.1 mrad", "--distribution=worst", "--life=iso16281",
        "--profile=straight-circular"}},
      {"sensitivities", "reducer_150kW", {"--by=bearing.rollers", "--by=input.power"}},
      {"sensitivities", "harris_209"},
      {"table", "reducer_150kW", {"--over=input.power=100 kW..150 kW", "--points=100"}},
      {"signals", "scratch_defect", {"--vary=defect.race=[none, outer]", "--set=signal.revolutions=3"}},
      {"signals", "scratched_rollers", {"--vary=defect.race=[none, outer]", "--set=signal.revolutions=3"}},
      {"validate", "reducer_150kW", {"--set=sweep.input.speed=[5000 rpm, 6000 rpm]"}},
      {"validate", "harris_209"},
      {"validate", "planet_bearing_iso16281"},
      {"validate", "duplex_7020", {"--samples=4"}},
      {"validate", "scratch_defect"},
  };
  return all;
}

// Keys beside those of the record.
const Json& common() {
  static const Json all{
      {"case", {{"type", "string"}, {"description", "name"}}},
      {"model", {{"type", "string"}, {"description", "what the case describes"}}},
      {"options", {{"type", "object"}, {"description", "of the command"}}},
      {"status", {{"type", "string"}, {"description", "implausible values, where there are such"}}},
      {"stiffness",
       {{"description", "of a planet bearing as by the command stiffness; of several sets, by set"}}},
      {"spectrum",
       {{"description", "lives under the load spectrum, and its bins with the columns of points"}}},
      {"uncertain", {{"type", "object"}, {"description", "inputs that are not known for sure"}}},
      {"assumptions",
       {{"type", "array"}, {"description", "inputs that the source does not give, with reasons"}}},
      {"warnings",
       {{"type", "array"}, {"items", {{"type", "string"}}}, {"description", "to be read before use"}}},
      {"versions", {{"type", "object"}, {"description", "of the program and its parts"}}},
      {"units",
       {{"type", "object"}, {"description", "of numbers by their keys, or by paths where keys are alike"}}}};
  return all;
}

// Output of the command, as its record describes it. Points of sweeps and signals have further columns that
// are keys of the case or of its sets.
Json schema_of_look(const Look& look) {
  std::vector<std::string> words{look.name.substr(0, look.name.find(' ')),
                                 ORBEARING_SOURCE_DIR "/cases/" + look.of + "/case.yaml", "--json"};
  words.insert(words.end(), look.words.begin(), look.words.end());
  CommandRequest request = request_of_words(words);
  Json schema, object;
  Printing& print = printing_of(request);
  print.quiet = true;
  print.to.record = [&](const Record& record) { schema = schema_of(record); };
  print.to.result = [&](const Json& result) { object = result; };
  execute(request);
  for (const auto& [key, value] : object.items())
    if (key == "units" || !schema["properties"].contains(key)) schema["properties"][key] = common().at(key);
  for (const char* rows : {"points", "signals"})
    if (Json& properties = schema["properties"]; properties.contains(rows))
      properties[rows]["items"]["patternProperties"] = {{"\\.", Json::object()}};
  return schema;
}

std::string result_schema() {
  Json definitions;
  for (const Look& look : looks()) extend_schema(definitions[look.name], schema_of_look(look));
  return Json{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "Orbearing results"},
              {"description", "what each command prints with --json"},
              {"$defs", std::move(definitions)}}
             .dump(1) +
         "\n";
}

TEST(ResultSchema, IsTheOneShipped) {
  const std::string path = ORBEARING_SOURCE_DIR "/cases/result.schema.json";
  const std::string schema = result_schema();
  if (std::getenv("ORBEARING_WRITE_SCHEMA") != nullptr) std::ofstream(path) << schema;
  std::stringstream shipped;
  shipped << std::ifstream(path).rdbuf();
  EXPECT_EQ(schema, shipped.str()) << "to regenerate it see cases/README.md";
}

}  // namespace
}  // namespace orbearing::app::result_schema_test
