// Rules of the project that a reader cannot keep an eye on by himself.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/unit/repository/source_tree.hpp"

namespace orbearing::repository::repository_test {
namespace {

/// Keys like [Gai2025] or [ISO281] in a text.
std::set<std::string> cited_keys(const std::string& text) {
  static const std::regex key(R"(\[([A-Z][A-Za-z]+[0-9]{3,5}[a-z]?)\])");
  std::set<std::string> keys;
  for (std::sregex_iterator match(text.begin(), text.end(), key), end; match != end; ++match) {
    keys.insert((*match)[1]);
  }
  return keys;
}

TEST(Repository, FindsKeysInText) {
  const std::string opening = "[";
  EXPECT_EQ(cited_keys("Eq. (36) of " + opening + "Nobody1900], x[3], " + opening + "ISO281]"),
            (std::set<std::string>{"Nobody1900", "ISO281"}));
}

TEST(Repository, CitedSourcesAreInReferences) {
  const std::set<std::string> known = cited_keys(contents(root() / "REFERENCES.md"));
  ASSERT_FALSE(known.empty());
  for (const auto& file : files({".hpp", ".cpp", ".py", ".md", ".yaml"})) {
    for (const std::string& key : cited_keys(contents(file))) {
      EXPECT_TRUE(known.contains(key)) << file << " cites " << key << ", which REFERENCES.md does not list";
    }
  }
}

TEST(Repository, FoldersExplainThemselves) {
  for (const char* folder :
       {"gearset", "bearing", "coupling", "app", "python", "cases", "tests", "docs", "benchmarks"}) {
    EXPECT_FALSE(contents(root() / folder / "README.md").empty())
        << folder << "/README.md is missing or empty";
  }
}

// ctest runs them by file: a test elsewhere, in a header say, would never run.
TEST(Repository, EveryTestStandsInAFileThatCtestRuns) {
  static const std::regex file(R"(.*/tests/(unit|identities|literature|regression)/.*_test\.cpp)");
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j)
      EXPECT_TRUE(std::regex_match(suite.GetTestInfo(j)->file(), file)) << suite.GetTestInfo(j)->file();
  }
}

// A file without a test is a red test of ctest where its dependency is not installed.
TEST(Repository, EveryFileThatCtestRunsHoldsATest) {
  std::set<std::string> filled;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j)
      filled.insert(std::filesystem::path(suite.GetTestInfo(j)->file()).lexically_relative(root()).string());
  }
  static const std::regex run(R"(tests/(unit|identities|literature|regression)/.*_test\.cpp)");
  for (const auto& file : files({".cpp"})) {
    const std::string name = file.lexically_relative(root()).string();
    if (std::regex_match(name, run)) {
      EXPECT_TRUE(filled.contains(name)) << name;
    }
  }
}

// Computing times differ from machine to machine; benchmarks/ measure them.
TEST(Repository, NoTestBoundsSeconds) {
  static const std::regex clock(
      "steady_clock|system_clock|std::clock\\(|(assert|EXPECT_|ASSERT_)(Less|Greater|L|G)[A-Za-z]*\\([^\\n]*"
      "(seconds|took|elapsed|time\\.|perf_counter|monotonic)");
  for (const auto& file : files({".cpp", ".hpp", ".py"})) {
    const std::string name = file.lexically_relative(root()).string();
    if (!name.starts_with("tests/") || name == "tests/unit/repository/repository_test.cpp") continue;
    std::smatch match;
    const std::string text = contents(file);
    EXPECT_FALSE(std::regex_search(text, match, clock)) << name << ": " << match.str();
  }
}

}  // namespace
}  // namespace orbearing::repository::repository_test
