// The clearance that follows from fits, temperatures and speed has the same effect as a stated one, at every
// speed and in every study.
#include <gtest/gtest.h>

#include "app/case/case_file.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/planetary_case.hpp"
#include "coupling/analysis/crowning/crown_grid.hpp"
#include "coupling/analysis/multi_stage.hpp"
#include "tests/identities/app_fields/field_bases.hpp"

namespace orbearing::app::app_mounted_clearance_test {
namespace {

constexpr double kRoundOff = 1e-12;  // relative

const std::vector<std::string> kMounted{
    "bearing.clearance_state=unmounted",      "bearing.radial_clearance=30 um",
    "bearing.fit.inner_interference=6 um",    "bearing.fit.outer_interference=8 um",
    "bearing.temperature.inner_ring=80 degC", "bearing.temperature.pin=75 degC",
    "bearing.temperature.rollers=80 degC",    "bearing.temperature.outer_ring=78 degC",
    "bearing.temperature.planet=70 degC"};

ResolvedCase reducer(const std::vector<std::string>& settings) {
  return read_point(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", settings);
}

std::vector<std::string> with(std::vector<std::string> settings, const std::string& more) {
  settings.push_back(more);
  return settings;
}

// The same bearing with the clearance that was found, stated as that of the running one.
std::string stated(const analysis::PointResult& point) {
  return fmt::format("bearing.radial_clearance={} m", point.radial_clearance);
}

analysis::PointResult point(const ResolvedCase& in,
                            analysis::Fidelity fidelity = analysis::Fidelity::quasi_static) {
  return analysis::evaluate(bearing_sets(in), fidelity);
}

TEST(StudyMountedClearance, IsFeltLikeAStatedOne) {
  const analysis::PointResult mounted = point(reducer(kMounted));
  EXPECT_GT(mounted.radial_clearance, 0.0);
  EXPECT_LT(mounted.radial_clearance, 30e-6);
  const analysis::PointResult plain = point(reducer({stated(mounted)}));
  EXPECT_NEAR(mounted.life_hours, plain.life_hours, kRoundOff * plain.life_hours);
}

TEST(StudyMountedClearance, IsFeltInMotionAndByOneSystem) {
  const std::string text = fields_test::bases().front().text;
  const auto small = [&](const std::vector<std::string>& settings) {
    return parse_case(text, "small.yaml", settings);
  };
  for (const analysis::Fidelity fidelity : {analysis::Fidelity::dynamic, analysis::Fidelity::monolithic}) {
    const analysis::PointResult mounted = point(small(kMounted), fidelity);
    const analysis::PointResult plain = point(small({stated(mounted)}), fidelity);
    EXPECT_EQ(mounted.life_hours, plain.life_hours);
    EXPECT_EQ(mounted.dynamic->final_state, plain.dynamic->final_state);
  }
}

TEST(StudyMountedClearance, FollowsTheSpeed) {
  const std::vector<analysis::NamedSet> slow = bearing_sets(reducer(kMounted));
  const double fast_speed = 1200.0;  // [rad/s]
  const analysis::PointResult fast = analysis::evaluate(analysis::at_speed(slow, fast_speed));
  EXPECT_GT(fast.radial_clearance, slow.front().drivetrain.bearing.radial_clearance);
  const analysis::PointResult direct =
      point(reducer(with(kMounted, fmt::format("input.speed={} rad/s", fast_speed))));
  EXPECT_NEAR(fast.radial_clearance, direct.radial_clearance, 1e-18);
  EXPECT_NEAR(fast.life_hours, direct.life_hours, kRoundOff * direct.life_hours);
}

TEST(StudyMountedClearance, IsThatOfEachPointOfACrownStudy) {
  using namespace analysis::crowning;
  const auto life = [](const std::vector<std::string>& settings) {
    const CrownProblem problem = problem_of(crown_request(reducer(settings), {}));
    return life_hours(problem, bearing::profile::Straight{}, Lean(1e-3, 0.0));
  };
  const double mounted = life(with(kMounted, "spectrum=[{power: 150 kW, speed: 11000 rpm, share: 1}]"));
  const std::string clearance = stated(point(reducer(with(kMounted, "input.speed=11000 rpm"))));
  const double plain = life({clearance, "input.speed=11000 rpm"});
  EXPECT_NEAR(mounted, plain, 1e-9 * plain);
}

// Inputs that determine the clearance affect every analysis that the clearance affects, and are described so.
TEST(StudyMountedClearance, IsMadeByTheSeats) {
  for (const char* seat :
       {"bearing.bore=24 mm", "material.youngs_modulus=150 GPa", "material.poisson_ratio=0.25"}) {
    const std::vector<std::string> changed = with(kMounted, seat);
    for (const AnalysisId analysis :
         {AnalysisId::quasi_static, AnalysisId::crown, AnalysisId::planet_stiffness})
      EXPECT_TRUE(require_used(reducer(changed), analysis).empty()) << seat;
    EXPECT_NE(point(reducer(changed)).radial_clearance, point(reducer(kMounted)).radial_clearance) << seat;
  }
  EXPECT_FALSE(require_used(reducer({"bearing.bore=24 mm"}), AnalysisId::crown).empty());
}

TEST(StudyMountedClearance, StandsInCheckLineByLine) {
  std::vector<std::string> lines;
  for (const Derived& row : derived_quantities(reducer(kMounted)))
    if (row.path.starts_with("bearing.clearance.")) lines.push_back(row.path);
  EXPECT_EQ(lines, (std::vector<std::string>{
                       "bearing.clearance.unmounted", "bearing.clearance.after_fits",
                       "bearing.clearance.at_temperatures", "bearing.clearance.operating",
                       "bearing.clearance.inner_seat_pressure", "bearing.clearance.outer_seat_pressure"}));
}

}  // namespace
}  // namespace orbearing::app::app_mounted_clearance_test
