#include "app/results/durable_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::durable_file_test {
namespace {

using ::testing::HasSubstr;

/// While it lives no file grows beyond `bytes`: the disk is full, as seen from this program.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &former_);
    const rlimit limit{bytes, former_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_IGN);  // as the program does
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &former_); }

 private:
  Interruption ignores_the_signal_;
  rlimit former_{};
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
