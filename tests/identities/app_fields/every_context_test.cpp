// The same as every_field_test in cases that use more of the features: in each, every field is changed by
// itself. A field that the analysis is stated to use changes its result; one that is stated to have no
// effect, or not to be modelled, leaves it equal to the last bit.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>

#include "app/case/unused_inputs.hpp"
#include "app/case/use_conditions.hpp"
#include "app/errors.hpp"
#include "tests/identities/app_fields/analysis_results.hpp"
#include "tests/identities/app_fields/field_bases.hpp"

namespace orbearing::app::every_context_test {
namespace {

using namespace fields_test;

struct Context {
  std::string name;
  std::string base;
  std::vector<std::string> settings;
  AnalysisSet analyses{};
};

const std::string kDynamics = "gearset.dynamics.";

std::vector<Context> contexts_of_rollers_at_rest() {
  const std::string set = "bearing_in_a_set", laminae = "bearing.laminae=20", kind = "bearing.profile.kind=";
  const std::string grade = "lubricant.grade=ISO VG 32", clean = "life.cleanliness=high";
  constexpr AnalysisSet rest = AnalysisId::quasi_static;
  return {
      {"film_and_oil",
       set,
       {"film.enabled=true", grade, clean},
       rest | AnalysisId::crown | AnalysisId::gears | AnalysisId::modes | AnalysisId::planet_stiffness},
      {"oil_by_its_viscosity",
       set,
       {"life.contamination_factor=0.5", "lubricant.viscosity=0.004 Pa.s"},
       rest | AnalysisId::crown},
      {"kappa_by_film", set, {grade, clean, "life.viscosity_ratio_by=film"}, rest | AnalysisId::crown},
      {"end_drop",
       set,
       {laminae, kind + "fujiwara-kawase", "bearing.profile.end_drop=5 um"},
       rest | AnalysisId::crown | AnalysisId::planet_stiffness},
      {"design_load",
       set,
       {laminae, kind + "fujiwara-kawase", "bearing.profile.design_load=700 N"},
       rest | AnalysisId::crown},
      {"design_load_and_drop",
       set,
       {laminae, kind + "fujiwara-kawase", "bearing.profile.design_load=700 N", "bearing.profile.drop=5 um"},
       rest},
      {"end_drop_and_drop",
       set,
       {laminae, kind + "fujiwara-kawase", "bearing.profile.end_drop=5 um", "bearing.profile.drop=4 um"},
       rest},
      {"chamfer_and_tilt",
       set,
       {laminae, kind + "chamfer", "bearing.misalignment.planet_tilt=1 mrad"},
       rest | AnalysisId::planet_stiffness},
      {"tilt_of_two_level_bearings",
       set,
       {laminae, "bearing.per_planet=2", "bearing.tilt_state=computed"},
       rest},
      {"tilt_of_one_level_bearing", set, {laminae, "bearing.tilt_state=computed"}, rest | AnalysisId::crown},
      {"tilt_of_pins_held_at_one_end",
       set,
       {laminae, "bearing.per_planet=2", "bearing.tilt_state=computed", "support.pin_ends=one"},
       rest | AnalysisId::crown},
      {"tilt_under_helical_teeth",
       set,
       {laminae, "bearing.tilt_state=computed", "gearset.helix_angle=12 deg"},
       rest},
      {"elastic_rim",
       set,
       {"gearset.planet_rim=elastic"},
       rest | AnalysisId::mesh | AnalysisId::modes | AnalysisId::planet_stiffness},
      {"helical",
       set,
       {"gearset.helix_angle=12 deg"},
       rest | AnalysisId::mesh | AnalysisId::gears | AnalysisId::modes | AnalysisId::fmu_gearset},
      {"unmounted",
       set,
       {"bearing.clearance_state=unmounted", "bearing.fit.inner_interference=4 um",
        "bearing.fit.outer_interference=20 um"},
       rest | AnalysisId::mesh | AnalysisId::modes},
      {"rings_outer", set, {"bearing.rings=outer"}, rest | AnalysisId::modes},
      {"rings_none", set, {"bearing.rings=none"}, rest | AnalysisId::modes},
      {"full_complement", set, {"bearing.complement=full", "bearing.rollers=21"}, rest | AnalysisId::crown},
      {"stated_support", set, {"support.stiffness=6e8 N/m"}, rest | AnalysisId::gears | AnalysisId::modes},
      {"stated_bearing_stiffness",
       set,
       {kDynamics + "planet.bearing_stiffness=2.5e8 N/m"},
       AnalysisId::gears | AnalysisId::modes | AnalysisId::modes_at_speed | AnalysisId::fmu_gearset},
      {"held_carrier", set, {"gearset.fixed=carrier"}, rest | AnalysisId::mesh},
      {"driven_carrier", set, {"input.member=carrier", "gearset.fixed=sun"}, rest | AnalysisId::mesh},
      {"two_contacts_in_one_law", set, {"contact.law=iso16281"}, rest | AnalysisId::planet_stiffness},
      {"no_carrier_rotation",
       set,
       {"inertia.carrier_centrifugal=false", "inertia.coriolis=false"},
       rest | AnalysisId::modes_at_speed},
      {"spectrum", set, {"spectrum=[{power: 140 kW, speed: 17000 rpm, share: 1}]"}, rest},
      {"parallel_stage", set, {"parallel_stage.front=[30, 31]"}, rest | AnalysisId::mesh},
      {"displaced_and_stated_support", "displaced_pins", {"support.stiffness=6e8 N/m"}, rest},
      {"displaced_and_laminae", "displaced_pins", {laminae, kind + "circular"}, rest},
      {"several_in_oil",
       "multi_stage",
       {grade, clean, "film.enabled=true"},
       rest | AnalysisId::planet_stiffness},
      {"several_by_film", "multi_stage", {grade, clean, "life.viscosity_ratio_by=film"}, rest},
      {"first_set_tilts",
       "multi_stage",
       {"sets.first." + laminae, "sets.first.bearing.misalignment.planet_tilt=1 mrad"},
       rest}};
}

std::vector<Context> contexts_of_teeth() {
  const std::string set = "bearing_in_a_set", loaded = "gearset.tooth_contact=loaded";
  const AnalysisSet mesh_of_pair = analyses_of_machine(gear_pair, "mesh");
  return {{"loaded_teeth", set, {loaded}, AnalysisId::mesh},
          {"relieved_teeth",
           set,
           {loaded, "gearset.tip_relief.sun=20 um", "gearset.tip_relief.planet=10 um",
            "gearset.lead_crown.sun=10 um", "gearset.lead_slope.ring=10 um"},
           AnalysisId::mesh},
          {"helical_pair", "pair_of_gears", {"pair.helix_angle=12 deg"}, mesh_of_pair},
          {"pair_with_web", "pair_of_gears", {"pair.web.thickness=0.3"}, mesh_of_pair},
          {"stated_meshes",
           "gears_alone",
           {kDynamics + "mesh_stiffness.sun=4e8 N/m", kDynamics + "mesh_stiffness.ring=4e8 N/m"},
           AnalysisId::modes},
          {"springs_that_turn",
           "masses_and_springs",
           {kDynamics + "sun.torsional_stiffness=1e7 N/m"},
           analyses_with(analysis::Physics::vibration)}};
}

std::vector<Context> contexts_of_single_bearings() {
  const std::string rollers = "roller_bearing", balls = "ball_bearing",
                    rotating = "operation.shaft_speed=9000 rpm";
  const std::string laminae = "bearing.laminae=20", kind = "bearing.profile.kind=";
  const AnalysisSet of_rollers = analyses_of_machine(roller_bearing, "run", "stiffness"),
                    of_balls = analyses_of_machine(ball_bearing, "run", "stiffness"),
                    of_pair = analyses_of_machine(duplex_pair, "modes", "run");
  return {
      {"rollers_under_moment", rollers, {laminae, kind + "circular", "load.moment=2 N.m"}, of_rollers},
      {"rollers_tilted", rollers, {laminae, "load.tilt=1 mrad"}, of_rollers},
      {"rollers_end_drop",
       rollers,
       {laminae, kind + "fujiwara-kawase", "bearing.profile.end_drop=5 um"},
       of_rollers},
      {"rollers_in_oil",
       rollers,
       {"operation.shaft_speed=3000 rpm", "lubricant.grade=ISO VG 68", "life.cleanliness=high"},
       of_rollers},
      {"rollers_by_kappa", rollers, {"life.viscosity_ratio=2", "life.contamination_factor=0.4"}, of_rollers},
      {"rollers_in_oil_by_kappa",
       rollers,
       {"operation.shaft_speed=3000 rpm", "lubricant.grade=ISO VG 68", "life.viscosity_ratio=2",
        "life.contamination_factor=0.4"},
       of_rollers},
      {"rollers_bought", rollers, {"bearing.designation=NU 204"}, of_rollers},
      {"balls_turning", balls, {rotating}, of_balls},
      {"balls_without_mass", balls, {rotating, "equilibrium.ball_inertia=false"}, of_balls},
      {"balls_without_mass_filmed",
       balls,
       {rotating, "equilibrium.ball_inertia=false", "film.enabled=true"},
       of_balls},
      {"balls_filmed", balls, {rotating, "film.enabled=true", "lubricant.grade=ISO VG 68"}, of_balls},
      {"balls_in_oil",
       balls,
       {rotating, "lubricant.kinematic_viscosity=20 mm2/s", "life.cleanliness=high"},
       of_balls},
      {"balls_under_axial_load", balls, {"load.axial=300 N"}, of_balls},
      {"balls_over_speeds", balls, {"operation.speeds=[1000 rpm, 2000 rpm]", "load.axial=300 N"}, of_balls},
      {"pair_turning", "duplex_pair", {rotating}, of_pair},
      {"pair_without_mass", "duplex_pair", {rotating, "equilibrium.ball_inertia=false"}, of_pair},
      {"pair_back_to_back", "duplex_pair", {"arrangement=back-to-back"}, of_pair},
      {"pair_by_linear_formulas", "duplex_pair", {"stiffness=linear"}, of_pair},
      {"film_by_reynolds",
       "spin_film",
       {"film.solver=reynolds", "contact.ellipticity=3", "points=[[20 N, 5 m/s, 200 rad/s]]"},
       analyses_of_machine(spin_film, "run")},
      {"no_scratch", "raceway_defect", {"defect.race=none"}, run_of_scratches(false)},
      {"scratched_ball", "raceway_defect", {"defect.race=ball"}, run_of_scratches(false)},
      {"scratched_outer",
       "raceway_defect",
       {"defect.race=outer", "signal.run_up_from=0.8"},
       run_of_scratches(false)}};
}

std::vector<Context> contexts_in_motion() {
  const std::string set = "bearing_in_a_set", balls = "ball_bearing_in_time";
  const std::string grade = "lubricant.grade=ISO VG 32", clean = "life.cleanliness=high";
  const AnalysisSet run_of_balls = analyses_of_machine(ball_motion, "run");
  return {
      {"limiting_shear", set, {"traction.law=limiting-shear"}, AnalysisId::dynamic | AnalysisId::fmu_bearing},
      {"mixed",
       set,
       {"traction.law=limiting-shear", "contact.lubrication=mixed"},
       AnalysisId::dynamic | AnalysisId::monolithic | AnalysisId::fmu_bearing},
      {"kappa_by_film_in_motion",
       set,
       {grade, clean, "life.viscosity_ratio_by=film"},
       AnalysisId::dynamic | AnalysisId::co_simulated},
      {"squeezed", set, {"contact.squeeze=true"}, AnalysisId::dynamic | AnalysisId::fmu_bearing},
      {"full_in_motion",
       set,
       {"bearing.complement=full", "bearing.rollers=21"},
       AnalysisId::dynamic | AnalysisId::fmu_bearing},
      {"smooth_pockets",
       set,
       {"bearing.cage.pocket_friction=0", "traction.law=limiting-shear"},
       AnalysisId::dynamic},
      {"dry_air", set, {"drag.enabled=false"}, AnalysisId::dynamic | AnalysisId::fmu_bearing},
      {"run_up",
       set,
       {"input.acceleration=1000 rpm/s", "simulation.run_up_time=0.003 s"},
       AnalysisId::dynamic},
      {"gears_run_up",
       set,
       {kDynamics + "run_up.from=0.5", kDynamics + "run_up.duration=0.01 s"},
       AnalysisId::gears | AnalysisId::fmu_gearset},
      {"tilt_in_motion",
       set,
       {"bearing.laminae=10", "bearing.tilt_state=computed", "support.pin_ends=one"},
       AnalysisId::dynamic},
      {"several_by_film_in_motion",
       "multi_stage",
       {grade, clean, "life.viscosity_ratio_by=film"},
       AnalysisId::dynamic_of_sets},
      {"balls_eyring", balls, {"traction.law=ree-eyring"}, run_of_balls},
      {"balls_limiting_shear", balls, {"traction.law=limiting-shear"}, run_of_balls},
      {"balls_heated", balls, {"heat.enabled=true", "lubricant.flow=0.1 L/min"}, run_of_balls},
      {"balls_in_warm_oil",
       balls,
       {"heat.enabled=true", "heat.model=oil", "lubricant.flow=0.1 L/min", "lubricant.fill=parker",
        "traction.inlet_heating=goksem-hargreaves", "traction.ball_rolling_law=reynolds"},
       run_of_balls},
      {"balls_in_resting_oil", balls, {"drag.mixture=at-rest", "lubricant.flow=0.1 L/min"}, run_of_balls},
      {"balls_without_drag", balls, {"drag.enabled=false"}, run_of_balls},
      {"balls_squeezing",
       balls,
       {"contact.squeeze=true", "bearing.cage.pocket_film=hydrodynamic"},
       run_of_balls}};
}

struct Subject {
  Context context;
  const Base* base = nullptr;
  AnalysisId analysis = AnalysisId::quasi_static;
};

// tools/test --full runs all of them, apart from the other tests.
bool is_full() {
  const char* full = std::getenv("EVERY_CONTEXT");
  return full != nullptr && std::string(full) == "yes";
}

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  const std::vector<Context> motion = contexts_in_motion();
  for (const std::vector<Context>& contexts :
       {contexts_of_rollers_at_rest(), contexts_of_teeth(), contexts_of_single_bearings(), motion})
    for (const Context& context : contexts)
      for (const Base& base : bases())
        for (const AnalysisId analysis : every_analysis())
          if (base.name == context.base && context.analyses.has(analysis))
            all.push_back({context, &base, analysis});
  return all;
}

std::string subject_name(const testing::TestParamInfo<Subject>& info) {
  std::string name = info.param.context.name + "_" + analysis_name(info.param.analysis);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

// Fields that have an effect only in conditions that a short run may not reach.
bool counts_now_and_then(const std::string& path, const Context& context) {
  const bool filmed =
      std::ranges::find(context.settings, "bearing.cage.pocket_film=hydrodynamic") != context.settings.end();
  if (filmed && (path == "bearing.cage.pocket_damping" || path == "bearing.cage.pocket_friction"))
    return true;  // where a ball breaks through the film of its pocket
  static const std::set<std::string> paths{
      "bearing.cage.largest_eccentricity",
      "bearing.cage.touch_down_stiffness",  // where the cage comes so near
      "simulation.load_drift",
      "simulation.cage_drift",
      "simulation.most_revolutions",  // where it lasts so long
      kDynamics + "settling_periods",
      kDynamics + "backlash",
      kDynamics + "separation",  // where teeth part
      "bearing.cage.pocket_straight"};
  return paths.contains(path);
}

bool is_label(const Field& field) {
  static const std::set<std::string> labels{"name", "source", "model", "bearing.type", "shafts"};
  return labels.contains(field.path);
}

// In motion a field takes a quarter of a second, and loaded teeth take half: each day some of them.
bool is_left_to_full_tests(const Field& field, const Subject& subject) {
  if (is_full()) return false;
  const AnalysisSet motions = analyses_with(analysis::Physics::run) | AnalysisId::fmu_bearing |
                              AnalysisId::fmu_gearset | AnalysisId::gears | run_of_scratches(false);
  const AnalysisSet slow =
      motions | analyses_of_machine(ball_motion, "run") | analyses_of_machine(duplex_pair, "run");
  const auto part = static_cast<std::size_t>(find_field(field.path) - all_fields().data());
  if (slow.has(subject.analysis)) return true;
  const auto hash = std::hash<std::string>{}(subject.context.name);
  return (part + hash) % 8 != 0;
}

// Meshes hold a planet that does not tilt: what they are differs in the last digits of nothing.
bool affects_rounding_alone(const std::string& path, const Subject& subject) {
  const bool level = subject.context.name.find("level_bearing") != std::string::npos;
  return level && (makes_meshes(path) || path == "bearing.bore" || path == "gearset.sun_bore_ratio" ||
                   path == "gearset.ring_outside_ratio");
}

class EveryContext : public testing::TestWithParam<Subject> {
 protected:
  // The context, with what `more` replaces.
  ResolvedCase in(const std::vector<std::string>& more) const {
    std::vector<std::string> settings;
    const auto path_of = [](const std::string& setting) { return setting.substr(0, setting.find('=')); };
    for (const std::string& setting : GetParam().context.settings)
      if (std::none_of(more.begin(), more.end(),
                       [&](const std::string& one) { return path_of(one) == path_of(setting); }))
        settings.push_back(setting);
    settings.insert(settings.end(), more.begin(), more.end());
    const Base& base = *GetParam().base;
    return parse_case(base.text, base.name + ".yaml", settings);
  }
};

TEST_P(EveryContext, TellsWhatIsUsed) {
  const AnalysisId analysis = GetParam().analysis;
  const ResolvedCase plain = in({});
  std::string before;
  int used = 0, without = 0, refused = 0;
  for (const Input& input : plain.inputs()) {
    const Field& field = *input.field;
    if (is_left_to_full_tests(field, GetParam()) || is_label(field) ||
        counts_now_and_then(field.path, GetParam().context))
      continue;
    const std::string set = GetParam().base->set;
    if (set_prefix_length(input.path) > 0 && !input.path.starts_with(set_prefix(set))) continue;
    Change change = change_of(field, plain, input.path);
    if (change.value.empty() || (plain.has(input.path) && plain.given(input.path) == change.value)) continue;
    if (affects_rounding_alone(field.path, GetParam())) continue;
    std::vector<std::string> more{input.path + "=" + change.value};
    for (const std::string& setting : change.together) more.push_back(setting);
    SCOPED_TRACE(more.front() + ", " + analysis_name(analysis));
    UseStatus status = UseStatus::neutral;
    std::string after;
    bool warned = false;
    try {
      const ResolvedCase changed = in(more);
      status = use_status_of(changed, input, analysis);
      for (const std::string& warning : require_used(changed, analysis))
        warned = warned ||
                 (warning.starts_with(input.path + ":") && warning.find("inferred") == std::string::npos);
      if (status == UseStatus::neutral) continue;
      after = result_of(changed, analysis);
    } catch (const BadInput&) {
      ++refused;  // which combinations are, and in which words, is tested elsewhere
      continue;
    }
    if (before.empty()) before = result_of(plain, analysis);
    if (status == UseStatus::used) {
      EXPECT_NE(before, after) << "said to be used, and the result is the same";
      EXPECT_FALSE(warned);
      ++used;
    } else {
      EXPECT_EQ(before == after, true) << "said to have no effect, and the result changed";
      EXPECT_TRUE(warned) << "an option without effect, and nothing is said";
      ++without;
    }
  }
  std::cout << fmt::format("fields: {} used, {} without effect, {} refused\n", used, without, refused);
}

INSTANTIATE_TEST_SUITE_P(AllCases, EveryContext, testing::ValuesIn(subjects()), subject_name);

}  // namespace
}  // namespace orbearing::app::every_context_test
