// Rows beside structures of parameters, and the fields that they become.
#include "app/case/described_fields.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/case/bearing_fields.hpp"
#include "app/case/described_case.hpp"
#include "app/case/field_table.hpp"
#include "bearing/parameters.hpp"
#include "coupling/system/steady_state.hpp"

namespace orbearing::app::described_fields_test {
namespace {

using described::Facts;
using described::member_count;

struct Inner {
  double a = 0.0;
  bool b = false;
};
struct Outer {
  Inner inner;
  std::vector<double> list;
  std::optional<double> maybe;
  int count = 2;
};

TEST(Described, CountsTheMembersOfAnAggregate) {
  EXPECT_EQ(member_count<Inner>(), 2u);
  EXPECT_EQ(member_count<Outer>(), 4u);
  EXPECT_EQ(member_count<bearing::InertiaSwitches>(), 4u);
}

TEST(Described, ASharedRowHasOneDefault) {
  std::vector<Field> fields;
  system::SteadyStateOptions rollers;
  add_described(fields, rollers);
  const std::size_t once = fields.size();
  add_described(fields, rollers);
  EXPECT_EQ(fields.size(), once);
  rollers.allowed_length_error *= 2.0;
  EXPECT_THROW(add_described(fields, rollers), std::logic_error);
}

// Each member that a case states, once.
struct Locations {
  template <class Member>
  void operator()(Member& member, const Facts& facts) {
    EXPECT_TRUE(members.insert(&member).second) << facts.path << " is a member that has another row too";
    EXPECT_TRUE(names.insert(std::string(facts.path)).second) << facts.path << " has two rows";
  }
  std::set<const void*> members;
  std::set<std::string> names;
};

TEST(Described, EachRowHasAMemberAndANameOfItsOwn) {
  Locations locations;
  analysis::PlanetaryDrivetrain drivetrain;
  describe(locations, drivetrain);
  EXPECT_GT(locations.names.size(), 60u);
  Locations of_balls;
  bearing::Bearing balls{.elements = bearing::Balls{}};
  describe(of_balls, balls);
  EXPECT_GE(of_balls.names.size(), 20u);
}

// A case that states nothing beyond what it must gives each member the value that its structure begins with.
struct Defaults {
  template <class Member>
  void operator()(Member& member, const Facts& facts) {
    if (facts.internal || facts.details.reason.empty()) return;
    const Field* field = find_field(facts.path);
    ASSERT_NE(field, nullptr) << facts.path;
    EXPECT_EQ(field->default_reason, facts.details.reason);
    if constexpr (std::is_same_v<Member, double>) {
      const bool plain = field->dimension.name.empty();
      const double read = plain ? std::stod(field->default_text)
                                : read_quantity(field->default_text, field->dimension).value.value();
      EXPECT_NEAR(read, member, 1e-14 * std::abs(member)) << facts.path << ": " << field->default_text;
      ++compared;
    }
  }
  int compared = 0;
};

TEST(Described, DefaultsInTheTableAreTheMembersInitialValues) {
  Defaults defaults;
  analysis::PlanetaryDrivetrain drivetrain = default_drivetrain();
  analysis::GearDynamicsChoice gears = default_gears();
  gearset::PlanetarySet set;
  describe(defaults, drivetrain);
  describe(defaults, gears);
  describe(defaults, set);
  EXPECT_GE(defaults.compared, 40);
}

TEST(Described, FactorsOfUnitsAreThoseOfTheUnitsLibrary) {
  namespace d = dimension;
  for (const Dimension& one :
       {d::length, d::small_length, d::angle, d::angular_speed, d::angular_acceleration, d::power, d::force,
        d::torque, d::mass, d::time, d::density, d::stress, d::viscosity, d::kinematic_viscosity,
        d::pressure_viscosity, d::stiffness, d::speed, d::inverse_speed, d::damping})
    EXPECT_DOUBLE_EQ(convert(1.0, one.customary, one.si).value.value(), one.factor) << one.customary;
}

TEST(Described, DefaultsAreWrittenAsAPersonWould) {
  EXPECT_EQ(default_text(2e-10, {.dimension = dimension::length}), "2e-7 mm");
  EXPECT_EQ(default_text(0.2e-6, {.dimension = dimension::small_length}), "0.2 um");
  EXPECT_EQ(default_text(5e-6, {.dimension = dimension::time, .written = "us"}), "5 us");
  EXPECT_EQ(default_text(0.83, {}), "0.83");
}

}  // namespace
}  // namespace orbearing::app::described_fields_test
