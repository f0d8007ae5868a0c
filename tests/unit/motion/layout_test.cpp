#include "bearing/motion/layout.hpp"

#include <gtest/gtest.h>

#include <set>

namespace orbearing::bearing::motion::layout_test {
namespace {

TEST(StateLayout, ViewsCoverTheStateOnceAndInOrder) {
  for (const StateLayout& layout :
       {StateLayout{4}, StateLayout{.rollers = 4, .followed = 1, .tilting = true, .waves = 5},
        StateLayout{.rollers = 3, .tilting = true, .caged = false}}) {
    Eigen::VectorXd x =
        Eigen::VectorXd::LinSpaced(layout.size(), 0.0, static_cast<double>(layout.size() - 1));
    const ConstStateViews state = state_views(layout, x.data());
    std::multiset<double> seen;
    for (const auto& rollers : {state.radius, state.angle, state.radial_speed, state.orbital_speed,
                                state.spin, state.end_displacement, state.turned})
      seen.insert(rollers.begin(), rollers.end());
    for (const auto& waves : {state.wave, state.wave_speed}) seen.insert(waves.begin(), waves.end());
    for (const auto& pair :
         {state.bore_position, state.bore_velocity, state.pin_position, state.pin_velocity})
      seen.insert(pair.begin(), pair.end());
    if (layout.caged) {
      for (const auto& pair : {state.cage_position, state.cage_velocity})
        seen.insert(pair.begin(), pair.end());
      seen.insert({state.cage_angle, state.cage_speed});
    }
    EXPECT_EQ(seen, std::multiset<double>(x.begin(), x.end()));
  }
}

TEST(StateLayout, NamesAndKindsDescribeEachVariable) {
  for (const bool caged : {true, false}) {
    const StateLayout layout{.rollers = 3, .tilting = true, .waves = 5, .caged = caged};
    const auto names = variable_names(layout);
    const auto kinds = variable_kinds(layout);
    ASSERT_EQ(names.size(), static_cast<std::size_t>(layout.size()));
    ASSERT_EQ(kinds.size(), names.size());
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    const auto unit_of = [](VariableKind kind) {
      switch (kind) {
        case VariableKind::length:
          return "[m]";
        case VariableKind::angle:
          return "[rad]";
        case VariableKind::velocity:
          return "[m/s]";
        default:
          return "[rad/s]";
      }
    };
    for (std::size_t i = 0; i < names.size(); ++i)
      EXPECT_TRUE(names[i].ends_with(unit_of(kinds[i]))) << names[i];
    EXPECT_EQ(names[static_cast<std::size_t>(4 * layout.rollers + 2)], "roller_3_spin [rad/s]");
    EXPECT_EQ(names[static_cast<std::size_t>(layout.wave() + 4)], "rim_wave_3_sine [m]");
    for (const std::string& name : names) EXPECT_TRUE(caged || !name.starts_with("cage")) << name;
  }
}

}  // namespace
}  // namespace orbearing::bearing::motion::layout_test
