#include <nlohmann/json.hpp>

#include "app/case/unused_inputs.hpp"
#include "app/commands/lone_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/results/terminal_chart.hpp"
#include "app/study/mesh_output.hpp"
#include "app/study/plausibility.hpp"

namespace orbearing::app {

int mesh_command(const Options& options) {
  const ResolvedCase resolved = point_of(options);
  MeshStudy study = mesh_study(resolved);
  const std::vector<std::string> unused = require_used(resolved, use::mesh);
  for (std::string& warning : judge(observations(resolved)).warnings)
    study.warnings.push_back(std::move(warning));
  study.warnings.insert(study.warnings.end(), unused.begin(), unused.end());
  Record record;
  describe(record, study);
  nlohmann::ordered_json object{{"case", resolved.text("name")}};
  object.update(json_of(record));
  object["warnings"] = study.warnings;
  object["units"] = units_of(record);
  present_lone_result(object, text_of(record) + mesh_charts(study, glyphs_of_locale()), options);
  return 0;
}

}  // namespace orbearing::app
