// A continued sweep: paths in order, every point from the final state before it, equal when cut and resumed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

#include "app/errors.hpp"
#include "app/results/point_file.hpp"
#include "app/results/progress.hpp"
#include "app/results/record_writers.hpp"
#include "app/results/sweep_run.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::continued_sweep_test {
namespace {

namespace fs = std::filesystem;
using fake_sweep::fake_request;
using fake_sweep::TemporaryFolder;
using ::testing::HasSubstr;
using Numbers = std::vector<std::size_t>;

constexpr std::size_t points = 12;             // one of them, failing_point, fails
constexpr Eigen::Index state_of_rollers = 29;  // variables of a bearing with three rollers

// The state remembers by which points it went, in which order; its digits fill a double.
Eigen::VectorXd next_state(std::size_t point, const Eigen::VectorXd& start) {
  if (start.size() == 0) return Eigen::VectorXd::Constant(state_of_rollers, std::sqrt(2.0 + double(point)));
  return (start.array() * 1.0625 + std::sqrt(3.0 + double(point))).matrix();
}

SweepRequest continued(const fs::path& folder, Direction direction) {
  SweepRequest request = fake_request(folder, points);
  request.header.fidelity = "dynamic";
  request.header.continued = direction;
  request.evaluate = [](std::size_t) -> analysis::PointResult { throw std::logic_error("not continued"); };
  request.evaluate_from = [](std::size_t point, const Eigen::VectorXd& start) {
    analysis::PointResult result = fake_sweep::fake_result(point);
    result.dynamic.emplace().final_state = next_state(point, start);
    result.dynamic->layout = {.rollers = 3};
    result.cage_slip = result.dynamic->final_state[0];
    return result;
  };
  return request;
}

std::string table_of(const SweepRequest& request) {
  run_sweep(request);
  return read_file(request.folder / "sweep.csv");
}

/// Ends the sweep as Ctrl-C does while it computes `point`; that point is kept.
void run_until(SweepRequest request, std::size_t point) {
  const auto evaluate = request.evaluate_from;
  request.evaluate_from = [=](std::size_t now, const Eigen::VectorXd& start) {
    if (now == point) std::raise(SIGINT);
    return evaluate(now, start);
  };
  const Interruption interruption;
  EXPECT_THROW(run_sweep(request), ComputationFailed);
}

TEST(ContinuationPaths, FollowTheSpeedWhateverTheOrderOfThePoints) {
  const std::vector<SweepPoint> list{{"", 300.0, {}}, {"", 100.0, {}}, {"", 200.0, {}}};
  EXPECT_EQ(continuation_paths(list, Direction::up), (std::vector<Numbers>{{1, 2, 0}}));
  EXPECT_EQ(continuation_paths(list, Direction::down), (std::vector<Numbers>{{0, 2, 1}}));
}

TEST(ContinuationPaths, OneForEachCombinationOfTheOtherAxes) {
  std::vector<SweepPoint> list;
  for (const double speed : {100.0, 200.0})
    for (const double power : {50.0, 150.0}) list.push_back({"", speed, {power}});
  EXPECT_EQ(continuation_paths(list, Direction::up), (std::vector<Numbers>{{0, 2}, {1, 3}}));
  EXPECT_EQ(continuation_paths(list, Direction::down), (std::vector<Numbers>{{2, 0}, {3, 1}}));
}

TEST(ContinuedSweep, EveryPointStartsWhereItsNeighbourEnded) {
  const TemporaryFolder location;
  for (const Direction direction : {Direction::up, Direction::down}) {
    const SweepOutcome outcome = run_sweep(continued(location / to_string(direction), direction));
    Eigen::VectorXd state;
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t point = direction == Direction::up ? i : points - 1 - i;
      if (point == fake_sweep::failing_point) continue;  // the next one starts where this one did
      state = next_state(point, state);
      EXPECT_EQ(outcome.rows[point].point.cage_slip, state[0]) << point;
      EXPECT_EQ(read_final_state(location / to_string(direction) / point_file_name(point)).front(), state[0]);
    }
  }
}

TEST(ContinuedSweep, CutAnywhereAndResumedItIsTheSameToTheLastBit) {
  const TemporaryFolder location;
  const std::string undisturbed = table_of(continued(location / "whole", Direction::up));
  for (const std::size_t cut : {std::size_t{0}, std::size_t{5}, fake_sweep::failing_point, points - 2}) {
    SweepRequest request = continued(location / std::to_string(cut), Direction::up);
    run_until(request, cut);
    request.resume = true;
    EXPECT_EQ(table_of(request), undisturbed) << cut;
    for (std::size_t point = 0; point < points; ++point)
      EXPECT_EQ(read_final_state(request.folder / point_file_name(point)),
                read_final_state(location / "whole" / point_file_name(point)));
  }
}

TEST(ContinuedSweep, LostPointIsComputedAnewFromItsNeighbour) {
  const TemporaryFolder location;
  SweepRequest request = continued(location / "d", Direction::up);
  const std::string undisturbed = table_of(request);
  fs::remove(request.folder / point_file_name(5));
  request.resume = true;
  EXPECT_EQ(table_of(request), undisturbed);
}

TEST(ContinuedSweep, DoesNotGoOnFromAStateThatIsNotItsOwn) {
  const TemporaryFolder location;
  const std::string undisturbed = table_of(continued(location / "whole", Direction::up));
  SweepRequest request = continued(location / "d", Direction::up);
  run_until(request, 5);
  fs::copy_file(request.folder / point_file_name(4), request.folder / point_file_name(5),
                fs::copy_options::overwrite_existing);
  request.resume = true;
  EXPECT_EQ(table_of(request), undisturbed);
}

TEST(ContinuedSweep, OtherDirectionsAreNotResumed) {
  const TemporaryFolder location;
  run_sweep(continued(location / "up", Direction::up));
  const auto before = fake_sweep::snapshot(location / "up");
  SweepRequest down = continued(location / "up", Direction::down);
  SweepRequest none = down;
  none.header.continued.reset();
  for (SweepRequest* request : {&down, &none}) {
    request->resume = true;
    try {
      run_sweep(*request);
      FAIL() << "resumed";
    } catch (const BadInput& error) {
      EXPECT_THAT(error.messages.front(), HasSubstr("direction of --continue 'up' was found"));
    }
  }
  EXPECT_EQ(fake_sweep::snapshot(location / "up"), before);
}

TEST(ContinuedSweep, ManifestRemembersTheDirection) {
  for (const Direction direction : {Direction::up, Direction::down}) {
    ManifestHeader header = fake_sweep::fake_header(points);
    header.continued = direction;
    EXPECT_EQ(parse_manifest(header_line(header), "m").header->continued, direction);
  }
  EXPECT_FALSE(
      parse_manifest(header_line(fake_sweep::fake_header(points)), "m").header->continued.has_value());
}

TEST(PointFile, FinalStateIsReadAsItWasWritten) {
  const TemporaryFolder location;
  analysis::PointResult result = fake_sweep::fake_result(1);
  result.dynamic.emplace().final_state = Eigen::VectorXd::LinSpaced(state_of_rollers, -1.0 / 3.0, 2.0 / 7.0);
  fake_sweep::write(location / "p.nc",
                    netcdf_bytes(point_content(fake_sweep::fake_header(5), 1, {}, result)));
  const Eigen::VectorXd& state = result.dynamic->final_state;
  EXPECT_EQ(read_final_state(location / "p.nc"), std::vector<double>(state.begin(), state.end()));
  EXPECT_TRUE(read_final_state(location / "missing.nc").empty());
}

// Rollers that tilt, rims that bend and bearings without a cage have variables of their own.
TEST(PointFile, FinalStateNamesEachOfItsVariables) {
  for (const bearing::motion::StateLayout& layout :
       {bearing::motion::StateLayout{.rollers = 3}, bearing::motion::StateLayout{.rollers = 3, .waves = 5},
        bearing::motion::StateLayout{.rollers = 3, .tilting = true, .waves = 5, .caged = false}}) {
    analysis::PointResult result;
    result.dynamic.emplace();
    result.dynamic->final_state = Eigen::VectorXd::Zero(layout.size());
    result.dynamic->layout = layout;
    Record record = record_of(result);
    const std::string names = record.entry(analysis::kFinalState).meaning;
    EXPECT_EQ(std::count(names.begin(), names.end(), '['), layout.size());
    EXPECT_EQ(names.find("end_displacement") != std::string::npos, layout.tilting);
    EXPECT_EQ(names.find("rim_wave_3_sine") != std::string::npos, layout.waves > 0);
    EXPECT_EQ(names.find("cage_x") != std::string::npos, layout.caged);
  }
}

}  // namespace
}  // namespace orbearing::app::continued_sweep_test
