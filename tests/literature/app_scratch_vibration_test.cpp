// What [ScratchVibration] reads from its figures, in the vibration that the shipped case gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/case/case_file.hpp"
#include "app/study/defect_study.hpp"

namespace orbearing::app {
namespace app_scratch_vibration_test {
namespace {

constexpr double kHalfPercent = 0.005;

DefectStudy study_of(std::vector<std::string> settings) {
  settings.insert(settings.end(), {"signal.revolutions=30"});
  return defect_study(read_case(ORBEARING_SOURCE_DIR "/cases/scratch_defect/case.yaml", settings));
}

// Issue 14, Build 7: the same case, all of the bearing in motion. A shorter signal at a lower rate.
DefectStudy study_in_motion(const std::string& race) {
  return defect_study(read_case(ORBEARING_SOURCE_DIR "/cases/scratch_defect/case.yaml",
                                {"defect.race=" + race, "signal.revolutions=12", "signal.sampling_rate=25.6 kHz"}),
                      DefectRung::all);
}

const NamedPeak* peak(const std::vector<NamedPeak>& peaks, const std::string& is) {
  const auto found =
      std::find_if(peaks.begin(), peaks.end(), [&](const NamedPeak& one) { return one.is == is; });
  return found == peaks.end() ? nullptr : &*found;
}

void expect_peak(const DefectStudy& study, const std::string& is, double frequency) {
  const NamedPeak* found = peak(study.peaks, is);
  ASSERT_NE(found, nullptr) << is;
  EXPECT_NEAR(found->frequency, frequency, kHalfPercent * frequency) << is;
}

// All passings alike: the line and its harmonics, nothing between them.
TEST(ScratchVibration, OuterRace) {
  const DefectStudy study = study_of({"defect.race=outer"});
  expect_peak(study, "outer race defect", 76.3);
  expect_peak(study, "2 x outer race defect", 2.0 * 76.3);
  EXPECT_EQ(study.peaks.front().is, "outer race defect");
  for (const NamedPeak& one : study.peaks)
    EXPECT_NE(one.is.find("outer race defect"), std::string::npos) << one.frequency << " " << one.is;
}

// The scratch passes the load zone once a turn of the shaft.
TEST(ScratchVibration, InnerRace) {
  const DefectStudy study = study_of({"defect.race=inner"});
  expect_peak(study, "inner race defect", 123.7);
  expect_peak(study, "2 x inner race defect", 2.0 * 123.7);
  expect_peak(study, "shaft", 25.0);
  expect_peak(study, "inner race defect - shaft", 123.7 - 25.0);
  expect_peak(study, "inner race defect + shaft", 123.7 + 25.0);
}

// Balls slip as they leave the load zone: the lines stand where the cage really turns.
TEST(ScratchVibration, OuterRaceWithAllInMotion) {
  const DefectStudy study = study_in_motion("outer");
  expect_peak(study, "outer race defect", 76.3);
  expect_peak(study, "2 x outer race defect", 2.0 * 76.3);
  EXPECT_LT(study.turned.cage, study.passing.cage);
  EXPECT_GT(study.turned.cage, 0.98 * study.passing.cage);
  // The ball meets the same edges under the same load as without mass.
  EXPECT_NEAR(study.vibration.largest_load, study_of({"defect.race=outer"}).vibration.largest_load,
              0.4 * study.vibration.largest_load);
}

TEST(ScratchVibration, InnerRaceWithAllInMotion) {
  const DefectStudy study = study_in_motion("inner");  // too short a signal to place 25 Hz itself
  expect_peak(study, "inner race defect", 123.7);
  expect_peak(study, "inner race defect - shaft", 123.7 - 25.0);
}

// "about 0.2 m/s2" at the most, with the period of the balls; the cage's 9.5 Hz cannot show where balls are
// alike.
TEST(ScratchVibration, WithoutAScratchOnlyTheBallsPass) {
  const DefectStudy study = study_of({"defect.race=none"});
  for (const std::vector<NamedPeak>& peaks : {study.peaks, study.spectrum_peaks}) {
    ASSERT_FALSE(peaks.empty());
    for (const NamedPeak& one : peaks)
      EXPECT_NE(one.is.find("ball passage"), std::string::npos) << one.frequency << " " << one.is;
  }
  const double largest = study.vibration.acceleration.row(0).abs().maxCoeff();
  EXPECT_GT(largest, 0.2 / 5.0);  // the source's stiffness and damping are not known
  EXPECT_LT(largest, 0.2 * 5.0);
}

// Figs. 6a and 6b: the ball leaves the races once a turn of the cage.
TEST(ScratchVibration, ABallLeavesTheLoadZone) {
  const DefectStudy study = study_of({"defect.race=none"});
  EXPECT_LT(study.vibration.ball_approach.minCoeff(), 0.0);
  EXPECT_LE(study.vibration.ball_load.minCoeff(), 0.0);
  EXPECT_GT(study.vibration.ball_load.maxCoeff(), 400.0);
}

}  // namespace
}  // namespace app_scratch_vibration_test
}  // namespace orbearing::app
