// [FangDuplex], Table 3: its calculated column by the linear formulas, its measured one by the nonlinear
// pair.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/case/case_file.hpp"
#include "app/errors.hpp"
#include "app/study/duplex_study.hpp"
#include "app/study/expected_file.hpp"

namespace orbearing::app {
namespace app_fang_duplex_test {
namespace {

const std::string kCase = ORBEARING_SOURCE_DIR "/cases/duplex_7020/case.yaml";

ResolvedCase pair(const std::vector<std::string>& settings) {
  return read_case(kCase, settings);
}

bool is_calculated(const PublishedValue& published) {
  return !published.settings.empty() && published.settings.back() == "stiffness=linear";
}

double deviation(const PublishedValue& published) {
  const PairPoint point = pair_point(pair(published.settings));
  for (std::size_t i = 0; i < point.asked().modes.size(); ++i)
    if (published.quantity == fmt::format("modes:/modes/{}/frequency_Hz", i))
      return point.asked().modes[i].frequency / *published.value - 1.0;
  return std::nan("");
}

// "the linear option gives the first printed column of both bearings within 0.1 %"
TEST(FangDuplex, LinearFormulasGiveTheCalculatedColumn) {
  int compared = 0;
  for (const PublishedValue& published : read_expected(expected_beside(kCase)).published) {
    if (!is_calculated(published)) continue;
    EXPECT_NEAR(deviation(published), 0.0, 0.001) << published.quantity << ", " << published.meaning;
    ++compared;
  }
  EXPECT_EQ(compared, 30);
}

// `stiffness: linear` alone selects the constants of that column.
TEST(FangDuplex, TheCaseHoldsBothSetsOfConstants) {
  const PairPoint linear = pair_point(pair({"stiffness=linear"})), other = pair_point(pair({}));
  EXPECT_NEAR(linear.asked().shaft.mass, 9.427, 0.001);
  EXPECT_GT(other.asked().shaft.mass, 10.0);
}

// Any contact angle and preload: those of 7020A5 are in neither set of measured frequencies of the case.
TEST(FangDuplex, OtherBearingsTakeAngleAndPreloadAlone) {
  for (const char* stiffness : {"stiffness=linear", "stiffness=nonlinear"}) {
    double below = 0.0;
    for (const char* preload : {"preload=830 N", "preload=1960 N", "preload=3920 N"}) {
      const PairPoint point = pair_point(pair({"bearing.contact_angle=25 deg", preload, stiffness}));
      const double axial = point.asked().modes[2].frequency;
      EXPECT_GT(axial, below + 50.0);
      below = axial;
    }
  }
}

// The case states what `run` identifies on 7020C alone.
TEST(FangDuplex, TheShaftOfTheCaseIsTheOneIdentified) {
  const DuplexStudy study = duplex_study(pair({}));
  ASSERT_TRUE(study.identification.has_value());
  const bearing::duplex::Shaft& found = study.identification->nonlinear.found.shaft;
  const bearing::duplex::Shaft& stated = study.point.nonlinear.shaft;
  constexpr double digits = 1e-5;
  EXPECT_NEAR(found.mass, stated.mass, digits * stated.mass);
  EXPECT_NEAR(found.levers.first, stated.levers.first, digits * stated.levers.first);
  EXPECT_EQ(found.levers.first, found.levers.second);
}

// A frequency of 7020A that changes leaves what is identified as it is: nothing is tuned to that bearing.
TEST(FangDuplex, IdentificationLooksAt7020CAlone) {
  const std::string changed = "measured.axial_z=[454.09 Hz, 699.52 Hz, 806.37 Hz, 900 Hz, 1200 Hz, 1400 Hz]";
  const DuplexStudy one = duplex_study(pair({})), other = duplex_study(pair({changed}));
  EXPECT_EQ(one.identification->nonlinear.found.shaft.mass, other.identification->nonlinear.found.shaft.mass);
  EXPECT_NE(one.identification->nonlinear.prediction.mean, other.identification->nonlinear.prediction.mean);
}

// Physical bounds: bearings that do not overlap, a shaft within a few per cent of a cylinder through them.
TEST(FangDuplex, TheIdentifiedShaftIsPossible) {
  const bearing::duplex::Shaft shaft = duplex_study(pair({})).identification->nonlinear.found.shaft;
  const double length = shaft.mass / (7850.0 * 0.25 * 3.14159265358979 * 0.1 * 0.1);
  EXPECT_GT(2.0 * shaft.levers.first, 24e-3);
  EXPECT_GT(length, 2.0 * shaft.levers.first + 24e-3);
  EXPECT_LT(length, 0.25);
}

// Fig. 7: the place of the balls changes next to nothing.
TEST(FangDuplex, PositionOfTheBallsHardlyMatters) {
  const PairPoint one = pair_point(pair({})),
                  turned = pair_point(pair({"bearing.first_element_angle=9 deg"}));
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(one.asked().modes[i].frequency, turned.asked().modes[i].frequency,
                1e-6 * one.asked().modes[i].frequency);
}

// Spacers that differ by both rows' approach are the same as the load.
TEST(FangDuplex, SpacersPressAsTheLoadDoes) {
  const std::string facing = "arrangement=face-to-face";  // spacers cannot press a tandem
  const PairPoint by_load = pair_point(pair({facing}));
  const std::string spacers = fmt::format("spacer_difference={:.12g} um", 2e6 * by_load.approach);
  const PairPoint by_spacers = pair_point(pair({facing, "preload=0 N", spacers}));
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(by_spacers.asked().modes[i].frequency, by_load.asked().modes[i].frequency, 1e-6);
}

TEST(FangDuplex, LinearIsRefusedBackToBack) {
  EXPECT_THROW(pair({"arrangement=back-to-back", "stiffness=linear"}), BadInput);
  EXPECT_NO_THROW(pair({"arrangement=back-to-back"}));
  EXPECT_NO_THROW(pair({"arrangement=tandem", "stiffness=linear"}));
}

// Fig. 9: the response along x shows tilt and translation, that along z the axial mode, as high as the loss
// factor lets it.
TEST(FangDuplex, ResponsePeaksAtTheModes) {
  const DuplexStudy study = duplex_study(pair({}));
  const auto& line = study.response.accelerance[2];
  std::size_t highest = 0;
  for (std::size_t k = 0; k < line.size(); ++k)
    if (std::abs(line[k]) > std::abs(line[highest])) highest = k;
  const double frequency = static_cast<double>(highest + 1) * study.response.step;
  const double axial = study.point.asked().modes[2].frequency;
  EXPECT_NEAR(frequency, axial, 2.0 * study.response.step);
  EXPECT_NEAR(std::abs(line[highest]), 1.0 / (0.005 * study.point.asked().shaft.mass),
              0.2 * std::abs(line[highest]));
}

}  // namespace
}  // namespace app_fang_duplex_test
}  // namespace orbearing::app
