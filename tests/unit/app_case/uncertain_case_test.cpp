// Statements of a case on numbers that are not known for sure.
#include "app/case/uncertain_case.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::uncertain_case_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string power = "uncertain.input.power={normal: {standard_deviation: 5 kW}}";
const std::string viscosity =
    "uncertain.lubricant.viscosity={normal: {mean: 12 mPa.s, standard_deviation: 2 mPa.s, from: 8 mPa.s}, "
    "reason: 'warm, or less so: by [1]'}";
const std::vector<std::string> catalogue_keys{"bearing.clearance_state=unmounted",
                                              "bearing.fit.inner_interference=5 um",
                                              "bearing.fit.outer_interference=10 um"};

std::vector<std::string> with_catalogue(std::vector<std::string> settings) {
  settings.insert(settings.begin(), catalogue_keys.begin(), catalogue_keys.end());
  return settings;
}

UncertainInput only(const std::vector<std::string>& settings) {
  return uncertain_inputs(shipped(settings)).inputs.at(0);
}

TEST(UncertainCase, NormalNumberStandsAboutTheCaseUnlessItSaysOtherwise) {
  const UncertainInput about = only({power});
  EXPECT_EQ(about.distribution, "normal");
  EXPECT_EQ(about.mean, 150e3);
  EXPECT_EQ(about.standard_deviation, 5e3);
  EXPECT_EQ(about.si_unit, "W");
  EXPECT_EQ(about.unit, "kW");
  EXPECT_DOUBLE_EQ(about.units_per_si, 1e-3);
  EXPECT_EQ(only({power, "input.power=100 kW"}).mean, 100e3);
}

TEST(UncertainCase, NormalNumberIsCutOff) {
  const UncertainInput cut = only({viscosity});
  EXPECT_EQ(cut.distribution, "truncated-normal");
  EXPECT_DOUBLE_EQ(cut.value, 0.01);
  EXPECT_DOUBLE_EQ(cut.mean, 0.012);
  EXPECT_DOUBLE_EQ(cut.from, 0.008);
  EXPECT_TRUE(std::isnan(cut.to));
}

// [ISO5753], cylindrical rollers, bore above 24 to 30 mm: CN from 20 to 45 um.
TEST(UncertainCase, ClearanceClassIsARange) {
  const UncertainInput clearance = only(with_catalogue({"uncertain.bearing.radial_clearance={class: CN}"}));
  EXPECT_EQ(clearance.distribution, "uniform");
  EXPECT_DOUBLE_EQ(clearance.from, 20e-6);
  EXPECT_DOUBLE_EQ(clearance.to, 45e-6);
}

TEST(UncertainCase, EachElementOfAListIsByItself) {
  const UncertainInputs pins = uncertain_inputs(
      shipped({"gearset.dynamics.pin_error.radial=[0 um, 0 um, 3 um, 0 um]",
               "uncertain.gearset.dynamics.pin_error.radial={uniform: {from: -2 um, to: 2 um}}",
               "uncertain.correlations={of: ['gearset.dynamics.pin_error.radial[0]', "
               "'gearset.dynamics.pin_error.radial[2]'], matrix: [[1, 0.5], [0.5, 1]]}"}));
  ASSERT_EQ(pins.inputs.size(), 4U);
  EXPECT_EQ(pins.inputs[2].path, "gearset.dynamics.pin_error.radial[2]");
  EXPECT_DOUBLE_EQ(pins.inputs[2].value, 3e-6);
  EXPECT_THAT(pins.correlations[2], ElementsAre(0.5, 0.0, 1.0, 0.0));
}

TEST(UncertainCase, StandsInTheResolvedCase) {
  const ResolvedCase first = shipped(
      {power, viscosity,
       "uncertain.correlations={of: [input.power, lubricant.viscosity], matrix: [[1, -0.25], [-0.25, 1]]}"});
  const ResolvedCase again = parse_case(write_resolved(first), "again.yaml");
  EXPECT_TRUE(again == first);
  EXPECT_EQ(write_resolved(again), write_resolved(first));
  EXPECT_EQ(uncertain_json(again).dump(), uncertain_json(first).dump());
  EXPECT_EQ(uncertain_json(again)["correlations"][0][1], -0.25);
  EXPECT_NE(case_hash(first), case_hash(shipped()));
}

TEST(UncertainCase, IsOfNoUseToASweepThatIsGivenIt) {
  EXPECT_THAT(
      require_used(shipped({power}), AnalysisId::quasi_static),
      testing::Contains(AllOf(StartsWith("uncertain.input.power"), HasSubstr("used by uncertainty"))));
  EXPECT_THAT(uncertain_warnings(shipped(
                  {"uncertain.bearing.cage.pocket_stiffness={normal: {standard_deviation: 1e5 N/m}}"})),
              ElementsAre(HasSubstr("not modelled by")));
  EXPECT_THAT(uncertain_warnings(shipped({power})), IsEmpty());
}

std::vector<std::string> refused(const std::string& path, const std::string& distribution) {
  return setting_mistakes({"uncertain." + path + "=" + distribution});
}

TEST(UncertainCase, ReportsMistakesOfItsKeys) {
  EXPECT_THAT(refused("input.powr", "{uniform: {from: 1 kW, to: 2 kW}}"),
              ElementsAre(HasSubstr("did you mean 'input.power'?")));
  EXPECT_THAT(refused("input", "{uniform: {from: 1 kW, to: 2 kW}}"),
              ElementsAre(HasSubstr("the whole path")));
  EXPECT_THAT(refused("bearing.rollers", "{uniform: {from: 1, to: 2}}"),
              ElementsAre(HasSubstr("no real number")));
  EXPECT_THAT(refused("input.power", "5 kW"), ElementsAre(HasSubstr("'5 kW' found; one of {normal")));
  EXPECT_THAT(refused("input.power", "{}"), ElementsAre(HasSubstr("no distributions")));
  EXPECT_THAT(refused("input.power", "{gamma: {from: 1 kW}}"),
              ElementsAre(HasSubstr("power.gamma: unknown key"), HasSubstr("no distributions")));
  EXPECT_THAT(refused("input.power", "{uniform: {from: 1 kW}}"),
              ElementsAre(HasSubstr("uniform.to: missing")));
  EXPECT_THAT(refused("input.power", "{uniform: {from: 1 mm, to: 2 kW}}"),
              ElementsAre(AllOf(HasSubstr("uniform.from"), HasSubstr("does not measure"))));
  EXPECT_THAT(refused("input.power", "{normal: {standard_deviation: 0 kW}}"),
              ElementsAre(HasSubstr("greater than 0")));
  EXPECT_THAT(refused("input.power", "{triangular: {from: 1 kW, peak: 3 kW, to: 2 kW}}"),
              ElementsAre(HasSubstr("a peak outside")));
  EXPECT_THAT(refused("input.power", "{uniform: {from: 2 kW, to: 1 kW}}"),
              ElementsAre(HasSubstr("not less than 'to'")));
  EXPECT_THAT(refused("lubricant.viscosity", "{class: CN}"), ElementsAre(HasSubstr("what is no clearance")));
  EXPECT_THAT(
      refused("input.power", "{normal: {standard_deviation: 5 kW, relative_standard_deviation: 0.1}}"),
      ElementsAre(HasSubstr("found together with relative_standard_deviation")));
  EXPECT_THAT(refused("input.power", "{normal: {mean: 150 kW}}"),
              ElementsAre(HasSubstr("standard_deviation: missing")));
  EXPECT_THAT(refused("input.power", "{normal: {relative_standard_deviation: 5 kW}}"),
              ElementsAre(HasSubstr("relative_standard_deviation")));
}

// Measurements on single bearings have uncertain inputs as those on drivetrains.
TEST(UncertainCase, MayBeOfAnyModel) {
  EXPECT_THAT(mistakes(bearing_case + "uncertain:\n  load.radial: {normal: {standard_deviation: 5 N}}\n"),
              IsEmpty());
  EXPECT_THAT(mistakes(bearing_case + "uncertain:\n  input.power: {normal: {standard_deviation: 5 N}}\n"),
              ElementsAre(HasSubstr("unknown path")));
}

TEST(UncertainCase, NormalNumberMaySpreadByAShareOfItsMean) {
  EXPECT_DOUBLE_EQ(
      only({"uncertain.input.power={normal: {relative_standard_deviation: 0.02}}"}).standard_deviation, 3e3);
  EXPECT_DOUBLE_EQ(only({"uncertain.input.power={normal: {relative_standard_deviation: 0.02, mean: 100 kW}}"})
                       .standard_deviation,
                   2e3);
}

TEST(UncertainCase, ReportsWhatDoesNotFitTheCase) {
  EXPECT_THAT(refused("input.power", "{normal: {standard_deviation: 26 kW}}"),
              ElementsAre(HasSubstr("beyond the range")));
  EXPECT_THAT(refused("input.power", "{normal: {standard_deviation: 26 kW, from: 100 kW}}"), IsEmpty());
  EXPECT_THAT(refused("input.power", "{normal: {standard_deviation: 1 kW, from: 151 kW}}"),
              ElementsAre(HasSubstr("a mean outside")));
  EXPECT_THAT(refused("bearing.radial_clearance", "{class: CN}"), ElementsAre(HasSubstr("unmounted")));
  EXPECT_THAT(refused("bearing.roller_diameter", "{uniform: {from: 5 mm, to: 8 mm}}"),
              ElementsAre(AllOf(HasSubstr("'8 mm' contradicts"), HasSubstr("do not fit"))));
  EXPECT_THAT(refused("gearset.dynamics.pin_error.radial", "{uniform: {from: -1 um, to: 1 um}}"),
              ElementsAre(HasSubstr("a number that the case does not have")));
}

TEST(UncertainCase, ShareOfZeroIsNoDeviation) {
  EXPECT_THAT(
      refused("bearing.radial_clearance", "{normal: {relative_standard_deviation: 0.1}}"),
      ElementsAre(
          AllOf(HasSubstr("uncertain.bearing.radial_clearance: a relative_standard_deviation of a mean of 0"),
                HasSubstr("standard_deviation above 0"))));
}

std::vector<std::string> correlated(const std::string& correlations) {
  return setting_mistakes({power, viscosity, "uncertain.correlations=" + correlations});
}

TEST(UncertainCase, ReportsImpossibleCorrelations) {
  EXPECT_THAT(correlated("{of: [input.power, lubricant.viscosity], matrix: [[1, 0.5], [0.4, 1]]}"),
              ElementsAre(HasSubstr("not symmetric")));
  EXPECT_THAT(correlated("{of: [input.power, lubricant.viscosity], matrix: [[1, 1], [1, 1]]}"),
              ElementsAre(HasSubstr("not positive definite")));
  EXPECT_THAT(correlated("{of: [input.power, lubricant.viscosity], matrix: [[1, 2], [2, 1]]}"),
              testing::Each(HasSubstr("from -1 to 1")));
  EXPECT_THAT(correlated("{of: [input.power, bearing.bore], matrix: [[1, 0], [0, 1]]}"),
              ElementsAre(HasSubstr("'bearing.bore' as a path")));
  EXPECT_THAT(correlated("{of: [input.power, input.power], matrix: [[1, 0], [0, 1]]}"),
              ElementsAre(HasSubstr("is listed twice")));
  EXPECT_THAT(correlated("[1]"), ElementsAre(HasSubstr("{of: [PATH, ...]")));
}

}  // namespace
}  // namespace orbearing::app::uncertain_case_test
