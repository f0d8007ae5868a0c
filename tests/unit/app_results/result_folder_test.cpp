// Permission to write into a folder: nothing may be touched where it is refused.
#include "app/results/result_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/errors.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::result_folder_test {
namespace {

namespace fs = std::filesystem;
using fake_sweep::fake_header;
using fake_sweep::snapshot;
using fake_sweep::TemporaryFolder;
using ::testing::HasSubstr;

constexpr const char* resolved = "name: fake\n";

std::string refusal(const fs::path& folder, const ManifestHeader& header, OpenMode mode) {
  try {
    const ResultFolder opened(folder, header, resolved, mode);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

/// Refused with a message that holds `part`, and not a byte changed.
void expect_untouched(const fs::path& folder, const ManifestHeader& header, OpenMode mode,
                      const std::string& part) {
  const auto before = snapshot(folder);
  EXPECT_THAT(refusal(folder, header, mode), HasSubstr(part));
  EXPECT_EQ(snapshot(folder), before);
}

FinishedPoint finished(std::size_t point) {
  return {point, "content", sweep_row(fake_sweep::fake_result(point), {})};
}

/// A folder with points 0 and 1 of 5.
fs::path begun(const TemporaryFolder& location) {
  ResultFolder folder(location / "begun", fake_header(5), resolved, OpenMode::fresh);
  folder.keep({finished(0), finished(1)});
  return folder.path();
}

TEST(ResultFolder, MissingFolderIsMadeWithItsParents) {
  const TemporaryFolder location;
  for (const OpenMode mode : {OpenMode::fresh, OpenMode::resume}) {
    const fs::path path = location / (mode == OpenMode::fresh ? "a/b/c" : "d/e/f/");
    EXPECT_EQ(refusal(path, fake_header(5), mode), "accepted");
    EXPECT_EQ(read_file(path / "case.resolved.yaml"), resolved);
    EXPECT_TRUE(fs::is_directory(path / "points"));
  }
}

TEST(ResultFolder, EmptyFolderIsTaken) {
  const TemporaryFolder location;
  for (const OpenMode mode : {OpenMode::fresh, OpenMode::resume}) {
    const fs::path path = location / (mode == OpenMode::fresh ? "fresh" : "resume");
    fs::create_directory(path);
    EXPECT_EQ(refusal(path, fake_header(5), mode), "accepted");
  }
}

TEST(ResultFolder, ResultsAreNotWrittenOver) {
  const TemporaryFolder location;
  expect_untouched(begun(location), fake_header(5), OpenMode::fresh,
                   "holds results; a new or empty folder is required, or --resume");
}

TEST(ResultFolder, ForeignFilesAreLeftAlone) {
  const TemporaryFolder location;
  fake_sweep::write(location / "thesis.tex", "years of work");
  for (const OpenMode mode : {OpenMode::fresh, OpenMode::resume})
    expect_untouched(location / "", fake_header(5), mode,
                     "holds 'thesis.tex', which is no result of a sweep");
}

TEST(ResultFolder, ForeignManifestIsLeftAlone) {
  for (const char* text :
       {"{\"from\": \"another program\"}\n", "a list of cargo", "{\"orbearing_results\":2}\n"}) {
    const TemporaryFolder location;
    fake_sweep::write(location / "manifest.jsonl", text);
    for (const OpenMode mode : {OpenMode::fresh, OpenMode::resume})
      expect_untouched(location / "", fake_header(5), mode, "required");
  }
}

TEST(ResultFolder, ResumesTheSameCase) {
  const TemporaryFolder location;
  const fs::path path = begun(location);
  const ResultFolder folder(path, fake_header(5), resolved, OpenMode::resume);
  EXPECT_EQ(folder.finished().size(), 2U);
  EXPECT_TRUE(folder.finished().contains(1));
}

TEST(ResultFolder, AnotherCaseVersionOrShardIsNotResumed) {
  const TemporaryFolder location;
  const fs::path path = begun(location);
  const auto refuses = [&](auto change, const std::string& part) {
    ManifestHeader header = fake_header(5);
    change(header);
    expect_untouched(path, header, OpenMode::resume, part);
  };
  refuses([](ManifestHeader& h) { h.case_hash = "ff"; },
          "resolved case with hash '0123456789abcdef' was found; 'ff'");
  refuses([](ManifestHeader& h) { h.program_version = "9"; },
          "program version '0.1.0' was found; '9' is required");
  refuses([](ManifestHeader& h) { h.fidelity = "dynamic"; }, "fidelity 'quasi-static' was found");
  refuses([](ManifestHeader& h) { h.instruction_set = "x86-64-v4"; }, "instruction set 'x86-64' was found");
  refuses(
      [](ManifestHeader& h) {
        h.shard = Shard{1, 2};
      },
      "the whole sweep was found; shard 1/2 is required");
}

TEST(ResultFolder, TornLastLineAndLeftoversAreClearedAtResume) {
  const TemporaryFolder location;
  const fs::path path = begun(location);
  const std::string sound = read_file(path / "manifest.jsonl");
  fake_sweep::write(path / "manifest.jsonl", sound + "{\"point\":2,\"fi");
  fake_sweep::write(path / "points/00002.nc.tmp", "half");
  fake_sweep::write(path / "sweep.csv.tmp", "half");
  ResultFolder folder(path, fake_header(5), resolved, OpenMode::resume);
  EXPECT_EQ(read_file(path / "manifest.jsonl"), sound);
  EXPECT_FALSE(fs::exists(path / "points/00002.nc.tmp"));
  EXPECT_FALSE(fs::exists(path / "sweep.csv.tmp"));
  folder.keep({finished(2)});
  EXPECT_EQ(read_results(path).entries.size(), 3U);
}

TEST(ResultFolder, KilledBeforeItsHeaderWasWrittenStartsAfresh) {
  for (const std::size_t length : {0U, 5U, 40U}) {
    const TemporaryFolder location;
    fake_sweep::write(location / "manifest.jsonl", header_line(fake_header(5)).substr(0, length));
    EXPECT_EQ(refusal(location / "", fake_header(5), OpenMode::resume), "accepted");
    EXPECT_TRUE(read_results(location / "").header);
  }
}

TEST(ResultFolder, PointWhoseFileIsGoneIsMissing) {
  const TemporaryFolder location;
  const fs::path path = begun(location);
  fs::remove(path / point_file_name(0));
  const ResultFolder folder(path, fake_header(5), resolved, OpenMode::resume);
  EXPECT_FALSE(folder.finished().contains(0));
  EXPECT_TRUE(folder.finished().contains(1));
}

TEST(ResultFolder, DamagedPointsAreMissingAndReported) {
  const TemporaryFolder location;
  const fs::path path = begun(location);
  const std::string whole = read_file(path / point_file_name(0));
  std::string flipped = whole;
  flipped[whole.size() / 2] ^= 1;
  for (const std::string& damaged :
       {std::string(), whole.substr(0, whole.size() - 1), whole + "more", flipped}) {
    fake_sweep::write(path / point_file_name(0), damaged);
    const ResultFolder folder(path, fake_header(5), resolved, OpenMode::resume);
    EXPECT_FALSE(folder.finished().contains(0));
    EXPECT_TRUE(folder.finished().contains(1));
    ASSERT_EQ(folder.damaged().size(), 1U);
    EXPECT_THAT(folder.damaged().front(), HasSubstr("points/00000.nc: "));
  }
}

/// A row that was changed since is computed anew, with a message, and is not found again.
TEST(ResultFolder, ChangedRowIsMissingReportedAndTakenAway) {
  const TemporaryFolder location;
  const fs::path path = begun(location);
  std::string text = read_file(path / "manifest.jsonl");
  const std::size_t digit = text.find("\"life_h\":") + 9;
  text[digit] = text[digit] == '9' ? '8' : '9';
  fake_sweep::write(path / "manifest.jsonl", text);
  {
    ResultFolder folder(path, fake_header(5), resolved, OpenMode::resume);
    EXPECT_FALSE(folder.finished().contains(0));
    EXPECT_TRUE(folder.finished().contains(1));
    ASSERT_EQ(folder.damaged().size(), 1U);
    EXPECT_THAT(folder.damaged().front(), HasSubstr("manifest.jsonl:2:1: differs from what its sweep wrote"));
    folder.keep({finished(0)});
  }
  const ResultFolder again(path, fake_header(5), resolved, OpenMode::resume);
  EXPECT_TRUE(again.damaged().empty());
  EXPECT_TRUE(again.finished().contains(0));
  EXPECT_EQ(again.finished().at(0).row.point.input_speed, finished(0).row.point.input_speed);
}

/// Further files of a result have check sums too.
TEST(ResultFolder, ChangedFileOfAResultIsReported) {
  const TemporaryFolder location;
  const fs::path path = location / "lone";
  {
    ResultFolder folder(path, fake_header(1), resolved, OpenMode::fresh);
    fake_sweep::write(path / "crown.json", "42");
    FinishedPoint point = finished(0);
    point.others = checksums_of(path, {"crown.json"});
    folder.keep({point});
  }
  fake_sweep::write(path / "crown.json", "43");
  const ResultFolder folder(path, fake_header(1), resolved, OpenMode::resume);
  EXPECT_FALSE(folder.finished().contains(0));
  ASSERT_EQ(folder.damaged().size(), 1U);
  EXPECT_THAT(folder.damaged().front(), HasSubstr("crown.json: differs"));
}

/// Nothing outside of the folder is written to through a link in it.
TEST(ResultFolder, LinksInTheFolderAreRefused) {
  for (const char* name : {"points", "manifest.jsonl"}) {
    const TemporaryFolder location;
    const fs::path path = begun(location);
    fs::rename(path / name, location / "elsewhere");
    fs::create_symlink(location / "elsewhere", path / name);
    EXPECT_THAT(refusal(path, fake_header(5), OpenMode::resume), HasSubstr("found a link to "));
  }
}

TEST(ResultFolder, WithoutAFolderNothingIsWritten) {
  ResultFolder folder(fake_header(5));
  folder.keep({finished(0), finished(3)});
  folder.write_table();
  EXPECT_EQ(folder.finished().size(), 2U);
  EXPECT_FALSE(fs::exists("manifest.jsonl"));
  EXPECT_FALSE(fs::exists("points"));
  EXPECT_FALSE(fs::exists("sweep.csv"));
}

TEST(ResultFolder, SecondSweepAtTheSameTimeIsRefused) {
  const TemporaryFolder location;
  const ResultFolder first(location / "d", fake_header(5), resolved, OpenMode::fresh);
  expect_untouched(location / "d", fake_header(5), OpenMode::resume, "another sweep is writing here");
}

TEST(ResultFolder, LocationThatCannotBeWrittenToIsBadInput) {
  const TemporaryFolder location;
  fake_sweep::write(location / "file", "text");
  EXPECT_THAT(refusal(location / "file", fake_header(5), OpenMode::fresh), HasSubstr("is not a folder"));
  EXPECT_THAT(refusal(location / "file/below", fake_header(5), OpenMode::fresh), HasSubstr("cannot be made"));
  EXPECT_THAT(refusal("/proc/none", fake_header(5), OpenMode::resume), HasSubstr("cannot be made"));
  EXPECT_EQ(read_file(location / "file"), "text");
}

TEST(ResultFolder, FolderWithoutResultsCannotBeRead) {
  const TemporaryFolder location;
  EXPECT_THROW(read_results(location / ""), BadInput);
  EXPECT_THROW(read_results(location / "none"), BadInput);
}

}  // namespace
}  // namespace orbearing::app::result_folder_test
