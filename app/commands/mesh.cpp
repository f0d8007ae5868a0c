#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/case/unused_inputs.hpp"
#include "app/commands/presentation.hpp"
#include "app/results/terminal_chart.hpp"
#include "app/study/mesh_output.hpp"
#include "app/study/plausibility.hpp"

namespace orbearing::app {

int mesh_command(const Options& options) {
  const ResolvedCase resolved = point_of(options);
  MeshStudy study = mesh_study(resolved);
  const std::vector<std::string> unused = require_used(resolved, use::mesh);
  for (std::string& warning : judge(observations(resolved)).warnings) study.warnings.push_back(std::move(warning));
  study.warnings.insert(study.warnings.end(), unused.begin(), unused.end());
  if (options.json) {
    nlohmann::ordered_json object{{"case", resolved.text("name")}, {"meshes", meshes_json(study)}};
    if (study.axial) object["axial"] = axial_json(study);
    if (study.planet_rim) object["planet_rim"] = planet_rim_json(study);
    object["warnings"] = study.warnings;
    print_object(object, options);
    return 0;
  }
  if (options.quiet) return 0;
  fmt::print("{}", mesh_text(study, glyphs_of_locale()));
  print_warnings(study.warnings);
  return 0;
}

}  // namespace orbearing::app
