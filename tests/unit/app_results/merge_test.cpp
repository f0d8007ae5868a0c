#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/errors.hpp"
#include "app/results/sweep_run.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app {
namespace {

namespace fs = std::filesystem;
using testing::fake_request;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

constexpr std::size_t points = 31;

SweepRequest shard_request(const TemporaryFolder& place, std::size_t index, std::size_t count) {
  SweepRequest request = fake_request(place / ("s" + std::to_string(index)), points);
  request.header.shard = Shard{index, count};
  return request;
}

fs::path run_shard(const TemporaryFolder& place, std::size_t index, std::size_t count) {
  const SweepRequest request = shard_request(place, index, count);
  run_sweep(request);
  return request.folder;
}

std::string refusal(const std::vector<fs::path>& shards, const fs::path& folder) {
  try {
    merge_shards(shards, folder);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Merge, EqualsTheSweepInOnePiece) {
  const TemporaryFolder place;
  const std::string table = testing::fake_table(place / "whole", points);
  const std::vector<fs::path> shards = {run_shard(place, 3, 3), run_shard(place, 1, 3),
                                        run_shard(place, 2, 3)};
  const SweepOutcome outcome = merge_shards(shards, place / "new/merged");
  EXPECT_EQ(outcome.rows.size(), points);
  EXPECT_EQ(outcome.failed, 1U);
  EXPECT_EQ(read_file(place / "new/merged/sweep.csv"), table);
  EXPECT_EQ(read_file(place / "new/merged/case.resolved.yaml"),
            read_file(place / "whole/case.resolved.yaml"));
  for (std::size_t point = 0; point < points; ++point)
    EXPECT_EQ(read_file(place / "new/merged" / point_file_name(point)),
              read_file(place / "whole" / point_file_name(point)));
}

TEST(Merge, MergedFolderIsAWholeSweepThatResumes) {
  const TemporaryFolder place;
  merge_shards({run_shard(place, 1, 2), run_shard(place, 2, 2)}, place / "merged");
  SweepRequest request = fake_request(place / "merged", points);
  request.resume = true;
  EXPECT_EQ(run_sweep(request).kept, points);
}

TEST(Merge, ShardTableHoldsItsOwnPoints) {
  const TemporaryFolder place;
  const std::string table = read_file(run_shard(place, 2, 3) / "sweep.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 10);  // points 1, 4, ..., 28
}

TEST(Merge, MissingShardsAreNamed) {
  const TemporaryFolder place;
  const std::string message = refusal({run_shard(place, 2, 3)}, place / "merged");
  EXPECT_THAT(message, HasSubstr("shard 1/3 is missing"));
  EXPECT_THAT(message, HasSubstr("shard 3/3 is missing"));
  EXPECT_FALSE(fs::exists(place / "merged"));
}

TEST(Merge, ShardGivenTwiceIsRefused) {
  const TemporaryFolder place;
  const fs::path first = run_shard(place, 1, 2);
  EXPECT_THAT(refusal({first, run_shard(place, 2, 2), first}, place / "merged"),
              HasSubstr("shard 1/2 was found, which"));
}

TEST(Merge, UnlikeShardsAreRefused) {
  const TemporaryFolder place;
  const fs::path first = run_shard(place, 1, 2);
  const auto refuses = [&](auto change, const std::string& part) {
    SweepRequest request = shard_request(place, 2, 2);
    change(request.header);
    fs::remove_all(request.folder);
    run_sweep(request);
    EXPECT_THAT(refusal({first, request.folder}, place / "merged"), HasSubstr(part));
    EXPECT_FALSE(fs::exists(place / "merged"));
  };
  refuses([](ManifestHeader& h) { h.case_hash = "ff"; }, "resolved case with hash 'ff' was found");
  refuses([](ManifestHeader& h) { h.program_version = "2"; }, "program version '2' was found");
  refuses([](ManifestHeader& h) { h.instruction_set = "arm"; }, "instruction set 'arm' was found");
  refuses([](ManifestHeader& h) { h.fidelity = "dynamic"; }, "fidelity 'dynamic' was found");
  refuses([](ManifestHeader& h) { h.shard = Shard{2, 3}; }, "shard 2/3 was found; one of 2 is required");
}

TEST(Merge, UnfinishedShardIsRefused) {
  const TemporaryFolder place;
  const fs::path second = run_shard(place, 2, 2);
  { const ResultFolder begun(place / "s1", shard_request(place, 1, 2).header, "", OpenMode::fresh); }
  EXPECT_THAT(refusal({place / "s1", second}, place / "merged"),
              HasSubstr("0 of 16 points were found; finish it"));
}

TEST(Merge, EveryFolderWithoutResultsIsNamed) {
  const TemporaryFolder place;
  const std::string message = refusal({place / "x", place / "y"}, place / "merged");
  EXPECT_THAT(message, HasSubstr("/x: no manifest.jsonl was found"));
  EXPECT_THAT(message, HasSubstr("/y: no manifest.jsonl was found"));
  EXPECT_NE(refusal({}, place / "merged"), "accepted");
}

TEST(Merge, OutputThatHoldsResultsIsRefused) {
  const TemporaryFolder place;
  const fs::path first = run_shard(place, 1, 2);
  EXPECT_THAT(refusal({first, run_shard(place, 2, 2)}, first), HasSubstr("holds results"));
}

TEST(Merge, PointFileGoneFromAShardIsNamed) {
  const TemporaryFolder place;
  const fs::path first = run_shard(place, 1, 2);
  fs::remove(first / point_file_name(2));
  EXPECT_THAT(refusal({first, run_shard(place, 2, 2)}, place / "merged"),
              HasSubstr("00002.nc: cannot be read"));
}

}  // namespace
}  // namespace orbearing::app
