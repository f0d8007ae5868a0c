// Analyses that `run` does with a case, and the duration of their motion.
#include "app/study/analysis.hpp"

#include <gtest/gtest.h>

#include "app/case/case_file.hpp"
#include "app/errors.hpp"

namespace orbearing::app::analysis_test {
namespace {

constexpr double kRoundOff = 1e-12;

ResolvedCase shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
  return read_case(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml", settings);
}

double simulated(const ResolvedCase& resolved, const std::string& fidelity = "") {
  const Analysis* analysis = analysis_of(resolved, fidelity);
  return analysis != nullptr && analysis->simulated != nullptr ? analysis->simulated(resolved) : -1.0;
}

TEST(Analysis, NameFollowsFromCaseAndFidelity) {
  EXPECT_STREQ(analysis_of(shipped("harris_209"))->names.name, "static");
  EXPECT_STREQ(analysis_of(shipped("ball_6305_iso16281"))->names.name, "static");
  EXPECT_STREQ(analysis_of(shipped("deep_groove_motor"))->names.name, "dynamic");
  EXPECT_STREQ(analysis_of(shipped("scratch_defect"))->names.name, "defect");
  EXPECT_STREQ(analysis_of(shipped("scratch_defect"), "dynamic")->names.name, "defect, all in motion");
  EXPECT_STREQ(analysis_of(shipped("planet_scratch"))->names.name, "scratched planet bearing");
  EXPECT_STREQ(analysis_of(shipped("duplex_7020"))->names.name, "duplex");
  EXPECT_STREQ(analysis_of(shipped("spin_film_guo2013"))->names.name, "film");
  EXPECT_STREQ(gears_alone().names.name, "gears");
  EXPECT_EQ(analysis_of(shipped("reducer_150kW")), nullptr);  // a sweep of one point
  EXPECT_THROW((void)analysis_of(shipped("harris_209"), "dynamic"), BadInput);
}

TEST(Analysis, AtRestNothingIsSimulated) {
  EXPECT_EQ(simulated(shipped("harris_209")), -1.0);
  EXPECT_EQ(simulated(shipped("scratch_defect")), -1.0);
}

TEST(Analysis, TimeOfBallsIsTheirDuration) {
  EXPECT_DOUBLE_EQ(simulated(shipped("deep_groove_motor", {"simulation.duration=0.25 s"})), 0.25);
}

// 1500 rpm are 25 revolutions a second.
TEST(Analysis, TimeOfASignalIsThatOfItsRevolutions) {
  const std::vector<std::string> turns{"signal.revolutions=10", "signal.settling_revolutions=5"};
  EXPECT_NEAR(simulated(shipped("scratch_defect", turns), "dynamic"), 15.0 / 25.0, kRoundOff);
}

// From half the speed on the mean speed is three quarters of it.
TEST(Analysis, ARunUpTakesLonger) {
  const std::vector<std::string> turns{"signal.revolutions=10", "signal.settling_revolutions=5",
                                       "signal.run_up_from=0.5"};
  EXPECT_NEAR(simulated(shipped("scratch_defect", turns), "dynamic"), 15.0 / 25.0 / 0.75, kRoundOff);
}

// The carrier of 37 and 79 teeth turns by 37/116 of the sun's 100 revolutions a second.
TEST(Analysis, TimeOfAScratchedPlanetIsThatOfRevolutionsOfTheCarrier) {
  const ResolvedCase in =
      shipped("planet_scratch", {"signal.carrier_revolutions=4", "signal.carrier_settling=0.5"});
  EXPECT_NEAR(simulated(in), 4.5 / (100.0 * 37.0 / 116.0), kRoundOff);
}

}  // namespace
}  // namespace orbearing::app::analysis_test
