#include "app/results/manifest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/errors.hpp"
#include "tests/unit/app_results/fake_sweep.hpp"

namespace orbearing::app::manifest_test {
namespace {

using ::testing::HasSubstr;

ManifestHeader header_with_all() {
  ManifestHeader header = fake_sweep::fake_header(10);
  header.shard = Shard{2, 3};
  header.axes = {{"bearing.radial_clearance_um", "um", "clearance"}};
  return header;
}

std::string line_of(const ManifestHeader& header, std::size_t point) {
  const SweepRow row =
      sweep_row(fake_sweep::fake_result(point), header, std::vector<double>(header.axes.size(), 0.1));
  return entry_line(header, point, {point_file_name(point), "0123456789abcdef", row});
}

std::string message_of(const std::string& text) {
  try {
    parse_manifest(text, "DIR/manifest.jsonl");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Manifest, GivesBackHeaderAndRows) {
  const ManifestHeader header = header_with_all();
  const std::string text = header_line(header) + line_of(header, 1) + line_of(header, 4);
  const Manifest manifest = parse_manifest(text, "m");
  ASSERT_TRUE(manifest.header);
  EXPECT_EQ(header_line(*manifest.header), header_line(header));
  EXPECT_EQ(manifest.sound_bytes, text.size());
  ASSERT_EQ(manifest.entries.size(), 2U);
  EXPECT_EQ(entry_line(header, 4, manifest.entries.at(4)), line_of(header, 4));
}

TEST(Manifest, CutAnywhereKeepsTheCompleteLines) {
  const ManifestHeader header = fake_sweep::fake_header(10);
  const std::string first = header_line(header);
  const std::string second = first + line_of(header, 0);
  const std::string third = second + line_of(header, 1);
  for (std::size_t length = 0; length <= third.size(); ++length) {
    const Manifest manifest = parse_manifest(third.substr(0, length), "m");
    const std::size_t whole = (length >= first.size()) + (length >= second.size()) + (length == third.size());
    EXPECT_EQ(manifest.header.has_value(), whole >= 1) << length;
    EXPECT_EQ(manifest.entries.size(), whole < 2 ? 0 : whole - 1) << length;
    EXPECT_EQ(manifest.sound_bytes,
              std::vector<std::size_t>({0, first.size(), second.size(), third.size()})[whole]);
  }
}

TEST(Manifest, LastLineOfZerosIsTakenForTorn) {
  const std::string sound = header_line(fake_sweep::fake_header(10));
  EXPECT_EQ(parse_manifest(sound + std::string(40, '\0') + "\n", "m").sound_bytes, sound.size());
}

/// Every changed character of a row is found; the row counts as missing and is named by its line.
TEST(Manifest, AnyChangedCharacterOfARowIsFound) {
  const ManifestHeader header = fake_sweep::fake_header(10);
  const std::string first = header_line(header), row = line_of(header, 1), last = line_of(header, 2);
  for (std::size_t at = 0; at + 1 < row.size(); ++at) {
    std::string changed = row;
    changed[at] = changed[at] == '9' ? '8' : '9';
    const Manifest manifest = parse_manifest(first + changed + last, "m");
    EXPECT_FALSE(manifest.entries.contains(1)) << changed;
    EXPECT_TRUE(manifest.entries.contains(2)) << changed;
    ASSERT_EQ(manifest.damaged.size(), 1U) << changed;
    EXPECT_EQ(manifest.damaged.front().number, 2U);
    EXPECT_EQ(manifest.damaged.front().begin, first.size());
    EXPECT_EQ(manifest.damaged.front().length, row.size() - 1);
    EXPECT_EQ(manifest.sound_bytes, first.size() + row.size() + last.size());
  }
}

TEST(Manifest, AChangedHeaderIsRefusedAndABlankLineSkipped) {
  const ManifestHeader header = fake_sweep::fake_header(10);
  const std::string first = header_line(header), row = line_of(header, 1);
  for (std::size_t at = 0; at + 1 < first.size(); ++at) {
    std::string changed = first;
    changed[at] = changed[at] == '9' ? '8' : '9';
    EXPECT_THAT(message_of(changed + row), HasSubstr("DIR/manifest.jsonl:1:1: ")) << changed;
  }
  EXPECT_THAT(message_of("some text\n"), HasSubstr("DIR/manifest.jsonl:1:1: "));
  const Manifest blank = parse_manifest(first + std::string(row.size() - 1, ' ') + "\n" + row, "m");
  EXPECT_EQ(blank.entries.size(), 1U);
  EXPECT_TRUE(blank.damaged.empty());
}

TEST(Manifest, PointOfAnotherShardOrFileOutsideIsRefused) {
  const ManifestHeader header = header_with_all();
  const std::string sound = line_of(header, 1);
  EXPECT_THAT(message_of(header_line(header) + line_of(header, 2) + sound), HasSubstr(":2:1: "));
  // Its check sum is right, its file outside of the folder.
  const SweepRow row =
      sweep_row(fake_sweep::fake_result(1), header, std::vector<double>(header.axes.size(), 0.1));
  const std::string outside = entry_line(header, 1, {"../../00001.nc", "0123456789abcdef", row});
  EXPECT_THAT(message_of(header_line(header) + outside + sound), HasSubstr(":2:1: "));
}

TEST(Manifest, DifferencesNameWhatWasFoundAndWhatIsRequired) {
  ManifestHeader other = fake_sweep::fake_header(10);
  other.program_version = "0.2.0";
  other.instruction_set = "x86-64-v3";
  const std::vector<std::string> lines = differences(other, fake_sweep::fake_header(10));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "program version '0.2.0' was found; '0.1.0' is required");
}

TEST(Shard, ReadsNumberOfCount) {
  EXPECT_EQ(parse_shard("2/3"), (Shard{2, 3}));
  EXPECT_EQ(to_string(parse_shard("1/1")), "1/1");
}

class BadShard : public ::testing::TestWithParam<const char*> {};

TEST_P(BadShard, IsRefusedWithTheFormRequired) {
  try {
    parse_shard(GetParam());
    FAIL() << "accepted " << GetParam();
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("--shard: '" + std::string(GetParam()) + "'; i/n"));
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, BadShard,
                         ::testing::Values("", "/", "1", "0/2", "3/2", "1/0", "-1/2", "1/2/3", "a/b", "1.0/2",
                                           " 1/2", "1/99999999999999999999999"));

TEST(Shard, EveryPointBelongsToOneShard) {
  for (const std::size_t count : {1U, 2U, 3U, 7U}) {
    std::size_t sum = 0;
    for (std::size_t index = 1; index <= count; ++index) {
      ManifestHeader header = fake_sweep::fake_header(23);
      header.shard = Shard{index, count};
      std::size_t held = 0;
      for (std::size_t point = 0; point < 30; ++point) held += header.holds(point) ? 1U : 0U;
      EXPECT_EQ(header.own_points(), held) << index << '/' << count;
      sum += held;
    }
    EXPECT_EQ(sum, 23U);
  }
}

}  // namespace
}  // namespace orbearing::app::manifest_test
