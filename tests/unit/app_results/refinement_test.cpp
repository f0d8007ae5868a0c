// Points added to a grid round by round: the same whatever threads, interruptions, kills and shards there
// were.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "app/results/sweep_run.hpp"
#include "tests/full.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::refinement_test {
namespace {

namespace fs = std::filesystem;
using fake_sweep::TemporaryFolder;
using ::testing::HasSubstr;

constexpr std::size_t grid_points = 12;
constexpr std::size_t rounds = 4;
constexpr double rpm_of_rad_s = 30.0 / std::numbers::pi;

double rpm_of(std::size_t point) {
  return 1000.0 * static_cast<double>(point + 1);
}

analysis::PointResult result_at(double input_speed) {
  const double rpm = input_speed * rpm_of_rad_s;
  analysis::PointResult result = fake_sweep::fake_result(0);
  result.input_speed = input_speed;
  result.life_hours = 5e4 * std::exp(-std::pow(std::log(rpm / 5432.1), 2.0));
  if (rpm > 5600.0 && rpm < 5700.0) throw std::runtime_error("no balance");
  return result;
}

SweepPoint point_at(double rpm) {
  return {"added", rpm / rpm_of_rad_s, {}};
}

// Each round adds three points above the best so far, nearer to it than the last: any change of its rows
// changes the requested points.
std::vector<SweepPoint> next_round(const std::vector<SweepRow>& rows) {
  const std::size_t round = (rows.size() - grid_points) / 3;
  if (round == rounds) return {};
  double best = 0.0, longest = 0.0;
  for (const SweepRow& row : rows) {
    const double life = row.point.life_hours;
    if (!(life > longest)) continue;
    longest = life;
    best = speed_in_rpm(row.point.input_speed);
  }
  std::vector<SweepPoint> points;
  for (const double step : {300.0, -100.0, 160.0})
    points.push_back(point_at(best + step / static_cast<double>(1 + 2 * round)));
  return points;
}

SweepRequest refined_request(const fs::path& folder) {
  SweepRequest request = fake_sweep::fake_request(folder, 0);
  request.header.points = grid_points;
  request.header.refined = true;
  for (std::size_t i = 0; i < grid_points; ++i) request.points.push_back(point_at(rpm_of(i)));
  request.evaluate = [points = request.points](std::size_t point) {
    fake_sweep::sleep_some(point);
    return result_at(points[point].input_speed);
  };
  request.refinement = Refinement{next_round, [](const SweepPoint& point) {
                                    fake_sweep::sleep_some(static_cast<std::size_t>(point.input_speed));
                                    return result_at(point.input_speed);
                                  }};
  return request;
}

std::string refined_table(const fs::path& folder) {
  run_sweep(refined_request(folder));
  return read_file(folder / "sweep.csv");
}

// Names and content of the files of the points.
std::vector<std::string> point_files(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder / "points"))
    files.push_back(entry.path().filename().string() + read_file(entry.path()));
  std::sort(files.begin(), files.end());
  return files;
}

TEST(RefinedSweep, TableRisesInSpeedAndSaysWhichPointsWereAdded) {
  const TemporaryFolder location;
  const SweepOutcome outcome = run_sweep(refined_request(location / "d"));
  ASSERT_EQ(outcome.rows.size(), grid_points + 3 * rounds);
  double last = 0.0;
  std::size_t added = 0;
  for (const SweepRow& row : outcome.rows) {
    const double rpm = speed_in_rpm(row.point.input_speed);
    EXPECT_GT(rpm, last);
    last = rpm;
    EXPECT_EQ(row.refined, std::fmod(rpm, 1000.0) != 0.0) << rpm;
    added += row.refined;
  }
  EXPECT_EQ(added, 3 * rounds);
  EXPECT_THAT(read_file(location / "d/sweep.csv"), HasSubstr(",true"));
  EXPECT_EQ(row_json(outcome.header, outcome.rows.front())["refined"], false);
  EXPECT_EQ(point_files(location / "d").size(), grid_points + 3 * rounds);
}

TEST(RefinedSweep, GridsPeakIsOfTheGridAlone) {
  const TemporaryFolder location;
  const SweepOutcome outcome = run_sweep(refined_request(location / "d"));
  EXPECT_EQ(grid_peak(outcome.header, outcome.rows).speed_rpm, 5000.0);
}

TEST(RefinedSweep, ThreadsChangeNoByte) {
  const TemporaryFolder location;
  const std::string table = refined_table(location / "reference");
  for (const int jobs : {1, 3, 8}) {
    SweepRequest request = refined_request(location / ("jobs" + std::to_string(jobs)));
    request.jobs = jobs;
    run_sweep(request);
    EXPECT_EQ(read_file(request.folder / "sweep.csv"), table) << jobs;
    EXPECT_EQ(point_files(request.folder), point_files(location / "reference")) << jobs;
  }
}

// Stopped once before each of the points, of the grid and of each round, and resumed.
TEST(RefinedSweep, InterruptedAnywhereItResumesToTheSameTable) {
  const TemporaryFolder location;
  const std::string table = refined_table(location / "reference");
  const std::size_t apart = test::is_full() ? 1 : 3;  // the ends of the grid and of the sweep are among them
  for (std::size_t stop = apart; stop <= grid_points + 3 * rounds; stop += apart) {
    SweepRequest request = refined_request(location / ("stop" + std::to_string(stop)));
    request.jobs = 1;
    std::size_t begun = 0;
    const auto count = [&] {
      if (++begun == stop) std::raise(SIGINT);
    };
    const auto grid = request.evaluate;
    const auto added = request.refinement->evaluate;
    request.evaluate = [&](std::size_t point) { return count(), grid(point); };
    request.refinement->evaluate = [&](const SweepPoint& point) { return count(), added(point); };
    if (const Interruption interruption; stop < grid_points + 3 * rounds) {
      EXPECT_THROW(run_sweep(request), ComputationFailed) << stop;
      EXPECT_FALSE(fs::exists(request.folder / "sweep.csv"));
    } else {
      run_sweep(request);
    }
    SweepRequest again = refined_request(request.folder);
    again.resume = true;
    const SweepOutcome outcome = run_sweep(again);
    EXPECT_EQ(outcome.kept, stop);
    EXPECT_EQ(read_file(again.folder / "sweep.csv"), table) << stop;
  }
}

TEST(RefinedSweep, ResumeOfAFinishedOneComputesNothing) {
  const TemporaryFolder location;
  const std::string table = refined_table(location / "d");
  SweepRequest request = refined_request(location / "d");
  request.resume = true;
  request.evaluate = [](std::size_t) -> analysis::PointResult { throw std::logic_error("computed again"); };
  request.refinement->evaluate = [](const SweepPoint&) -> analysis::PointResult {
    throw std::logic_error("computed again");
  };
  run_sweep(request);
  EXPECT_EQ(read_file(location / "d/sweep.csv"), table);
}

TEST(RefinedSweep, LostFilesOfAnyPointsAreComputedAgain) {
  const TemporaryFolder location;
  const std::string table = refined_table(location / "d");
  for (const std::size_t point : {std::size_t{4}, grid_points + 1, grid_points + 3 * rounds - 1})
    fs::remove(location / "d" / point_file_name(point));
  SweepRequest request = refined_request(location / "d");
  request.resume = true;
  run_sweep(request);
  EXPECT_EQ(read_file(location / "d/sweep.csv"), table);
}

std::vector<fs::path> shards_of(const TemporaryFolder& location, std::size_t count) {
  std::vector<fs::path> shards;
  for (std::size_t index = 1; index <= count; ++index) {
    SweepRequest request =
        refined_request(location / ("s" + std::to_string(count) + "_" + std::to_string(index)));
    request.header.shard = Shard{index, count};
    for (const SweepRow& row : run_sweep(request).rows) EXPECT_FALSE(row.refined);
    shards.push_back(request.folder);
  }
  return shards;
}

TEST(RefinedSweep, ShardsHoldTheGridAndTheMergedOneIsRefinedToTheSameTable) {
  const TemporaryFolder location;
  const std::string table = refined_table(location / "reference");
  for (const std::size_t count : {1U, 2U, 5U}) {
    const fs::path merged = location / ("merged" + std::to_string(count));
    EXPECT_TRUE(merge_shards(shards_of(location, count), merged).header.refined);
    SweepRequest request = refined_request(merged);
    request.resume = true;
    EXPECT_EQ(run_sweep(request).kept, grid_points);
    EXPECT_EQ(read_file(merged / "sweep.csv"), table) << count;
    EXPECT_EQ(point_files(merged), point_files(location / "reference")) << count;
  }
}

TEST(RefinedSweep, AWholeOneIsMergedWithItsAddedPointsOrWithout) {
  const TemporaryFolder location;
  const std::string table = refined_table(location / "d");
  merge_shards({location / "d"}, location / "copy");
  EXPECT_EQ(read_file(location / "copy/sweep.csv"), table);
  const SweepOutcome grid = merge_shards({location / "d"}, location / "grid", true);
  EXPECT_FALSE(grid.header.refined);
  EXPECT_EQ(grid.rows.size(), grid_points);
}

std::string refusal_of(const SweepRequest& request) {
  try {
    run_sweep(request);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "taken";
}

TEST(RefinedSweep, ResumeNeitherDropsNorAddsARefinementUnasked) {
  const TemporaryFolder location;
  run_sweep(refined_request(location / "d"));
  SweepRequest request = refined_request(location / "d");
  request.resume = true;
  request.header.refined = false;
  EXPECT_THAT(refusal_of(request), HasSubstr("refinement of the peak 'on' was found; 'off' is required"));
}

TEST(RefinedSweep, AnotherSearchThanTheFoldersIsRefused) {
  const TemporaryFolder location;
  run_sweep(refined_request(location / "d"));
  SweepRequest request = refined_request(location / "d");
  request.resume = true;
  request.refinement->next = [](const std::vector<SweepRow>&) {
    return std::vector<SweepPoint>{point_at(4444.0)};
  };
  EXPECT_THAT(refusal_of(request),
              HasSubstr("point 12, which refines the sweep, was found at another speed"));
  request.refinement->next = [](const std::vector<SweepRow>&) { return std::vector<SweepPoint>{}; };
  EXPECT_THAT(refusal_of(request), HasSubstr("point 12"));
}

TEST(RefinedSweep, PointsStandOnTheLineOfTheirOtherAxes) {
  const TemporaryFolder location;
  SweepRequest request = refined_request(location / "d");
  request.header.axes = {{"bearing.radial_clearance_um", "um", "clearance"}};
  for (std::size_t i = 0; i < grid_points; ++i) {  // speed is the slower axis
    request.points[i] = point_at(1000.0 * static_cast<double>(1 + i / 2));
    request.points[i].axis_values = {i % 2 == 0 ? 10.0 : 20.0};
  }
  request.evaluate = [points = request.points](std::size_t i) { return result_at(points[i].input_speed); };
  request.refinement->next = [](const std::vector<SweepRow>& rows) {
    std::vector<SweepPoint> points;
    for (const double rpm : {4400.0, 4200.0}) {
      points.push_back(point_at(rpm));
      points.back().axis_values = {20.0};
    }
    return rows.size() == grid_points ? points : std::vector<SweepPoint>{};
  };
  const SweepOutcome outcome = run_sweep(request);
  std::vector<std::pair<double, double>> order;
  for (const SweepRow& row : outcome.rows)
    order.emplace_back(speed_in_rpm(row.point.input_speed), row.axes.at(0));
  EXPECT_EQ(order.size(), grid_points + 2);
  EXPECT_EQ(order[7], std::make_pair(4000.0, 20.0));
  EXPECT_EQ(order[8], std::make_pair(4200.0, 20.0));
  EXPECT_EQ(order[9], std::make_pair(4400.0, 20.0));
  EXPECT_EQ(order[10], std::make_pair(5000.0, 10.0));
}

TEST(NamedResonance, StandsInRowJsonManifestAndFile) {
  const TemporaryFolder location;
  SweepRequest request = refined_request(location / "d");
  request.header.resonances = true;
  request.resonance_of = [](const SweepPoint& point) -> std::optional<Resonance> {
    if (point.input_speed * rpm_of_rad_s > 11500.0) return std::nullopt;
    return Resonance{"planet", "P1", 5093.5, 2, 6063.0 / rpm_of_rad_s};
  };
  const SweepOutcome outcome = run_sweep(request);
  const nlohmann::ordered_json first = row_json(outcome.header, outcome.rows.front());
  EXPECT_EQ(first["resonance_kind"], "planet");
  EXPECT_EQ(first["resonance_mode"], "P1");
  EXPECT_EQ(first["resonance_frequency_Hz"], 5093.5);
  EXPECT_EQ(first["resonance_harmonic"], 2.0);
  EXPECT_EQ(first["resonance_speed_rpm"], 6063.0);
  EXPECT_TRUE(row_json(outcome.header, outcome.rows.back())["resonance_speed_rpm"].is_null());
  request.resume = true;
  EXPECT_EQ(run_sweep(request).rows.front().resonance->mode, "P1");
}

}  // namespace
}  // namespace orbearing::app::refinement_test
