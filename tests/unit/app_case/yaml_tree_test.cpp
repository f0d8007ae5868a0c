#include "app/case/yaml_tree.hpp"

#include <gtest/gtest.h>

namespace orbearing::app::yaml_tree_test {
namespace {

void expect_fault(const std::string& text, const char* part, int line, int column) {
  try {
    read_yaml(text);
    FAIL() << "read without objection: " << text;
  } catch (const YamlFault& fault) {
    EXPECT_NE(fault.message.found.find(part), std::string::npos) << fault.message.found;
    EXPECT_EQ(fault.location.line, line) << text;
    EXPECT_EQ(fault.location.column, column) << text;
  }
}

TEST(YamlTree, KeepsLocationsQuotesAndDuplicates) {
  const Entry root = read_yaml("a: 1\nb: {c: \"2\", d: [3, 4]}\na: 5\n");
  ASSERT_EQ(root.members.size(), 3U);
  EXPECT_EQ(root.members[2].key, "a");
  EXPECT_EQ(root.members[2].location.line, 3);
  const Entry& block = find_member(root, "b")->value;
  EXPECT_TRUE(find_member(block, "c")->value.quoted);
  EXPECT_EQ(find_member(block, "c")->value.location.column, 8);
  EXPECT_EQ(find_member(block, "d")->value.items.size(), 2U);
}

TEST(YamlTree, CountsColumnsInCharacters) {
  const Entry root = read_yaml("\xEF\xBB\xBF{\xC3\xA9\xC3\xA9: 1, b: 2}");
  EXPECT_EQ(root.members[1].location.column, 9);
}

TEST(YamlTree, LocationsAMissingValueAtItsKey) {
  const Entry root = read_yaml("a: 1\nb:\nc: 2\n");
  EXPECT_EQ(root.members[1].value.shape, Entry::Shape::nothing);
  EXPECT_EQ(root.members[1].value.location.line, 2);
}

TEST(YamlTree, RefusesWrongSyntaxWithItsLocation) {
  expect_fault("a: 1\n b: 2\n", "wrong YAML", 2, 3);
  expect_fault("a: \"b\n", "does not end", 1, 4);
  expect_fault("a: 'it''s\n", "does not end", 1, 4);
  expect_fault("a: 1\n---\nb: 2\n", "second YAML document", 3, 1);
  expect_fault("? [a]\n: 2\n", "no plain text", 1, 3);
}

TEST(YamlTree, RefusesWhatCouldHideOrMultiplyInput) {
  expect_fault("a: &x 1\n", "anchor", 1, 4);
  expect_fault("a: 1\nb: *x\n", "", 2, 4);
  expect_fault("a: !!binary x\n", "tag", 1, 4);
  expect_fault("a: 1\x04\nb: 2\n", "control character", 1, 5);
  expect_fault("a: \xC3(\n", "not UTF-8", 1, 4);
}

TEST(YamlTree, RefusesWhatIsNoTextOfUtf8) {
  expect_fault("a: \xed\xb3\xa4\n", "not UTF-8", 1, 4);       // half of a pair of UTF-16
  expect_fault("a: \xc0\xaf\n", "not UTF-8", 1, 4);           // longer than it need be
  expect_fault("a: \xf4\x90\x80\x80\n", "not UTF-8", 1, 4);   // beyond Unicode
  expect_fault("\xff\xfe" "a\n", "UTF-16", 1, 1);
  expect_fault("a: \"\\e[31mred\"\n", "control character", 1, 4);
  expect_fault("a: \"\\x9b31m\"\n", "control character", 1, 4);
  EXPECT_EQ(find_member(read_yaml("a: \"two\\nlines \xc3\xa9\"\n"), "a")->value.text, "two\nlines \xc3\xa9");
}

TEST(YamlTree, NamesTabs) {
  expect_fault("a:\n\tb: 1\n  c: 2\n", "a tab in the indentation", 2, 1);
  EXPECT_EQ(read_yaml("a: 1\t# a comment\n").members.size(), 1U);
}

TEST(YamlTree, RefusesDeepNestingAtOnce) {
  expect_fault(std::string(100, '[') + std::string(100, ']'), "16 levels", 1, 17);
  expect_fault(std::string(200000, '['), "", 1, 1);
  std::string deep;
  for (int i = 0; i < 50; ++i) deep += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  expect_fault(deep, "16 levels", 17, 17);
}

TEST(YamlTree, AcceptsClosedQuotations) {
  EXPECT_EQ(read_yaml("\"a\\\"b\"").text, "a\"b");
  EXPECT_EQ(read_yaml("'it''s'").text, "it's");
}

}  // namespace
}  // namespace orbearing::app::yaml_tree_test
