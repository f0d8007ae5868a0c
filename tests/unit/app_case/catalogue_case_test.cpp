// Bearings by designation, clearance class and cage material; full complement; without rings.
#include "app/case/catalogue_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "app/case/catalogue_file.hpp"
#include "app/case/catalogue_quantities.hpp"
#include "app/case/catalogue_warnings.hpp"
#include "app/case/machines.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/study/planetary_case.hpp"
#include "bearing/catalogue/entries.hpp"
#include "bearing/default_design.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::bought_case_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double kWritten = 1e-8;  // [-]  nine digits are put into a case
constexpr double kUm = 1e-6;

const std::string kByDesignation = R"(name: bought
source: a catalogue
model: roller-bearing
load: {radial: 3000 N}
bearing: {designation: NU 205, clearance_class: CN}
)";

const std::string kBallsByDesignation = R"(name: bought
source: a catalogue
model: ball-bearing
load: {radial: 1000 N}
bearing: {designation: 6205, clearance_class: C3}
)";

// As short as a planet's bearing can be stated.
std::string planet(const std::string& bearing) {
  return R"(name: planet
source: a catalogue
model: planetary-drivetrain
input: {power: 150 kW, speed: 6000 rpm}
gearset:
  planets: 4
  teeth: {sun: 37, planet: 22, ring: 79}
  module: 3 mm
  profile_shift: {sun: 0.2618, ring: 0.4146}
  face_width: 28 mm
bearing: {)" +
         bearing + "}\n";
}

const std::string kCatalogue =
    "designation: NU 204, per_planet: 2, clearance_class: CN, cage: {material: brass}";
const std::string kNeedles =
    "type: cylindrical-roller, per_planet: 1, roller_diameter: 5 mm, roller_length: 20 mm, pitch_diameter: "
    "30 mm, "
    "radial_clearance: 20 um, width: 22 mm, rings: none, ";
const std::string kCage =
    "rollers: 14, cage: {inner_diameter: 28 mm, outer_diameter: 32 mm, width: 21.5 mm, material: steel}";

ResolvedCase of(const std::string& text, const std::vector<std::string>& settings = {}) {
  return parse_case(text, "case.yaml", settings);
}

TEST(CatalogueBearing, DesignationGivesRollersRingsAndRating) {
  const ResolvedCase in = of(kByDesignation);
  const bearing::catalogue::Inside inside =
      bearing::catalogue::inside_of(*bearing::catalogue::find(built_in_catalogue(), "NU 205"));
  EXPECT_EQ(in.integer("bearing.rollers"), inside.elements);
  EXPECT_NEAR(in.quantity("bearing.roller_length"), inside.length, kWritten * inside.length);
  EXPECT_DOUBLE_EQ(in.quantity("bearing.pitch_diameter"), inside.pitch_diameter);
  EXPECT_DOUBLE_EQ(in.quantity("bearing.bore"), 25e-3);
  EXPECT_DOUBLE_EQ(in.quantity("bearing.dynamic_capacity"), 29300.0);
  EXPECT_THAT(in.assumed().at("bearing.roller_length"), AllOf(HasSubstr("inferred"), HasSubstr("NU 205")));
  EXPECT_THAT(in.assumed().at("bearing.bore"), HasSubstr("NSKE1102"));
  EXPECT_EQ(in.origin("bearing.rollers"), "default");
}

TEST(CatalogueBearing, DesignationGivesBallsAndTheirAngle) {
  const ResolvedCase in = of(kBallsByDesignation);
  EXPECT_EQ(in.integer("bearing.balls"), 9);
  EXPECT_DOUBLE_EQ(in.quantity("bearing.radial_clearance"), 20.5 * kUm);
  EXPECT_EQ(in.with("bearing.designation", "6206").quantity("bearing.pitch_diameter"), 46e-3);
  const ResolvedCase angular =
      of(kBallsByDesignation, {"bearing={designation: 7205 B, radial_clearance: 0 um}"});
  EXPECT_NEAR(angular.quantity("bearing.contact_angle"), 0.698131701, 1e-8);
}

// --- a user's own catalogue

const std::string kTable =
    "bearing: {designation: NU 205, clearance_class: CN, catalogue: \"designation, family, bore [mm], "
    "outside_diameter [mm], width [mm], inner_raceway [mm], outer_raceway [mm], dynamic_capacity [kN], "
    "static_capacity [kN], fatigue_load_limit [kN], maker\\nNU 205, cylindrical-roller, 25, 52, 15, 31.5, "
    "46.5, "
    "28.6, 27, 3.35, ACME\\nNU/NJ 3205, cylindrical-roller, 25, 52, 20.6, 31.5,, 40, 42, , ACME\\n\"}\n";

std::string with_table(const std::string& changed = kTable) {
  return replaced(kByDesignation, "bearing: {designation: NU 205, clearance_class: CN}\n", changed);
}

TEST(CatalogueBearing, RowsOfAUserGoBeforeThoseOfTheProgram) {
  const ResolvedCase in = of(with_table());
  EXPECT_DOUBLE_EQ(in.quantity("bearing.dynamic_capacity"), 28600.0);
  EXPECT_DOUBLE_EQ(in.quantity("bearing.static_capacity"), 27000.0);
  EXPECT_DOUBLE_EQ(in.quantity("bearing.fatigue_load_limit"), 3350.0);
  EXPECT_DOUBLE_EQ(in.quantity("bearing.roller_diameter"), 7.5e-3);
  EXPECT_THAT(in.assumed().at("bearing.bore"), HasSubstr("ACME NU 205"));
  EXPECT_DOUBLE_EQ(in.with("bearing.designation", "NJ 3205").quantity("bearing.dynamic_capacity"), 40e3);
  EXPECT_DOUBLE_EQ(in.with("bearing.designation", "NU 206").quantity("bearing.dynamic_capacity"), 39e3);
  EXPECT_THAT(of(with_table()).assumed().at("bearing.dynamic_capacity"), Not(HasSubstr("NSK")));
}

// The resolved case holds the one row that is used, and no file.
TEST(CatalogueBearing, ResolvedCaseOfAUsersRowNeedsNoFile) {
  const std::string written = write_resolved(of(with_table()));
  EXPECT_THAT(written, AllOf(HasSubstr("ACME"), Not(HasSubstr("3205"))));
  EXPECT_EQ(write_resolved(of(written)), written);
  // Lines that are not the user's are not repeated.
  EXPECT_THAT(write_resolved(of(with_table(), {"bearing.designation=NU 206"})), Not(HasSubstr("ACME")));
}

// Values of a catalogue that a resolved case repeats are no statement of the user.
TEST(CatalogueBearing, RatingsOfAResolvedCaseFollowAnotherDesignation) {
  const std::string written = write_resolved(of(kByDesignation));
  const ResolvedCase other = of(written, {"bearing.designation=NU 206"});
  EXPECT_DOUBLE_EQ(other.quantity("bearing.dynamic_capacity"), 39e3);
  EXPECT_THAT(other.assumed().at("bearing.dynamic_capacity"), HasSubstr("NU 206"));
}

TEST(CatalogueBearing, WrongRowsAreRefusedWithTheirLine) {
  const auto refused = [](const std::string& from, const std::string& to) {
    return mistakes(with_table(replaced(kTable, from, to)));
  };
  EXPECT_THAT(refused("28.6, 27", "28.6 kg, 27"),
              ElementsAre(HasSubstr("line 2 of the table: dynamic_capacity")));
  EXPECT_THAT(refused(", 31.5, 46.5", ", , 46.5"), ElementsAre(HasSubstr("no inner_raceway")));
  EXPECT_THAT(refused("NU/NJ 3205, cyl", "NU/NJ 205, cyl"),
              ElementsAre(HasSubstr("line 3 of the table: the designation 'NU 205' again")));
  EXPECT_THAT(refused("NJ 3205, cylindrical-roller", "NJ 3205, roller"),
              ElementsAre(AllOf(HasSubstr("family: 'roller'"), HasSubstr("deep-groove-ball"))));
  EXPECT_THAT(refused("25, 52, 15, 31.5", "25, 52, 15, 21.5"),
              ElementsAre(HasSubstr("more than the bore of 25 mm")));
  EXPECT_THAT(refused("designation, family", "name, family"), ElementsAre(HasSubstr("the column 'name'")));
}

// --- ratings stated with a designation

TEST(CatalogueBearing, StatedRatingsReplaceThoseOfTheCatalogueAndAreNamed) {
  const ResolvedCase in =
      of(kByDesignation, {"bearing.dynamic_capacity=34 kN", "bearing.fatigue_load_limit=4 kN"});
  EXPECT_DOUBLE_EQ(in.quantity("bearing.dynamic_capacity"), 34e3);
  EXPECT_DOUBLE_EQ(in.quantity("bearing.static_capacity"), 27700.0);
  EXPECT_THAT(idle_inputs(in), IsEmpty());
  EXPECT_THAT(
      inferred_warnings(in),
      Contains(AllOf(HasSubstr("bearing.dynamic_capacity: 34 kN as stated replaces 29300 N of NSK NU 205 EW"),
                     HasSubstr("rollers"))));
  EXPECT_DOUBLE_EQ(
      of(planet(kCatalogue), {"bearing.dynamic_capacity=34 kN"}).quantity("bearing.dynamic_capacity"), 34e3);
  const std::string written = write_resolved(in);
  EXPECT_DOUBLE_EQ(of(written).quantity("bearing.dynamic_capacity"), 34e3);
}

TEST(CatalogueBearing, NeedleCagesRunOnPinAndPlanet) {
  const std::string cage =
      "designation: K 30x37x16, per_planet: 1, radial_clearance: 20 um, cage: {material: steel}";
  const ResolvedCase in = of(planet(cage));
  EXPECT_EQ(in.choice("bearing.rings"), "none");
  EXPECT_NEAR(in.quantity("bearing.bore"), 30e-3 - 10e-6, 1e-9);
  EXPECT_NEAR(in.quantity("bearing.outside_diameter"), 37e-3 + 10e-6, 1e-9);
  EXPECT_THAT(in.assumed().at("bearing.width"), HasSubstr("NTN K 30x37x16"));
  EXPECT_EQ(of(planet(cage), {"bearing.designation=NU 204"}).choice("bearing.rings"), "both");
  EXPECT_THAT(mistakes(planet(cage + ", rings: both")),
              Contains(HasSubstr("run on the pin and in the planet")));
}

// A resolved case that is read again is the same case.
TEST(CatalogueBearing, ResolvedCaseReadAgainIsTheSame) {
  for (const std::string& text :
       {kByDesignation, kBallsByDesignation, planet(kCatalogue), planet(kNeedles + kCage)}) {
    const std::string written = write_resolved(of(text));
    EXPECT_EQ(write_resolved(of(written)), written);
  }
}

// As with an oil's grade: values stated with it have no effect, which is reported.
TEST(CatalogueBearing, StatedGeometryBesideADesignationHasNoEffectAndIsWarnedOf) {
  const ResolvedCase in =
      of(kByDesignation, {"bearing.pitch_diameter=40 mm", "bearing.radial_clearance=12 um"});
  EXPECT_DOUBLE_EQ(in.quantity("bearing.pitch_diameter"), 39e-3);
  EXPECT_DOUBLE_EQ(in.quantity("bearing.radial_clearance"), 32.5 * kUm);
  EXPECT_THAT(idle_inputs(in), ElementsAre(AllOf(HasSubstr("bearing.pitch_diameter: 40 mm has no effect"),
                                                 HasSubstr("bearing.designation is not given")),
                                           AllOf(HasSubstr("bearing.radial_clearance: 12 um has no effect"),
                                                 HasSubstr("bearing.clearance_class is not given"))));
  EXPECT_THAT(idle_inputs(of(kByDesignation)), IsEmpty());
}

TEST(CatalogueBearing, WhatIsNotKnownIsRefused) {
  EXPECT_THAT(mistakes(kByDesignation, {"bearing.designation=NU 9999"}),
              ElementsAre(HasSubstr("'NU 9999' is not in the catalogue")));
  EXPECT_THAT(mistakes(kByDesignation, {"bearing.designation=NU204"}), IsEmpty());  // blanks are ignored
  for (const char* written : {"nu-204", "NU 204 QX"})
    EXPECT_THAT(mistakes(kByDesignation, {std::string("bearing.designation=") + written}),
                ElementsAre(HasSubstr("nearest: NU 204, ")))
        << written;
  EXPECT_THAT(mistakes(kByDesignation, {"bearing.designation=6205"}),
              Contains(HasSubstr("'6205', a bearing of balls; one of rollers, such as NU 205, is required")));
  EXPECT_THAT(mistakes(kBallsByDesignation, {"bearing.designation=7205 A"}),
              Contains(HasSubstr("angular-contact")));
  EXPECT_THAT(mistakes(bearing_case, {"bearing.clearance_class=C3"}),
              ElementsAre(HasSubstr("bearing.designation or bearing.bore is required as well")));
  EXPECT_THAT(mistakes(planet(kCatalogue), {"bearing.clearance_state=operating"}),
              ElementsAre(HasSubstr("A class is for an unmounted bearing")));
}

// Messages on a missing value name the inputs that would give it.
TEST(CatalogueBearing, WhatIsMissingNamesWhatWouldGiveIt) {
  EXPECT_THAT(mistakes(replaced(planet(kCatalogue), "clearance_class: CN", "clearance_state: operating")),
              Contains(AllOf(HasSubstr("bearing.radial_clearance: missing"),
                             HasSubstr("or bearing.clearance_class instead"))));
  EXPECT_THAT(mistakes(kByDesignation, {"bearing.designation=NU 9999", "bearing.clearance_class=C3"}),
              Not(Contains(HasSubstr("bearing.clearance_class"))));
}

// Normal clearance by ISO 5753: 6205 has 5 to 20 um as CN and 13 to 28 um as C3; the middle is used.
TEST(CatalogueBearing, WithoutAClearanceItIsNormalAndSaysSo) {
  const std::string bare = replaced(kBallsByDesignation, ", clearance_class: C3", "");
  const ResolvedCase in = of(bare);
  EXPECT_EQ(in.choice("bearing.clearance_class"), "CN");
  EXPECT_EQ(in.origin("bearing.clearance_class"), "default");
  EXPECT_THAT(in.assumed().at("bearing.clearance_class"), HasSubstr("default: normal clearance"));
  EXPECT_DOUBLE_EQ(in.quantity("bearing.radial_clearance"), 12.5 * kUm);
  EXPECT_TRUE(of(write_resolved(in)) == in);
  // A stated clearance, given at once or later, also to a resolved case, is no longer that of a class.
  for (const ResolvedCase& stated :
       {of(bare, {"bearing.radial_clearance=7 um"}), in.with("bearing.radial_clearance", "7 um"),
        of(write_resolved(in)).with("bearing.radial_clearance", "7 um")}) {
    EXPECT_FALSE(stated.has("bearing.clearance_class"));
    EXPECT_DOUBLE_EQ(stated.quantity("bearing.radial_clearance"), 7.0 * kUm);
    EXPECT_FALSE(stated.is_replaced("bearing.radial_clearance"));
  }
  EXPECT_EQ(of(bare, {"bearing.clearance_class=C4"}).choice("bearing.clearance_class"), "C4");
}

TEST(CatalogueBearing, SuffixesAreReadAndListed) {
  const auto named = [](const std::string& designation) {
    return of(replaced(kBallsByDesignation, "6205, clearance_class: C3", designation));
  };
  const ResolvedCase sealed = named("6205-2Z/C3");
  EXPECT_DOUBLE_EQ(sealed.quantity("bearing.radial_clearance"), 20.5 * kUm);
  EXPECT_EQ(sealed.assumed().at("bearing.clearance_class"), "default: the suffix of bearing.designation");
  EXPECT_THAT(inferred_warnings(sealed),
              Contains(HasSubstr("'6205-2Z/C3' is read as 6205 with the suffixes 2Z (shields on both sides), "
                                 "C3 (class of clearance)")));
  EXPECT_THAT(
      inferred_warnings(named("7208 BEP")),
      Contains(HasSubstr("'7208 BEP' is read as 7208 B with the suffixes E (reinforced inside), P (cage of "
                         "polyamide)")));
  EXPECT_THAT(inferred_warnings(named("6205")), Not(Contains(HasSubstr("suffix"))));
  const ResolvedCase rollers = of(replaced(kByDesignation, "NU 205", "NU 2207 ECP"));
  EXPECT_EQ(rollers.quantity("bearing.bore"), 0.035);
  EXPECT_THAT(mistakes(replaced(kByDesignation, "NU 205", "NCF 2207 V")),
              Contains(HasSubstr("for a full complement state bearing.complement: full with")));
  EXPECT_THAT(mistakes(replaced(kByDesignation, "NU 205", "NU 205 XYZ")),
              Contains(HasSubstr("not in the catalogue")));
}

TEST(CatalogueBearing, AnInferredInsideIsWarnedOf) {
  const auto of_balls = AllOf(HasSubstr("bearing.designation: the inside of"), HasSubstr("inferred"),
                              HasSubstr("uncertain"), HasSubstr("by 2 %"));
  EXPECT_THAT(inferred_warnings(of(kBallsByDesignation)), ElementsAre(of_balls));
  EXPECT_THAT(require_used(of(kBallsByDesignation), machine_analysis(ball_bearing, "run")->used),
              Contains(of_balls));
  EXPECT_THAT(inferred_warnings(shipped()), IsEmpty());
}

// 16.7: the class is the clearance from which fits, temperatures and speeds make the operating one.
TEST(CatalogueBearing, ClassIsTheUnmountedClearanceOfAPlanetBearing) {
  const ResolvedCase in = of(planet(kCatalogue), {"bearing.fit.inner_interference=8 um"});
  EXPECT_EQ(in.choice("bearing.clearance_state"), "unmounted");
  const analysis::PlanetaryDrivetrain drivetrain = bearing_sets(in).front().drivetrain;
  const bearing::ClearanceChain chain = analysis::clearance_chain(drivetrain);
  EXPECT_DOUBLE_EQ(chain.unmounted, 32.5 * kUm);
  EXPECT_LT(chain.fitted, 32.5 * kUm - 5.0 * kUm);
  EXPECT_DOUBLE_EQ(drivetrain.bearing.radial_clearance, chain.operating);
  std::vector<std::string> shown;
  for (const Derived& row : catalogue_quantities(in))
    shown.push_back(fmt::format("{} {:g}", row.path, row.value));
  EXPECT_THAT(shown,
              AllOf(Contains("bearing.clearance_class.least 20"), Contains("bearing.clearance_class.most 45"),
                    Contains("bearing.catalogue.dynamic_rating 25700")));
}

TEST(CatalogueBearing, MaterialOfACageIsItsDensityAndStiffness) {
  double stiffness = 0.0;
  for (const char* name : {"polyamide", "brass", "steel"}) {
    const ResolvedCase in = of(planet(kCatalogue), {fmt::format("bearing.cage.material={}", name)});
    EXPECT_DOUBLE_EQ(in.quantity("bearing.cage.density"), bearing::cage_material(name).density);
    EXPECT_GT(in.quantity("bearing.cage.pocket_stiffness"), stiffness) << name;
    stiffness = in.quantity("bearing.cage.pocket_stiffness");
  }
}

TEST(FullComplement, HasAsManyRollersAsGoInAndNoCage) {
  const ResolvedCase in = of(planet(kNeedles + "complement: full"));
  EXPECT_EQ(in.integer("bearing.rollers"), 18);  // pi/asin(5.005/30) = 18.76
  EXPECT_EQ(bearing_sets(in).front().geometry.bearing.cage_mass, 0.0);
  EXPECT_THAT(mistakes(planet(kNeedles + "complement: full, rollers: 15")),
              ElementsAre(HasSubstr("a full complement of 15 rollers with room for 3 more; 18 rollers")));
  for (const AnalysisId felt : {AnalysisId::quasi_static, AnalysisId::dynamic, AnalysisId::co_simulated,
                                AnalysisId::monolithic, AnalysisId::fmu_bearing})
    EXPECT_NO_THROW((void)require_used(in, felt));
  EXPECT_THROW((void)require_used(in, AnalysisId::planet_defect), BadInput);
}

// 16 rollers for the 13 of NU 2340: C of ISO 281 is proportional to Z^(3/4), C_0 of ISO 76 and C_u to Z.
TEST(FullComplement, HasRatingsOfItsOwnNumberOfRollers) {
  const std::string text = replaced(kByDesignation, "NU 205", "NU 2340");
  const ResolvedCase caged = of(text), full = of(text, {"bearing.complement=full"});
  ASSERT_EQ(caged.integer("bearing.rollers"), 13);
  ASSERT_EQ(full.integer("bearing.rollers"), 16);
  EXPECT_EQ(caged.quantity("bearing.dynamic_capacity"), 1910e3);
  constexpr double written = 1e-5;  // six digits are put into a case
  EXPECT_NEAR(full.quantity("bearing.dynamic_capacity") / (1910e3 * std::pow(16.0 / 13.0, 0.75)), 1.0,
              written);
  EXPECT_NEAR(full.quantity("bearing.static_capacity") / caged.quantity("bearing.static_capacity"),
              16.0 / 13.0, written);
  EXPECT_THAT(full.assumed().at("bearing.dynamic_capacity"),
              HasSubstr("13 rollers in a cage, times (16/13)^0.75"));
  // A resolved case has the same ratings.
  EXPECT_NEAR(of(write_resolved(full)).quantity("bearing.dynamic_capacity") /
                  full.quantity("bearing.dynamic_capacity"),
              1.0, written);
  // Who states the printed one hears that it is another bearing's.
  const ResolvedCase stated = of(text, {"bearing.complement=full", "bearing.dynamic_capacity=1910 kN"});
  EXPECT_EQ(stated.quantity("bearing.dynamic_capacity"), 1910e3);
  EXPECT_THAT(inferred_warnings(stated),
              Contains(HasSubstr("with 13 rollers in a cage; 16 rollers without")));
}

TEST(CatalogueBearing, RatingsOfSteelAreNotThoseOfAnotherMaterial) {
  EXPECT_THAT(mistakes(kByDesignation, {"material.youngs_modulus=310 GPa"}),
              ElementsAre(HasSubstr("310 GPa together with NU 205, whose ratings are those of steel")));
  EXPECT_THAT(mistakes(kByDesignation, {"material.youngs_modulus=310 GPa", "bearing.dynamic_capacity=30 kN"}),
              IsEmpty());
  EXPECT_THAT(mistakes(kByDesignation, {"material.youngs_modulus=210 GPa"}), IsEmpty());
}

TEST(CatalogueBearing, WithoutItsOwnRingsIsWarnedOf) {
  EXPECT_THAT(inferred_warnings(of(planet("designation: NU 204, per_planet: 2, rings: none, "
                                          "radial_clearance: 30 um, cage: {material: brass}"))),
              Contains(HasSubstr("bearing.rings: none; ratings of NSK NU 204")));
}

// The meaning of a designation determines the suggested word: no cylindrical bearing is near a tapered one.
TEST(CatalogueBearing, OtherTypesAreNamed) {
  for (const char* name : {"30305", "33014", "HR30206J"})
    EXPECT_THAT(mistakes(kByDesignation, {std::string("bearing.designation=") + name}),
                ElementsAre(AllOf(HasSubstr("a tapered roller bearing, of which no catalogue has a line"),
                                  HasSubstr("bearing.type: tapered-roller"), Not(HasSubstr("NU")))))
        << name;
  EXPECT_THAT(mistakes(kByDesignation, {"bearing.designation=22310 E"}),
              ElementsAre(HasSubstr("a spherical roller bearing")));
  for (const char* name : {"NU 22310", "RNU 2210", "HK 3020"})
    EXPECT_THAT(mistakes(kByDesignation, {std::string("bearing.designation=") + name}),
                ElementsAre(HasSubstr("nearest: NU")))
        << name;
  const auto expect_words = [&](const std::string& name, const char* words) {
    EXPECT_THAT(mistakes(kByDesignation, {"bearing.designation=" + name}),
                ElementsAre(AllOf(HasSubstr(words), HasSubstr("of which no catalogue has a line"))))
        << name;
  };
  for (const char* series : {"30", "31", "32", "33"})
    expect_words(series + std::string("210 A"), "a tapered roller bearing");
  for (const char* series : {"21", "22", "23", "24"})
    expect_words(series + std::string("310 CC"), "a spherical roller bearing");
}

// Each series of a type that is not computed, with the words of its type.
TEST(CatalogueBearing, TypesThatAreNotComputedAreNamed) {
  struct Type {
    const char* words;
    std::vector<const char*> names;
  };
  const std::vector<Type> types{{"a thrust ball bearing", {"51210", "52210", "53210", "54210"}},
                                {"a spherical roller thrust bearing", {"29220", "29320 E", "29420 E"}},
                                {"a cylindrical roller thrust bearing", {"81210", "89310"}},
                                {"a self-aligning ball bearing", {"1210", "1310", "2210-TVH", "2310"}},
                                {"a double-row angular contact ball bearing", {"3210", "3310"}},
                                {"a four-point contact ball bearing", {"QJ 210"}},
                                {"a toroidal roller bearing", {"C 2210"}}};
  for (const Type& type : types)
    for (const char* name : type.names)
      EXPECT_THAT(mistakes(kByDesignation, {std::string("bearing.designation=") + name}),
                  ElementsAre(AllOf(HasSubstr(type.words), HasSubstr("others are not computed"))))
          << name;
}

// Outside the catalogue a cage is the typical one of such a section too.
TEST(CageSize, FollowsFromStatedRollers) {
  const ResolvedCase in = of(planet(kNeedles + "rollers: 14, cage: {material: steel}"));
  const bearing::CageSize cage = bearing::default_cage_size(30e-3, 5e-3, 20e-3, 22e-3);
  EXPECT_NEAR(in.quantity("bearing.cage.inner_diameter"), cage.inner_diameter, 1e-11);
  EXPECT_NEAR(in.quantity("bearing.cage.outer_diameter"), cage.outer_diameter, 1e-11);
  EXPECT_NEAR(in.quantity("bearing.cage.width"), cage.width, 1e-11);
  EXPECT_TRUE(in.assumed().contains("bearing.cage.width"));
}

TEST(FullComplement, TakesNoNoticeOfACageAndSaysSo) {
  const ResolvedCase in = of(planet(kNeedles + "complement: full, cage: {material: steel}"));
  EXPECT_EQ(bearing_sets(in).front().geometry.bearing.cage_mass, 0.0);
  EXPECT_THAT(idle_inputs(in), Contains(HasSubstr("bearing.cage.material: steel has no effect")));
}

TEST(RinglessPlanet, RunsOnThePinAndInTheBoreOfThePlanet) {
  const ResolvedCase in = of(planet(kNeedles + kCage));
  EXPECT_NEAR(in.quantity("bearing.bore"), 24.99e-3, 1e-11);
  EXPECT_NEAR(in.quantity("bearing.outside_diameter"), 35.01e-3, 1e-11);
  const analysis::NamedSet set = bearing_sets(in).front();
  EXPECT_NEAR(set.geometry.bearing.outer_ring_mass, 0.0, 1e-9);
  EXPECT_NEAR(set.geometry.bearing.inner_radius, 0.5 * in.quantity("bearing.bore"), 1e-11);
  EXPECT_THAT(
      idle_inputs(of(planet(kNeedles + kCage), {"bearing.bore=20 mm"})),
      ElementsAre(AllOf(HasSubstr("bearing.bore: 20 mm has no effect"), HasSubstr("bearing.rings is both"))));
  EXPECT_THAT(mistakes(planet(kNeedles + kCage), {"bearing.clearance_class=CN"}),
              ElementsAre(HasSubstr("without both rings")));
}

}  // namespace
}  // namespace orbearing::app::bought_case_test
