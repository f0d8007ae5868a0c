#include "app/results/durable_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <mutex>
#include <optional>

#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "orbearing/files.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::durable_file_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// While it exists a limit of the process is `most`.
class Limit {
 public:
  Limit(int what, rlim_t most) : what_(what) {
    getrlimit(what_, &former_);
    const rlimit limit{most, former_.rlim_max};
    setrlimit(what_, &limit);
  }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;
  ~Limit() { setrlimit(what_, &former_); }

 private:
  int what_;
  rlimit former_{};
};

/// While it exists no file grows beyond `bytes`: to this program the disk is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : limit_(RLIMIT_FSIZE, bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
  }  // as the program does

 private:
  Interruption ignores_the_signal_;
  Limit limit_;
};

TEST(DurableFile, ReplacesTheWholeContentAndLeavesNothingAside) {
  const fake_sweep::TemporaryFolder folder;
  write_aside_and_rename(folder / "file", "a long first text");
  write_aside_and_rename(folder / "file", "second");
  EXPECT_EQ(read_file(folder / "file"), "second");
  EXPECT_EQ(fake_sweep::snapshot(folder / "").size(), 1U);
}

TEST(DurableFile, FullDiskKeepsTheFormerContent) {
  const fake_sweep::TemporaryFolder folder;
  write_aside_and_rename(folder / "file", "former");
  const FullDisk full(8);
  EXPECT_THROW(write_aside_and_rename(folder / "file", "longer than eight bytes"), ComputationFailed);
  EXPECT_EQ(read_file(folder / "file"), "former");
  EXPECT_EQ(fake_sweep::snapshot(folder / "").size(), 1U);
}

// The remedy follows from the cause; too many open files are no full disk.
TEST(DurableFile, TooManyOpenFilesAreNoFullDisk) {
  const fake_sweep::TemporaryFolder folder;
  const Limit none(RLIMIT_NOFILE, 0);
  try {
    write_aside_and_rename(folder / "file", "text");
    FAIL() << "a file was opened beyond the limit";
  } catch (const WriteFailed& error) {
    EXPECT_THAT(error.cause, HasSubstr("Too many open files"));
    EXPECT_THAT(error.remedy, HasSubstr("ulimit -n"));
    EXPECT_THAT(error.remedy, Not(HasSubstr("make room")));
  }
}

TEST(DurableFile, SweepThatCanOpenNoFileSaysHowToGoOn) {
  const fake_sweep::TemporaryFolder folder;
  SweepRequest request = fake_sweep::fake_request(folder / "out", 3);
  std::optional<Limit> none;
  std::once_flag once;
  request.evaluate = [&](std::size_t point) {
    std::call_once(once, [&] { none.emplace(RLIMIT_NOFILE, 0); });
    return fake_sweep::fake_result(point);
  };
  try {
    run_sweep(request);
    FAIL() << "points were written beyond the limit";
  } catch (const ComputationFailed& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("Too many open files; finished points are kept: raise the number of open files "
                          "(ulimit -n), then continue with --resume"));
  }
  none.reset();
  request.resume = true;
  EXPECT_EQ(run_sweep(request).failed, 0U);
}

TEST(DurableFile, UnreadableFileIsBadInput) {
  const fake_sweep::TemporaryFolder folder;
  EXPECT_THROW(read_file(folder / "none"), BadInput);
}

TEST(AppendOnlyFile, AddsAndCuts) {
  const fake_sweep::TemporaryFolder folder;
  AppendOnlyFile file(folder / "log");
  file.append("one\n");
  file.append("two\n");
  file.truncate(4);
  file.append("three\n");
  EXPECT_EQ(file.content(), "one\nthree\n");
}

TEST(AppendOnlyFile, FullDiskLeavesNoTornLine) {
  const fake_sweep::TemporaryFolder folder;
  AppendOnlyFile file(folder / "log");
  file.append("one\n");
  const FullDisk full(8);
  EXPECT_THROW(file.append("a line of more than eight bytes\n"), ComputationFailed);
  EXPECT_EQ(file.content(), "one\n");
}

TEST(AppendOnlyFile, SecondWriterIsRefusedUntilTheFirstIsDone) {
  const fake_sweep::TemporaryFolder folder;
  {
    const AppendOnlyFile first(folder / "log");
    try {
      const AppendOnlyFile second(folder / "log");
      FAIL() << "two writers at once";
    } catch (const BadInput& error) {
      EXPECT_THAT(error.what(), HasSubstr("another sweep is writing here"));
    }
  }
  EXPECT_NO_THROW(AppendOnlyFile(folder / "log"));
}

}  // namespace
}  // namespace orbearing::app::durable_file_test
