// One program for all kinds of C++ tests. Beside the patterns of GoogleTest, --gtest_filter takes a folder of
// tests/ that ends in "/": --gtest_filter=unit/bearing/ means the tests whose sources stand there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace {

std::string tests_in(const std::string& folder) {
  const std::string place = "/tests/" + folder;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  std::string names;
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      if (std::string(test.file()).find(place) == std::string::npos) continue;
      if (!names.empty()) names += ':';
      names.append(suite.name()).append(".").append(test.name());
    }
  }
  return names;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  const std::string filter = GTEST_FLAG_GET(filter);
  if (filter.ends_with('/')) GTEST_FLAG_SET(filter, tests_in(filter));
  return RUN_ALL_TESTS();
}
