// [FangDuplex], Table 3: its calculated column by the linear formulas, its measured one by the nonlinear
// pair.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/case/case_file.hpp"
#include "app/case/machine_of.hpp"
#include "app/errors.hpp"
#include "app/study/expected_file.hpp"
#include "coupling/analysis/duplex_run.hpp"
#include "tests/reference/measured_pairs.hpp"

namespace orbearing::app {
namespace app_fang_duplex_test {
namespace {

const std::string kCase = ORBEARING_SOURCE_DIR "/cases/duplex_7020/case.yaml";

using analysis::PairPoint;

ResolvedCase pair(const std::vector<std::string>& settings) {
  return read_case(kCase, settings);
}

PairPoint point(const std::vector<std::string>& settings) {
  return analysis::point_of(machine_of<analysis::PreloadedPair>(pair(settings)));
}

bool is_calculated(const PublishedValue& published) {
  return !published.settings.empty() && published.settings.back() == "stiffness=linear";
}

double deviation(const PublishedValue& published) {
  const PairPoint found = point(published.settings);
  for (std::size_t i = 0; i < found.chosen().modes.size(); ++i)
    if (published.quantity == fmt::format("modes:/modes/{}/frequency_Hz", i))
      return found.chosen().modes[i].frequency / *published.value - 1.0;
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
  const PairPoint linear = point({"stiffness=linear"}), other = point({});
  EXPECT_NEAR(linear.chosen().shaft.mass, 9.427, 0.001);
  EXPECT_GT(other.chosen().shaft.mass, 10.0);
}

// Any contact angle and preload: those of 7020A5 are in neither set of measured frequencies of the case.
TEST(FangDuplex, OtherBearingsTakeAngleAndPreloadAlone) {
  for (const char* stiffness : {"stiffness=linear", "stiffness=nonlinear"}) {
    double below = 0.0;
    for (const char* preload : {"preload=830 N", "preload=1960 N", "preload=3920 N"}) {
      const PairPoint found = point({"bearing.contact_angle=25 deg", preload, stiffness});
      const double axial = found.chosen().modes[2].frequency;
      EXPECT_GT(axial, below + 50.0);
      below = axial;
    }
  }
}

using fang_duplex::measured_7020A;
using fang_duplex::measured_7020C;
using fang_duplex::MeasuredPair;
using MeasuredPairs = std::array<MeasuredPair, 3>;

// Logarithms of calculated over measured frequencies.
std::vector<double> deviations(const MeasuredPairs& pairs, const std::vector<std::string>& settings) {
  std::vector<double> all;
  for (const MeasuredPair& measured : pairs) {
    std::vector<std::string> more = settings;
    more.push_back(std::string("bearing.contact_angle=") + measured.contact_angle);
    more.push_back(std::string("preload=") + measured.preload);
    const PairPoint found = point(more);
    for (std::size_t i = 0; i < measured.frequency.size(); ++i)
      all.push_back(std::log(found.chosen().modes[i].frequency / measured.frequency[i]));
  }
  return all;
}

struct Errors {
  double mean = 0.0, worst = 0.0;  // [%]  of magnitudes
};

Errors errors_of(const MeasuredPairs& pairs, const std::vector<std::string>& settings) {
  Errors errors;
  const std::vector<double> all = deviations(pairs, settings);
  for (const double one : all) {
    const double error = 100.0 * std::abs(std::expm1(one));
    errors.mean += error / static_cast<double>(all.size());
    errors.worst = std::max(errors.worst, error);
  }
  return errors;
}

// Table of docs/duplex: one shaft for each model, identified from 7020C alone.
TEST(FangDuplex, MeasuredFrequenciesWithTheShaftOf7020C) {
  struct Model {
    std::vector<std::string> settings;
    Errors of_7020C, of_7020A;
  };
  const std::vector<Model> models{{{}, {6.0, 14.7}, {5.6, 12.1}},
                                  {{"arrangement=face-to-face", "spindle.mass=10.4987 kg",
                                    "spindle.first_lever=29.23575 mm", "spindle.second_lever=29.23575 mm"},
                                   {6.5, 15.5},
                                   {11.3, 20.7}},
                                  {{"stiffness=linear", "linear.mass=10.349029 kg",
                                    "linear.first_lever=39.900883 mm", "linear.second_lever=0.146069 mm",
                                    "linear.inertia_x=0.10208535 kg.m2", "linear.inertia_y=0.08735217 kg.m2"},
                                   {6.4, 13.7},
                                   {7.9, 18.6}}};
  constexpr double digits = 0.05;  // [%]  of the printed errors
  for (const Model& model : models) {
    SCOPED_TRACE(model.settings.empty() ? "the case" : model.settings.front());
    for (const auto& [pairs, printed] :
         {std::pair(&measured_7020C, model.of_7020C), {&measured_7020A, model.of_7020A}}) {
      const Errors errors = errors_of(*pairs, model.settings);
      EXPECT_NEAR(errors.mean, printed.mean, digits);
      EXPECT_NEAR(errors.worst, printed.worst, digits);
    }
  }
}

// Least squares of logarithms of frequency ratios, of mass and lever of a cylinder.
TEST(FangDuplex, TheShaftOfTheCaseFits7020CBest) {
  const auto squares = [](double mass, double lever) {
    const std::string of_lever = fmt::format("{} mm", lever);
    double sum = 0.0;
    for (const double one :
         deviations(measured_7020C, {fmt::format("spindle.mass={} kg", mass),
                                     "spindle.first_lever=" + of_lever, "spindle.second_lever=" + of_lever}))
      sum += one * one;
    return sum;
  };
  constexpr double mass = 11.37719, lever = 12.38132, apart = 1e-3;
  const double least = squares(mass, lever);
  EXPECT_LT(least, squares(mass * (1.0 + apart), lever));
  EXPECT_LT(least, squares(mass * (1.0 - apart), lever));
  EXPECT_LT(least, squares(mass, lever * (1.0 + apart)));
  EXPECT_LT(least, squares(mass, lever * (1.0 - apart)));
  const bearing::duplex::Shaft shaft = point({}).nonlinear.shaft;
  EXPECT_DOUBLE_EQ(shaft.mass, mass);
  EXPECT_DOUBLE_EQ(shaft.levers.first, 1e-3 * lever);
}

// Physical bounds: bearings that do not overlap, a shaft within a few per cent of a cylinder through them.
TEST(FangDuplex, TheShaftIsPossible) {
  const bearing::duplex::Shaft shaft = point({}).nonlinear.shaft;
  const double length = shaft.mass / (7850.0 * 0.25 * 3.14159265358979 * 0.1 * 0.1);
  EXPECT_GT(2.0 * shaft.levers.first, 24e-3);
  EXPECT_GT(length, 2.0 * shaft.levers.first + 24e-3);
  EXPECT_LT(length, 0.25);
}

// Fig. 7: the place of the balls changes next to nothing.
TEST(FangDuplex, PositionOfTheBallsHardlyMatters) {
  const PairPoint one = point({}), turned = point({"bearing.first_element_angle=9 deg"});
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(one.chosen().modes[i].frequency, turned.chosen().modes[i].frequency,
                1e-6 * one.chosen().modes[i].frequency);
}

// Spacers that differ by both rows' approach are the same as the load.
TEST(FangDuplex, SpacersPressAsTheLoadDoes) {
  const std::string facing = "arrangement=face-to-face";  // spacers cannot press a tandem
  const PairPoint by_load = point({facing});
  const std::string spacers = fmt::format("spacer_difference={:.12g} um", 2e6 * by_load.approach);
  const PairPoint by_spacers = point({facing, "preload=0 N", spacers});
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(by_spacers.chosen().modes[i].frequency, by_load.chosen().modes[i].frequency, 1e-6);
}

TEST(FangDuplex, LinearIsRefusedBackToBack) {
  EXPECT_THROW(pair({"arrangement=back-to-back", "stiffness=linear"}), BadInput);
  EXPECT_NO_THROW(pair({"arrangement=back-to-back"}));
  EXPECT_NO_THROW(pair({"arrangement=tandem", "stiffness=linear"}));
}

// Fig. 9: the response along x shows tilt and translation, that along z the axial mode, as high as the loss
// factor lets it.
TEST(FangDuplex, ResponsePeaksAtTheModes) {
  const auto study = analysis::duplex_run(machine_of<analysis::DuplexPair>(pair({})));
  const auto& line = study.response.accelerance[2];
  std::size_t highest = 0;
  for (std::size_t k = 0; k < line.size(); ++k)
    if (std::abs(line[k]) > std::abs(line[highest])) highest = k;
  const double frequency = static_cast<double>(highest + 1) * study.response.step;
  const double axial = study.modes.point.chosen().modes[2].frequency;
  EXPECT_NEAR(frequency, axial, 2.0 * study.response.step);
  EXPECT_NEAR(std::abs(line[highest]), 1.0 / (0.005 * study.modes.point.chosen().shaft.mass),
              0.2 * std::abs(line[highest]));
}

}  // namespace
}  // namespace app_fang_duplex_test
}  // namespace orbearing::app
