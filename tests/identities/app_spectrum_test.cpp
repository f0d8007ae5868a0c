// Load spectra through runs, sweeps and crown studies: what must hold in every rung.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/results/sweep_run.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/sweep_study.hpp"
#include "coupling/analysis/crowning/crown_grid.hpp"
#include "tests/identities/app_fields/field_bases.hpp"

namespace orbearing::app::app_spectrum_test {
namespace {

constexpr double kSame = 1e-12;  // relative: the same point with its speed written in another unit

const std::string kOil = "lubricant.grade=ISO VG 220";

ResolvedCase reducer(std::vector<std::string> settings) {
  settings.push_back(kOil);
  return read_point(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml", settings);
}

SweepOutcome outcome_of_case(const ResolvedCase& in, const std::string& fidelity = "quasi-static") {
  SweepRequest request = sweep_request(in, fidelity);
  request.quiet = true;
  request.jobs = 1;
  return run_sweep(request);
}

SpectrumResult spectrum(const std::string& rows, const std::vector<std::string>& settings = {}) {
  std::vector<std::string> all = settings;
  all.push_back("spectrum=" + rows);
  return outcome_of_case(reducer(all)).spectra.at(0);
}

void expect_same_lives(const SpectrumResult& one, const SpectrumResult& other) {
  for (const auto& [name, life] : one.lives) {
    if (std::isnan(life)) {  // only for unequal planets
      EXPECT_TRUE(std::isnan(life_of(other, name))) << name;
    } else {
      EXPECT_NEAR(life_of(other, name), life, kSame * life) << name;
    }
  }
}

// The case's own point, 150 kW at 6000 rpm.
const std::string kOwn = "{power: 150 kW, speed: 6000 rpm, share: 1}";

void expect_own_point(const SweepOutcome& outcome) {
  for (const char* name : {"life_h", "system_life_h", "L10mh", "system_L10mh", "inner_life_Mrev",
                           "outer_life_Mrev", "inner_L10m_Mrev", "outer_L10m_Mrev"}) {
    const double own = number_named(outcome.header, outcome.rows.at(0), name);
    ASSERT_TRUE(std::isfinite(own)) << name;
    EXPECT_NEAR(life_of(outcome.spectra.at(0), name), own, kSame * own) << name;
  }
  EXPECT_NEAR(outcome.spectra.at(0).bins.at(0).damage_share, 1.0, kSame);
}

TEST(LoadSpectra, OfOneBinIsThePlainRun) {
  expect_own_point(outcome_of_case(reducer({"spectrum=[" + kOwn + "]"})));
}

TEST(LoadSpectra, OfOneBinIsThePlainRunInMotionToo) {
  const fields_test::Base& base = fields_test::bases().front();
  const ResolvedCase in =
      parse_case(base.text, "small.yaml", {kOil, "spectrum=[{power: 150 kW, speed: 18000 rpm, share: 1}]"});
  expect_own_point(outcome_of_case(in, "dynamic"));
}

TEST(LoadSpectra, OfTwoEqualBinsIsThatOfOne) {
  const SpectrumResult one = spectrum("[" + kOwn + "]");
  const SpectrumResult two = spectrum(
      "[{power: 150 kW, speed: 6000 rpm, share: 0.3}, {torque: 238.7324146378430 N.m, speed: 6000 rpm, "
      "share: 0.7}]");
  expect_same_lives(one, two);
  EXPECT_NEAR(two.bins[0].damage_share, 0.3, kSame);
  EXPECT_NEAR(two.bins[1].modified_damage_share, 0.7, kSame);
}

TEST(LoadSpectra, DoesNotCareForTheOrderOfItsRowsNorForShareOrHours) {
  const SpectrumResult one = spectrum(
      "[{power: 150 kW, speed: 6000 rpm, share: 0.25}, {power: 60 kW, speed: 2000 rpm, share: 0.75}]");
  const SpectrumResult other =
      spectrum("[{power: 60 kW, speed: 2000 rpm, hours: 300}, {power: 150 kW, speed: 6000 rpm, hours: 100}]");
  expect_same_lives(one, other);
  EXPECT_NEAR(one.bins[0].damage_share, other.bins[1].damage_share, kSame);
}

TEST(LoadSpectra, IsMinersSumOfItsBinsRunOneByOne) {
  const SpectrumResult slow = spectrum("[{power: 60 kW, speed: 2000 rpm, share: 1}]");
  const SpectrumResult fast = spectrum("[" + kOwn + "]");
  const SpectrumResult both =
      spectrum("[{power: 60 kW, speed: 2000 rpm, share: 0.5}, " + kOwn.substr(0, kOwn.rfind('1')) +
               "0.25}, " + "{power: 0 W, speed: 0 rpm, share: 0.25}]");
  for (const char* name : {"life_h", "system_life_h", "L10mh", "system_L10mh"}) {
    const double expected = 1.0 / (0.5 / life_of(slow, name) + 0.25 / life_of(fast, name));
    EXPECT_NEAR(life_of(both, name), expected, kSame * expected) << name;
  }
  double sum = 0.0;
  for (const SpectrumBin& bin : both.bins) sum += bin.damage_share;
  EXPECT_NEAR(sum, 1.0, kSame);
}

// Carrier and planet still cause centrifugal loads of rollers.
TEST(LoadSpectra, IdlesWithoutTorque) {
  const SpectrumResult found =
      spectrum("[{power: 0 kW, speed: 6000 rpm, share: 0.5}, {power: 150 kW, speed: 6000 rpm, share: 0.5}]");
  ASSERT_TRUE(found.bins[0].row && found.bins[0].row->ok());
  EXPECT_LT(found.bins[0].damage_share, found.bins[1].damage_share);
  EXPECT_GT(life_of(found, "life_h"), 0.0);
}

// Each combination of the other swept values has its own; speeds and powers are the bins' alone.
TEST(LoadSpectra, StandsOnceForEachOtherSweptValue) {
  const ResolvedCase in =
      read_case(ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml",
                {kOil, "spectrum=[" + kOwn + "]", "sweep.input.speed=[5000 rpm, 6000 rpm]",
                 "sweep.bearing.radial_clearance=[0 um, 10 um]"});
  const SweepOutcome outcome = outcome_of_case(in);
  ASSERT_EQ(outcome.rows.size(), 4U);
  ASSERT_EQ(outcome.spectra.size(), 2U);
  for (const SpectrumResult& result : outcome.spectra)
    for (const SweepRow& row : outcome.rows)
      if (speed_in_rpm(row.point.input_speed) == 6000.0 && row.axes.at(0) == result.axis_values.at(0)) {
        const double own = row.point.life_hours;
        EXPECT_NEAR(life_of(result, "life_h"), own, kSame * own);
      }
  EXPECT_TRUE(spectrum_json(outcome.header, outcome.spectra).is_array());
}

TEST(LoadSpectra, OfSeveralSetsIsOneForEach) {
  const ResolvedCase in = read_point(ORBEARING_SOURCE_DIR "/cases/three_sets_150kW/case.yaml",
                                     {"spectrum=[" + kOwn + "]", "input.speed=6000 rpm"});
  const SweepOutcome outcome = outcome_of_case(in);
  const SpectrumResult& found = outcome.spectra.at(0);
  for (const std::string& set : outcome.header.sets) {
    const double own = number_named(outcome.header, outcome.rows.at(0), "sets." + set + ".life_h");
    EXPECT_NEAR(life_of(found, "sets." + set + ".life_h"), own, kSame * own);
  }
  EXPECT_EQ(found.worst.set, outcome.rows.at(0).point.limiting_set);
  EXPECT_EQ(life_of(found, "life_h"), life_of(found, "sets." + found.worst.set + ".life_h"));
}

// One mechanism: the life of a crown under the spectrum is Miner's sum of its lives at the bins.
TEST(LoadSpectra, IsWhatACrownStudyLivesUnder) {
  using namespace analysis::crowning;
  const auto problem = [](const std::string& rows) {
    return problem_of(crown_request(reducer({"spectrum=" + rows}), {}));
  };
  const bearing::profile::Profile straight = bearing::profile::Straight{};
  const auto life = [&](const CrownProblem& of) { return life_hours(of, straight, Lean(1e-3, 0.0)); };
  const double plain = life(problem_of(crown_request(reducer({}), {})));
  EXPECT_NEAR(life(problem("[" + kOwn + "]")), plain, kSame * plain);
  const double slow = life(problem("[{power: 60 kW, speed: 2000 rpm, share: 1}]"));
  const double both =
      life(problem("[{power: 60 kW, speed: 2000 rpm, hours: 2}, {power: 150 kW, speed: 6000 rpm, "
                   "hours: 1}, {power: 0 kW, speed: 0 rpm, hours: 1}]"));
  const double expected = 1.0 / (0.5 / slow + 0.25 / plain);
  EXPECT_NEAR(both, expected, kSame * expected);
}

TEST(LoadSpectra, OfACrownStudyIsStatedOnce) {
  CrownChoices options;
  options.spectrum = true;
  EXPECT_THROW(crown_request(reducer({"spectrum=[" + kOwn + "]"}), options), BadInput);
}

}  // namespace
}  // namespace orbearing::app::app_spectrum_test
