#include <nlohmann/json.hpp>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/lone_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/life_derivatives_output.hpp"
#include "app/study/static_study.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

int sensitivities_command(const Options& options) {
  if (options.resume && options.output.empty())
    throw BadInput("--resume: found without --output; required: the folder to go on with");
  const ResolvedCase resolved = point_of(options);
  const ManifestHeader header = manifest_header(resolved, "sensitivities");
  const LifeDerivatives derivatives = life_derivatives(resolved);
  const std::vector<std::string> warnings =
      require_used(resolved, is_static_bearing(resolved) ? use::static_load : use::quasi_static);
  const nlohmann::ordered_json object = lone_result_json(resolved, derivatives_json(derivatives), warnings);
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  if (!folder.finished().contains(0)) {
    if (!folder.path().empty()) {
      write_aside_and_rename(folder.path() / "sensitivities.csv", derivatives_csv(derivatives));
      write_aside_and_rename(folder.path() / "sensitivities.json", object.dump(2) + "\n");
    }
    folder.keep({{0, lone_result_file(header, "sensitivities of a life", derivatives_content(derivatives)),
                  lone_row(folder.head())}});
  }
  present_lone_result(object, derivatives_text(derivatives), options);
  return 0;
}

}  // namespace orbearing::app
