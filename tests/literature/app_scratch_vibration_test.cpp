// Values that [ScratchVibration] reads from its figures, in the vibration of the shipped case.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/case/case_file.hpp"
#include "app/study/scratch_case.hpp"

namespace orbearing::app {
namespace app_scratch_vibration_test {
namespace {

using analysis::ScratchedVibration;

constexpr double kHalfPercent = 0.005;

ScratchedVibration study_of(std::vector<std::string> settings) {
  settings.insert(settings.end(), {"signal.revolutions=30"});
  return scratched_vibration(read_case(ORBEARING_SOURCE_DIR "/cases/scratch_defect/case.yaml", settings));
}

// The same case, all of the bearing in motion. A shorter signal at a lower rate.
ScratchedVibration study_in_motion(const std::string& race) {
  return scratched_vibration(read_case(ORBEARING_SOURCE_DIR "/cases/scratch_defect/case.yaml",
                                {"defect.race=" + race, "signal.revolutions=12", "signal.sampling_rate=25.6 kHz"}),
                      MovingParts::all);
}

const diagnosis::NamedPeak* peak(const std::vector<diagnosis::NamedPeak>& peaks, const std::string& is) {
  const auto found =
      std::find_if(peaks.begin(), peaks.end(), [&](const diagnosis::NamedPeak& one) { return one.is == is; });
  return found == peaks.end() ? nullptr : &*found;
}

void expect_peak(const ScratchedVibration& study, const std::string& is, double frequency) {
  const diagnosis::NamedPeak* found = peak(study.view.envelope_peaks, is);
  ASSERT_NE(found, nullptr) << is;
  EXPECT_NEAR(found->frequency, frequency, kHalfPercent * frequency) << is;
}

// All passings equal: the line and its harmonics, nothing between them.
TEST(ScratchVibration, OuterRace) {
  const ScratchedVibration study = study_of({"defect.race=outer"});
  expect_peak(study, "outer race defect", 76.3);
  expect_peak(study, "2 x outer race defect", 2.0 * 76.3);
  EXPECT_EQ(study.view.envelope_peaks.front().is, "outer race defect");
  for (const diagnosis::NamedPeak& one : study.view.envelope_peaks)
    EXPECT_NE(one.is.find("outer race defect"), std::string::npos) << one.frequency << " " << one.is;
}

// The scratch passes the load zone once a turn of the shaft.
TEST(ScratchVibration, InnerRace) {
  const ScratchedVibration study = study_of({"defect.race=inner"});
  expect_peak(study, "inner race defect", 123.7);
  expect_peak(study, "2 x inner race defect", 2.0 * 123.7);
  expect_peak(study, "shaft", 25.0);
  expect_peak(study, "inner race defect - shaft", 123.7 - 25.0);
  expect_peak(study, "inner race defect + shaft", 123.7 + 25.0);
}

// A run-up, whose lines are smeared over frequency, has them at orders of the shaft.
TEST(ScratchVibration, RunUpsHaveTheirLinesOverOrders) {
  const auto order = [](const ScratchedVibration& study, const std::string& is, double expected) {
    const diagnosis::NamedPeak* found = peak(study.view.envelope_peaks, is);
    ASSERT_NE(found, nullptr) << is;
    EXPECT_NEAR(found->frequency, expected, kHalfPercent * expected) << is;
  };
  const auto run_up = [](const std::string& race) {
    return scratched_vibration(
        read_case(ORBEARING_SOURCE_DIR "/cases/scratch_defect/case.yaml",
                  {"defect.race=" + race, "signal.run_up_from=0.5", "signal.revolutions=16"}));
  };
  const ScratchedVibration outer = run_up("outer");
  order(outer, "outer race defect", 76.27 / 25.0);
  order(outer, "2 x outer race defect", 2.0 * 76.27 / 25.0);
  const ScratchedVibration inner = run_up("inner");
  order(inner, "inner race defect", 123.73 / 25.0);
  order(inner, "inner race defect - shaft", 123.73 / 25.0 - 1.0);
  order(inner, "inner race defect + shaft", 123.73 / 25.0 + 1.0);
  // Squares of the speed grow with the angle; two revolutions of 18 are left out.
  EXPECT_NEAR(inner.turned.shaft, 0.5 * (std::sqrt(0.25 + 0.75 * 2.0 / 18.0) + 1.0) * 25.0, 0.1);
  // Over frequency the same signal has no such line: the largest stays below half of that over orders.
  const diagnosis::Spectrum smeared =
      diagnosis::spectrum_of(outer.view.envelope, outer.vibration.rate, diagnosis::Window::hann);
  const auto from = static_cast<Eigen::Index>(30.0 / smeared.resolution);
  const auto to = static_cast<Eigen::Index>(90.0 / smeared.resolution);
  EXPECT_LT(smeared.amplitude.segment(from, to - from).maxCoeff(),
            0.5 * peak(outer.view.envelope_peaks, "outer race defect")->amplitude);
}

// 14 rollers of 10 mm on 65 mm at 25 turns a second. By hand, g = 10/65: cage 25 (1 - g)/2 = 10.577, outer
// race 14 x 10.577 = 148.08, inner race 14 (25 - 10.577) = 201.92, a point of a roller 25 (1/g - g) = 158.65
// Hz.
TEST(ScratchedRollers, LinesOnPaperAreThoseOfTheRun) {
  const auto of = [](const std::string& race) {
    return scratched_vibration(read_case(ORBEARING_SOURCE_DIR "/cases/scratched_rollers/case.yaml",
                                  {"defect.race=" + race, "signal.revolutions=16"}));
  };
  const ScratchedVibration outer = of("outer");
  expect_peak(outer, "outer race defect", 148.08);
  for (const diagnosis::NamedPeak& one : outer.view.envelope_peaks)
    EXPECT_NE(one.is.find("outer race defect"), std::string::npos) << one.frequency << " " << one.is;
  const ScratchedVibration inner = of("inner");
  expect_peak(inner, "inner race defect", 201.92);
  expect_peak(inner, "inner race defect - shaft", 201.92 - 25.0);
  expect_peak(inner, "inner race defect + shaft", 201.92 + 25.0);
  const ScratchedVibration roller = of("roller");
  expect_peak(roller, "roller defect", 158.65);
  expect_peak(roller, "cage", 10.577);
  EXPECT_TRUE(peak(roller.view.envelope_peaks, "roller defect - cage") != nullptr ||
              peak(roller.view.envelope_peaks, "roller defect + cage") != nullptr);
  const ScratchedVibration sound = of("none");
  for (const diagnosis::NamedPeak& one : sound.view.spectrum_peaks)
    EXPECT_NE(one.is.find("roller passage"), std::string::npos) << one.frequency << " " << one.is;
}

TEST(ScratchedRollers, ABallInThemIsRefused) {
  try {
    read_case(ORBEARING_SOURCE_DIR "/cases/scratched_rollers/case.yaml", {"defect.race=ball"});
    FAIL() << "not refused";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("'ball' in a bearing of rollers"), std::string::npos)
        << error.what();
  }
}

// Balls slip as they leave the load zone: the lines are at the actual cage speed.
TEST(ScratchVibration, OuterRaceWithAllInMotion) {
  const ScratchedVibration study = study_in_motion("outer");
  expect_peak(study, "outer race defect", 76.3);
  expect_peak(study, "2 x outer race defect", 2.0 * 76.3);
  EXPECT_LT(study.turned.cage, study.passing.cage);
  EXPECT_GT(study.turned.cage, 0.98 * study.passing.cage);
  // The ball meets the same edges under the same load as without mass.
  EXPECT_NEAR(study.vibration.largest_load, study_of({"defect.race=outer"}).vibration.largest_load,
              0.4 * study.vibration.largest_load);
}

TEST(ScratchVibration, InnerRaceWithAllInMotion) {
  const ScratchedVibration study = study_in_motion("inner");  // too short a signal to place 25 Hz itself
  expect_peak(study, "inner race defect", 123.7);
  expect_peak(study, "inner race defect - shaft", 123.7 - 25.0);
}

// "about 0.2 m/s2" at the most, with the period of the balls; the cage's 9.5 Hz cannot appear with equal
// balls.
TEST(ScratchVibration, WithoutAScratchOnlyTheBallsPass) {
  const ScratchedVibration study = study_of({"defect.race=none"});
  for (const std::vector<diagnosis::NamedPeak>& peaks : {study.view.envelope_peaks, study.view.spectrum_peaks}) {
    ASSERT_FALSE(peaks.empty());
    for (const diagnosis::NamedPeak& one : peaks)
      EXPECT_NE(one.is.find("ball passage"), std::string::npos) << one.frequency << " " << one.is;
  }
  const double largest = study.vibration.acceleration.row(0).abs().maxCoeff();
  EXPECT_GT(largest, 0.2 / 5.0);  // the source's stiffness and damping are not known
  EXPECT_LT(largest, 0.2 * 5.0);
}

// Figs. 6a and 6b: the ball leaves the races once a turn of the cage.
TEST(ScratchVibration, ABallLeavesTheLoadZone) {
  const ScratchedVibration study = study_of({"defect.race=none"});
  EXPECT_LT(study.vibration.ball_approach.minCoeff(), 0.0);
  EXPECT_LE(study.vibration.ball_load.minCoeff(), 0.0);
  EXPECT_GT(study.vibration.ball_load.maxCoeff(), 400.0);
}

}  // namespace
}  // namespace app_scratch_vibration_test
}  // namespace orbearing::app
