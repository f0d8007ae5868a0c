#include "bearing/motion/layout.hpp"

#include <span>

namespace orbearing::bearing::motion {

namespace {

struct Variable {
  const char* name;
  VariableKind kind;
};

constexpr Variable kOfRollers[] = {
    {"radius [m]", VariableKind::length},           {"angle [rad]", VariableKind::angle},
    {"radial_speed [m/s]", VariableKind::velocity}, {"orbital_speed [rad/s]", VariableKind::angular_speed},
    {"spin [rad/s]", VariableKind::angular_speed},  {"end_displacement [m]", VariableKind::length}};
constexpr Variable kOfRings[] = {{"cage_x [m]", VariableKind::length},
                                 {"cage_y [m]", VariableKind::length},
                                 {"cage_angle [rad]", VariableKind::angle},
                                 {"cage_x_speed [m/s]", VariableKind::velocity},
                                 {"cage_y_speed [m/s]", VariableKind::velocity},
                                 {"cage_speed [rad/s]", VariableKind::angular_speed},
                                 {"bore_x [m]", VariableKind::length},
                                 {"bore_y [m]", VariableKind::length},
                                 {"bore_x_speed [m/s]", VariableKind::velocity},
                                 {"bore_y_speed [m/s]", VariableKind::velocity},
                                 {"pin_x [m]", VariableKind::length},
                                 {"pin_y [m]", VariableKind::length},
                                 {"pin_x_speed [m/s]", VariableKind::velocity},
                                 {"pin_y_speed [m/s]", VariableKind::velocity}};

// As equilibrium/elastic_waves.hpp orders them.
std::string wave_name(Eigen::Index i) {
  return "rim_wave_" + std::to_string(i == 0 ? 0 : (i + 3) / 2) +
         (i == 0 || i % 2 == 1 ? "_cosine" : "_sine");
}

std::span<const Variable> rings_of(const StateLayout& layout) {
  return std::span(kOfRings).subspan(layout.caged ? 0 : 6);
}

}  // namespace

std::vector<VariableKind> variable_kinds(const StateLayout& layout) {
  std::vector<VariableKind> kinds;
  for (Eigen::Index group = 0; group < layout.groups(); ++group)
    kinds.insert(kinds.end(), static_cast<std::size_t>(layout.rollers), kOfRollers[group].kind);
  for (const Variable& variable : rings_of(layout)) kinds.push_back(variable.kind);
  kinds.insert(kinds.end(), static_cast<std::size_t>(layout.waves), VariableKind::length);
  kinds.insert(kinds.end(), static_cast<std::size_t>(layout.waves), VariableKind::velocity);
  kinds.insert(kinds.end(), static_cast<std::size_t>(layout.followed), VariableKind::angle);
  return kinds;
}

std::vector<std::string> variable_names(const StateLayout& layout) {
  std::vector<std::string> names;
  for (Eigen::Index group = 0; group < layout.groups(); ++group)
    for (Eigen::Index roller = 1; roller <= layout.rollers; ++roller)
      names.push_back("roller_" + std::to_string(roller) + "_" + kOfRollers[group].name);
  for (const Variable& variable : rings_of(layout)) names.emplace_back(variable.name);
  for (Eigen::Index i = 0; i < layout.waves; ++i) names.push_back(wave_name(i) + " [m]");
  for (Eigen::Index i = 0; i < layout.waves; ++i) names.push_back(wave_name(i) + "_speed [m/s]");
  for (Eigen::Index i = 1; i <= layout.followed; ++i)
    names.push_back("followed_roller_" + std::to_string(i) + "_turned [rad]");
  return names;
}

}  // namespace orbearing::bearing::motion
