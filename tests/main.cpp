// One program for all kinds of C++ tests. Besides the patterns of GoogleTest, --gtest_filter takes a folder
// or a file of tests/: --gtest_filter=unit/bearing/ or --gtest_filter=unit/life/damage_test.cpp means the
// tests in it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <iostream>
#include <string>

namespace {

std::string tests_in(const std::string& folder_or_file) {
  const std::string position = "/tests/" + folder_or_file;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  std::string names;
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      if (std::string(test.file()).find(position) == std::string::npos) continue;
      if (!names.empty()) names += ':';
      names.append(suite.name()).append(".").append(test.name());
    }
  }
  return names;
}

}  // namespace

int main(int argc, char** argv) {
  // Tests raise SIGINT; a parent that ignores it, as nohup does, passes that on.
  std::signal(SIGINT, SIG_DFL);
  testing::InitGoogleMock(&argc, argv);
  const std::string filter = GTEST_FLAG_GET(filter);
  if (filter.ends_with('/') || filter.ends_with(".cpp")) {
    const std::string names = tests_in(filter);
    if (names.empty()) {
      std::cerr << "no test stands in tests/" << filter << '\n';
      return 2;
    }
    GTEST_FLAG_SET(filter, names);
  }
  return RUN_ALL_TESTS();
}
