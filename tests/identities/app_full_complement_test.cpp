// A full complement of rollers and a planet without rings run at every fidelity, as the participant in an
// FMU, and continue from a saved state.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/case/case_file.hpp"
#include "app/study/planetary_case.hpp"
#include "coupling/analysis/driven_setups.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "tests/messages.hpp"

namespace orbearing::app::full_complement_test {
namespace {

using analysis::Fidelity;
using analysis::PointResult;

// On the pin and in the bore of two planets; few windows and coarse steps, since only the completion of the
// run is tested.
std::string planet(const std::string& bearing) {
  return R"(name: planet
source: a catalogue
model: planetary-drivetrain
input: {power: 75 kW, speed: 12000 rpm}
gearset:
  planets: 2
  teeth: {sun: 37, planet: 22, ring: 79}
  module: 3 mm
  profile_shift: {sun: 0.2618, ring: 0.4146}
  face_width: 28 mm
  dynamics: {observed_periods: 8, settling_periods: 100}
simulation: {observed_revolutions: 1, most_revolutions: 2, length_error: 1e-6 mm}
bearing: {type: cylindrical-roller, per_planet: 1, roller_diameter: 6 mm, roller_length: 20 mm,
  pitch_diameter: 36 mm, radial_clearance: 29 um, width: 22 mm, rings: none, )" +
         bearing + "}\n";
}

const std::string kFull = "complement: full";
const std::string kCaged =
    "rollers: 14, cage: {inner_diameter: 33.6 mm, outer_diameter: 38.8 mm, width: 21.5 mm, material: steel, "
    "guide_land_diameter: 39.2 mm}";

struct Rung {
  const char* name;
  Fidelity fidelity;
};

class EveryRung : public testing::TestWithParam<Rung> {
 protected:
  PointResult at_rung(const std::string& bearing) const {
    const analysis::NamedSet set = bearing_sets(parse_case(planet(bearing), "case.yaml", {})).front();
    return analysis::evaluate(set.drivetrain, set.geometry, GetParam().fidelity);
  }
  // Rollers in motion carry the quasi-static loads but for traction and the share that `shaken` allows for
  // vibration.
  void expect_loads_at_rest(const std::string& bearing, const PointResult& moving, double shaken) const {
    const analysis::NamedSet set = bearing_sets(parse_case(planet(bearing), "case.yaml", {})).front();
    const PointResult still = analysis::evaluate(set.drivetrain, set.geometry);
    EXPECT_NEAR(moving.outer.load_rms / still.outer.load_rms, 1.0, shaken);
    EXPECT_GT(moving.life_hours, 0.0);
    EXPECT_LT(moving.life_hours, 2.0 * still.life_hours);
  }
};

TEST_P(EveryRung, RunsRollersWithoutCageAndRings) {
  const PointResult result = at_rung(kFull);
  EXPECT_EQ(result.status, "ok");
  EXPECT_FALSE(result.caged);
  expect_loads_at_rest(kFull, result, 0.3);  // by the gears, and by neighbours that strike
  if (GetParam().fidelity == Fidelity::quasi_static) return;
  ASSERT_TRUE(result.dynamic.has_value());
  // Free rollers run ahead with the bore and queue before the load zone, through which they then roll without
  // gaps: 18 rollers that touch take 36 asin(6/36) of the circle, so that all go round faster than pure
  // rolling by what is left of it. Some slide, some gaps stay: within a third.
  const double play = 2.0 * M_PI / (36.0 * std::asin(6.0 / 36.0)) - 1.0;
  EXPECT_NEAR(result.dynamic->orbit_slip.value(), -play, play / 3.0);
  EXPECT_GT(result.dynamic->loss.neighbours, 0.0) << "rollers pushed one another";
  EXPECT_EQ(result.dynamic->loss.pockets, 0.0);
  EXPECT_EQ(result.dynamic->loss.guidance, 0.0);
}

TEST_P(EveryRung, RunsARinglessPlanetWithACage) {
  const PointResult result = at_rung(kCaged);
  EXPECT_EQ(result.status, "ok");
  EXPECT_TRUE(result.caged);
  expect_loads_at_rest(kCaged, result, 0.1);  // by the gears
  if (GetParam().fidelity == Fidelity::quasi_static) return;
  ASSERT_TRUE(result.dynamic.has_value());
  EXPECT_FALSE(result.dynamic->orbit_slip.has_value());
  EXPECT_EQ(result.dynamic->loss.neighbours, 0.0);
  EXPECT_GT(result.dynamic->loss.guidance, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Rungs, EveryRung,
                         testing::Values(Rung{"quasi_static", Fidelity::quasi_static},
                                         Rung{"dynamic", Fidelity::dynamic},
                                         Rung{"co_simulated", Fidelity::co_simulated},
                                         Rung{"monolithic", Fidelity::monolithic}),
                         [](const testing::TestParamInfo<Rung>& rung) { return rung.param.name; });

// Participant in an FMU: outputs name no cage, and a saved state continues to the same bits.
TEST(FullComplementParticipant, NamesTheRollersAndGoesOnFromASavedState) {
  const analysis::NamedSet set = bearing_sets(parse_case(planet(kFull), "case.yaml", {})).front();
  system::DrivenBearing bearing(analysis::driven_bearing_setup(set.drivetrain, set.geometry));
  std::vector<std::string> names;
  for (const system::Output& output : bearing.outputs()) names.push_back(output.name);
  EXPECT_THAT(names, testing::Contains("rollers.speed"));
  EXPECT_THAT(names, testing::Not(testing::Contains(testing::StartsWith("cage."))));
  const std::vector<double> inputs{20e-6, 5e-6, 0.0, 0.0, -700.0, 400.0, 0.0};
  std::vector<system::InputPolynomial> held;
  for (const double value : inputs) held.push_back({{value, 0.0, 0.0, 0.0}});
  bearing.initialize(0.0, inputs);
  bearing.advance({0.0, 1e-3}, held);
  system::SavedState saved;
  bearing.save(saved);
  const auto go_on = [&] {
    bearing.advance({1e-3, 1.5e-3}, held);
    return bearing.values(inputs, names.size());
  };
  const std::vector<double> first = go_on();
  bearing.restore(saved);
  EXPECT_EQ(go_on(), first);
  EXPECT_EQ(first.size(), names.size());
  const double kinematic = bearing::kinematic_cage_speed(set.geometry.bearing, 0.0, -700.0);
  const auto speed = std::find(names.begin(), names.end(), "rollers.speed") - names.begin();
  EXPECT_NEAR(first[static_cast<std::size_t>(speed)] / kinematic, 1.0, 0.3)
      << "a third of a turn after the start";
}

// Such a state has no gears, but the bearing moves with them.
TEST(FullComplementStart, IsRefused) {
  const analysis::NamedSet set = bearing_sets(parse_case(planet(kFull), "case.yaml", {})).front();
  EXPECT_REFUSED(std::invalid_argument, "full_complement 1",
                 analysis::evaluate_from(set.drivetrain, set.geometry, Eigen::VectorXd::Zero(86)));
}

}  // namespace
}  // namespace orbearing::app::full_complement_test
