#include "mechanics/member_keys.hpp"

#include <gmock/gmock.h>

#include <optional>

#include "mechanics/problem.hpp"

namespace orbearing::mechanics::member_keys_test {
namespace {

using testing::ElementsAre;

struct Oil {
  double viscosity = 0.0;
  double density = 0.0;
};
template <class Visitor>
void describe(Visitor& visit, Oil& m) {
  using namespace described;
  members(visit, m, internal(m.viscosity, "oil.viscosity"), internal(m.density, "oil.density"));
}

struct Bath {
  Oil oil;
  std::optional<double> level;
  double unlisted = 0.0;
};
template <class Visitor>
void describe(Visitor& visit, Bath& m) {
  using namespace described;
  members(visit, m,
          part(m.oil,
               [&] {
                 visit_row(visit, internal(m.oil, "oil.grade"));  // at the address of its first member
                 describe(visit, m.oil);
               }),
          internal(m.level, "level"), apart(m.unlisted));
}

TEST(MemberKeys, AreThoseOfTheRows) {
  const Bath bath;
  const MemberKeys key(bath);
  EXPECT_EQ(key(bath.oil.density), "oil.density");
  EXPECT_EQ(key(bath.level), "level");
}

TEST(MemberKeys, TellAStructureFromItsFirstMember) {
  const Bath bath;
  const MemberKeys key(bath);
  EXPECT_EQ(key(bath.oil), "oil.grade");
  EXPECT_EQ(key(bath.oil.viscosity), "oil.viscosity");
}

TEST(MemberKeys, OfAPartAreAllWithinIt) {
  const Bath bath;
  EXPECT_THAT(MemberKeys(bath).within(bath.oil), ElementsAre("oil.grade", "oil.viscosity", "oil.density"));
}

TEST(MemberKeys, AreAskedOfMembersWithARowAlone) {
  const Bath bath, other;
  const MemberKeys key(bath);
  EXPECT_THROW(key(bath.unlisted), std::logic_error);
  EXPECT_THROW(key(other.level), std::logic_error);
}

TEST(MemberKeys, OfATypeNeedNoValue) {
  EXPECT_EQ(key_of<Bath>([](const Bath& bath) -> const auto& { return bath.oil.density; }), "oil.density");
}

TEST(TextsOfProblems, HaveInputsAsTheyAreWritten) {
  const std::string text = as_written("width") + " and " + as_written("bore") + "; less is required";
  const auto written = [](const std::string& key) { return key == "width" ? "9 mm" : "{3} mm"; };
  EXPECT_EQ(with_inputs(text, written), "9 mm and {3} mm; less is required");
  EXPECT_EQ(with_inputs("none", written), "none");
}

}  // namespace
}  // namespace orbearing::mechanics::member_keys_test
