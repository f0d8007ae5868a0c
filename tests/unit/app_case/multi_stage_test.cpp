// Cases of several sets on common shafts.
#include <gmock/gmock.h>

#include <algorithm>

#include "app/case/drivetrain_reader.hpp"
#include "app/case/case_shape.hpp"
#include "app/case/field_table.hpp"
#include "app/case/resolved_writer.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::multi_stage_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string three_path = ORBEARING_SOURCE_DIR "/cases/three_sets_150kW/case.yaml";

std::string three() {
  return text_of(three_path);
}

std::vector<std::string> three_mistakes(const std::string& old, const std::string& fresh) {
  return mistakes(replaced(three(), old, fresh));
}

std::vector<std::string> three_with(const std::string& setting) {
  return mistakes(three(), {setting});
}

TEST(MultiStage, AreReadWithTheirShafts) {
  const ResolvedCase resolved = read_case(three_path);
  EXPECT_TRUE(resolved.shape().several);
  EXPECT_THAT(resolved.shape().sets, ElementsAre("reduction", "coupling", "transmission"));
  EXPECT_EQ(resolved.integer("sets.coupling.gearset.teeth.ring"), 66);
  EXPECT_THAT(resolved.texts("shafts.first"), ElementsAre("reduction.carrier", "coupling.sun"));
  EXPECT_FALSE(resolved.has("sets.transmission.bearing.rollers"));
  EXPECT_FALSE(resolved.has("sets.transmission.bearing.cage.guidance"));  // nor its default
  EXPECT_FALSE(resolved.has("input.member"));
  const gearset::Arrangement arrangement = arrangement_of(stated_drivetrain(resolved));
  ASSERT_EQ(arrangement.shafts.size(), 5U);
  EXPECT_TRUE(arrangement.shafts[0].motor);
  EXPECT_TRUE(arrangement.shafts[3].load);
  EXPECT_TRUE(arrangement.shafts[4].ground);
  EXPECT_EQ(arrangement.shafts[4].members.size(), 3U);
}

TEST(MultiStage, GiveEachAsACaseOfItsOwn) {
  const ResolvedCase coupling = read_case(three_path).of_set("coupling");
  EXPECT_FALSE(coupling.shape().several);
  EXPECT_EQ(coupling.integer("gearset.teeth.sun"), 30);
  EXPECT_EQ(coupling.quantity("input.power"), 150e3);
  EXPECT_TRUE(coupling.assumed().contains("bearing.per_planet"));
  EXPECT_FALSE(coupling.has("sets.reduction.gearset.teeth.sun"));
}

TEST(MultiStage, AreWrittenAndReadAgain) {
  const ResolvedCase resolved = read_case(three_path);
  const std::string written = write_resolved(resolved);
  EXPECT_EQ(parse_case(written, "case.yaml"), resolved);
  EXPECT_EQ(write_resolved(parse_case(written, "case.yaml")), written);
  EXPECT_THAT(written, HasSubstr("\n  first: [reduction.carrier, coupling.sun]\n"));
}

TEST(MultiStage, TakeSettingsAndSweeps) {
  const ResolvedCase set =
      read_case(three_path, {"sets.coupling.bearing.radial_clearance=5 um",
                             "sweep.sets.coupling.bearing.rollers=[11, 12]",
                             "sweep.input.speed={from: 1000 rpm, to: 2000 rpm, step: 1000 rpm}"});
  EXPECT_DOUBLE_EQ(set.quantity("sets.coupling.bearing.radial_clearance"), 5e-6);
  EXPECT_FALSE(set.assumed().contains("sets.coupling.bearing.radial_clearance"));
  EXPECT_EQ(sweep_size(set), 4U);
  EXPECT_EQ(set.with(sweep_point(set, 3)).integer("sets.coupling.bearing.rollers"), 12);
  EXPECT_THAT(three_with("sweep.sets.coupling.bearing.rolers=[11]"),
              ElementsAre(HasSubstr("did you mean 'sets.coupling.bearing.rollers'")));
  EXPECT_THAT(three_with("sweep.gearset.planets=[4]"), ElementsAre(HasSubstr("unknown path")));
  EXPECT_THAT(three_with("sweep.sets.coupling.gearset.planets=[4, 5]"),
              ElementsAre(AllOf(StartsWith("--set: sweep.sets.coupling.gearset.planets: "),
                                HasSubstr("5 equally spaced planets"))));
}

TEST(MultiStage, AreCheckedEachForItself) {
  EXPECT_THAT(
      three_with("sets.coupling.gearset.planets=5"),
      ElementsAre(StartsWith("--set: sets.coupling.gearset.planets: found 5 equally spaced planets")));
  EXPECT_THAT(three_with("sets.coupling.gearset.modul=4 mm"),
              ElementsAre(HasSubstr("did you mean 'sets.coupling.gearset.module'")));
  EXPECT_THAT(
      three_with("sets.coupling.gearset.fixed=ring"),
      ElementsAre(AllOf(HasSubstr("sets.coupling.gearset.fixed: unknown key"), HasSubstr("'ground'"))));
  EXPECT_THAT(three_with("input.member=sun"), ElementsAre(HasSubstr("several sets does not use")));
  EXPECT_THAT(three_with("sets.transmission.bearing.rollers=12"),
              Contains(HasSubstr("sets.transmission.bearing.roller_diameter: missing")));
  EXPECT_THAT(three_mistakes("      module: 3 mm\n", ""),
              ElementsAre(StartsWith("case.yaml:17:5: sets.reduction.gearset.module: missing")));
}

TEST(MultiStage, HaveSoundNames) {
  EXPECT_THAT(three_with("sets.a-b={}"), Contains(HasSubstr("sets.a-b: the name 'a-b'; a name of")));
  EXPECT_FALSE(is_name("") || is_name("1st") || is_name("a.b") || is_name(std::string(41, 'a')));
  EXPECT_TRUE(is_name("a") && is_name("Low_1"));
  EXPECT_EQ(find_field("sets.1.gearset.module"), nullptr);
  EXPECT_EQ(find_field("sets.low.gearset.fixed"), nullptr);
  EXPECT_EQ(find_field("sets.low.gearset.module"), find_field("gearset.module"));
  EXPECT_THAT(three_mistakes("  coupling:\n", "  reduction:\n"),
              Contains(HasSubstr("sets.reduction: duplicate key")));
}

TEST(MultiStage, StandNotBesideOneSet) {
  EXPECT_THAT(setting_mistakes({"shafts.input=[motor]"}),
              Contains(AllOf(StartsWith("--set: gearset: the fields of one set together with"),
                             HasSubstr("either gearset and bearing, or sets and shafts"))));
  EXPECT_THAT(three_with("gearset.planets=4"), Contains(StartsWith("--set: gearset: the fields of one set")));
  EXPECT_THAT(mistakes(bearing_case + "sets:\n  a: {}\n"), ElementsAre(HasSubstr("sets: unknown key")));
}

TEST(MultiStage, NeedWordsThatMeanSomething) {
  EXPECT_THAT(
      three_mistakes("[motor, reduction.sun]", "[motor, reduction.son]"),
      ElementsAre("case.yaml:10:18: shafts.input: 'reduction.son' cannot be joined; motor, load, ground "
                  "or a member of a set, as in 'reduction.sun', is required"));
  EXPECT_THAT(three_mistakes("[motor, reduction.sun]", "motor"),
              ElementsAre(HasSubstr("shafts.input: 'motor' found")));
  EXPECT_THAT(three_mistakes("[motor, reduction.sun]", "[motor, [a]]"),
              ElementsAre(HasSubstr("a list found")));
}

TEST(MultiStage, NameTheMembersAtFault) {
  // Two grounds on one set.
  EXPECT_THAT(three_with("shafts.housing=[ground, reduction.ring, reduction.carrier, coupling.ring, "
                         "transmission.ring]"),
              Contains(AllOf(StartsWith("--set: shafts.housing: "), HasSubstr("reduction.carrier on"))));
  EXPECT_THAT(three_mistakes("[transmission.carrier, load]", "[transmission.carrier, load, ground]"),
              ElementsAre(AllOf(StartsWith("case.yaml:13:11: shafts.output: "),
                                HasSubstr("ground together with the load"))));
  // A floating member.
  EXPECT_THAT(
      three_mistakes(", transmission.ring]", "]"),
      ElementsAre(AllOf(StartsWith("case.yaml:85:20: sets.transmission: transmission.ring on no shaft"),
                        HasSubstr("floats"))));
  // Shafts that contradict each other: sun and carrier of one set on one shaft, its ring on the ground.
  const std::string locked =
      replaced(replaced(three(), "[reduction.carrier, coupling.sun]", "[coupling.sun, load]"),
               "[motor, reduction.sun]", "[motor, reduction.sun, reduction.carrier]");
  EXPECT_THAT(mistakes(locked),
              Contains(AllOf(StartsWith("case.yaml:14:12: shafts.housing: speeds that contradict"),
                             HasSubstr("reduction.sun (on 'input'), reduction.ring (on "
                                       "'housing') and reduction.carrier (on 'input')"))));
  // No motor.
  EXPECT_THAT(three_mistakes("[motor, reduction.sun]", "[load, reduction.sun]"),
              Contains(StartsWith("case.yaml:10:10: shafts: no motor on any shaft")));
  EXPECT_THAT(three_mistakes("shafts:\n", "shaft:\n"), Contains(HasSubstr("shafts: missing")));
}

TEST(MultiStage, AreNotTooMany) {
  std::string many = "name: many\nsource: made up\nmodel: planetary-drivetrain\nsets:\n";
  for (int i = 0; i < 17; ++i) many += "  s" + std::to_string(i) + ": {}\n";
  EXPECT_THAT(mistakes(many), Contains(HasSubstr("sets: 17 sets; at most 16 are required")));
}

}  // namespace
}  // namespace orbearing::app::multi_stage_test
