// Life under a spectrum from the rows of its bins: by hand, and what must hold whatever the lives are.
#include "app/results/spectrum_life.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::spectrum_life_test {
namespace {

using testing::HasSubstr;

constexpr double kRoundOff = 1e-13;  // relative, of sums of a few terms

// A bin with the lives that its row is to show.
struct Lived {
  LoadBin bin;
  double hours = 0.0, inner = 0.0;  // [h], [Mrev]
  std::string status = "ok";
};

SpectrumResult result_of(const std::vector<Lived>& lived) {
  ManifestHeader header = fake_sweep::fake_header(0);
  std::map<std::size_t, ManifestEntry> entries;
  header.spectrum.lines = 1;
  for (const Lived& one : lived) header.spectrum.bins.push_back(one.bin);
  header.points = header.spectrum.points();
  std::size_t point = 0;
  for (const Lived& one : lived) {
    if (!one.bin.turns()) continue;
    analysis::PointResult result;
    result.input_speed = one.bin.speed;
    result.life_hours = one.hours;
    result.system_life_hours = 0.5 * one.hours;
    result.inner.life = 1e6 * one.inner;
    result.outer.life = 3e6 * one.inner;
    result.status = one.status;
    entries[point++].row = sweep_row(result, header);
  }
  const std::vector<SpectrumResult> results = spectrum_results(header, entries);
  return results.empty() ? SpectrumResult{} : results.front();
}

TEST(SpectrumLife, IsMinersSumByHand) {
  // 1/L = 0.2/1000 + 0.5/5000 + 0.3/20000 = 1/5000 + 1/10000 + 1/66666.7 = 63/200000
  const SpectrumResult found = result_of({{{4e4, 100.0, 0.2}, 1000.0, 10.0},
                                          {{3e4, 200.0, 0.5}, 5000.0, 60.0},
                                          {{2e4, 300.0, 0.3}, 20000.0, 90.0}});
  EXPECT_NEAR(life_of(found, "life_h"), 200000.0 / 63.0, kRoundOff * 4000.0);
  EXPECT_NEAR(life_of(found, "system_life_h"), 100000.0 / 63.0, kRoundOff * 4000.0);
  EXPECT_NEAR(found.bins[0].damage_share, 40.0 / 63.0, kRoundOff);
  EXPECT_NEAR(found.bins[1].damage_share, 20.0 / 63.0, kRoundOff);
  EXPECT_NEAR(found.bins[2].damage_share, 3.0 / 63.0, kRoundOff);
  // In revolutions: shares 20 : 100 : 90 of 210; damage 20/10 + 100/60 + 90/90 over 210 in 1/Mrev.
  EXPECT_NEAR(life_of(found, "inner_life_Mrev"), 210.0 / (2.0 + 5.0 / 3.0 + 1.0), kRoundOff * 100.0);
  EXPECT_NEAR(life_of(found, "outer_life_Mrev"), 3.0 * life_of(found, "inner_life_Mrev"), 1e-10);
  EXPECT_TRUE(std::isnan(life_of(found, "L10mh")));  // no oil is stated
}

TEST(SpectrumLife, TimeAtRestUsesUpNothing) {
  const SpectrumResult half = result_of({{{4e4, 100.0, 0.5}, 1000.0, 10.0}, {{0.0, 0.0, 0.5}}});
  EXPECT_NEAR(life_of(half, "life_h"), 2000.0, kRoundOff * 2000.0);
  EXPECT_NEAR(life_of(half, "inner_life_Mrev"), 10.0, kRoundOff * 10.0);
  EXPECT_EQ(half.bins[1].damage_share, 0.0);
  EXPECT_FALSE(half.bins[1].row);
}

TEST(SpectrumLife, AShareOfZeroUsesUpNothing) {
  const SpectrumResult found = result_of({{{4e4, 100.0, 1.0}, 1000.0, 10.0}, {{9e4, 100.0, 0.0}, 1.0, 0.01}});
  EXPECT_EQ(life_of(found, "life_h"), 1000.0);
  EXPECT_EQ(found.bins[1].damage_share, 0.0);
}

TEST(SpectrumLife, WithoutLoadIsInfiniteAndOfABinThatFailedNotKnown) {
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isinf(life_of(result_of({{{1.0, 100.0, 1.0}, none, none}}), "life_h")));
  const SpectrumResult failed =
      result_of({{{4e4, 100.0, 0.5}, 1000.0, 10.0}, {{4e4, 100.0, 0.5}, 1000.0, 10.0, "no balance"}});
  EXPECT_TRUE(std::isnan(life_of(failed, "life_h")));
  EXPECT_TRUE(std::isnan(failed.bins[0].damage_share));
  EXPECT_EQ(failed.failed, 1U);
}

// By hand, from P and C of the rows.
TEST(SpectrumLife, SumsDamageAndSkidRiskByFile) {
  ManifestHeader header = fake_sweep::fake_header(0);
  header.spectrum = {
      .bins = {{4e4, 100.0, 0.5, "a"}, {3e4, 100.0, 0.2, "b"}, {1.0, 100.0, 0.1, "b"}, {0.0, 0.0, 0.2, "b"}},
      .minimum_load = 0.02,
      .lines = 1};
  header.points = 3;
  std::map<std::size_t, ManifestEntry> entries;
  const auto put = [&](std::size_t point, double hours, double load) {
    analysis::PointResult result;
    result.life_hours = hours;
    result.rating.lives.dynamic_capacity = 1e5;
    result.rating.lives.dynamic_load = load;
    entries[point].row = sweep_row(result, header);
  };
  put(0, 1000.0, 2001.0);
  put(1, 4000.0, 1999.0);
  put(2, 1e9, 0.0);
  const auto results = [&] { return spectrum_results(header, entries).front(); };
  const SpectrumResult found = results();
  EXPECT_EQ(found.bins[0].skid_risk, false);
  EXPECT_EQ(found.bins[1].skid_risk, true);
  EXPECT_EQ(found.bins[3].skid_risk, false);  // at rest
  const BinSums a = sums_of(found.bins, "a"), b = sums_of(found.bins, "b"), all = sums_of(found.bins);
  EXPECT_EQ(a.skid_risk_share, 0.0);
  EXPECT_NEAR(b.skid_risk_share, 0.3, kRoundOff);
  EXPECT_NEAR(all.skid_risk_share, 0.3, kRoundOff);
  EXPECT_NEAR(b.share, 0.5, kRoundOff);
  EXPECT_NEAR(a.damage_share, 0.5 / 1000.0 * life_of(found, "life_h"), kRoundOff);
  EXPECT_NEAR(a.damage_share + b.damage_share, 1.0, kRoundOff);
  EXPECT_THAT(spectrum_text(header, {found}),
              HasSubstr(" time [%]  uses [%]  skid risk [%]  skid risk [h]  file\n"
                        "       50      90.9              0              -  a\n"
                        "       50      9.09             30              -  b\n"));
  header.spectrum.hours = 1000.0;
  EXPECT_THAT(spectrum_text(header, {found}),
              HasSubstr("       50      9.09             30            300  b\n"));
  put(1, 4000.0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(results().bins[1].skid_risk);
  EXPECT_TRUE(std::isnan(sums_of(results().bins).skid_risk_share));
}

// One planet carries more in the first bin, all carry equal loads in the second: its bearing is the worst,
// and damage is its damage. Of two sets the one with that bearing limits, though its mean life is the longer
// one.
TEST(SpectrumLife, IsJudgedByTheWorstBearing) {
  ManifestHeader header = fake_sweep::fake_header(0);
  header.spectrum = {.bins = {{4e4, 100.0, 0.5}, {3e4, 100.0, 0.5}}, .hours = 100.0, .lines = 1};
  header.points = 2;
  header.sets = {"even", "uneven"};
  analysis::SetResult even, uneven, alike;
  even.life_hours = 1200.0;
  uneven.life_hours = 1000.0;
  uneven.unlike.shortest_hours = 500.0;
  alike.life_hours = 5000.0;
  std::map<std::size_t, ManifestEntry> entries;
  const auto row_of = [&](double hours, const std::vector<analysis::SetResult>& sets) {
    analysis::PointResult result;
    result.life_hours = hours;
    result.sets = sets;
    return sweep_row(result, header);
  };
  entries[0].row = row_of(1000.0, {even, uneven});
  entries[1].row = row_of(1200.0, {even, alike});
  const SpectrumResult found = spectrum_results(header, entries).front();
  const double life = 1.0 / (0.5 / 500.0 + 0.5 / 5000.0);
  EXPECT_EQ(found.worst.column(), "sets.uneven.shortest_life_h");
  EXPECT_NEAR(found.worst.value, life, kRoundOff * life);
  EXPECT_EQ(life_of(found, "shortest_life_h"), found.worst.value);
  EXPECT_NEAR(life_of(found, "life_h"), 1.0 / (0.5 / 1000.0 + 0.5 / 5000.0), kRoundOff * life * 2.0);
  EXPECT_NEAR(found.bins[0].damage_share, 0.5 / 500.0 * life, kRoundOff);
  EXPECT_EQ(found.bins[1].worst_life, 5000.0);
  EXPECT_NEAR(spectrum_json(header, {found})["used_up"], 100.0 / life, kRoundOff);
}

TEST(SpectrumLife, NeedsAllPointsAsAShardHasNot) {
  ManifestHeader header = fake_sweep::fake_header(2);
  header.spectrum = {.bins = {{4e4, 100.0, 0.5}, {4e4, 200.0, 0.5}}, .lines = 1};
  std::map<std::size_t, ManifestEntry> entries;
  entries[0].row = sweep_row(fake_sweep::fake_result(0), header);
  EXPECT_TRUE(spectrum_results(header, entries).empty());
}

// Points of a spectrum follow the grid's, are no rows of the table, and have a file of their own.
TEST(SpectrumLife, OfASweepStandsBesideItsTable) {
  const fake_sweep::TemporaryFolder location;
  const auto request_of = [&](const std::string& folder, std::optional<Shard> shard) {
    SweepRequest request = fake_sweep::fake_request(location / folder, 6);
    request.header.spectrum = {.bins = {{4e4, 100.0, 0.25, "a"}, {4e4, 0.0, 0.25}, {4e4, 102.0, 0.5, "b, c"}},
                               .lines = 1};
    request.header.shard = shard;
    return request;
  };
  const SweepOutcome whole = run_sweep(request_of("whole", {}));
  EXPECT_EQ(whole.rows.size(), 4U);
  ASSERT_EQ(whole.spectra.size(), 1U);
  EXPECT_EQ(speed_in_rpm(whole.spectra[0].bins[2].row->point.input_speed),
            speed_in_rpm(fake_sweep::input_speed_of(5)));
  run_sweep(request_of("one", Shard{1, 2}));
  EXPECT_FALSE(std::filesystem::exists(location / "one" / "spectrum.csv"));
  run_sweep(request_of("two", Shard{2, 2}));
  merge_shards({location / "one", location / "two"}, location / "merged");
  for (const char* file : {"sweep.csv", "spectrum.csv"})
    EXPECT_EQ(read_file(location / "merged" / file), read_file(location / "whole" / file)) << file;
  EXPECT_EQ(parse_manifest(read_file(location / "whole" / "manifest.jsonl"), "").header->spectrum.bins,
            request_of("", {}).header.spectrum.bins);
}

}  // namespace
}  // namespace orbearing::app::spectrum_life_test
