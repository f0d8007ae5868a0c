// SIGKILL at random moments. The sweep that is killed is this program run again with the one test
// SweepProgram, whose folder is in the environment.
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <random>
#include <sstream>

#include "app/results/sweep_run.hpp"
#include "orbearing/files.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::kill_test {
namespace {

namespace fs = std::filesystem;
using fake_sweep::TemporaryFolder;

constexpr std::size_t points = 400;
constexpr int kills = 8;
constexpr const char* folder_variable = "ORBEARING_TEST_SWEEP";

/// The sweep in the folder named by the environment; notes each point it begins in a file beside it.
TEST(SweepProgram, DISABLED_Runs) {
  const char* folder = std::getenv(folder_variable);
  ASSERT_NE(folder, nullptr);
  SweepRequest request = fake_sweep::fake_request(folder, points);
  request.resume = true;
  AppendOnlyFile begun(std::string(folder) + ".begun");
  std::mutex one_at_a_time;
  request.evaluate = [&](std::size_t point) {
    {
      const std::lock_guard<std::mutex> lock(one_at_a_time);
      begun.append(std::to_string(point) + "\n");
    }
    fake_sweep::sleep_some(point);
    return fake_sweep::fake_result(point);
  };
  run_sweep(request);
}

/// Starts this program as SweepProgram. [process number]
pid_t start_sweep(const fs::path& folder) {
  setenv(folder_variable, folder.c_str(), 1);
  std::string program = fs::read_symlink("/proc/self/exe").string();
  std::string filter = "--gtest_filter=SweepProgram.*";
  std::string disabled = "--gtest_also_run_disabled_tests";
  std::string quiet = "--gtest_brief=1";
  char* arguments[] = {program.data(), filter.data(), disabled.data(), quiet.data(), nullptr};
  pid_t process = 0;
  EXPECT_EQ(posix_spawn(&process, program.c_str(), nullptr, nullptr, arguments, environ), 0);
  return process;
}

int wait_for(pid_t process) {
  int status = 0;
  waitpid(process, &status, 0);
  return status;
}

std::set<std::size_t> begun_points(const fs::path& folder) {
  std::istringstream text(read_file(folder.string() + ".begun"));
  std::set<std::size_t> begun;
  for (std::size_t point = 0; text >> point;) begun.insert(point);
  return begun;
}

/// Points in the manifest; none before there is one.
std::set<std::size_t> kept_points(const fs::path& folder) {
  std::set<std::size_t> kept;
  if (!fs::exists(folder / "manifest.jsonl")) return kept;
  for (const auto& [point, entry] : parse_manifest(read_file(folder / "manifest.jsonl"), "").entries)
    kept.insert(point);
  return kept;
}

TEST(KilledSweep, ResumesWithoutLosingOrRepeatingAPoint) {
  const TemporaryFolder location;
  const std::string table = fake_sweep::fake_table(location / "reference", points);
  const fs::path folder = location / "killed";
  std::mt19937 random(20240517);
  std::uniform_int_distribution<int> milliseconds(20, 120);
  std::size_t killed_at_work = 0;
  for (int i = 0; i < kills; ++i) {
    const std::set<std::size_t> before = kept_points(folder);
    const pid_t process = start_sweep(folder);
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds(random)));
    kill(process, SIGKILL);
    if (WIFSIGNALED(wait_for(process))) ++killed_at_work;
    const std::set<std::size_t> after = kept_points(folder);
    EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end())) << "lost a point";
    if (!fs::exists(folder.string() + ".begun")) continue;
    for (const std::size_t point : begun_points(folder))
      EXPECT_FALSE(before.contains(point)) << "computed point " << point << " again";
    fs::remove(folder.string() + ".begun");
  }
  EXPECT_GE(killed_at_work, 2U);
  EXPECT_EQ(wait_for(start_sweep(folder)), 0);
  EXPECT_EQ(read_file(folder / "sweep.csv"), table);
}

}  // namespace
}  // namespace orbearing::app::kill_test
