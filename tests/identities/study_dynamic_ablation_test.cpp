// Effects of the motion in time, switched one at a time: each one does something, and a switch undoes itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "coupling/study/ablation.hpp"
#include "tests/reducer.hpp"

namespace orbearing::study::study_dynamic_ablation_test {
namespace {

PlanetaryDrivetrain short_run() {
  PlanetaryDrivetrain drivetrain = example::reducer();
  drivetrain.dynamics.cage.guide_diameter = 38.88e-3;
  drivetrain.steady_state.integration.method = integration::Method::linearly_implicit;
  drivetrain.steady_state.most_windows = 2;
  drivetrain.steady_state.observed_windows = 1;
  drivetrain.steady_state.series_samples = 100;
  return drivetrain;
}

const Ablation& named(const std::vector<Ablation>& list, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Ablation& one) { return one.name == name; });
  if (found == list.end()) throw std::out_of_range(name);
  return *found;
}

std::set<std::string> names(const std::vector<Ablation>& list) {
  std::set<std::string> all;
  for (const Ablation& one : list) all.insert(one.name);
  return all;
}

TEST(DynamicAblation, EveryEffectChangesTheMotion) {
  const PlanetaryDrivetrain drivetrain = short_run();
  const std::vector<Ablation> list = dynamic_ablations(drivetrain);
  EXPECT_EQ(names(list).size(), list.size());
  const std::vector<PointResult> points =
      evaluate_all(drivetrain, list, {drivetrain.drive.speed}, Fidelity::dynamic);
  for (std::size_t i = 0; i < points.size(); ++i) {
    SCOPED_TRACE(list[i].name);
    ASSERT_EQ(points[i].status, "ok");
    EXPECT_GT(points[i].life_hours, 0.0);
    if (i == 0) continue;
    EXPECT_NE(points[i].cage_slip, points[0].cage_slip);
    // Only the cage's reference leaves the rollers as they were; the path to it differs all the same.
    EXPECT_NE(points[i].dynamic->loss.total(), points[0].dynamic->loss.total());
  }
}

TEST(DynamicAblation, SwitchesOnWhatIsOffAndOffWhatIsOn) {
  PlanetaryDrivetrain drivetrain = short_run();
  const std::vector<Ablation> before = dynamic_ablations(drivetrain);
  const std::pair<const char*, const char*> switches[] = {
      {"film in the approach", "no film in the approach"},
      {"limiting-shear traction", "Coulomb traction"},
      {"mixed lubrication", "no mixed lubrication"},
      {"film in the pockets", "no film in the pockets"},
      {"cage on the inner ring", "cage on the outer ring"}};
  for (const auto& [on, off] : switches) named(before, on).change(drivetrain);
  EXPECT_NEAR(drivetrain.dynamics.cage.guide_diameter, 33.44e-3 - 0.34e-3, 1e-12);
  const std::vector<Ablation> after = dynamic_ablations(drivetrain);
  for (const auto& [on, off] : switches) {
    EXPECT_EQ(names(after).count(on), 0u) << on;
    named(after, off).change(drivetrain);
  }
  EXPECT_EQ(names(dynamic_ablations(drivetrain)), names(before));
  EXPECT_NEAR(drivetrain.dynamics.cage.guide_diameter, 38.88e-3, 1e-12);
}

TEST(DynamicAblation, LeavesOutWhatTheDrivetrainHasNotOrHasAlready) {
  PlanetaryDrivetrain drivetrain = short_run();
  EXPECT_EQ(names(dynamic_ablations(drivetrain)).count("constant mesh stiffness"), 0u);
  drivetrain.dynamics.cage.guide_diameter = 0.0;
  drivetrain.dynamics.race.damping_law = bearing::motion::DampingLaw::as_printed;
  drivetrain.gear_set = [] { return gearset::dynamics::SetParameters{}; };
  const std::set<std::string> left = names(dynamic_ablations(drivetrain));
  EXPECT_EQ(left.count("constant mesh stiffness"), 1u);
  EXPECT_EQ(left.count("cage on the inner ring"), 0u);
  EXPECT_EQ(left.count("damping as printed"), 0u);
}

}  // namespace
}  // namespace orbearing::study::study_dynamic_ablation_test
