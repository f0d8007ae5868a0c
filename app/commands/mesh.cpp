#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/commands/command_line.hpp"
#include "app/results/terminal_chart.hpp"
#include "app/study/mesh_output.hpp"

namespace orbearing::app {

int mesh_command(const Options& options) {
  const ResolvedCase resolved = read_case(options.case_file, options.settings).without_sweep();
  const MeshStudy study = mesh_study(resolved);
  if (options.json) {
    const nlohmann::ordered_json object{
        {"case", resolved.text("name")}, {"meshes", meshes_json(study)}, {"warnings", study.warnings}};
    fmt::print("{}\n", object.dump(2));
    return 0;
  }
  if (options.quiet) return 0;
  fmt::print("{}", mesh_text(study, glyphs_of_locale()));
  for (const std::string& warning : study.warnings) fmt::print("warning: {}\n", warning);
  return 0;
}

}  // namespace orbearing::app
