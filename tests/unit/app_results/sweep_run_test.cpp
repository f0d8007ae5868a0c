#include "app/results/sweep_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <nlohmann/json.hpp>

#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "mechanics/cancellation.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::sweep_run_test {
namespace {

namespace fs = std::filesystem;
using fake_sweep::fake_request;
using fake_sweep::TemporaryFolder;
using ::testing::HasSubstr;

constexpr std::size_t points = 60;

std::string failure_of(const SweepRequest& request) {
  const Interruption interruption;
  try {
    run_sweep(request);
  } catch (const ComputationFailed& error) {
    return error.what();
  }
  return "done";
}

/// Asks for an end, as a user does by Ctrl-C, when `after` points were begun.
SweepRequest interrupted_request(const fs::path& folder, std::size_t after) {
  SweepRequest request = fake_request(folder, points);
  request.jobs = 1;  // a second thread could finish the sweep while the first is about to ask for its end
  request.evaluate = [after](std::size_t point) {
    if (point == after) std::raise(SIGINT);
    return fake_sweep::fake_result(point);
  };
  return request;
}

TEST(Sweep, TableHasARowPerPointAndTheFailedOneItsReason) {
  const TemporaryFolder location;
  const std::string table = fake_sweep::fake_table(location / "d", points);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), std::ptrdiff_t(points + 1));
  EXPECT_THAT(table, HasSubstr(",,,,\"no balance, \"\"as\"\" found in line 2\","));
  EXPECT_TRUE(fs::exists(location / "d/points/00007.nc"));
  EXPECT_TRUE(fs::exists(location / "d/points/00059.nc"));
}

TEST(Sweep, OutcomeCountsFailures) {
  const TemporaryFolder location;
  const SweepOutcome outcome = run_sweep(fake_request(location / "d", points));
  EXPECT_EQ(outcome.rows.size(), points);
  EXPECT_EQ(outcome.failed, 1U);
  EXPECT_EQ(outcome.kept, 0U);
}

TEST(Sweep, ThreadsDoNotChangeTheTable) {
  const TemporaryFolder location;
  const std::string table = fake_sweep::fake_table(location / "reference", points);
  for (const int jobs : {0, 1, 3, 8}) {
    SweepRequest request = fake_request(location / ("jobs" + std::to_string(jobs)), points);
    request.jobs = jobs;
    run_sweep(request);
    EXPECT_EQ(read_file(request.folder / "sweep.csv"), table) << jobs;
  }
}

TEST(Sweep, UsesTheThreadsItIsGiven) {
  const TemporaryFolder location;
  SweepRequest request = fake_request(location / "d", points);
  request.jobs = 5;
  std::atomic<int> now = 0;
  std::atomic<int> most = 0;
  request.evaluate = [&](std::size_t point) {
    const int here = ++now;
    for (int seen = most; seen < here && !most.compare_exchange_weak(seen, here);) continue;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    --now;
    return fake_sweep::fake_result(point);
  };
  run_sweep(request);
  EXPECT_LE(most, 5);
  EXPECT_GE(most, 2);
}

TEST(Sweep, InterruptedKeepsWhatIsDoneAndResumes) {
  const TemporaryFolder location;
  const std::string table = fake_sweep::fake_table(location / "reference", points);
  EXPECT_THAT(failure_of(interrupted_request(location / "d", 30)), HasSubstr("continue with --resume"));
  EXPECT_FALSE(fs::exists(location / "d/sweep.csv"));
  SweepRequest request = fake_request(location / "d", points);
  request.resume = true;
  const SweepOutcome outcome = run_sweep(request);
  EXPECT_GE(outcome.kept, 29U);
  EXPECT_LT(outcome.kept, points);
  EXPECT_EQ(read_file(location / "d/sweep.csv"), table);
}

// A point that a stop request interrupts is no failed point, and no later one is begun.
TEST(Sweep, PointThatIsBrokenOffIsNotKept) {
  const TemporaryFolder location;
  const std::string table = fake_sweep::fake_table(location / "reference", points);
  SweepRequest request = fake_request(location / "d", points);
  request.jobs = 1;
  request.evaluate = [](std::size_t point) {
    if (point == 30) request_stop();
    throw_if_stopped();
    return fake_sweep::fake_result(point);
  };
  EXPECT_THROW(run_sweep(request), Interrupted);
  clear_stop();
  EXPECT_FALSE(fs::exists(location / "d/sweep.csv"));
  EXPECT_TRUE(fs::exists(location / "d/points/00029.nc"));
  EXPECT_FALSE(fs::exists(location / "d/points/00030.nc"));
  SweepRequest again = fake_request(location / "d", points);
  again.resume = true;
  EXPECT_EQ(run_sweep(again).kept, 30U);
  EXPECT_EQ(read_file(location / "d/sweep.csv"), table);
}

TEST(Sweep, ResumeOfAFinishedSweepComputesNothing) {
  const TemporaryFolder location;
  const std::string table = fake_sweep::fake_table(location / "d", points);
  SweepRequest request = fake_request(location / "d", points);
  request.resume = true;
  request.evaluate = [](std::size_t) -> analysis::PointResult { throw std::logic_error("computed again"); };
  EXPECT_EQ(run_sweep(request).kept, points);
  EXPECT_EQ(read_file(location / "d/sweep.csv"), table);
}

TEST(Sweep, DiskThatFillsUpEndsItAndLosesNothing) {
  const TemporaryFolder location;
  const std::string table = fake_sweep::fake_table(location / "reference", points);
  SweepRequest request = fake_request(location / "d", points);
  request.evaluate = [&](std::size_t point) {
    // A folder in the way of the file is a write error at any user's rights.
    if (point == 20) fs::create_directories(location / "d/points/00020.nc/x");
    return fake_sweep::fake_result(point);
  };
  EXPECT_THAT(failure_of(request), HasSubstr("00020.nc: cannot be written"));
  fs::remove_all(location / "d/points/00020.nc");
  request = fake_request(location / "d", points);
  request.resume = true;
  run_sweep(request);
  EXPECT_EQ(read_file(location / "d/sweep.csv"), table);
}

TEST(Sweep, AxesStandInTableAndManifest) {
  const TemporaryFolder location;
  SweepRequest request = fake_request(location / "d", 3);
  request.header.axes = {{"bearing.radial_clearance_um", "um", "clearance"}};
  for (SweepPoint& point : request.points) point.axis_values = {0.1};
  const SweepOutcome outcome = run_sweep(request);
  EXPECT_EQ(outcome.rows[2].axes.at(0), 0.1);
  EXPECT_EQ(read_results(location / "d").header->axes.front().units, "um");
}

TEST(Sweep, JsonHasThePromisedKeysAndNullWhereNothingIsKnown) {
  const TemporaryFolder location;
  const SweepOutcome outcome = run_sweep(fake_request(location / "d", 10));
  const nlohmann::ordered_json object =
      sweep_json(outcome, grid_peak(outcome.header, outcome.rows), nlohmann::ordered_json::array(),
                 nlohmann::ordered_json::array({"a warning"}), {{"orbearing", "0.1.0"}});
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  EXPECT_EQ(keys,
            (std::vector<std::string>{"points", "peak", "assumptions", "warnings", "versions", "units"}));
  EXPECT_EQ(object["points"].size(), 10U);
  EXPECT_TRUE(object["points"][fake_sweep::failing_point]["life_h"].is_null());
  EXPECT_TRUE(object["points"][0]["film_inner_um"].is_null());
  EXPECT_TRUE(object["peak"]["refined_life_h"].is_null());
  EXPECT_TRUE(object["peak"]["life_h"].is_number());
}

TEST(GridPeak, IsTheLongestLifeAndNothingWithoutLives) {
  const auto lived = [](double rpm, double hours) {
    return row_of_numbers({{"input_speed_rpm", rpm}, {"life_h", hours}}, {});
  };
  const double none = std::nan("");
  EXPECT_EQ(grid_peak({}, {lived(1.0, none), lived(2.0, 5.0), lived(3.0, 4.0)}).speed_rpm, 2.0);
  EXPECT_TRUE(std::isnan(grid_peak({}, {lived(1.0, none)}).life_h));
}

}  // namespace
}  // namespace orbearing::app::sweep_run_test
