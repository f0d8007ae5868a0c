// Some rows of a structure, with structures to choose among.
#include "mechanics/part_rows.hpp"

#include <gmock/gmock.h>

#include <string>
#include <variant>
#include <vector>

namespace orbearing::mechanics::part_rows_test {
namespace {

using testing::ElementsAre;

struct Steel {
  static constexpr const char* name = "steel";
  double hardness = 0.0;
};
template <class Visitor>
void describe(Visitor& visit, Steel& m) {
  described::members(visit, m, described::input(m.hardness, "hardness", ""));
}
struct Oil {
  double viscosity = 0.0;
};
template <class Visitor>
void describe(Visitor& visit, Oil& m) {
  described::members(visit, m, described::input(m.viscosity, "viscosity", ""));
}

struct Gear {
  double width = 0.0;
  std::variant<Steel> body;
  std::variant<Oil> bath;
};
template <class Visitor>
void describe(Visitor& visit, Gear& m) {
  using namespace described;
  members(visit, m, input(m.width, "width", ""), choice(m.body, "body", ""), either(m.bath));
}

/// Paths of the rows that it is given; those that may be absent end in "?".
struct Paths {
  std::vector<std::string> found;

  void add(const described::Facts& facts) {
    found.push_back(facts.path + (facts.details.may_be_absent ? "?" : ""));
  }
  template <class Member>
  void operator()(Member&, const described::Facts& facts) {
    add(facts);
  }
  template <class Self, class Variant>
  void choose(Self& self, Variant& member, const described::Facts& facts) {
    add(facts);
    choose_by_inputs(self, member);
  }
  template <class Self, class Variant>
  void choose_by_inputs(Self& self, Variant& member) {
    std::visit([&](auto& chosen) { describe(self, chosen); }, member);
  }
};

template <class Describe>
std::vector<std::string> paths(const Describe& describe_some) {
  Gear gear;
  Paths visit;
  describe_some(visit, gear);
  return visit.found;
}

TEST(PartRows, LeaveOutMembersAndStructuresToChooseAmong) {
  EXPECT_THAT(paths([](auto& visit, Gear& m) { describe(visit, m); }),
              ElementsAre("width", "body", "hardness", "viscosity"));
  EXPECT_THAT(paths([](auto& visit, Gear& m) { describe_without(visit, m, m.width); }),
              ElementsAre("body", "hardness", "viscosity"));
  EXPECT_THAT(paths([](auto& visit, Gear& m) { describe_without(visit, m, m.body, m.bath); }),
              ElementsAre("width"));
}

TEST(PartRows, TakeMembersAndStructuresToChooseAmong) {
  EXPECT_THAT(paths([](auto& visit, Gear& m) { describe_only(visit, m, m.body); }),
              ElementsAre("body", "hardness"));
  EXPECT_THAT(paths([](auto& visit, Gear& m) { describe_only(visit, m, m.width, m.bath); }),
              ElementsAre("width", "viscosity"));
}

TEST(PartRows, MayAllBeAbsent) {
  EXPECT_THAT(paths([](auto& visit, Gear& m) { describe_not_required(visit, m); }),
              ElementsAre("width?", "body?", "hardness?", "viscosity?"));
}

}  // namespace
}  // namespace orbearing::mechanics::part_rows_test
