// Folders of results, templates, quantities and files, by the headers of include/orbearing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "orbearing/case.hpp"
#include "orbearing/files.hpp"
#include "orbearing/pace.hpp"
#include "orbearing/quantity.hpp"
#include "orbearing/request.hpp"
#include "orbearing/results.hpp"
#include "orbearing/templates.hpp"
#include "tests/messages.hpp"

namespace orbearing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

/// A new folder, removed in the end.
struct Folder {
  fs::path path;
  Folder() {
    std::string name = (fs::temp_directory_path() / "orbearing-folders-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path); }
};

// Four speeds of a template, of which `points` are computed.
Json swept(const fs::path& folder, const Json& more = Json::object()) {
  Json options{{"output", folder.string()}, {"grid_only", true}};
  options.update(more);
  const Answer found = answer(
      {.command = "sweep",
       .case_text = case_template("industrial").text,
       .settings = {"sweep={input.speed: [500 rpm, 1000 rpm, 2000 rpm, 3000 rpm]}", "name=four speeds"},
       .options = options.dump()});
  return Json::parse(found.result);
}

TEST(Folders, OfASweepHaveItsPointsAndResult) {
  const Folder folder;
  const Json printed = swept(folder.path / "results");
  const ResultsInBrief brief = results_in_brief(folder.path / "results");
  EXPECT_EQ(brief.case_name, "four speeds");
  EXPECT_EQ(brief.fidelity, "quasi-static");
  EXPECT_EQ(brief.points, 4U);
  EXPECT_EQ(brief.of, 4U);
  const Json held = Json::parse(results_json(folder.path / "results"));
  EXPECT_EQ(held["finished"], true);
  EXPECT_EQ(held["points"], printed["points"]);
  EXPECT_EQ(held["result"], printed);
  EXPECT_FALSE(held.contains("options"));
}

TEST(Folders, OfASweepInPartsHaveNoResultYet) {
  const Folder folder;
  swept(folder.path / "results", {{"shard", "2/3"}});
  const Json held = Json::parse(results_json(folder.path / "results"));
  EXPECT_EQ(held["finished"], false);
  EXPECT_LT(held["points"].size(), 4U);
  EXPECT_FALSE(held.contains("result"));
  EXPECT_FALSE(held.contains("options")) << "no command continues a part by itself";
  EXPECT_EQ(results_in_brief(folder.path / "results").points, held["points"].size());
}

TEST(Folders, OfOtherCasesAreRefused) {
  const Folder folder;
  const fs::path results = folder.path / "results";
  swept(results);
  require_case_of_results(results);
  write_file(results / resolved_case_name, read_file(results / resolved_case_name) + "# more\n");
  const auto is_refused = [&](const auto& call) {
    try {
      call();
    } catch (const BadInput& error) {
      EXPECT_THAT(error.what(), HasSubstr(std::string(resolved_case_name) + ": differs"));
      return true;
    }
    return false;
  };
  EXPECT_TRUE(is_refused([&] { require_case_of_results(results); }));
  EXPECT_TRUE(is_refused([&] { results_json(results); }));
  EXPECT_THROW(results_in_brief(folder.path), BadInput);
}

TEST(Templates, AreCases) {
  EXPECT_EQ(template_names().size(), 7U);
  for (const std::string& name : template_names()) {
    const CaseTemplate found = case_template(name);
    EXPECT_EQ(found.name, name);
    EXPECT_THAT(found.text, testing::StartsWith("# " + found.title + ": " + found.purpose + "\n"));
    EXPECT_TRUE(Case::parse(found.text).has("model"));
  }
  EXPECT_THROW(case_template("yacht"), BadInput);
}

TEST(Quantities, AreConverted) {
  EXPECT_DOUBLE_EQ(in_unit("3 mm", "um"), 3000.0);
  EXPECT_DOUBLE_EQ(in_unit("-60 rpm", "rad/s"), -6.283185307179586);
  EXPECT_DOUBLE_EQ(in_unit("0.1 kN", "N"), 100.0);
  EXPECT_REFUSED(BadInput, "quantity of no number", in_unit("three", "mm"));
  EXPECT_REFUSED(BadInput, "quantity of another dimension", in_unit("3 mm", "N"));
}

TEST(Files, AreWholeAndNoLinks) {
  const Folder folder;
  const fs::path file = folder.path / "a.txt", link = folder.path / "b.txt";
  write_file(file, "one");
  write_file(file, "two\n");
  EXPECT_EQ(read_file(file), "two\n");
  require_no_link(file);
  fs::create_symlink(file, link);
  EXPECT_THROW(require_no_link(link), BadInput);
  EXPECT_THROW(read_file(folder.path), BadInput);
  EXPECT_THROW(write_file(folder.path / "none" / "a.txt", ""), ComputationFailed);
}

// The published values of FNV-1a with 64 bits.
TEST(Files, HaveChecksums) {
  EXPECT_EQ(checksum(""), "cbf29ce484222325");
  EXPECT_EQ(checksum("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(checksum("foobar"), "85944171f73967e8");
}

TEST(Pace, IsThatOfOnePiece) {
  Pace pace;
  EXPECT_FALSE(pace.seconds_left("one", 1.0, 4.0));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const bool slept = *pace.seconds_left("one", 2.0, 4.0) >= 0.04;  // two are left, and one took 0.02 s
  EXPECT_TRUE(slept);
  EXPECT_EQ(*pace.seconds_left("one", 4.0, 4.0), 0.0);
  EXPECT_FALSE(pace.seconds_left("two", 4.5, 9.0));
}

}  // namespace
}  // namespace orbearing
