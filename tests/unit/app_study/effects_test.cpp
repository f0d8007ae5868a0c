// Effects of the motion in time are data, switched one at a time: each one does something, and a switch
// undoes itself. Issue 13, Build 6.
#include "app/study/effects.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::effects_test {
namespace {

const NamedChange& named(const std::vector<NamedChange>& list, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const NamedChange& one) { return one.name == name; });
  if (found == list.end()) throw std::out_of_range(name);
  return *found;
}

std::set<std::string> names(const std::vector<NamedChange>& list) {
  std::set<std::string> all;
  for (const NamedChange& one : list) all.insert(one.name);
  return all;
}

ResolvedCase three_sets() {
  return read_case(ORBEARING_SOURCE_DIR "/cases/three_sets_150kW/case.yaml");
}

// A short run of a bearing that no gears shake.
study::PointResult short_run(std::vector<study::NamedSet> sets, study::Fidelity fidelity) {
  study::PlanetaryDrivetrain& drivetrain = sets.front().drivetrain;
  drivetrain.gear_set = nullptr;
  drivetrain.steady_state.most_windows = 2;
  drivetrain.steady_state.observed_windows = 1;
  drivetrain.steady_state.series_samples = 100;
  return study::evaluate(sets, fidelity);
}

TEST(EffectsInMotion, EachChangesTheMotion) {
  const ResolvedCase resolved = shipped();
  std::vector<NamedChange> list = effects_in_motion(resolved, true);
  EXPECT_EQ(names(list).size(), list.size());
  std::erase_if(list, [](const NamedChange& one) { return one.group == "gears"; });
  const std::vector<ChangeResult> results = results_of(resolved, list,
                                                       {.speed = {resolved.quantity("input.speed")},
                                                        .fidelity = study::Fidelity::dynamic,
                                                        .evaluate = short_run});
  const study::PointResult& reference = results.front().points.front();
  for (const ChangeResult& result : results) {
    SCOPED_TRACE(result.change.name);
    const study::PointResult& point = result.points.front();
    ASSERT_EQ(point.status, "ok");
    EXPECT_GT(point.life_hours, 0.0);
    if (&result == &results.front()) continue;
    EXPECT_NE(point.cage_slip, reference.cage_slip);
    // Only the cage's reference leaves the rollers as they were; the path to it differs all the same.
    EXPECT_NE(point.dynamic->loss.total(), reference.dynamic->loss.total());
  }
}

TEST(EffectsInMotion, SwitchOnWhatIsOffAndOffWhatIsOn) {
  const ResolvedCase stated = shipped();
  const std::vector<NamedChange> before = effects_in_motion(stated, true);
  const std::pair<const char*, const char*> switches[] = {
      {"film in the approach", "no film in the approach"},
      {"limiting-shear traction", "Coulomb traction"},
      {"mixed lubrication", "no mixed lubrication"},
      {"film in the pockets", "no film in the pockets"},
      {"cage on the inner ring", "cage on the outer ring"}};
  const char* land = "bearing.cage.guide_land_diameter";
  ResolvedCase changed = stated;
  for (const auto& [on, off] : switches) changed = with_settings(changed, named(before, on).settings);
  EXPECT_NEAR(changed.quantity(land), 33.44e-3 - 0.34e-3, 1e-12);
  const std::vector<NamedChange> after = effects_in_motion(changed, true);
  for (const auto& [on, off] : switches) {
    EXPECT_EQ(names(after).count(on), 0u) << on;
    changed = with_settings(changed, named(after, off).settings);
  }
  EXPECT_EQ(names(effects_in_motion(changed, true)), names(before));
  EXPECT_NEAR(changed.quantity(land), 38.88e-3, 1e-12);
}

TEST(EffectsInMotion, LeaveOutWhatTheCaseHasNotOrHasAlready) {
  const std::vector<NamedChange> of_a_set = effects_in_motion(three_sets(), true, "reduction");
  EXPECT_EQ(names(of_a_set).count("constant mesh stiffness"), 0u);
  const ResolvedCase without_land =
      parse_case(replaced(text_of(shipped_path()), "    guide_land_diameter: 38.88 mm\n", ""), "case.yaml",
                 {"contact.damping_law=as-printed"});
  const std::set<std::string> left = names(effects_in_motion(without_land, true));
  EXPECT_EQ(left.count("constant mesh stiffness"), 1u);
  EXPECT_EQ(left.count("cage on the inner ring"), 0u);
  EXPECT_EQ(left.count("damping as printed"), 0u);
}

TEST(EffectsInMotion, OfSeveralSetsChangeTheOneThatIsLookedAt) {
  const ResolvedCase stated = three_sets();
  const std::string land = "bearing.cage.guide_land_diameter";
  const std::vector<NamedChange> list = effects_in_motion(stated, true, "reduction");
  const ResolvedCase changed = with_settings(stated, named(list, "cage on the inner ring").settings);
  EXPECT_NEAR(changed.quantity("sets.reduction." + land), 33.44e-3 - 0.34e-3, 1e-12);
  EXPECT_EQ(changed.quantity("sets.coupling." + land), stated.quantity("sets.coupling." + land));
}

// A wave more stands beside those that the case has.
TEST(EffectsInMotion, KeepTheFormsOfTheCase) {
  const std::string block = "bearing.outer_race.out_of_roundness";
  const ResolvedCase stated =
      shipped({block + ".order=[3]", block + ".amplitude=[1 um]", block + ".phase=[30 deg]"});
  const ResolvedCase changed =
      with_settings(stated, named(effects_in_motion(stated, true), "oval bore, 5 um").settings);
  EXPECT_EQ(changed.list(block + ".order"), (std::vector<double>{3.0, 2.0}));
  EXPECT_EQ(changed.list(block + ".amplitude").front(), stated.list(block + ".amplitude").front());
  EXPECT_EQ(changed.list(block + ".amplitude").back(), 5e-6);
  EXPECT_EQ(changed.list(block + ".phase").back(), 0.0);
}

TEST(EffectsAtRest, LeaveOutAClearanceThatTheCageHasNoRoomFor) {
  EXPECT_EQ(names(effects_at_rest(shipped())).size(), 9u);
  const ResolvedCase tight =
      shipped({"bearing.radial_clearance=38 um", "bearing.cage.inner_diameter=30.385 mm"});
  const std::set<std::string> left = names(effects_at_rest(tight));
  EXPECT_EQ(left.count("clearance 0 um"), 0u);
  EXPECT_EQ(left.count("clearance 37 um"), 1u);
}

}  // namespace
}  // namespace orbearing::app::effects_test
