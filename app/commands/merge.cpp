#include "app/case/case_file.hpp"
#include "app/commands/command_line.hpp"
#include "app/errors.hpp"
#include "app/study/sweep_study.hpp"

namespace orbearing::app {

int merge_command(const Options& options) {
  if (!options.settings.empty())
    throw BadInput("--set: " + options.settings.front() +
                   ": found with merge; required: set it in the sweeps of all shards");
  const SweepOutcome outcome = merge_shards({options.folders.begin(), options.folders.end()}, options.output);
  const ResolvedCase resolved = read_case(options.output + "/case.resolved.yaml");
  return present_sweep(resolved, outcome, options.json, options.quiet);
}

}  // namespace orbearing::app
