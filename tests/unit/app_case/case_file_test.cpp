#include "app/case/case_file.hpp"

#include <gmock/gmock.h>

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "app/case/field_table.hpp"
#include "app/case/settings.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::case_file_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(CaseFile, ReadsTheShippedCase) {
  const ResolvedCase resolved = shipped();
  EXPECT_EQ(resolved.model(), planetary_drivetrain);
  EXPECT_EQ(resolved.quantity("input.power"), 150e3);
  EXPECT_EQ(resolved.integer("gearset.teeth.ring"), 79);
  EXPECT_EQ(resolved.number("gearset.profile_shift.sun"), 0.2618);
  EXPECT_FALSE(resolved.flag("film.enabled"));
  EXPECT_EQ(resolved.choice("gearset.fixed"), "ring");
  EXPECT_EQ(sweep_size(resolved), 12U);
}

TEST(CaseFile, TellsGivenFromDefault) {
  const ResolvedCase resolved = parse_case(bearing_case, "case.yaml");
  EXPECT_EQ(resolved.given("bearing.rollers"), "14");
  EXPECT_EQ(resolved.origin("bearing.rollers"), "case.yaml:8:12");
  EXPECT_EQ(resolved.origin("life.reduction_factor"), "default");
  EXPECT_THAT(resolved.assumed().at("life.reduction_factor"), StartsWith("default: "));
  EXPECT_FALSE(resolved.has("bearing.bore"));
  EXPECT_THROW(resolved.quantity("bearing.bore"), std::logic_error);
}

TEST(CaseFile, ReportsUnknownKeysWithTheNearest) {
  EXPECT_THAT(mistakes(replaced(bearing_case, "  rollers:", "  roller:")),
              ElementsAre(AllOf(StartsWith("case.yaml:6:1: bearing.rollers: missing; a whole number")),
                          AllOf(StartsWith("case.yaml:8:3: bearing.roller: unknown key"),
                                HasSubstr("did you mean 'bearing.rollers'?"))));
  EXPECT_THAT(mistakes(bearing_case + "module: 3 mm\n"), ElementsAre(HasSubstr("'gearset.module'")));
  EXPECT_THAT(mistakes(bearing_case + "qqqqqq: 1\n"), ElementsAre(HasSubstr("one of name, source, model")));
  EXPECT_THAT(mistakes(bearing_case + "film.enabled: true\n"),
              ElementsAre(HasSubstr("nested by its blocks")));
}

TEST(CaseFile, ReportsDuplicateKeys) {
  EXPECT_THAT(mistakes(bearing_case + "load:\n  radial: 1 N\n"),
              ElementsAre("case.yaml:13:1: load: duplicate key, first on line 4; each key once is required"));
  EXPECT_THAT(mistakes(bearing_case + "  rollers: 15\n"),
              ElementsAre(StartsWith("case.yaml:13:3: bearing.rollers")));
}

TEST(CaseFile, ReportsWrongKinds) {
  const auto rollers = [](const char* value) { return mistakes(replaced(bearing_case, "14", value)); };
  for (const char* value :
       {"14.5", "'14'", "many", "[14]", "", "0x0e", "014", "14 mm", "99999999999", "2", "1e1"})
    EXPECT_THAT(rollers(value), ElementsAre(HasSubstr("bearing.rollers"))) << value;
  EXPECT_THAT(mistakes(replaced(bearing_case, "load:\n  radial: 4450 N", "load: 4450 N")),
              ElementsAre("case.yaml:4:7: load: '4450 N' found; a block with keys (radial, axial, moment, "
                          "moment_across, tilt) is required"));
  EXPECT_THAT(mistakes(replaced(bearing_case, "small", "' '")), ElementsAre(HasSubstr("an empty text")));
}

TEST(CaseFile, ReportsEveryMistakeInOrder) {
  std::string text = replaced(bearing_case, "4450 N", "-1 N");
  text = replaced(text, "10 mm", "10 kg");
  text = replaced(text, "made up", "\"\"");
  EXPECT_THAT(mistakes(text, {"bearing.rollers=0"}),
              ElementsAre(StartsWith("case.yaml:2:9: source"), StartsWith("case.yaml:5:11: load.radial"),
                          StartsWith("case.yaml:9:20: bearing.roller_diameter"),
                          StartsWith("--set: bearing.rollers")));
}

TEST(CaseFile, RefusesFieldsAndModelsThatAreNotHere) {
  EXPECT_THAT(mistakes(bearing_case + "input:\n  power: 1 kW\n"),
              ElementsAre(HasSubstr("roller-bearing does not use")));
  EXPECT_THAT(mistakes(replaced(bearing_case, "roller-bearing", "rolling")),
              ElementsAre(HasSubstr("none of the choices")));
}

TEST(CaseFile, ChecksAssumptions) {
  EXPECT_THAT(mistakes(bearing_case + "assumed:\n  bearing.rollers: counted\n"), IsEmpty());
  EXPECT_THAT(mistakes(bearing_case + "assumed:\n  bearing.roller: x\n"),
              ElementsAre(HasSubstr("'bearing.rollers'")));
  EXPECT_THAT(mistakes(bearing_case + "assumed:\n  bearing.bore: x\n"),
              ElementsAre(HasSubstr("missing value")));
  EXPECT_THAT(mistakes(bearing_case + "assumed:\n  bearing.rollers:\n"),
              ElementsAre(HasSubstr("the reason")));
  EXPECT_THAT(mistakes(bearing_case + "assumed: [a]\n"), ElementsAre(HasSubstr("a block with keys")));
  EXPECT_THAT(mistakes(bearing_case + "assumed:\n  lubricant.viscosity: a\n  lubricant.viscosity: b\n"),
              ElementsAre(HasSubstr("duplicate")));
}

TEST(CaseFile, RefusesFilesThatAreNoCase) {
  EXPECT_THAT(mistakes(""), ElementsAre(HasSubstr("case.yaml:1:1: (file): an empty file")));
  EXPECT_THAT(mistakes("# nothing\n"), ElementsAre(HasSubstr("an empty file")));
  EXPECT_THAT(mistakes("- a\n"), ElementsAre(HasSubstr("a list found")));
  EXPECT_THAT(mistakes("a: [\n"), ElementsAre(HasSubstr("(file)")));
  EXPECT_THROW(read_case("no/such/file.yaml"), BadInput);
  EXPECT_THROW(read_case(std::filesystem::temp_directory_path()), BadInput);
}

TEST(CaseFile, RefusesPipesAndDevices) {
  // Opening a pipe without a writer would wait for ever.
  const std::string pipe = ::testing::TempDir() + "orbearing_pipe_" + std::to_string(::getpid());
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& file : {pipe, std::string("/dev/zero")}) try {
      read_case(file);
      ADD_FAILURE() << file;
    } catch (const BadInput& error) {
      EXPECT_THAT(error.what(), HasSubstr("a pipe, a device or a socket; a readable case file is required"));
    }
  ::unlink(pipe.c_str());
}

TEST(CaseFile, BoundsPowerAndSpeed) {
  EXPECT_THAT(setting_mistakes({"input.power=0.001 W", "input.speed=0.001 rpm"}), IsEmpty());
  EXPECT_THAT(setting_mistakes({"input.power=10 GW", "input.speed=1e6 rpm"}), IsEmpty());
  for (const char* setting : {"input.power=0.0009 W", "input.power=11 GW"})
    EXPECT_THAT(setting_mistakes({setting}),
                ElementsAre(HasSubstr("at least 1e-06 kW and at most 10000000 kW")));
  for (const char* setting : {"input.speed=0.0009 rpm", "input.speed=1.1e6 rpm"})
    EXPECT_THAT(setting_mistakes({setting}),
                ElementsAre(HasSubstr("at least 0.001 rpm and at most 1000000 rpm")));
}

TEST(CaseFile, ReportsAnEmptyBlockOnce) {
  EXPECT_THAT(mistakes(replaced(bearing_case, "  radial: 4450 N\n", "")),
              ElementsAre("case.yaml:4:1: load: nothing found; a block with keys (radial, axial, moment, "
                          "moment_across, tilt) is required"));
}

TEST(FieldTable, DefaultsAreValuesOfTheirFields) {
  for (const Field& field : all_fields()) {
    if (field.default_text.empty()) continue;
    EXPECT_TRUE(read_field_text(field, field.default_text).good) << field.path;
    EXPECT_FALSE(field.default_reason.empty()) << field.path;
    EXPECT_EQ(field.required_by, no_model) << field.path;
  }
}

TEST(FieldTable, PathsAreUniqueAndNoPathIsABlock) {
  for (const Field& field : all_fields())
    for (const Field& other : all_fields())
      EXPECT_TRUE(&field == &other || (field.path != other.path && !other.path.starts_with(field.path + ".")))
          << field.path;
}

TEST(Field, ReadsLists) {
  const Field teeth{.path = "teeth",
                    .kind = Kind::list,
                    .use = {AnalysisSet::all(), {}},
                    .range = {5, 100},
                    .element = Kind::integer};
  const FieldReading reading = read_field(teeth, read_yaml("[20, 30]"));
  ASSERT_TRUE(reading.good);
  EXPECT_THAT(reading.value.list, ElementsAre(20, 30));
  EXPECT_EQ(reading.value.given, "[20, 30]");
  EXPECT_FALSE(read_field(teeth, read_yaml("[20, 3]")).good);
  EXPECT_FALSE(read_field(teeth, read_yaml("20")).good);
  EXPECT_THAT(requirement(teeth), StartsWith("a list, each element a whole number"));
}

}  // namespace
}  // namespace orbearing::app::case_file_test
