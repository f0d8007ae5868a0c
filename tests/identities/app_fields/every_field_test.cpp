// Nothing is ignored in silence: every field of every kind of case, changed under every analysis, changes the
// result, or is refused, or is warned of; and a field that an analysis is stated not to model, or to ignore,
// leaves its result equal to the last bit. So the table of fields cannot be wrong in either direction.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>

#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "tests/full.hpp"
#include "tests/identities/app_fields/analysis_results.hpp"
#include "tests/identities/app_fields/field_bases.hpp"

namespace orbearing::app::every_field_test {
namespace {

using namespace fields_test;
using test::is_full;
using testing::HasSubstr;

struct Subject {
  const Base* base = nullptr;
  AnalysisId analysis = AnalysisId::quasi_static;
};

ResolvedCase case_of(const Base& base, const std::vector<std::string>& settings) {
  return parse_case(base.text, base.name + ".yaml", settings);
}

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  for (const Base& base : bases())
    for (const AnalysisId analysis : analyses_of(case_of(base, {})))
      if (!base.but.has(analysis)) all.push_back({&base, analysis});
  return all;
}

std::string subject_name(const testing::TestParamInfo<Subject>& info) {
  std::string name = info.param.base->name + "_" + analysis_name(info.param.analysis);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

// Words, not numbers: nothing is computed from them, or there is one choice alone; and checks of what
// follows, of which another value is refused (StatedGeometry in unit/app_case/consistency_test).
bool is_label(const Field& field) {
  static const std::set<std::string> labels{"name",
                                            "source",
                                            "model",
                                            "bearing.type",
                                            "shafts",
                                            "gearset.centre_distance",
                                            "gearset.profile_shift.planet"};
  return labels.contains(field.path);
}

// Outcome for one pair of field and analysis.
struct Verdict {
  bool refused = false;
  bool warned = false;
  bool changed = false;
  std::string text;  // refusal or warnings
};

class EveryField : public testing::TestWithParam<Subject> {
 protected:
  std::string in_set(const std::string& setting) const {
    const std::string path = setting.substr(0, setting.find('='));
    const Field* field = find_field(path);
    const bool of_set = !base().set.empty() && field != nullptr && in_each_set(*field);
    return (of_set ? set_prefix(base().set) : "") + setting;
  }

  // Settings for a run-up of another part are left out where this analysis does not have them.
  std::vector<std::string> beside(const Change& change) {
    std::vector<std::string> settings;
    for (const std::string& setting : change.beside) {
      const std::string path = setting.substr(0, setting.find('='));
      if ((find_field(path)->models & in({}).model()) == 0) continue;
      const bool run_up = path.find("run_up") != std::string::npos || path == "input.acceleration";
      if (run_up && !use_of(*find_field(path)).by.has(GetParam().analysis)) continue;
      settings.push_back(in_set(setting));
    }
    return settings;
  }

  // Settings of the changed case: those of the case that it is compared with, and the change.
  std::vector<std::string> changed(const Input& input, const std::vector<std::string>& beside,
                                   const Change& change) const {
    std::vector<std::string> settings = beside;
    for (const std::string& setting : change.together) settings.push_back(in_set(setting));
    settings.push_back(input.path + "=" + change.value);
    return settings;
  }

  Verdict judge(const Input& input, const std::vector<std::string>& beside, const Change& change) {
    Verdict verdict;
    try {
      const std::vector<std::string> settings = changed(input, beside, change);
      for (const std::string& warning : require_used(in(settings), GetParam().analysis))
        if (warning.starts_with(input.path + ":")) verdict.text += warning;
      // The warning of values inferred from a designation is given wherever they are used: it is no warning
      // of the field.
      verdict.warned = !verdict.text.empty() && verdict.text.find("is inferred from") == std::string::npos;
      verdict.changed = result(settings) != result(beside);
    } catch (const BadInput& refusal) {
      verdict.refused = true;
      verdict.text = refusal.what();
    }
    return verdict;
  }

  // Whether both cases can be read.
  bool are_cases(const Input& input, const std::vector<std::string>& beside, const Change& change) {
    try {
      in(beside);
      in(changed(input, beside, change));
    } catch (const BadInput&) {
      return false;
    }
    return true;
  }

  UseStatus row_status(const Input& input, const std::vector<std::string>& beside, const Change& change) {
    return use_status_of(in(changed(input, beside, change)), input, GetParam().analysis);
  }

  const Base& base() const { return *GetParam().base; }
  const Use& use_of(const Field& field) { return field.use_in(in({}).model()); }

 private:
  // Results are kept: the reference of one field is sometimes the changed case of another.
  const std::string& result(const std::vector<std::string>& settings) {
    const auto found = results_.find(settings);
    if (found != results_.end()) return found->second;
    return results_[settings] = result_of(in(settings), GetParam().analysis);
  }

  // Reading a case takes as long as many a result.
  const ResolvedCase& in(const std::vector<std::string>& settings) {
    const auto found = cases_.find(settings);
    if (found != cases_.end()) return found->second;
    return cases_.emplace(settings, case_of(base(), settings)).first->second;
  }

  std::map<std::vector<std::string>, ResolvedCase> cases_;
  std::map<std::vector<std::string>, std::string> results_;
};

// Fields of analyses in motion, of a second crown or of tilting planets of several sets take up to a quarter
// of a second each: each day a part of them is tested, a different one for each fidelity, of those in motion
// a quarter for each; all of them for each with ORBEARING_FULL=yes.
bool is_left_to_full_tests(const Field& field, const Subject& subject) {
  if (is_full()) return false;
  const AnalysisId analysis = subject.analysis;
  const auto location = static_cast<std::size_t>(find_field(field.path) - all_fields().data());
  const auto unless = [&](std::size_t part, std::size_t parts) { return location % parts != part; };
  const AnalysisSet run_of_balls = analyses_of_machine(ball_motion, "run");
  switch (analysis) {
    case AnalysisId::gears:
    case AnalysisId::fmu_bearing:
      return unless(0, 3);
    case AnalysisId::modes_at_speed:
      return unless(1, 3);
    case AnalysisId::fmu_gearset:
      return unless(2, 3);
    case AnalysisId::dynamic:
      return unless(0, 24);
    case AnalysisId::dynamic_of_sets:
      return unless(2, 12);
    case AnalysisId::co_simulated:
      return unless(4, 12);
    case AnalysisId::monolithic:
      if (subject.base->name == "displaced_pins") return !field.path.starts_with("gearset.") || unless(6, 12);
      return unless(8, 12);
    case AnalysisId::planet_defect:  // what moves as by monolithic shares that part
      return field.use.by.has(AnalysisId::monolithic) && unless(10, 12);
    case AnalysisId::crown:
    case AnalysisId::planet_stiffness:
      return subject.base->name == "multi_stage" && unless(5, 6);
    default:
      break;
  }
  if (analysis ==
      run_of_scratches(true)) {  // balls roll as in a ball's run, and scratches act as without mass
    const bool elsewhere = field.use_in(raceway_defect).by.has(run_of_scratches(false)) ||
                           field.use_in(ball_motion).by.has_some_of(run_of_balls);
    return elsewhere && unless(1, 6);
  }
  return run_of_balls.has(analysis) && unless(4, 6);
}

struct Count {
  int used = 0, refused = 0, warned = 0, by_nature = 0;
};

void expect(UseStatus status, const Verdict& verdict, Count& count) {
  switch (status) {
    case UseStatus::used:
      EXPECT_FALSE(verdict.refused) << verdict.text;
      EXPECT_FALSE(verdict.warned) << verdict.text;
      EXPECT_TRUE(verdict.changed) << "said to be used, and the result is the same";
      ++count.used;
      return;
    case UseStatus::not_modelled:
      EXPECT_TRUE(verdict.refused || verdict.warned) << "set by an option and not warned of";
      EXPECT_FALSE(verdict.changed) << "said not to be modelled, and the result changed";
      ++count.by_nature;
      return;
    case UseStatus::idle:
    case UseStatus::unused:
      EXPECT_TRUE(verdict.warned) << "not used and not warned of";
      EXPECT_FALSE(verdict.changed) << "warned of as without effect, and the result changed";
      ++count.warned;
      return;
    case UseStatus::refused:
      EXPECT_TRUE(verdict.refused);
      EXPECT_THAT(verdict.text, HasSubstr("required"));
      ++count.refused;
      return;
    case UseStatus::neutral:
      ADD_FAILURE() << "the changed value is the default: nothing was tried";
  }
}

TEST_P(EveryField, ChangesTheResultOrIsReported) {
  const ResolvedCase plain = case_of(base(), {});
  Count count;
  for (const Input& input : plain.inputs()) {
    if (is_left_to_full_tests(*input.field, GetParam())) continue;
    if (stays_as_it_is(*input.field, plain)) continue;
    if (is_label(*input.field)) continue;
    if (set_prefix_length(input.path) > 0 && !input.path.starts_with(set_prefix(base().set))) continue;
    Change change = change_of(*input.field, plain, input.path);
    if (GetParam().analysis == AnalysisId::fmu_bearing)  // heats no inlet of the film
      std::erase(change.beside, "film.inlet_heating=gupta");
    SCOPED_TRACE(input.path + "=" + change.value + ", " + analysis_name(GetParam().analysis));
    // Fields of rollers alone are absent for balls; the cases with rollers change them.
    if (change.value.empty() && base().name == "planets_on_balls" && !plain.has(input.path)) continue;
    ASSERT_FALSE(change.value.empty()) << "no other value is known; add one to stated_changes()";
    if (base().reader_may_refuse && !are_cases(input, beside(change), change)) {
      ++count.refused;
      continue;
    }
    expect(row_status(input, beside(change), change), judge(input, beside(change), change), count);
  }
  std::cout << fmt::format("pairs: {} used, {} refused, {} warned, {} not modelled\n", count.used,
                           count.refused, count.warned, count.by_nature);
}

// Without the other inputs that it requires, a value has no effect, and that is reported.
TEST_P(EveryField, WithoutItsConditionIsReported) {
  const ResolvedCase plain = case_of(base(), {});
  int tried = 0;
  for (const Input& input : plain.inputs()) {
    if (is_left_to_full_tests(*input.field, GetParam())) continue;
    if (stays_as_it_is(*input.field, plain)) continue;
    // A field that has an effect only where another value is absent has its condition here.
    const Use& use = use_of(*input.field);
    const std::vector<Condition>& conditions = use.conditions;
    if (std::all_of(conditions.begin(), conditions.end(), [](const Condition& c) { return c.absent; }))
      continue;
    if (!use.by.has(GetParam().analysis)) continue;
    if (set_prefix_length(input.path) > 0 && !input.path.starts_with(set_prefix(base().set))) continue;
    const Change change = change_of(*input.field, plain, input.path);
    SCOPED_TRACE(input.path + "=" + change.value + ", " + analysis_name(GetParam().analysis));
    const Verdict verdict = judge(input, {}, change);
    if (verdict.changed && !verdict.warned) continue;  // its condition holds in the plain case
    EXPECT_TRUE(verdict.refused || (verdict.warned && !verdict.changed)) << verdict.text;
    ++tried;
  }
  std::cout << fmt::format("pairs: {} without their condition\n", tried);
}

INSTANTIATE_TEST_SUITE_P(AllCases, EveryField, testing::ValuesIn(subjects()), subject_name);

// Planets in pairs are a kind of gear train of their own: each of their fields changes a quasi-static point.
TEST(PlanetsInPairs, EachFieldChangesAPointAtRest) {
  const Base base{"planets_in_pairs", kDrivetrain + kGears + kBearing};
  const std::vector<std::string> pairs{"gearset.teeth.ring=121", "gearset.second_planet.teeth=24"};
  const auto result = [&](const std::string& setting) {
    std::vector<std::string> settings = pairs;
    if (!setting.empty()) settings.push_back("gearset.second_planet." + setting);
    return result_of(case_of(base, settings), AnalysisId::quasi_static);
  };
  const std::string plain = result("");
  for (const char* setting : {"teeth=25", "first_profile_shift=0.1", "profile_shift=0.1", "side=behind"})
    EXPECT_NE(result(setting), plain) << setting;
}

void expect_disjoint(const Use& use) {
  EXPECT_FALSE(use.by.has_some_of(use.not_modelled_by));
  EXPECT_FALSE(use.by.has_some_of(use.refused_by));
  EXPECT_FALSE(use.not_modelled_by.has_some_of(use.refused_by));
}

bool is_used_by_any(const Use& use) {
  return !use.by.is_empty() ||
         std::ranges::any_of(use.ways, [](const Way& way) { return !way.by.is_empty(); });
}

// A row states one status for each analysis.
TEST(FieldUse, AnalysesOfARowAreDisjoint) {
  for (const Field& field : all_fields()) {
    SCOPED_TRACE(field.path);
    expect_disjoint(field.use);
    bool used = is_used_by_any(field.use);
    for (const auto& [model, use] : field.of_machines) {
      expect_disjoint(use);
      used = used || is_used_by_any(use);
    }
    // A stage behind the sets has no effect on any of them: it is in the power flow of check.
    EXPECT_NE(used, field.path == "parallel_stage.behind") << "a field that nothing uses";
  }
}

// An analysis that no row names yet: everything that the case gives is warned of.
TEST(FieldUse, ANewAnalysisCannotForgetAField) {
  const auto unheard_of = static_cast<AnalysisId>(60);
  const ResolvedCase in = case_of(bases().front(), {"contact.damping=0.2 s/m"});
  const std::vector<std::string> warnings = require_used(in, unheard_of);
  EXPECT_THAT(warnings, testing::Contains(HasSubstr("contact.damping")));
  EXPECT_THAT(warnings, testing::Contains(HasSubstr("bearing.rollers")));
}

// A value that is not modelled causes no warning where the file gives it: one case serves all fidelities.
TEST(FieldUse, AFileIsNotWarnedOfWhatIsNotModelled) {
  EXPECT_TRUE(require_used(case_of(bases().front(), {}), AnalysisId::quasi_static).empty());
  for (const char* name :
       {"reducer_150kW", "coupling_set_150kW", "three_sets_150kW", "lin_parker_1999", "mesh_62_62",
        "planet_bearing_iso16281", "harris_209", "ball_6305_iso16281", "deep_groove_acceleration",
        "deep_groove_motor", "nasa_35mm", "scratch_defect", "scratched_rollers", "jones_218", "duplex_7020",
        "spin_film_guo2013", "spin_bearing_7210"}) {
    const ResolvedCase in = read_case(std::string(ORBEARING_SOURCE_DIR "/cases/") + name + "/case.yaml");
    for (const AnalysisId analysis : analyses_of(in))
      EXPECT_THAT(require_used(in, analysis), testing::IsEmpty()) << name << ", " << analysis_name(analysis);
  }
}

const Base& base_named(const std::string& name) {
  return *std::find_if(bases().begin(), bases().end(), [&](const Base& base) { return base.name == name; });
}

// Inputs that have an effect because of displaced pins have it in the set with these pins, not in another
// one.
TEST(FieldUse, PinsThatDoNotCountMakeNothingFelt) {
  const std::string block = "gearset.dynamics.", pins = "pin_error.tangential=[4 um, 0 um]";
  const std::string mass = "sun.mass=1.3 kg";
  const ResolvedCase one = case_of(base_named("bearing_in_a_set"), {block + pins, block + mass});
  EXPECT_THAT(require_used(one, AnalysisId::quasi_static), testing::IsEmpty());
  const std::string set = "sets.first." + block;
  const ResolvedCase several = case_of(base_named("multi_stage"), {set + pins, set + mass});
  EXPECT_THAT(require_used(several, AnalysisId::quasi_static), testing::IsEmpty());
  const std::string other = "sets.second." + block;
  const ResolvedCase even = case_of(base_named("multi_stage"), {set + pins, other + mass});
  EXPECT_THAT(require_used(even, AnalysisId::quasi_static), testing::Contains(HasSubstr(other + "sun.mass")));
}

std::string refusal_of(const Base& base, const std::vector<std::string>& settings, AnalysisId analysis,
                       Axes axes) {
  try {
    require_used(case_of(base, settings), analysis, axes);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(FieldUse, ASweepOfWhatIsNotUsedIsRefused) {
  const std::vector<std::string> pocket{"sweep.bearing.cage.pocket_friction=[0.05, 0.1]"};
  EXPECT_THAT(refusal_of(bases().front(), pocket, AnalysisId::quasi_static, Axes::all),
              HasSubstr("sweep.bearing.cage.pocket_friction"));
  EXPECT_EQ(refusal_of(bases().front(), pocket, AnalysisId::dynamic, Axes::all), "");
}

TEST(FieldUse, ASweepOfWhatHasNoEffectHereIsRefused) {
  const std::string axis = "sweep.lubricant.viscosity=[0.01 Pa.s, 0.02 Pa.s]";
  EXPECT_EQ(refusal_of(bases().front(), {axis}, AnalysisId::quasi_static, Axes::all), "");
  EXPECT_THAT(
      refusal_of(bases().front(), {axis, "lubricant.grade=ISO VG 220"}, AnalysisId::quasi_static, Axes::all),
      HasSubstr("it counts only where lubricant.grade is not given"));
  // The input of its condition may be swept too: then it has an effect at some of the points.
  const std::vector<std::string> both{"sweep.gearset.dynamics.run_up.from=[0.2, 0.4]",
                                      "sweep.gearset.dynamics.run_up.duration=[0 s, 1 s]"};
  EXPECT_THAT(refusal_of(bases().front(), both, AnalysisId::gears, Axes::all),
              Not(HasSubstr("has no effect")));
}

TEST(FieldUse, ASpectrumOfCrownTakesSpeedsAlone) {
  const std::string speeds = "sweep.input.speed=[1000 rpm, 2000 rpm]";
  EXPECT_EQ(refusal_of(bases().front(), {speeds}, AnalysisId::crown, Axes::speed), "");
  EXPECT_THAT(refusal_of(bases().front(), {speeds, "sweep.input.power=[20 kW, 30 kW]"}, AnalysisId::crown,
                         Axes::speed),
              HasSubstr("sweep.input.power"));
}

TEST(FieldUse, ASingleBearingHasNoSweep) {
  for (const Base& base : bases()) {
    if (base.text.find("planetary") != std::string::npos) continue;
    try {
      case_of(base, {"sweep.material.youngs_modulus=[200 GPa, 210 GPa]"});
      ADD_FAILURE() << base.name;
    } catch (const BadInput& error) {
      EXPECT_THAT(error.what(), HasSubstr("sweep: a sweep of a"));
    }
  }
}

}  // namespace
}  // namespace orbearing::app::every_field_test
