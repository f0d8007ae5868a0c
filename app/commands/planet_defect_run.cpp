#include "app/commands/planet_defect_run.hpp"

#include <nlohmann/json.hpp>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/defect_run.hpp"
#include "app/commands/lone_result.hpp"
#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/planet_defect.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

int run_planet_defect_case(const ResolvedCase& resolved, const Options& options) {
  if (options.fidelity != "quasi-static" && options.fidelity != "monolithic")
    throw BadInput(
        "--fidelity: found " + options.fidelity +
        "; required: none, or monolithic, for a gear set with a scratched planet bearing, which is one "
        "system of gears and bearings");
  const std::vector<std::string> warnings = require_used(resolved, use::planet_defect);
  const ManifestHeader header = manifest_header(resolved, "scratched planet bearing");
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  constexpr std::size_t parts = 100;
  Progress progress(0, parts, !options.quiet, "signal, in hundredths: ");
  const PlanetDefectStudy study = planet_defect_study(
      resolved, [&](double share) { progress.show(static_cast<std::size_t>(share * parts)); });
  const nlohmann::ordered_json result = lone_result_json(resolved, planet_defect_json(study), warnings);
  if (!folder.finished().contains(0)) {
    if (!folder.path().empty())
      write_aside_and_rename({{folder.path() / defect_file_name, result.dump(2) + "\n"}});
    const double largest = study.vibration.largest_load;
    folder.keep({{0,
                  lone_result_file(header, "vibration of a gear set with a scratched planet bearing",
                                   planet_defect_content(study)),
                  lone_row(folder.head(), {{"inner_load_max_N", largest}, {"outer_load_max_N", largest}})}});
  }
  present_lone_result(result, planet_defect_text(study), options);
  return 0;
}

}  // namespace orbearing::app
