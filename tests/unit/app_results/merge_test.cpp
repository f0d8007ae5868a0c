#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>

#include "app/errors.hpp"
#include "app/results/sweep_run.hpp"
#include "tests/messages.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::merge_test {
namespace {

namespace fs = std::filesystem;
using fake_sweep::fake_request;
using fake_sweep::TemporaryFolder;
using ::testing::HasSubstr;

constexpr std::size_t points = 31;

SweepRequest shard_request(const TemporaryFolder& location, std::size_t index, std::size_t count) {
  SweepRequest request = fake_request(location / ("s" + std::to_string(index)), points);
  request.header.shard = Shard{index, count};
  return request;
}

fs::path run_shard(const TemporaryFolder& location, std::size_t index, std::size_t count) {
  const SweepRequest request = shard_request(location, index, count);
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
  const TemporaryFolder location;
  const std::string table = fake_sweep::fake_table(location / "whole", points);
  const std::vector<fs::path> shards = {run_shard(location, 3, 3), run_shard(location, 1, 3),
                                        run_shard(location, 2, 3)};
  const SweepOutcome outcome = merge_shards(shards, location / "new/merged");
  EXPECT_EQ(outcome.rows.size(), points);
  EXPECT_EQ(outcome.failed, 1U);
  EXPECT_EQ(read_file(location / "new/merged/sweep.csv"), table);
  EXPECT_EQ(read_file(location / "new/merged/case.resolved.yaml"),
            read_file(location / "whole/case.resolved.yaml"));
  for (std::size_t point = 0; point < points; ++point)
    EXPECT_EQ(read_file(location / "new/merged" / point_file_name(point)),
              read_file(location / "whole" / point_file_name(point)));
}

TEST(Merge, MergedFolderIsAWholeSweepThatResumes) {
  const TemporaryFolder location;
  merge_shards({run_shard(location, 1, 2), run_shard(location, 2, 2)}, location / "merged");
  SweepRequest request = fake_request(location / "merged", points);
  request.resume = true;
  EXPECT_EQ(run_sweep(request).kept, points);
}

TEST(Merge, ShardTableHoldsItsOwnPoints) {
  const TemporaryFolder location;
  const std::string table = read_file(run_shard(location, 2, 3) / "sweep.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 10);  // points 1, 4, ..., 28
}

TEST(Merge, MissingShardsAreNamed) {
  const TemporaryFolder location;
  const std::string message = refusal({run_shard(location, 2, 3)}, location / "merged");
  EXPECT_THAT(message, HasSubstr("shard 1/3 is missing"));
  EXPECT_THAT(message, HasSubstr("shard 3/3 is missing"));
  EXPECT_FALSE(fs::exists(location / "merged"));
}

TEST(Merge, ShardGivenTwiceIsRefused) {
  const TemporaryFolder location;
  const fs::path first = run_shard(location, 1, 2);
  EXPECT_THAT(refusal({first, run_shard(location, 2, 2), first}, location / "merged"),
              HasSubstr("shard 1/2 was found, which"));
}

TEST(Merge, UnlikeShardsAreRefused) {
  const TemporaryFolder location;
  const fs::path first = run_shard(location, 1, 2);
  const auto refuses = [&](auto change, const std::string& part) {
    SweepRequest request = shard_request(location, 2, 2);
    change(request.header);
    fs::remove_all(request.folder);
    run_sweep(request);
    EXPECT_THAT(refusal({first, request.folder}, location / "merged"), HasSubstr(part));
    EXPECT_FALSE(fs::exists(location / "merged"));
  };
  refuses([](ManifestHeader& h) { h.case_hash = "ff"; }, "resolved case with hash 'ff' was found");
  refuses([](ManifestHeader& h) { h.program_version = "2"; }, "program version '2' was found");
  refuses([](ManifestHeader& h) { h.instruction_set = "arm"; }, "instruction set 'arm' was found");
  refuses([](ManifestHeader& h) { h.fidelity = "dynamic"; }, "fidelity 'dynamic' was found");
  refuses([](ManifestHeader& h) { h.shard = Shard{2, 3}; }, "shard 2/3 was found; one of 2 is required");
}

TEST(Merge, UnfinishedShardIsRefused) {
  const TemporaryFolder location;
  const fs::path second = run_shard(location, 2, 2);
  { const ResultFolder begun(location / "s1", shard_request(location, 1, 2).header, "", OpenMode::fresh); }
  EXPECT_THAT(refusal({location / "s1", second}, location / "merged"),
              HasSubstr("0 of 16 points were found; finish it"));
}

TEST(Merge, EveryFolderWithoutResultsIsNamed) {
  const TemporaryFolder location;
  const std::string message = refusal({location / "x", location / "y"}, location / "merged");
  EXPECT_THAT(message, HasSubstr("/x: no manifest.jsonl was found"));
  EXPECT_THAT(message, HasSubstr("/y: no manifest.jsonl was found"));
  EXPECT_REFUSED(BadInput, "merge.nothing", merge_shards({}, location / "merged"));
}

TEST(Merge, OutputThatHoldsResultsIsRefused) {
  const TemporaryFolder location;
  const fs::path first = run_shard(location, 1, 2);
  EXPECT_THAT(refusal({first, run_shard(location, 2, 2)}, first), HasSubstr("holds results"));
}

TEST(Merge, EveryDamagedFileIsNamedBeforeAnythingIsWritten) {
  const TemporaryFolder location;
  const std::vector<fs::path> shards = {run_shard(location, 1, 2), run_shard(location, 2, 2)};
  const std::string whole = read_file(shards[0] / point_file_name(4));
  fs::remove(shards[0] / point_file_name(2));
  fake_sweep::write(shards[0] / point_file_name(4), whole.substr(0, 4096));
  fake_sweep::write(shards[1] / point_file_name(1), "");
  fake_sweep::write(shards[1] / point_file_name(3), "no netCDF");
  const std::string message = refusal(shards, location / "merged");
  EXPECT_THAT(message, HasSubstr("s1/points/00002.nc: is missing"));
  EXPECT_THAT(message, HasSubstr("s1/points/00004.nc: differs from what its sweep wrote"));
  EXPECT_THAT(message, HasSubstr("s2/points/00001.nc: is empty"));
  EXPECT_THAT(message, HasSubstr("s2/points/00003.nc: differs from what its sweep wrote"));
  EXPECT_FALSE(fs::exists(location / "merged"));
}

TEST(Merge, ChangedRowIsNamedBeforeAnythingIsWritten) {
  const TemporaryFolder location;
  const std::vector<fs::path> shards = {run_shard(location, 1, 2), run_shard(location, 2, 2)};
  std::string text = read_file(shards[0] / "manifest.jsonl");
  const std::size_t digit = text.find("\"life_h\":") + 9;
  text[digit] = text[digit] == '9' ? '8' : '9';
  fake_sweep::write(shards[0] / "manifest.jsonl", text);
  EXPECT_THAT(refusal(shards, location / "merged"),
              HasSubstr("s1/manifest.jsonl:2:1: differs from what its sweep wrote; required: run"));
  EXPECT_FALSE(fs::exists(location / "merged"));
}

TEST(Merge, ChangedCaseOfAShardIsRefused) {
  const TemporaryFolder location;
  const std::vector<fs::path> shards = {run_shard(location, 1, 2), run_shard(location, 2, 2)};
  fake_sweep::write(shards[1] / "case.resolved.yaml", "name: other\n");
  EXPECT_THAT(refusal(shards, location / "merged"), HasSubstr("s2/case.resolved.yaml: is empty or differs"));
  EXPECT_FALSE(fs::exists(location / "merged"));
}

/// Files cannot grow beyond a size: the manifest of many points meets it late.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t most) {
    getrlimit(RLIMIT_FSIZE, &former_);
    const rlimit limit{most, former_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_IGN);  // as the program does
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &former_); }

 private:
  rlimit former_{};
};

/// Message of a merge onto a disk that takes the first points and not the last; "merged" where it takes all.
std::string failure(const std::vector<fs::path>& shards, const fs::path& folder) {
  const auto whole = static_cast<rlim_t>(fs::file_size(shards.front() / "manifest.jsonl"));
  const SmallDisk disk(whole + whole / 2);
  try {
    merge_shards(shards, folder);
  } catch (const ComputationFailed& error) {
    return error.what();
  }
  return "merged";
}

TEST(Merge, FullDiskLeavesNothingAndTheRetrySucceeds) {
  const TemporaryFolder location;
  std::vector<fs::path> shards;
  for (std::size_t index = 1; index <= 2; ++index) {
    SweepRequest request = fake_request(location / ("s" + std::to_string(index)), 200);
    request.header.shard = Shard{index, 2};
    run_sweep(request);
    shards.push_back(request.folder);
  }
  fs::create_directory(location / "empty");
  for (const char* name : {"new/merged", "empty"}) {
    EXPECT_THAT(
        failure(shards, location / name),
        HasSubstr(
            "nothing of the merge is kept: raise the limit of the size of files (ulimit -f), then merge"));
    EXPECT_FALSE(fs::exists(location / "new"));
    EXPECT_TRUE(fs::is_empty(location / "empty"));
  }
  EXPECT_EQ(merge_shards(shards, location / "empty").rows.size(), 200U);
}

}  // namespace
}  // namespace orbearing::app::merge_test
