#include "orbearing/text.hpp"

#include <gmock/gmock.h>

#include "app/case/field_table.hpp"
#include "tests/unit/app_case/small_case.hpp"

namespace orbearing::app::printable_test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

TEST(Printable, EscapesWhatATerminalObeys) {
  EXPECT_EQ(printable("a\x1b[31mb\x07\x7f"), "a\\x1b[31mb\\x07\\x7f");
  EXPECT_EQ(printable("a\nb\tc\r"), "a\\nb\\tc\\r");
  EXPECT_EQ(printable("\xC2\x9B"), "\\x9b");             // the one-byte start of a control sequence
  EXPECT_EQ(printable("\xE2\x80\xAE"), "\\u202e");       // from right to left
  EXPECT_EQ(printable("r\xFFpm\xC3"), "r\\xffpm\\xc3");  // no UTF-8
}

TEST(Printable, LeavesTheRest) {
  const std::string text = "3 \xC2\xB5m, \xE2\x82\xAC, \xF0\x9F\x99\x82 \\n";
  EXPECT_EQ(printable(text), text);
  EXPECT_EQ(printable(printable("\x1b")), printable("\x1b"));
}

TEST(Printable, CutsBetweenCharacters) {
  EXPECT_EQ(shortened(std::string(60, 'a')), std::string(60, 'a'));
  EXPECT_EQ(shortened(std::string(61, 'a')), std::string(60, 'a') + "...");
  EXPECT_EQ(shortened(std::string(59, 'a') + "\xC2\xB5\xC2\xB5"), std::string(59, 'a') + "...");
  EXPECT_EQ(quote(std::string(500, '\n')).size(), 2 * 60 + std::string("'...'").size());
}

TEST(Printable, ShowsEveryPathWhole) {
  for (const Field& field : all_fields())
    EXPECT_EQ(shortened("sweep." + field.path + ".step"), "sweep." + field.path + ".step");
}

TEST(Printable, HoldsForMessages) {
  constexpr std::size_t bearable = 600;  // [byte] three texts of 60, escaped at worst, and our own words
  const std::string many(5000, 'm');
  const std::vector<std::string> lines = setting_mistakes(
      {"inp\x1bt=1", "gearset.module=\"3 \\e[31mmm\"", "material.density=1 " + many, many + "=3",
       "input.power=" + std::string(300, '1'), "sweep.input.speed.step=" + many, "a\xFF.b=1"});
  EXPECT_THAT(lines, SizeIs(7));
  EXPECT_THAT(lines, Each(AllOf(StartsWith("--set: "), Not(HasSubstr("\x1b")), Not(HasSubstr("\xFF")))));
  for (const std::string& line : lines) EXPECT_LT(line.size(), bearable) << line;
}

TEST(Printable, HoldsForKeysAndNamesOfFiles) {
  try {
    parse_case("\"a\\eb\": 1\n", "case\n.yaml");
    FAIL();
  } catch (const BadInput& error) {
    EXPECT_THAT(error.messages.front(), StartsWith("case\\n.yaml:1:1: "));
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("(file): an escape that makes a control character"), Not(HasSubstr("\x1b"))));
  }
}

}  // namespace
}  // namespace orbearing::app::printable_test
