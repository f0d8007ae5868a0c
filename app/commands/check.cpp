#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/case/check_table.hpp"
#include "app/commands/command_line.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/mesh_study.hpp"

namespace orbearing::app {

namespace {

struct Checked {
  std::vector<Derived> derived;
  std::vector<std::string> warnings;
};

Checked check(const ResolvedCase& resolved) {
  if (resolved.model() == gear_pair) {
    const MeshStudy meshes = mesh_study(resolved.without_sweep());
    return {pair_quantities(resolved, meshes), meshes.warnings};
  }
  if (resolved.model() != planetary_drivetrain) return {};
  const study::PlanetaryDrivetrain drivetrain = drivetrain_of(resolved);
  const study::DrivetrainGeometry geometry = study::derive(drivetrain);
  return {derived_quantities(drivetrain, geometry), gear_warnings(geometry)};
}

}  // namespace

int check_command(const Options& options) {
  const ResolvedCase resolved = read_case(options.case_file, options.settings);
  const Checked checked = check(resolved);
  if (options.json) {
    nlohmann::json object = check_json(resolved, checked.derived);
    object["warnings"] = checked.warnings;
    fmt::print("{}\n", object.dump(2));
    return 0;
  }
  if (options.quiet) return 0;
  fmt::print("{}", check_table(resolved, checked.derived));
  for (const std::string& warning : checked.warnings) fmt::print("warning: {}\n", warning);
  return 0;
}

}  // namespace orbearing::app
